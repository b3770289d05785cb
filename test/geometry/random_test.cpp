#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <scrubjay/geometry/random.hpp>
#include <vector>

namespace scrubjay {
namespace {

// Whoever changes a number below changes every simulated run.

TEST(RandomTest, KeepsItsNumbers) {
  const std::uint64_t expected[] = {0x863B891F4C0ABD4F, 0x4D58FBD282EAF415, 0xF0E521070CC03750, 0xE21B503436E97F5B,
                                    0xA9E76CFF841529F5, 0x583825D25ACE04F8, 0x660295FD0C2FA166, 0x9ACD7389A1455C90,
                                    0xCFB7F0A0F435E0E6, 0x16650EF5667A5BC0, 0xE993E4AE36580724, 0x2B90FB07DB5F92C9};
  Random random(7);
  for (const std::uint64_t number : expected) EXPECT_EQ(random.next(), number);
}

TEST(RandomTest, KeepsItsNormalNumbers) {
  const std::uint64_t expected[] = {0x3FAF43CD03183780, 0xBFE095926BF86FD4, 0x3FF902D52F735394, 0x3FF30F818B3AF0C8,
                                    0x3FDB0B077F045A14, 0xBFD9985525BBF8F5, 0xBFD07775E3884DCE, 0x3FD0FE5C304BE15A,
                                    0x3FEC421981E14BC7, 0xBFF5B3FAF0B799C9, 0x3FF5B135F772E07D, 0xBFEE82AA3EB83221};
  Random random(7);
  for (const std::uint64_t number : expected) EXPECT_EQ(std::bit_cast<std::uint64_t>(random.normal()), number);
}

TEST(RandomTest, KeepsItsSmallNumbers) {
  Random random(7);
  for (const std::uint32_t number : {524u, 302u, 940u, 883u, 663u, 344u, 398u, 604u, 811u, 87u, 912u, 170u}) {
    EXPECT_EQ(random.below(1000), number);
  }
}

TEST(RandomTest, KeepsItsForks) {
  Random fork = Random(7).fork(3);
  EXPECT_EQ(fork.next(), 0x3A1EBD3166939EF2u);
  EXPECT_EQ(fork.next(), 0x40D6471BFBFEBC25u);
}

TEST(RandomTest, ForksDontDependOnWhatWasDrawn) {
  Random drawn(9);
  for (int i = 0; i < 1000; ++i) drawn.normal();
  Random one = drawn.fork(5);
  Random other = Random(9).fork(5);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(one.next(), other.next());
}

TEST(RandomTest, ForksDifferFromEachOtherFromTheirParentAndBySeed) {
  std::vector<std::uint64_t> firsts;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    firsts.push_back(Random(seed).next());
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
      firsts.push_back(Random(seed).fork(stream).next());
      firsts.push_back(Random(seed).fork(1).fork(stream).next());
    }
  }
  std::sort(firsts.begin(), firsts.end());
  EXPECT_EQ(std::unique(firsts.begin(), firsts.end()), firsts.end());
}

TEST(RandomTest, ForksAreUncorrelated) {
  Random one = Random(1).fork(0);
  Random other = Random(1).fork(1);
  constexpr int kDraws = 100000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) sum += one.normal() * other.normal();
  EXPECT_NEAR(sum / kDraws, 0.0, 4.0 / std::sqrt(kDraws));
}

TEST(RandomTest, UniformHasItsMomentsAndFillsItsRange) {
  Random random(2);
  constexpr int kDraws = 1000000;
  double sum = 0.0;
  double squares = 0.0;
  std::array<int, 10> tenths{};
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
    ++tenths[static_cast<std::size_t>(10.0 * u)];
  }
  // Four standard deviations of each figure.
  EXPECT_NEAR(sum / kDraws, 1.0 / 2, 4.0 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 4.0 * std::sqrt(4.0 / 45 / kDraws));
  for (const int count : tenths) EXPECT_NEAR(count, kDraws / 10, 4.0 * std::sqrt(kDraws * 0.09));
}

TEST(RandomTest, UniformBetweenBoundsStaysBetweenThem) {
  Random random(3);
  double low = 1e9;
  double high = -1e9;
  for (int i = 0; i < 100000; ++i) {
    const double value = random.uniform(-2.0, 5.0);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  EXPECT_GE(low, -2.0);
  EXPECT_LT(high, 5.0);
  EXPECT_NEAR(low, -2.0, 0.001);
  EXPECT_NEAR(high, 5.0, 0.001);
}

TEST(RandomTest, NormalHasItsMomentsAndQuantiles) {
  Random random(4);
  constexpr int kDraws = 1000000;
  std::vector<double> draws(kDraws);
  std::array<double, 4> moments{};
  for (double& draw : draws) {
    draw = random.normal();
    double power = 1.0;
    for (double& moment : moments) moment += (power *= draw) / kDraws;
  }
  // Four standard deviations: the variance of x^k is 1, 2, 15 and 96.
  EXPECT_NEAR(moments[0], 0.0, 4.0 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(moments[1], 1.0, 4.0 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(moments[2], 0.0, 4.0 * std::sqrt(15.0 / kDraws));
  EXPECT_NEAR(moments[3], 3.0, 4.0 * std::sqrt(96.0 / kDraws));

  std::sort(draws.begin(), draws.end());
  const double points[] = {-3.5, -2.5, -1.973, -1.0, -0.3, 0.0, 0.3, 1.0, 1.973, 2.5, 3.5};  // 1.973: where tails begin
  for (const double x : points) {
    const double p = 0.5 * std::erfc(-x / std::sqrt(2.0));
    const double share = static_cast<double>(std::lower_bound(draws.begin(), draws.end(), x) - draws.begin()) / kDraws;
    EXPECT_NEAR(share, p, 4.0 * std::sqrt(p * (1.0 - p) / kDraws)) << "below " << x;
  }
  EXPECT_LT(draws.front(), -4.0);
  EXPECT_GT(draws.back(), 4.0);
}

TEST(RandomTest, BelowIsInRangeAndEven) {
  for (const std::uint32_t count : {1u, 2u, 7u, 1000u}) {
    Random random(count);
    const int draws = 1000 * static_cast<int>(count);
    std::vector<int> seen(count);
    for (int i = 0; i < draws; ++i) {
      const std::uint32_t value = random.below(count);
      ASSERT_LT(value, count);
      ++seen[value];
    }
    // Chi-squared over count cells of 1000: mean count - 1, variance 2 (count - 1).
    double chi_squared = 0.0;
    for (const int hits : seen) chi_squared += (hits - 1000) * (hits - 1000) / 1000.0;
    EXPECT_NEAR(chi_squared, count - 1.0, 4.0 * std::sqrt(2.0 * (count - 1.0)) + 1e-9);
  }
  Random random(5);
  std::uint32_t highest = 0;
  for (int i = 0; i < 1000; ++i) highest = std::max(highest, random.below(0xFFFFFFFFu));
  EXPECT_GT(highest, 0xFE000000u);
}

}  // namespace
}  // namespace scrubjay

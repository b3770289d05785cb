#include <gtest/gtest.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/frame_tally.hpp>

namespace scrubjay {
namespace {

TEST(FrameTallyTest, CountsNothingOfAWholeStream) {
  FrameTally tally;
  EXPECT_EQ(tally.lost(), 0u);
  for (int i = 0; i < 10000; ++i) tally.arrive(i * FrameTally::kTick);
  EXPECT_EQ(tally.arrived(), 10000u);
  EXPECT_EQ(tally.lost(), 0u);
}

TEST(FrameTallyTest, CountsEveryFrameThatDidntCome) {
  Random random(1);
  // Where a frame may be later than the next one is due, one or two may be taken for another.
  for (const double delay : {0.0, 0.01, 0.02}) {
    FrameTally tally;
    std::uint64_t lost = 0;
    double last = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const bool silent = i % 1000 > 900;  // a second and a half
      if (i > 0 && i < 19999 && (silent || random.uniform() < 0.1)) {
        ++lost;
        continue;
      }
      tally.arrive(last = std::max(last, i * FrameTally::kTick + random.uniform(0.0, delay)));
    }
    EXPECT_NEAR(static_cast<double>(tally.lost()), static_cast<double>(lost), delay < FrameTally::kTick ? 1.0 : 4.0)
        << delay;
  }
}

TEST(FrameTallyTest, MissesNoneInBursts) {
  FrameTally tally;
  for (int burst = 0; burst < 1000; ++burst) {
    for (int i = 0; i < 3; ++i) tally.arrive(burst * 3 * FrameTally::kTick);
  }
  EXPECT_LE(tally.lost(), 2u);
}

TEST(FrameTallyTest, FollowsAClockThatRunsOtherwise) {
  for (const double share : {0.97, 1.03}) {
    FrameTally tally;
    for (int i = 0; i < 100000; ++i) tally.arrive(i * FrameTally::kTick * share);
    EXPECT_LE(tally.lost(), 1u) << share;
  }
}

}  // namespace
}  // namespace scrubjay

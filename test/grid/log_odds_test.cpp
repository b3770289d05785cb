#include <gtest/gtest.h>

#include <cmath>
#include <scrubjay/grid/log_odds.hpp>

namespace scrubjay {
namespace {

double probability(LogOdds cell) {
  return 1.0 / (1.0 + std::exp(-cell * kLogOddsPerUnit));
}

TEST(LogOddsTest, GivesTheProbabilityBackToTheStep) {
  // Half a step of 1/20 in log-odds is at most 1/40 * p * (1 - p).
  for (double p = 0.007; p < 0.993; p += 0.001) {
    EXPECT_NEAR(probability(log_odds(p)), p, 1.02 / 40.0 * p * (1.0 - p) + 1e-12) << p;
  }
}

TEST(LogOddsTest, SaysNothingAtEvenOddsAndIsOddAround) {
  EXPECT_EQ(log_odds(0.5), 0);
  for (const double p : {0.1, 0.3, 0.45, 0.6, 0.9}) EXPECT_EQ(log_odds(p), -log_odds(1.0 - p));
}

TEST(LogOddsTest, ClampsCertainty) {
  EXPECT_EQ(log_odds(0.0), -kMaxLogOdds);
  EXPECT_EQ(log_odds(1.0), kMaxLogOdds);
  EXPECT_EQ(log_odds(1e-12), -kMaxLogOdds);
}

TEST(TrinaryTest, FollowsTheThresholdsOfNav2ForEveryCell) {
  for (int step = -kMaxLogOdds; step <= kMaxLogOdds; ++step) {
    const auto cell = static_cast<LogOdds>(step);
    const double p = probability(cell);
    const Occupancy expected = p >= 0.65 ? kOccupied : p <= 0.196 ? kFree : kUnknown;
    EXPECT_EQ(trinary(cell), expected) << "p = " << p;
  }
}

TEST(UpdateCellTest, EvidenceAddsAsBayesRuleSays) {
  LogOdds cell = 0;
  update_cell(cell, log_odds(0.6));
  update_cell(cell, log_odds(0.7));
  const double odds = (0.6 / 0.4) * (0.7 / 0.3);
  EXPECT_NEAR(probability(cell), odds / (1.0 + odds), 0.01);
  update_cell(cell, log_odds(0.4));
  update_cell(cell, log_odds(0.3));
  EXPECT_EQ(cell, 0);
}

TEST(UpdateCellTest, ClampsSoThatACellCanChangeItsMind) {
  LogOdds cell = 0;
  for (int i = 0; i < 1000; ++i) update_cell(cell, 44);
  EXPECT_EQ(cell, kMaxLogOdds);
  for (int i = 0; i < 4; ++i) update_cell(cell, -44);
  EXPECT_EQ(trinary(cell), kFree);
  for (int i = 0; i < 1000; ++i) update_cell(cell, -127);
  EXPECT_EQ(cell, -kMaxLogOdds);
}

}  // namespace
}  // namespace scrubjay

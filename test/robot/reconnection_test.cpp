#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/robot/reconnection.hpp>
#include <vector>

namespace scrubjay {
namespace {

using Step = Reconnection::Step;

TEST(ReconnectionTest, TriesAtOnceAndThenWithGrowingPauses) {
  Reconnection link({.first_retry = 0.125, .longest_retry = 0.5, .give_up = 60.0});
  link.alive(10.0);
  std::vector<int> tries;
  for (int i = 8; i < 128; ++i) {
    if (link.silent(10.0 + i / 64.0) == Step::Retry) tries.push_back(i);
  }
  EXPECT_THAT(tries, testing::ElementsAre(8, 16, 32, 64, 96));
}

TEST(ReconnectionTest, GivesUpInTheEnd) {
  Reconnection link({.first_retry = 0.1, .longest_retry = 2.0, .give_up = 5.0});
  link.alive(1.0);
  EXPECT_NE(link.silent(5.9), Step::GiveUp);
  EXPECT_EQ(link.silent(6.1), Step::GiveUp);
}

TEST(ReconnectionTest, GivesUpOnOneThatNeverSpokeToo) {
  Reconnection link({.first_retry = 0.1, .longest_retry = 2.0, .give_up = 5.0});
  EXPECT_EQ(link.silent(100.0), Step::Retry);
  EXPECT_EQ(link.silent(105.5), Step::GiveUp);
}

TEST(ReconnectionTest, KeepsAnAccountAndStartsAnewAfterEachSilence) {
  Reconnection link;
  link.alive(1.0);
  link.silent(1.1);
  link.silent(1.2);
  link.alive(1.5);
  link.alive(1.515);
  EXPECT_EQ(link.silent(2.0), Step::Retry);
  EXPECT_EQ(link.silences(), 2u);
  EXPECT_EQ(link.reconnections(), 1u);
  EXPECT_DOUBLE_EQ(link.longest_silence(), 0.5);
}

}  // namespace
}  // namespace scrubjay

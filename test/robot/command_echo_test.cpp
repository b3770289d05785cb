#include <gtest/gtest.h>

#include <scrubjay/robot/command_echo.hpp>
#include <scrubjay/robot/frame_tally.hpp>

namespace scrubjay {
namespace {

TEST(CommandEchoTest, ARobotThatNeverEchoedIsntCalledDeaf) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  for (int i = 1; i < 100; ++i) EXPECT_FALSE(echo.is_deaf(0, 0, i * FrameTally::kTick));
}

TEST(CommandEchoTest, GivesAnEchoItsTime) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, FrameTally::kTick));
  echo.tell(100, 300, 1.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, 1.0 + 3 * FrameTally::kTick));
  EXPECT_FALSE(echo.is_deaf(100, 300, 1.0 + 4 * FrameTally::kTick));
}

TEST(CommandEchoTest, FindsARobotDeafThatGoesOnAsBefore) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, FrameTally::kTick));
  echo.tell(0, 0, 1.0);
  EXPECT_TRUE(echo.is_deaf(200, 200, 1.0 + 5 * FrameTally::kTick));
  EXPECT_FALSE(echo.is_deaf(200, 200, 1.0 + 6 * FrameTally::kTick));  // said already
  EXPECT_TRUE(echo.is_deaf(200, 200, 1.0 + 10 * FrameTally::kTick));
}

TEST(CommandEchoTest, SoItDoesWhileTheMotionChangesEveryTick) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, FrameTally::kTick));
  int deaf_at = 0;
  for (int i = 1; deaf_at == 0 && i < 50; ++i) {
    echo.tell(200 + i, 200 - i, 1.0 + i * FrameTally::kTick);
    if (echo.is_deaf(200, 200, 1.0 + i * FrameTally::kTick)) deaf_at = i;
  }
  EXPECT_GT(deaf_at, 3);
  EXPECT_LE(deaf_at, 7);
}

TEST(CommandEchoTest, FindsItDeafWhereItObeysWhatNobodySaid) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, FrameTally::kTick));
  EXPECT_TRUE(echo.is_deaf(-28416, 145, 1.0));
}

}  // namespace
}  // namespace scrubjay

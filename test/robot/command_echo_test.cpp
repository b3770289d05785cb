#include <gtest/gtest.h>

#include <scrubjay/robot/command_echo.hpp>

namespace scrubjay {
namespace {

constexpr double kTick = 0.015;

TEST(CommandEchoTest, ARobotThatNeverEchoedIsntCalledDeaf) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  for (int i = 1; i < 100; ++i) EXPECT_FALSE(echo.is_deaf(0, 0, i * kTick));
}

TEST(CommandEchoTest, GivesAnEchoItsTime) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, kTick));
  echo.tell(100, 300, 1.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, 1.0 + 3 * kTick));
  EXPECT_FALSE(echo.is_deaf(100, 300, 1.0 + 4 * kTick));
}

TEST(CommandEchoTest, FindsARobotDeafThatGoesOnAsBefore) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, kTick));
  echo.tell(0, 0, 1.0);
  EXPECT_TRUE(echo.is_deaf(200, 200, 1.0 + 5 * kTick));
  EXPECT_FALSE(echo.is_deaf(200, 200, 1.0 + 6 * kTick));  // said already
  EXPECT_TRUE(echo.is_deaf(200, 200, 1.0 + 10 * kTick));
}

TEST(CommandEchoTest, SoItDoesWhileTheMotionChangesEveryTick) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, kTick));
  int deaf_at = 0;
  for (int i = 1; deaf_at == 0 && i < 50; ++i) {
    echo.tell(200 + i, 200 - i, 1.0 + i * kTick);
    if (echo.is_deaf(200, 200, 1.0 + i * kTick)) deaf_at = i;
  }
  EXPECT_GT(deaf_at, 3);
  EXPECT_LE(deaf_at, 7);
}

TEST(CommandEchoTest, FindsItDeafWhereItObeysWhatNobodySaid) {
  CommandEcho echo;
  echo.tell(200, 200, 0.0);
  EXPECT_FALSE(echo.is_deaf(200, 200, kTick));
  EXPECT_TRUE(echo.is_deaf(-28416, 145, 1.0));
}

}  // namespace
}  // namespace scrubjay

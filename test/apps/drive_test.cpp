#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <io/temporary_folder.hpp>
#include <thread>

#include "command_line.hpp"
#include "driven_terminal.hpp"

namespace scrubjay {
namespace {

/// The longest line of what was shown, without the sequences that move the cursor.
std::size_t columns_of(const std::string& shown) {
  std::size_t longest = 0;
  std::size_t column = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (shown[i] == '\033') {
      while (i < shown.size() && (shown[i] < '@' || shown[i] == '[')) ++i;
    } else {
      column = shown[i] == '\n' || shown[i] == '\r' ? 0 : column + 1;
      longest = std::max(longest, column);
    }
  }
  return longest;
}

TEST(DriveTest, DrivesASimulatedRobotByKeyAndQuits) {
  TerminalCall call({"drive", own_world("room")});
  ASSERT_TRUE(call.wait_for("+0.00 m/s"));
  EXPECT_FALSE(call.is_cooked());
  ASSERT_TRUE(call.hold_until("w", "+0.10 m/s"));
  call.forget();
  ASSERT_TRUE(call.wait_for("+0.00 m/s")) << "drives on without a key";
  call.type("+\033[D");
  ASSERT_TRUE(call.wait_for("+34 deg/s"));
  call.type("q");
  EXPECT_EQ(call.wait(), 0);
  EXPECT_THAT(call.shown(), testing::HasSubstr("the robot stands"));
  EXPECT_LT(columns_of(call.shown()), 80U);
  EXPECT_TRUE(call.is_cooked());
}

TEST(DriveTest, DrivesARobotWithALidarToo) {
  TerminalCall call({"drive", own_world("room"), "--model", "turtlebot3-burger", "--max-speed", "0.1"});
  ASSERT_TRUE(call.wait_for("nearest thing"));
  call.type("q");
  EXPECT_EQ(call.wait(), 0);
}

class InterruptedDriveTest : public testing::TestWithParam<int> {};

TEST_P(InterruptedDriveTest, EndsAndLeavesTheTerminalAsItWas) {
  TerminalCall call({"drive", own_world("room")});
  ASSERT_TRUE(call.wait_for("+0.00 m/s"));
  ASSERT_TRUE(call.hold_until("w", "+0.10 m/s"));
  call.send(GetParam());
  EXPECT_EQ(call.wait(), 0);
  EXPECT_TRUE(call.is_cooked());
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptedDriveTest, testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(DriveTest, CtrlZDoesNotLeaveTheRobotDriving) {
  TerminalCall call({"drive", own_world("room")});
  ASSERT_TRUE(call.wait_for("+0.00 m/s"));
  ASSERT_TRUE(call.hold_until("w", "+0.10 m/s"));
  call.type("\x1A");
  call.forget();
  ASSERT_TRUE(call.wait_for("+0.00 m/s"));
  call.type("q");
  EXPECT_EQ(call.wait(), 0);
}

TEST(DriveTest, RefusesToDriveWithoutATerminal) {
  const Outcome outcome = scrubjay({"drive", own_world("room")});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(is_one_line(outcome.err));
  EXPECT_THAT(outcome.err, testing::HasSubstr("terminal"));
}

TEST(DriveTest, RefusesWhatTheRobotCannotDo) {
  for (const std::vector<std::string>& words :
       {Words{"--max-speed", "5"}, Words{"--max-speed", "0"}, Words{"--max-turn", "nan"}, Words{"--robot", "log:a"},
        Words{"--robot", "serial:/nowhere"}, Words{"--robot", "spaceship"}}) {
    Words all{"drive", own_world("room")};
    all.insert(all.end(), words.begin(), words.end());
    TerminalCall call(all);
    EXPECT_EQ(call.wait(), 2) << words.back() << call.shown();
    EXPECT_THAT(call.shown(), testing::StartsWith("scrubjay: "));
  }
}

/// A robot behind a pseudo-terminal.
class WiredDriveTest : public testing::Test {
 protected:
  WiredDriveTest() : emulator_({"emulate", own_world("room"), "--pty", port()}) {
    while (!std::filesystem::is_symlink(port())) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ~WiredDriveTest() override {
    emulator_.send(SIGTERM);
    emulator_.wait();
  }
  std::string port() const { return (folder_ / "robot").string(); }

  TemporaryFolder folder_;
  Call emulator_;
};

TEST_F(WiredDriveTest, DrivesWhatIsBehindThePort) {
  TerminalCall call({"drive", "--robot", "serial:" + port()});
  ASSERT_TRUE(call.wait_for("mode Safe"));
  EXPECT_TRUE(call.hold_until("w", "driven 0.1"));
  call.type("q");
  EXPECT_EQ(call.wait(), 0);
}

TEST_F(WiredDriveTest, StopsTheRobotWhenTheWindowIsClosed) {
  {
    TerminalCall call({"drive", "--robot", "serial:" + port()});
    ASSERT_TRUE(call.wait_for("mode Safe"));
    ASSERT_TRUE(call.hold_until("w", "+0.10 m/s"));
    call.hang_up();
    EXPECT_GE(call.wait(), 0) << "ended by a signal, without a word to the robot";
  }
  // What it was told last stands in its requested velocities, and the mode is one that charges.
  const Outcome after = scrubjay({"doctor", "--port", port(), "--no-reset", "--json", "--listen", "0.5"});
  EXPECT_THAT(after.out, testing::HasSubstr("\"mode\": \"Passive\"")) << after.err;
}

}  // namespace
}  // namespace scrubjay

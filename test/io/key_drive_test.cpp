#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mission/fakes.hpp>
#include <scrubjay/io/key_drive.hpp>
#include <stdexcept>
#include <utility>

namespace scrubjay {
namespace {

using Kind = Key::Kind;

Key letter(char character) {
  return {Kind::Character, character};
}

Frame at(double stamp) {
  Frame frame;
  frame.stamp = stamp;
  return frame;
}

TEST(KeyDriverTest, DrivesByLettersAndArrowsAlike) {
  const std::vector<std::pair<Key, Motion>> keys{
      {letter('w'), {0.1, 0.0}},     {{Kind::Up, 0}, {0.1, 0.0}},    {letter('s'), {-0.1, 0.0}},
      {letter('S'), {-0.1, 0.0}},    {{Kind::Down, 0}, {-0.1, 0.0}}, {letter('a'), {0.0, 0.5}},
      {{Kind::Left, 0}, {0.0, 0.5}}, {letter('d'), {0.0, -0.5}},     {{Kind::Right, 0}, {0.0, -0.5}},
  };
  for (const auto& [key, motion] : keys) {
    KeyDriver driver;
    driver.press(key, 10.0);
    EXPECT_EQ(driver.motion(at(10.0)), motion) << static_cast<int>(key.kind) << key.character;
  }
}

TEST(KeyDriverTest, TurnsWhileItDrives) {
  KeyDriver driver;
  driver.press(letter('w'), 10.0);
  driver.press(letter('a'), 10.1);
  EXPECT_EQ(driver.motion(at(10.2)), (Motion{0.1, 0.5}));
}

TEST(KeyDriverTest, StopsWhenAKeyIsNotPressedAgainInTime) {
  KeyDriver driver;
  driver.press(letter('w'), 10.0);
  EXPECT_EQ(driver.motion(at(10.69)).linear, 0.1);
  EXPECT_EQ(driver.motion(at(10.71)).linear, 0.0);
}

TEST(KeyDriverTest, StopsSoonerOnceAKeyWasRepeated) {
  KeyDriver driver;
  driver.press(letter('w'), 10.0);
  driver.press(letter('w'), 10.5);  // the first repetition
  driver.press(letter('w'), 10.53);
  EXPECT_EQ(driver.motion(at(10.77)).linear, 0.1);
  EXPECT_EQ(driver.motion(at(10.79)).linear, 0.0);
}

TEST(KeyDriverTest, TheOppositeKeyTurnsAroundAtOnce) {
  KeyDriver driver;
  driver.press(letter('w'), 10.0);
  driver.press(letter('s'), 10.05);
  EXPECT_EQ(driver.motion(at(10.1)).linear, -0.1);
  EXPECT_EQ(driver.motion(at(10.7)).linear, -0.1);  // the first press of another key, not a repetition
}

TEST(KeyDriverTest, AnyKeyWithoutAMeaningStops) {
  for (const Key& key :
       {letter(' '), letter('x'), letter('\r'), letter(26), Key{Kind::Escape, 0}, Key{Kind::Other, 0}}) {
    KeyDriver driver;
    driver.press(letter('w'), 10.0);
    driver.press(letter('a'), 10.0);
    driver.press(key, 10.1);
    EXPECT_EQ(driver.motion(at(10.1)), Motion{});
    EXPECT_FALSE(driver.quit());
  }
}

TEST(KeyDriverTest, SpeedStaysBetweenATenthAndTheLimit) {
  KeyDriveParams params;
  params.max_speed = 0.3;
  params.max_turn = 2.0;
  KeyDriver driver(params);
  for (int i = 0; i < 30; ++i) driver.press(letter('+'), 0.0);
  driver.press(letter('w'), 0.0);
  driver.press(letter('a'), 0.0);
  EXPECT_EQ(driver.motion(at(0.0)), (Motion{0.3, 2.0}));
  for (int i = 0; i < 30; ++i) driver.press(letter('-'), 0.0);
  EXPECT_NEAR(driver.motion(at(0.0)).linear, 0.03, 1e-12);
}

TEST(KeyDriverTest, BumpsAndCliffsStopForwardMotionAlone) {
  Frame bumped = at(10.0);
  bumped.bump_right = true;
  Frame cliff = at(10.0);
  cliff.cliff_flags = 4;
  for (const Frame& frame : {bumped, cliff}) {
    KeyDriver driver;
    driver.press(letter('w'), 10.0);
    driver.press(letter('a'), 10.0);
    EXPECT_EQ(driver.motion(frame), (Motion{0.0, 0.5}));
    EXPECT_NE(driver.held(), KeyDriver::Held::No);
    EXPECT_EQ(driver.motion(at(10.1)).linear, 0.0) << "goes on without having been told again";
    driver.press(letter('s'), 10.1);
    EXPECT_EQ(driver.motion(frame).linear, -0.1);
  }
}

TEST(KeyDriverTest, AHangingWheelStopsEverything) {
  Frame lifted = at(10.0);
  lifted.wheel_drop_left = true;
  KeyDriver driver;
  driver.press(letter('s'), 10.0);
  driver.press(letter('d'), 10.0);
  EXPECT_EQ(driver.motion(lifted), Motion{});
  EXPECT_EQ(driver.motion(at(10.1)), Motion{});
}

/// Keys by the frame at which they come.
class DriveLoopTest : public testing::Test {
 protected:
  DriveEnd drive(test::FakeRobot& robot) {
    return drive_by_keys(
        robot, driver_,
        [this]() -> std::optional<std::vector<Key>> {
          const int now = frame_++;
          if (now == unplugged_) return std::nullopt;
          const auto found = keys_.find(now);
          return found == keys_.end() ? std::vector<Key>{} : found->second;
        },
        [this](const Frame&, const Motion& motion, const KeyDriver&) { seen_.push_back(motion); }, stop_.get_token());
  }

  std::map<int, std::vector<Key>> keys_;
  int unplugged_ = -1;
  int frame_ = 0;
  KeyDriver driver_;
  std::stop_source stop_;
  std::vector<Motion> seen_;
};

TEST_F(DriveLoopTest, RenewsTheMotionWithEveryFrameAndShowsIt) {
  test::FakeRobot robot(20);
  keys_[0] = {letter('w')};
  EXPECT_EQ(drive(robot), DriveEnd::RobotGone);
  ASSERT_EQ(robot.motions.size(), 20U);
  EXPECT_THAT(robot.motions, testing::Each(Motion{0.1, 0.0}));
  EXPECT_EQ(seen_, robot.motions);
  EXPECT_EQ(robot.stops, 1);
}

TEST_F(DriveLoopTest, QuitsByKeyAndStopsTheRobot) {
  for (const Key& key : {letter('q'), letter(4)}) {
    test::FakeRobot robot(100);
    frame_ = 0;
    driver_ = KeyDriver();
    keys_ = {{0, {letter('w')}}, {5, {letter('w'), key}}};
    EXPECT_EQ(drive(robot), DriveEnd::Quit);
    EXPECT_EQ(robot.given, 6);
    EXPECT_EQ(robot.stops, 1);
  }
}

TEST_F(DriveLoopTest, StopsTheRobotWhenTheKeyboardIsGone) {
  test::FakeRobot robot(100);
  keys_[0] = {letter('w')};
  unplugged_ = 3;
  EXPECT_EQ(drive(robot), DriveEnd::KeyboardGone);
  EXPECT_EQ(robot.motions_before_stop, 3U);
  EXPECT_EQ(robot.stops, 1);
}

TEST_F(DriveLoopTest, StopsWhenSomebodyAsksTo) {
  test::FakeRobot robot(100, [this](int given, Frame&) {
    if (given == 10) stop_.request_stop();
  });
  EXPECT_EQ(drive(robot), DriveEnd::Stopped);
  EXPECT_EQ(robot.stops, 1);
}

TEST_F(DriveLoopTest, StopsTheRobotWhenAnybodyThrows) {
  test::FakeRobot robot(100, [](int given, Frame&) {
    if (given == 10) throw std::runtime_error("the port is on fire");
  });
  EXPECT_THROW(drive(robot), std::runtime_error);
  EXPECT_EQ(robot.stops, 1);
}

TEST_F(DriveLoopTest, ForgetsKeysThatWerePressedWhileTheRobotWasSilent) {
  test::FakeRobot robot(40, [](int given, Frame& frame) {
    if (given >= 20) frame.stamp += 0.3;
  });
  keys_ = {{18, {letter('w')}}, {20, {letter('w')}}, {30, {letter('s')}}};
  drive(robot);
  EXPECT_EQ(robot.motions[19].linear, 0.1);
  EXPECT_EQ(robot.motions[20].linear, 0.0);
  EXPECT_EQ(robot.motions[29].linear, 0.0);
  EXPECT_EQ(robot.motions[30].linear, -0.1);
}

TEST_F(DriveLoopTest, EndsByKeyWhileTheRobotIsSilent) {
  const auto once = [](char character) {
    return [character, given = false]() mutable -> std::optional<std::vector<Key>> {
      return std::exchange(given, true) ? std::vector<Key>{} : std::vector<Key>{letter(character)};
    };
  };
  KeyDriver moving;
  moving.press(letter('w'), 0.0);
  EXPECT_TRUE(heed_keys_in_silence(moving, once('w')));
  EXPECT_EQ(moving.motion(at(0.0)), Motion{}) << "drives on when the robot is heard again";
  EXPECT_TRUE(heed_keys_in_silence(moving, once('+')));
  EXPECT_NEAR(moving.speed(), 0.6, 1e-12);
  EXPECT_FALSE(heed_keys_in_silence(driver_, [] { return std::nullopt; }));

  EXPECT_FALSE(heed_keys_in_silence(driver_, once('q')));
  test::FakeRobot gone(0);
  EXPECT_EQ(drive(gone), DriveEnd::Quit);
  EXPECT_EQ(gone.stops, 1);
}

TEST_F(DriveLoopTest, TellsAKeyboardThatIsGoneFromARobotThatIs) {
  test::FakeRobot gone(0);
  EXPECT_EQ(drive(gone), DriveEnd::RobotGone);
  unplugged_ = frame_;
  EXPECT_EQ(drive(gone), DriveEnd::KeyboardGone);
}

TEST_F(DriveLoopTest, QuitsEvenByAKeyThatWasPressedInASilence) {
  test::FakeRobot robot(40, [](int given, Frame& frame) {
    if (given >= 20) frame.stamp += 5.0;
  });
  keys_ = {{20, {letter('q')}}};
  EXPECT_EQ(drive(robot), DriveEnd::Quit);
}

}  // namespace
}  // namespace scrubjay

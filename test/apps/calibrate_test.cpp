#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder with a world that has room for every drive.
class CalibrateTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("hall.yaml",
                  "name: hall\nwalls:\n  - [[0, 0], [7, 0], [7, 7], [0, 7], [0, 0]]\nstart: [3, 3, 0.3]\n");
  }

  Outcome calibrate(const Words& more) {
    Words words{"calibrate", "hall.yaml"};
    words.insert(words.end(), more.begin(), more.end());
    return scrubjay_in(folder_.path(), words);
  }
  /// Explores as the robot that was calibrated, or as one that wasn't.
  Outcome explore(const Words& more) {
    Words words{"explore", "hall.yaml", "--noise", "uncalibrated", "--seed", "5", "--max-time", "60"};
    words.insert(words.end(), more.begin(), more.end());
    return scrubjay_in(folder_.path(), words);
  }
  double final_error(const std::string& out) { return metrics_of(folder_ / out).at("final_error_m").get<double>(); }

  TemporaryFolder folder_;
};

TEST_F(CalibrateTest, WritesAFileThatMakesTheNextRunBetter) {
  const Outcome outcome = calibrate({"--noise", "uncalibrated", "--seed", "5"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("left wheel"), HasSubstr("axle"), HasSubstr("calibration.yaml\n")));
  ASSERT_EQ(explore({"--out", "before"}).code, 0);
  ASSERT_EQ(explore({"--out", "after", "--calibration", "calibration.yaml"}).code, 0);
  EXPECT_LT(final_error("after"), 0.25 * final_error("before"));
}

TEST_F(CalibrateTest, FindsTheSameFactorsAgain) {
  const Words words{"--noise", "hard-floor", "--date", "2026-03-31", "--json", "--out"};
  const auto with_out = [&](const std::string& out) {
    Words all = words;
    all.push_back(out);
    return all;
  };
  const Outcome first = calibrate(with_out("first.yaml"));
  const Outcome second = calibrate(with_out("second.yaml"));
  ASSERT_EQ(first.code, 0) << first.err;
  EXPECT_EQ(first.out, second.out);
  EXPECT_NEAR(nlohmann::json::parse(first.out).at("axle").get<double>(), 1.0, 0.03);
  const Contents files = contents_of(folder_.path());
  EXPECT_EQ(files.at("first.yaml"), files.at("second.yaml"));
  EXPECT_THAT(files.at("first.yaml"), HasSubstr("date: 2026-03-31\n"));
}

TEST_F(CalibrateTest, ARunWithACalibrationIsRepeatedAndReplayedToTheByte) {
  ASSERT_EQ(calibrate({"--noise", "uncalibrated", "--seed", "5", "--quiet"}).code, 0);
  ASSERT_EQ(explore({"--out", "run", "--calibration", "calibration.yaml", "--record", "run.oilog"}).code, 0);
  std::filesystem::remove(folder_ / "calibration.yaml");  // all that is needed is in the scenario
  const Contents run = repeatable(contents_of(folder_ / "run"));
  EXPECT_THAT(run.at("scenario.yaml"), HasSubstr("calibration: {left: "));

  ASSERT_EQ(scrubjay_in(folder_.path(), {"explore", "--scenario", "run/scenario.yaml", "--out", "again"}).code, 0);
  EXPECT_EQ(repeatable(contents_of(folder_ / "again")), run);
  ASSERT_EQ(scrubjay_in(folder_.path(), {"replay", "run.oilog", "--out", "replay"}).code, 0);
  const Contents replay = contents_of(folder_ / "replay");
  EXPECT_EQ(replay.at("map.pgm"), run.at("map.pgm"));
  EXPECT_EQ(replay.at("trajectory.tum"), run.at("trajectory.tum"));
}

TEST_F(CalibrateTest, AReplayMayTryOtherFactors) {
  ASSERT_EQ(calibrate({"--noise", "uncalibrated", "--seed", "5", "--quiet"}).code, 0);
  ASSERT_EQ(explore({"--out", "run", "--record", "run.oilog"}).code, 0);
  const Outcome outcome =
      scrubjay_in(folder_.path(), {"replay", "run.oilog", "--out", "replay", "--calibration", "calibration.yaml"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(contents_of(folder_ / "replay").at("trajectory.tum"), contents_of(folder_ / "run").at("trajectory.tum"));
}

TEST_F(CalibrateTest, RefusesWhatItCannotDo) {
  const auto expect_refused = [](const Outcome& outcome, int code, const std::string& what) {
    EXPECT_EQ(outcome.code, code);
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(StartsWith("scrubjay: "), HasSubstr(what)));
  };
  expect_refused(calibrate({"--drives", "circle"}), 2, "there is no drive 'circle'");
  expect_refused(calibrate({"--side", "0"}), 2, "--side is 0; want 0.3 to 10 m");
  expect_refused(calibrate({"--turns", "0"}), 2, "--turns is 0; want 1 to 50");
  expect_refused(calibrate({"--repeat", "0"}), 2, "--repeat is 0; want 1 to 100");
  expect_refused(calibrate({"--date", "today"}), 2, "--date is 'today'");
  expect_refused(calibrate({"--model", "turtlebot3-burger"}), 2,
                 "turtlebot3-burger, which doesn't speak the Open Interface");
  expect_refused(calibrate({"--measured", "3"}), 2, "--measured");
  expect_refused(calibrate({"--out", "nowhere/c.yaml"}), 1, "nowhere/c.yaml: cannot write");
  expect_refused(calibrate({"--side", "6"}), 1, "square-left: something is in the way");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "calibration.yaml"));

  folder_.write("other.yaml", "model: create-1\nleft: 1\nright: 1\naxle: 1\n");
  expect_refused(explore({"--calibration", "other.yaml"}), 2, "other.yaml: the calibration of a create-1");
  expect_refused(explore({"--calibration", "absent.yaml"}), 2, "absent.yaml");
  folder_.write("bad.yaml", "model: roomba-600\nleft: 1\nright: 1\naxle: 9\n");
  expect_refused(explore({"--calibration", "bad.yaml"}), 2, "bad.yaml:4: axle is 9; want a factor from 0.5 to 2");
}

}  // namespace
}  // namespace scrubjay

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <io/temporary_folder.hpp>
#include <scrubjay/geometry/pose2.hpp>
#include <sstream>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

/// Numbers, each with a blank before it.
std::string columns(std::initializer_list<double> values) {
  std::ostringstream text;
  for (const double value : values) text << ' ' << std::fixed << value;
  return text.str();
}

std::string columns(const Pose2& pose) {
  return columns({pose.x, pose.y, pose.yaw});
}

/// What a lidar in a room of 6 x 4 m sees at `bearing` from a pose.
double range_in_room(const Pose2& pose, double bearing) {
  const Point2 ray = direction(pose.yaw + bearing);
  const double across = (ray.x() > 0.0 ? 3.0 - pose.x : 3.0 + pose.x) / std::fabs(ray.x());
  const double along = (ray.y() > 0.0 ? 2.0 - pose.y : 2.0 + pose.y) / std::fabs(ray.y());
  return std::min(across, along);
}

/// The robot's way from scan `i` to the next: a circle, all in all, and no part of it like another.
Pose2 step(int i) {
  return {0.1, 0.0, 0.05 + 0.1 * (i * i % 59) / 59.0};
}

/// A robot that drives a circle in a room and turns left of what its wheels tell: a log that was corrected.
std::string circle_log() {
  std::string log = "# message formats defined: PARAM SYNC ODOM FLASER\n";
  Pose2 pose{0.0, -1.0, 0.0};
  for (int i = 0; i < 60; ++i) {
    log += "FLASER 181";
    for (int beam = 0; beam <= 180; ++beam) log += columns({range_in_room(pose, radians(beam - 90))});
    const std::string stamp = columns({0.5 * i});
    log += columns(pose) + columns(pose) + stamp + " host" + stamp + "\n";
    log += "ODOM" + columns(pose) + " 0 0 0 0 host 0\n";
    const std::string then = columns({0.5 * (i + 1)});
    log += "ODOM" + columns(pose * step(i) * Pose2{0.0, 0.0, -0.01}) + " 0 0 0" + then + " host" + then + "\n";
    pose = pose * step(i);
  }
  return log;
}

/// Relations of that drive, by another clock.
std::string circle_relations() {
  std::string text;
  for (int i = 0; i + 7 < 60; ++i) {
    Pose2 motion;
    for (int j = i; j < i + 3 + i % 5; ++j) motion = motion * step(j);
    text += columns({1000.0 + 0.5 * i, 1000.0 + 0.5 * (i + 3 + i % 5), motion.x, motion.y, 0, 0, 0, motion.yaw});
    text += '\n';
  }
  return text;
}

class ReplayCarmenTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("circle.log", circle_log());
    folder_.write("circle.relations", circle_relations());
  }
  Outcome replay(Words words) const {
    words.insert(words.begin(), {"replay", "circle.log"});
    return scrubjay_in(folder_.path(), words);
  }

  TemporaryFolder folder_;
};

TEST_F(ReplayCarmenTest, MapsWithThePosesOfTheLog) {
  const Outcome outcome = replay({"--poses", "log", "--out", "run"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(broken_result(folder_ / "run"), "");
  EXPECT_EQ(names_of(contents_of(folder_ / "run")),
            (std::set<std::string>{"map.pgm", "map.yaml", "map.png", "trajectory.tum", "reference.tum", "metrics.json",
                                   "timing.json"}));
  EXPECT_EQ(content_of(folder_ / "run/trajectory.tum"), content_of(folder_ / "run/reference.tum"));
  const nlohmann::json metrics = metrics_of(folder_ / "run");
  EXPECT_EQ(metrics.at("ate_m"), 0.0);
  EXPECT_EQ(metrics.at("poses"), "log");
  EXPECT_EQ(metrics.at("log"), "circle");
  EXPECT_NEAR(metrics.at("distance_m"), 6.0, 0.2);
}

TEST_F(ReplayCarmenTest, TellsHowFarTheWheelsAloneAreOff) {
  ASSERT_EQ(replay({"--poses", "odometry", "--out", "run", "--relations", "circle.relations"}).code, 0);
  const nlohmann::json metrics = metrics_of(folder_ / "run");
  EXPECT_GT(metrics.at("ate_m"), 0.1);
  EXPECT_NEAR(metrics.at("final_heading_error_rad"), 59 * 0.01, 0.001);
  const nlohmann::json& relations = metrics.at("relations");
  EXPECT_EQ(relations.at("matched"), 53);
  EXPECT_NEAR(relations.at("clock_offset_s"), 1000.0, 0.05);
  EXPECT_NEAR(relations.at("rotation_rad").at("max"), 0.07, 0.005) << "a hundredth a step, seven steps at most";
}

TEST_F(ReplayCarmenTest, KeepsThePoseByMatchingScans) {
  ASSERT_EQ(replay({"--out", "run"}).code, 0);
  EXPECT_EQ(metrics_of(folder_ / "run").at("poses"), "scan-matching");
  EXPECT_LT(metrics_of(folder_ / "run").at("ate_m"), 0.05);
}

TEST_F(ReplayCarmenTest, GivesTheSameFilesEveryTime) {
  ASSERT_EQ(replay({"--out", "a"}).code, 0);
  ASSERT_EQ(replay({"--out", "b"}).code, 0);
  EXPECT_EQ(repeatable(contents_of(folder_ / "a")), repeatable(contents_of(folder_ / "b")));
}

TEST_F(ReplayCarmenTest, WritesTheMapAsAnOctomapToo) {
  ASSERT_EQ(replay({"--poses", "log", "--out", "run", "--octomap", "map.bt"}).code, 0);
  EXPECT_THAT(content_of(folder_ / "map.bt"), HasSubstr("# Octomap OcTree binary file"));
}

TEST_F(ReplayCarmenTest, RefusesWhatIsWrongBeforeItWritesAnything) {
  const auto complaint = [&](Words words) {
    words.insert(words.end(), {"--out", "run"});
    const Outcome outcome = replay(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "run"));
    return outcome.err;
  };
  EXPECT_THAT(complaint({"--poses", "gps"}), HasSubstr("--poses is 'gps'; want log, odometry or scan-matching"));
  EXPECT_THAT(complaint({"--resolution", "0"}), HasSubstr("--resolution is 0; want 0.005 to 10 m"));
  EXPECT_THAT(complaint({"--forward-cone", "181"}), HasSubstr("--forward-cone is 181; want 1 to 180 degrees"));
  EXPECT_THAT(complaint({"--relations", "none"}), HasSubstr("none: cannot read"));
  folder_.write("other.relations", "1 2 0.5 0 0 0 0 3\n2 3 0.5 0 0 0 0 3\n");
  EXPECT_THAT(complaint({"--relations", "other.relations"}), HasSubstr("don't fit the poses in circle.log"));
}

TEST_F(ReplayCarmenTest, IsToldApartByInfo) {
  const Outcome outcome = scrubjay_in(folder_.path(), {"info", "circle.log"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              HasSubstr("circle.log: CARMEN log\nlength: 30.000 s\nscans: 60\nbeams: 181, from -90 to 90 degrees\n"));
}

}  // namespace
}  // namespace scrubjay

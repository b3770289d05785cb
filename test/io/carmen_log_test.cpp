#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/packed.hpp>
#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/carmen_log.hpp>

namespace scrubjay {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CarmenLog parse(const std::string& text) {
  return parse_carmen_log(unpacked(text), "a.log");
}

std::string complaint(const std::string& text) {
  return message_of([&] { parse(text); });
}

void expect_pose(const Pose2& pose, const Pose2& expected) {
  EXPECT_NEAR(pose.x, expected.x, 1e-12);
  EXPECT_NEAR(pose.y, expected.y, 1e-12);
  EXPECT_NEAR(angle_difference(pose.yaw, expected.yaw), 0.0, 1e-12);
}

// A robot that drives a metre a second along x while its wheels tell that it drives along a circle. After each scan the
// log puts the odometry back to the scan's pose.
const char* const kCorrected =
    "# message formats defined: PARAM SYNC ODOM FLASER\n"
    "PARAM robot_frontlaser_offset -0.04 host 0\n"
    "ODOM 5 5 5 0 0 0 0.5 host 0.5\n"
    "FLASER 4 1 2 3 4 0 0 0 0 0 0 1 host 1\n"
    "ODOM 0 0 0 0 0 0 1e-72 host 0\n"
    "NEFF 10\n"
    "ODOM 0.5 0 0.1 0 0 0 1.5 host 1.5\n"
    "ODOM 1 0 0.25 0 0 0 2 host 2\n"
    "FLASER 4 5 6 7 8 1 0 0 1 0 0 2 host 2\n"
    "ODOM 1 0 0 junk junk junk nan host 0\n"
    "ODOM 2 0 0.25 0 0 0 3 host 3\n"
    "FLASER 4 9 9 9 81.83 2 0 0 2 0 0 3 host 3\n"
    "ODOM 2 0 0 0 0 0 0 host 0\n";

TEST(CarmenLogTest, KeepsScansWithTheirRangesAndPoses) {
  const CarmenLog log = parse(kCorrected);
  EXPECT_EQ(log.name, "a.log");
  ASSERT_EQ(log.scans.size(), 3u);
  EXPECT_THAT(log.scan_ranges(0), ElementsAre(1.f, 2.f, 3.f, 4.f));
  EXPECT_THAT(log.scan_ranges(2), ElementsAre(9.f, 9.f, 9.f, 81.83f));
  for (std::size_t i = 0; i < 3; ++i) {
    const CarmenRecord& record = log.records[log.scans[i]];
    EXPECT_EQ(record.scan, i);
    EXPECT_EQ(record.stamp, 1.0 + static_cast<double>(i));
    EXPECT_EQ(record.pose, (Pose2{static_cast<double>(i), 0.0, 0.0}));
  }
  EXPECT_EQ(log.duration(), 2.0);
  EXPECT_EQ(log.laser_offset, -0.04);
}

TEST(CarmenLogTest, RecoversTheWheelsFromALogThatWasCorrected) {
  const CarmenLog log = parse(kCorrected);
  ASSERT_EQ(log.records.size(), 4u) << "what is said at a scan is the scan's, and the resets are no motion";
  EXPECT_EQ(log.records[1].scan, std::nullopt);
  expect_pose(log.records[0].odometry, {});
  expect_pose(log.records[1].odometry, {0.5, 0.0, 0.1});
  const Pose2 step{1.0, 0.0, 0.25};
  expect_pose(log.records[2].odometry, step);
  expect_pose(log.records[3].odometry, step * step);
}

TEST(CarmenLogTest, CarriesThePosesOnBetweenScans) {
  const CarmenLog log = parse(kCorrected);
  EXPECT_EQ(log.records[1].stamp, 1.5);
  expect_pose(log.records[1].pose, {0.5, 0.0, 0.1});
}

TEST(CarmenLogTest, TakesTheWheelsOfARawLogFromItsOdometryColumns) {
  const CarmenLog log = parse(
      "FLASER 2 1 1 10 0 1.5707963267948966 3 0 0 1 host 1\n"
      "ODOM 3.5 0 0 0 0 0 1.5 host 1.5\n"
      "FLASER 2 1 1 10 2 1.5707963267948966 4 0 0.5 2 host 2\n");
  ASSERT_EQ(log.records.size(), 3u);
  expect_pose(log.records[1].odometry, {0.5, 0.0, 0.0});
  expect_pose(log.records[1].pose, {10.0, 0.5, kPi / 2});
  expect_pose(log.records[2].odometry, {1.0, 0.0, 0.5});
  expect_pose(log.records[2].pose, {10.0, 2.0, kPi / 2});
}

TEST(CarmenLogTest, TrustsTheOrderOfTheFileMoreThanLateStamps) {
  const CarmenLog log = parse(
      "FLASER 2 1 1 0 0 0 0 0 0 1 host 1\n"
      "ODOM 0.1 0 0 0 0 0 1.9 host 1.9\n"
      "ODOM 0.2 0 0 0 0 0 1.4 host 1.4\n"
      "FLASER 2 1 1 1 0 0 1 0 0 2 host 2\n");
  ASSERT_EQ(log.records.size(), 4u);
  EXPECT_EQ(log.late, 1u);
  EXPECT_EQ(log.records[1].stamp, 1.4);
  EXPECT_EQ(log.records[2].stamp, 1.4);
  EXPECT_EQ(log.records[1].logged_stamp, 1.9);
  const std::vector<StampedPose> logged = at_logged_stamps(log, logged_poses(log));
  ASSERT_EQ(logged.size(), 4u);
  EXPECT_EQ(logged[1].stamp, 1.4);
  expect_pose(logged[1].pose, {0.2, 0.0, 0.0});
  EXPECT_EQ(logged[2].stamp, 1.9);
  expect_pose(logged[2].pose, {0.1, 0.0, 0.0});
}

std::string log_of_beams(int beams, const std::string& before = "") {
  std::string text = before + "FLASER " + std::to_string(beams);
  for (int i = 0; i < beams; ++i) text += " 1";
  return text + " 0 0 0 0 0 0 1 host 1\n";
}

TEST(CarmenLogTest, SpreadsBeamsOver180DegreesFromTheRightOn) {
  for (const auto& [beams, degrees_between] : {std::pair{180, 1.0}, {181, 1.0}, {360, 0.5}, {361, 0.5}}) {
    const LidarModel lidar = parse(log_of_beams(beams)).lidar;
    EXPECT_EQ(lidar.beams, beams);
    EXPECT_DOUBLE_EQ(degrees(lidar.angle_min), -90.0);
    EXPECT_DOUBLE_EQ(degrees(lidar.angle_increment), degrees_between) << beams;
    EXPECT_EQ(lidar.mount, Pose2{});
    EXPECT_EQ(lidar.max_range, 80.0);
  }
}

TEST(CarmenLogTest, BelievesWhatItsParametersSayOfTheLaser) {
  const LidarModel lidar = parse(log_of_beams(181,
                                              "PARAM laser_front_laser_resolution 0.25 host 0\n"
                                              "PARAM robot_front_laser_max 31.5 host 0\n"))
                               .lidar;
  EXPECT_DOUBLE_EQ(degrees(lidar.angle_increment), 0.25);
  EXPECT_EQ(lidar.max_range, 31.5);
}

TEST(CarmenLogTest, ReadsWhatGzipPacked) {
  const CarmenLog log = parse_carmen_log(packed(kCorrected), "a.log.gz");
  EXPECT_EQ(log.scans.size(), 3u);
  std::vector<std::uint8_t> two = packed(log_of_beams(5));
  const std::vector<std::uint8_t> second = packed(log_of_beams(5));
  two.insert(two.end(), second.begin(), second.end());
  EXPECT_EQ(parse_carmen_log(two, "two.gz").scans.size(), 2u) << "members are one text";
}

TEST(CarmenLogTest, ReadsTheSameFromAFile) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.log", kCorrected);
  EXPECT_EQ(read_carmen_log(path).name, path.string());
  EXPECT_THAT(message_of([&] { read_carmen_log(folder / "none.log"); }), HasSubstr("none.log: cannot read"));
}

TEST(CarmenLogTest, SaysWhereALogIsWrong) {
  EXPECT_EQ(complaint("# nothing\n\nFLASER 2 1 far 0 0 0 0 0 0 1 h 1\n"),
            "a.log:3: field 4: range is \"far\"; want a number");
  EXPECT_EQ(complaint("FLASER 2 1 inf 0 0 0 0 0 0 1 h 1\n"), "a.log:1: field 4: range is \"inf\"; want a number");
  EXPECT_EQ(complaint("FLASER 2 1 2 0 0\n"), "a.log:1: field 7: theta is missing; want a number");
  EXPECT_EQ(complaint("FLASER -1\n"), "a.log:1: field 2: number of readings is \"-1\"; want a whole number");
  EXPECT_EQ(complaint("FLASER 1 1\n"), "a.log:1: FLASER of 1 readings; want 2 or more");
  EXPECT_EQ(complaint(log_of_beams(4) + log_of_beams(5)),
            "a.log:2: FLASER of 5 readings; want 4, as in the scans before");
  EXPECT_EQ(complaint(log_of_beams(4) + "ODOM 1 2 3 4 5 6\n"), "a.log:2: field 8: stamp is missing; want a number");
  EXPECT_EQ(complaint("PARAM robot_front_laser_max 0 h 1\n"),
            "a.log:1: robot_front_laser_max is 0; want a positive length");
  EXPECT_EQ(complaint(""), "a.log: no FLASER record; want a CARMEN log with scans");
}

TEST(CarmenLogTest, RefusesPosesBeyondAnyBuildingAndStampsBeyondAnyClock) {
  EXPECT_EQ(complaint("FLASER 2 1 1 1e300 0 0 0 0 0 1 h 1\n"), "a.log:1: field 5: x is 1e+300; want -1000 to 1000");
  EXPECT_EQ(complaint("FLASER 2 1 1 0 0 0 0 -1001 0 1 h 1\n"), "a.log:1: field 9: odom_y is -1001; want -1000 to 1000");
  EXPECT_THAT(complaint("FLASER 2 1 1 0 0 1e300 0 0 0 1 h 1\n"), HasSubstr("field 7: theta is 1e+300; want"));
  EXPECT_THAT(complaint("FLASER 2 1 1 0 0 0 0 0 0 1e300 h 1\n"), HasSubstr("field 11: stamp is 1e+300; want"));
  EXPECT_THAT(complaint(log_of_beams(4) + "ODOM 1 -1e9 3 4 5 6 7 h 1\n"), HasSubstr("a.log:2: field 3: y is -1e+09"));
  EXPECT_THAT(complaint(log_of_beams(4) + "ODOM 1 2 3 4 5 6 -1e12 h 1\n"),
              HasSubstr("field 8: stamp is -1e+12; want -1e+11 to 1e+11"));
  EXPECT_THAT(complaint("PARAM robot_frontlaser_offset 1e300 h 1\n"), HasSubstr("robot_frontlaser_offset is 1e+300"));
}

TEST(CarmenLogTest, SaysThatAPackedFileIsCutOrDamaged) {
  const std::vector<std::uint8_t> whole = packed(kCorrected);
  for (std::size_t size = 2; size < whole.size(); ++size) {
    const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THAT(message_of([&] { parse_carmen_log(cut, "cut.gz"); }), HasSubstr("cut.gz: cut:")) << size;
  }
  std::vector<std::uint8_t> damaged = whole;
  damaged[whole.size() - 5] ^= 1;  // its checksum
  EXPECT_THAT(message_of([&] { parse_carmen_log(damaged, "bad.gz"); }), HasSubstr("bad.gz: damaged:"));
}

TEST(CarmenLogTest, RefusesWhatWouldFillTheMemory) {
  const std::string megabyte(1 << 20, '\n');
  std::vector<std::uint8_t> bomb;
  const std::vector<std::uint8_t> member = packed(megabyte);
  for (int i = 0; i < 257; ++i) bomb.insert(bomb.end(), member.begin(), member.end());
  EXPECT_EQ(message_of([&] { parse_carmen_log(bomb, "bomb.gz"); }), "bomb.gz: more than 256 MiB of text; want less");
}

}  // namespace
}  // namespace scrubjay

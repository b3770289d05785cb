#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/trajectory_file.hpp>

namespace scrubjay {
namespace {

using testing::HasSubstr;

TEST(TrajectoryFileTest, WritesAPoseALine) {
  const std::vector<StampedPose> trajectory{{0.0, {}}, {0.015, {1.5, -0.25, radians(90.0)}}};
  EXPECT_EQ(trajectory_text(trajectory),
            "0.000000000 0.000000 0.000000 0 0 0 0.000000000 1.000000000\n"
            "0.015000000 1.500000 -0.250000 0 0 0 0.707106781 0.707106781\n");
}

TEST(TrajectoryFileTest, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  std::vector<StampedPose> trajectory;
  for (int i = 0; i <= 72; ++i) {
    trajectory.push_back({i * 15000000 / 1e9, {0.001 * i * i, -0.5 * i, wrap_angle(radians(5.0 * i))}});
  }
  write_trajectory(folder / "t.tum", trajectory);
  const std::vector<StampedPose> again = read_trajectory(folder / "t.tum");
  ASSERT_EQ(again.size(), trajectory.size());
  for (std::size_t i = 0; i < again.size(); ++i) {
    EXPECT_EQ(again[i].stamp, trajectory[i].stamp) << "whole nanoseconds come back exactly";
    EXPECT_NEAR(again[i].pose.x, trajectory[i].pose.x, 1e-6);
    EXPECT_NEAR(again[i].pose.y, trajectory[i].pose.y, 1e-6);
    EXPECT_NEAR(angle_difference(again[i].pose.yaw, trajectory[i].pose.yaw), 0.0, 1e-8);
  }
}

TEST(TrajectoryFileTest, TakesCommentsBlanksTiltAndAMissingLastLineEnd) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("t.tum", "# stamp x y z qx qy qz qw\n\n \t\r\n1e3\t1 2 3  0 0 1 0\r\n2 4 5 6 0.5 0.5 0.5 0.5");
  const auto trajectory = read_trajectory(path);
  ASSERT_EQ(trajectory.size(), 2u);
  EXPECT_EQ(trajectory[0].stamp, 1000.0);
  EXPECT_NEAR(std::abs(trajectory[0].pose.yaw), kPi, 1e-12);
  EXPECT_NEAR(trajectory[1].pose.yaw, radians(90.0), 1e-12);
}

TEST(TrajectoryFileTest, TellsTheLineThatIsBroken) {
  const TemporaryFolder folder;
  for (const std::string bad :
       {"1 2 3", "1 2 3 4 5 6 7 8 9", "1 2 3 4 5 6 7 eight", "1 2 3 4 5 6 nan 8", "1 2 3 4 5 6 7 8x"}) {
    const auto path = folder.write("t.tum", "# one\n1 0 0 0 0 0 0 1\n" + bad + "\n");
    EXPECT_THAT(message_of([&] { read_trajectory(path); }), HasSubstr("t.tum:3: want eight numbers")) << bad;
  }
}

}  // namespace
}  // namespace scrubjay

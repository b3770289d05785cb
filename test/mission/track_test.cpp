#include <gmock/gmock.h>

#include <scrubjay/mission/track.hpp>

#include "fakes.hpp"

namespace scrubjay::test {
namespace {

/// Shows `track` a tick.
void show(Track& track, double stamp, const Pose2& pose, bool bumped = false) {
  Frame frame;
  frame.stamp = stamp;
  frame.bump_right = bumped;
  PoseEstimate estimate;
  estimate.pose = pose;
  const Decision decision;
  track.notify({frame, estimate, {}, decision});
}

TEST(TrackTest, KeepsTenPosesASecond) {
  Track track;
  for (int i = 0; i <= 4000; ++i) show(track, 7.0 + 0.015 * i, {0.01 * i, 0.0, 0.0});
  ASSERT_FALSE(track.points().empty());
  EXPECT_EQ(track.points().front(), (StampedPose{7.0, {}}));
  for (std::size_t i = 1; i < track.points().size(); ++i) {
    const double step = track.points()[i].stamp - track.points()[i - 1].stamp;
    EXPECT_GE(step, 0.1 - 1e-9);
    EXPECT_LT(step, 0.1 + 0.015);
  }
}

TEST(TrackTest, KeepsThePoseOfItsTime) {
  Track track;
  for (int i = 0; i <= 100; ++i) show(track, 0.1 * i, {0.01 * i, -0.02 * i, 0.001 * i});
  ASSERT_EQ(track.points().size(), 101u) << "frames that come ten times a second are kept all";
  EXPECT_EQ(track.points()[37], (StampedPose{0.1 * 37, {0.01 * 37, -0.02 * 37, 0.001 * 37}}));
}

TEST(TrackTest, KeepsWhereEachBumpBegan) {
  Track track;
  for (int i = 0; i < 30; ++i) show(track, 0.015 * i, {0.01 * i, 0.0, 0.0}, i == 3 || (i >= 10 && i < 20));
  EXPECT_THAT(track.bumps(), ::testing::ElementsAre(Pose2{0.03, 0.0, 0.0}, Pose2{0.1, 0.0, 0.0}));
}

TEST(TrackTest, KeepsEveryFrameWhenAskedTo) {
  Track track(0.0);
  for (const double stamp : {1.0, 1.001, 1.001, 2.0}) show(track, stamp, {stamp, 0.0, 0.0});
  EXPECT_EQ(track.points().size(), 4u);
}

}  // namespace
}  // namespace scrubjay::test

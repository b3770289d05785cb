#include <gtest/gtest.h>

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/world/relation_error.hpp>
#include <vector>

namespace scrubjay {
namespace {

TEST(PoseAtTest, LiesBetweenThePosesBeforeAndAfter) {
  const StampedPose track[] = {{0.0, {0, 0, 3.0}}, {1.0, {2, 4, -3.0}}, {2.0, {2, 4, 0.0}}};
  const auto pose = pose_at(track, 0.25);
  ASSERT_TRUE(pose);
  EXPECT_DOUBLE_EQ(pose->x, 0.5);
  EXPECT_DOUBLE_EQ(pose->y, 1.0);
  EXPECT_NEAR(pose->yaw, 3.0 + 0.25 * (2.0 * kPi - 6.0), 1e-12);
  EXPECT_EQ(pose_at(track, 1.0), track[1].pose);
  EXPECT_EQ(pose_at(track, 2.0), track[2].pose);
}

TEST(PoseAtTest, IsNowhereOutsideOfTheTrajectoryAndInItsGaps) {
  const StampedPose track[] = {{0.0, {}}, {1.0, {}}, {1.0 + kLongestGap + 0.1, {}}};
  EXPECT_FALSE(pose_at(track, -0.1));
  EXPECT_FALSE(pose_at(track, 2.0));
  EXPECT_FALSE(pose_at(track, 9.0));
  EXPECT_TRUE(pose_at(track, 0.5));
  EXPECT_FALSE(pose_at({}, 0.0));
}

TEST(RelationErrorTest, TakesMeanDeviationAndMaximumOfBothErrors) {
  const StampedPose track[] = {{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}, {2.0, {1, 1, kPi / 2}}};
  const Relation relations[] = {{10.0, 11.0, {1.3, 0.4, 0.1}},        // 0.5 m and 0.1 rad off
                                {11.0, 12.0, {0.0, 1.0, kPi / 2}},    // right
                                {12.0, 10.0, {-1.0, 1.0, -kPi / 2}},  // right, and back in time
                                {12.0, 15.0, {0.0, 0.0, 0.0}}};       // ends after the trajectory
  const RelationError error = relation_error(track, relations, 10.0);
  EXPECT_EQ(error.relations, 4u);
  EXPECT_EQ(error.matched, 3u);
  EXPECT_EQ(error.offset, 10.0);
  EXPECT_NEAR(error.translation.mean, 0.5 / 3.0, 1e-12);
  EXPECT_NEAR(error.translation.max, 0.5, 1e-12);
  EXPECT_NEAR(error.translation.deviation, std::sqrt(0.25 / 3.0 - 0.25 / 9.0), 1e-12);
  EXPECT_NEAR(error.translation_squared.mean, 0.25 / 3.0, 1e-12);
  EXPECT_NEAR(error.translation_squared.max, 0.25, 1e-12);
  EXPECT_NEAR(error.rotation.mean, 0.1 / 3.0, 1e-12);
  EXPECT_NEAR(error.rotation_squared.max, 0.01, 1e-12);
}

TEST(RelationErrorTest, IsTheSameWhereverTheTrajectoryBegins) {
  const Relation relations[] = {{0.0, 1.0, {0.9, 0.1, 0.2}}, {0.0, 2.0, {2.0, 0.3, 0.4}}};
  std::vector<StampedPose> track{{0.0, {0, 0, 0}}, {1.0, {1, 0, 0.1}}, {2.0, {2, 0.5, 0.5}}};
  const RelationError here = relation_error(track, relations, 0.0);
  for (StampedPose& at : track) at.pose = Pose2{-30.0, 12.0, 2.5} * at.pose;
  const RelationError there = relation_error(track, relations, 0.0);
  EXPECT_NEAR(here.translation.mean, there.translation.mean, 1e-12);
  EXPECT_NEAR(here.rotation.deviation, there.rotation.deviation, 1e-12);
}

/// A drive of ten minutes with turns of all kinds and a few stops, five poses a second.
std::vector<StampedPose> some_drive(std::uint64_t seed) {
  Random random(seed);
  std::vector<StampedPose> track;
  Pose2 pose;
  Twist2 twist;
  for (int i = 0; i < 3000; ++i) {
    if (i % 15 == 0) twist = {random.uniform() < 0.2 ? 0.0 : 0.4 * random.uniform(), 0.0, random.uniform() - 0.5};
    track.push_back({100.0 + 0.2 * i, pose});
    pose = pose * Pose2{0.2 * twist.linear, 0.0, 0.2 * twist.angular};
  }
  return track;
}

/// Relations of a drive by another clock, a few centimetres off; every `wrong`th is nonsense.
std::vector<Relation> some_relations(const std::vector<StampedPose>& track, double offset, std::size_t wrong) {
  Random random(99);
  std::vector<Relation> relations;
  for (std::size_t i = 0; i + 40 < track.size(); i += 9) {
    const StampedPose& from = track[i];
    const StampedPose& to = track[i + 5 + i % 30];
    Pose2 motion = inverse(from.pose) * to.pose * Pose2{0.02 * random.uniform(), 0.02 * random.uniform(), 0.0};
    if (relations.size() % wrong == 0)
      motion = {5.0 * random.uniform(), 5.0 * random.uniform(), 6.0 * random.uniform()};
    relations.push_back({from.stamp + offset, to.stamp + offset, motion});
  }
  return relations;
}

TEST(RelationOffsetTest, FindsTheClockOfTheRelationsByTheMotion) {
  for (const double offset : {976052857.34, -3.217, 0.0}) {
    const std::vector<StampedPose> track = some_drive(1);
    const auto found = relation_offset(track, some_relations(track, offset, 1000));
    ASSERT_TRUE(found) << offset;
    EXPECT_NEAR(*found, offset, 0.03);
  }
}

TEST(RelationOffsetTest, IsNotMisledByRelationsThatAreWrong) {
  const std::vector<StampedPose> track = some_drive(2);
  const auto found = relation_offset(track, some_relations(track, 50.0, 4));
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 50.0, 0.03);
}

TEST(RelationOffsetTest, FindsATrajectoryThatIsOnlyPartOfTheDrive) {
  const std::vector<StampedPose> track = some_drive(3);
  const std::vector<Relation> relations = some_relations(track, 7.0, 1000);
  const std::vector<StampedPose> part(track.begin() + 500, track.end() - 500);
  const auto found = relation_offset(part, relations);
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 7.0, 0.03);
}

TEST(RelationOffsetTest, IsNoneForRelationsOfAnotherDriveOrWithoutMotion) {
  const std::vector<StampedPose> track = some_drive(4);
  EXPECT_FALSE(relation_offset(track, some_relations(some_drive(5), 0.0, 1000)));
  EXPECT_FALSE(relation_offset({}, some_relations(track, 0.0, 1000)));
  EXPECT_FALSE(relation_offset(track, {}));
  const Relation still[] = {{100.0, 101.0, {}}};
  EXPECT_FALSE(relation_offset(track, still));
}

}  // namespace
}  // namespace scrubjay

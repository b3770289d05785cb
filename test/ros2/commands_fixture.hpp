/// \file
/// Commands, messages for them, and what became of these.
#pragma once

#include <gtest/gtest.h>

#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/conversions.hpp>
#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/ros2/commands.hpp>

namespace scrubjay::ros {

inline constexpr CommandLimits kLimits{0.5, 2.0};

inline Bytes twist(double linear, double angular) {
  Twist message;
  message.linear.x = linear;
  message.angular.z = angular;
  return encode(message);
}

inline Bytes twist_stamped(double linear, double angular) {
  TwistStamped message;
  message.header.frame_id = "base_link";
  message.twist.linear.x = linear;
  message.twist.angular.z = angular;
  return encode(message);
}

inline Pose pose_at(double x, double y, const Quaternion& turn) {
  Pose pose;
  pose.position.x = x;
  pose.position.y = y;
  pose.orientation = turn;
  return pose;
}

inline Bytes goal(const Pose& pose, const std::string& frame = "map") {
  PoseStamped message;
  message.header.frame_id = frame;
  message.pose = pose;
  return encode(message);
}

inline Bytes initial_pose(const Pose& pose, const std::string& frame = "map", double covariance = 0.25) {
  PoseWithCovarianceStamped message;
  message.header.frame_id = frame;
  message.pose.pose = pose;
  message.pose.covariance[7] = covariance;
  return encode(message);
}

inline Bytes song(std::uint8_t slot, std::uint8_t length, std::vector<std::uint8_t> notes,
                  std::vector<float> durations) {
  return encode(DefineSong{slot, length, std::move(notes), std::move(durations)});
}

inline Bytes octets(std::vector<std::uint8_t> data) {
  UInt8MultiArray message;
  message.data = std::move(data);
  return encode(message);
}

/// What goes over the robot's wire for each of them.
inline std::vector<std::vector<int>> as_bytes(const std::vector<oi::Command>& commands) {
  std::vector<std::vector<int>> all;
  for (const oi::Command& command : commands) {
    const oi::CommandBytes bytes = oi::encode(command);
    all.emplace_back(bytes.bytes().begin(), bytes.bytes().end());
  }
  return all;
}

inline std::vector<oi::Command> all_orders(Commands& commands) {
  std::vector<oi::Command> all;
  while (const auto order = commands.next_order()) all.push_back(*order);
  return all;
}

class CommandsTest : public ::testing::Test {
 protected:
  /// Since it was asked last.
  CommandTally counted() {
    const CommandTally now = commands.tally();
    const CommandTally since{now.taken - before_.taken, now.malformed - before_.malformed,
                             now.out_of_range - before_.out_of_range, now.other_frame - before_.other_frame};
    before_ = now;
    return since;
  }
  void expect_taken() { expect_counts({1, 0, 0, 0}); }
  void expect_malformed() { expect_counts({0, 1, 0, 0}); }
  void expect_out_of_range() { expect_counts({0, 0, 1, 0}); }
  void expect_other_frame() { expect_counts({0, 0, 0, 1}); }
  void expect_nothing_wanted() {
    const Wishes wishes = commands.wishes();
    EXPECT_FALSE(wishes.dock);
    EXPECT_FALSE(wishes.velocity);
    EXPECT_FALSE(wishes.goal);
    EXPECT_FALSE(commands.initial_pose());
    EXPECT_FALSE(commands.next_order());
  }

  std::optional<Motion> velocity() { return commands.wishes().velocity; }
  std::vector<oi::Command> orders() { return all_orders(commands); }
  void forget() {
    (void)commands.wishes();
    (void)commands.initial_pose();
    (void)orders();
  }

  Commands commands{kLimits};

 private:
  void expect_counts(const CommandTally& expected) {
    const CommandTally since = counted();
    EXPECT_EQ(since.taken, expected.taken);
    EXPECT_EQ(since.malformed, expected.malformed);
    EXPECT_EQ(since.out_of_range, expected.out_of_range);
    EXPECT_EQ(since.other_frame, expected.other_frame);
  }
  CommandTally before_;
};

}  // namespace scrubjay::ros

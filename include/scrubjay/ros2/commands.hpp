/// \file
/// What others want of the robot: checked, limited, and kept until the control loop takes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/robot/motion.hpp>
#include <span>
#include <utility>
#include <vector>

namespace scrubjay::ros {

struct CommandLimits {
  double linear = 0.5;    ///< what is faster is slowed down to it, the curve kept [m/s] ...
  double angular = 4.25;  ///< ... or [rad/s]
};

struct CommandTally {
  std::uint64_t taken = 0;
  std::uint64_t malformed = 0;     ///< bytes that are no such message
  std::uint64_t out_of_range = 0;  ///< not finite, or what no robot on a floor can do, or no such song
};

/// Bytes come in from any thread; the control loop asks what came. Nothing that is refused changes anything.
///
/// The topics are those of nav2 and rviz (cmd_vel, goal_pose, initialpose) and of create_robot (the others).
class Commands {
 public:
  explicit Commands(const CommandLimits& limits) : limits_(limits) {}

  using Bytes = std::span<const std::byte>;
  void take_twist(Bytes message);
  void take_twist_stamped(Bytes message);
  void take_goal(Bytes message);          ///< geometry_msgs/PoseStamped in the map's frame
  void take_initial_pose(Bytes message);  ///< geometry_msgs/PoseWithCovarianceStamped in the map's frame
  void take_dock(Bytes message);
  void take_undock(Bytes message);
  void take_song(Bytes message);  ///< create_msgs/DefineSong
  void take_play(Bytes message);  ///< create_msgs/PlaySong
  /// std_msgs/Bool for one of oi::Leds' bits.
  void take_led(std::uint8_t bit, Bytes message);
  void take_power_led(Bytes message);  ///< std_msgs/UInt8MultiArray: color, and maybe intensity
  void take_digits(Bytes message);     ///< std_msgs/UInt8MultiArray: up to four characters

  /// The newest of each kind since it was last asked for.
  std::optional<Motion> velocity() { return take(velocity_); }
  std::optional<Pose2> goal() { return take(goal_); }
  std::optional<Pose2> initial_pose() { return take(initial_pose_); }
  /// What is to be said to the robot, in the order in which it came; never more than 32.
  std::vector<oi::Command> orders();
  CommandTally tally() const;

 private:
  template <class T>
  std::optional<T> take(std::optional<T>& slot) {
    const std::lock_guard lock(mutex_);
    return std::exchange(slot, std::nullopt);
  }
  void take_velocity(double linear, double angular);
  void take_pose(const Pose& pose, std::optional<Pose2>& slot);
  void order(const oi::Command& command);
  /// As they were ordered last, and this changed.
  void order_leds(const std::function<void(oi::Leds&)>& change);
  bool append(const oi::Command& command);  // with the mutex held; false if there are too many
  void refuse(std::uint64_t CommandTally::*why);

  CommandLimits limits_;
  mutable std::mutex mutex_;  // of all that follows
  std::optional<Motion> velocity_;
  std::optional<Pose2> goal_;
  std::optional<Pose2> initial_pose_;
  std::vector<oi::Command> orders_;
  oi::Leds leds_{.power_color = 0, .power_intensity = 255};
  CommandTally tally_;
};

}  // namespace scrubjay::ros

/// \file
/// What others want of the robot: checked, limited, and kept until the control loop takes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/messages/geometry_msgs.hpp>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/robot/motion.hpp>
#include <span>
#include <string>
#include <utility>

namespace scrubjay::ros {

struct CommandLimits {
  double linear = 0.5;    ///< what is faster is slowed down to it, the curve kept [m/s] ...
  double angular = 4.25;  ///< ... or [rad/s]
};

struct CommandTally {
  std::uint64_t taken = 0;
  std::uint64_t malformed = 0;     ///< bytes that are no such message
  std::uint64_t out_of_range = 0;  ///< not finite, or what no robot on a floor can do, or no such song; or too many
  std::uint64_t other_frame = 0;   ///< poses that aren't in the map's frame
};

/// Where the robot is to drive: the newest of each kind.
struct Wishes {
  bool dock = false;  ///< what was wanted before is over; the rest came later
  std::optional<Motion> velocity{};
  std::optional<Pose2> goal{};
  bool goal_is_newer = false;  ///< of the two
};

/// Bytes come in from any thread; the control loop asks what came. Nothing that is refused changes anything.
///
/// The topics are those of nav2 and rviz (cmd_vel, goal_pose, initialpose) and of create_robot (the others). What nav2
/// refuses is refused: poses in no frame, and any that holds what isn't a number.
class Commands {
 public:
  /// Is given, once, a line about a pose in another frame than the map's, from the thread that brought it.
  using Tell = std::function<void(const std::string& line)>;

  /// A pose farther than this from the map's origin, along either axis, is refused: the map would grow to it [m].
  static constexpr double kReach = 100.0;
  /// Orders that wait; one more is refused.
  static constexpr std::size_t kMostOrders = 32;

  explicit Commands(const CommandLimits& limits, Tell tell = nullptr) : limits_(limits), tell_(std::move(tell)) {}

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

  /// Since they were asked for last.
  Wishes wishes();
  /// The newest since it was asked for last.
  std::optional<Pose2> initial_pose();
  /// The next thing to be said to the robot, in the order in which they came.
  std::optional<oi::Command> next_order();
  CommandTally tally() const;

 private:
  void take_velocity(const Twist& twist);
  /// None if it is refused.
  std::optional<Pose2> place(const Header& header, const Pose& pose, const char* topic);
  void order(const oi::Command& command);
  /// As they were ordered last, and this changed.
  void order_leds(const std::function<void(oi::Leds&)>& change);
  bool append(const oi::Command& command);  // with the mutex held; false if there are too many
  void refuse(std::uint64_t CommandTally::*why);
  void refuse_frame(const char* topic);

  CommandLimits limits_;
  Tell tell_;
  mutable std::mutex mutex_;  // of all that follows
  Wishes wishes_;
  std::optional<Pose2> initial_pose_;
  std::deque<oi::Command> orders_;
  oi::Leds leds_{.power_color = 0, .power_intensity = 255};
  CommandTally tally_;
};

}  // namespace scrubjay::ros

/// \file
/// All that a mission knows, as messages at their times.
#pragma once

#include <optional>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/messages/conversions.hpp>
#include <scrubjay/messages/log_queue.hpp>
#include <scrubjay/messages/message_sink.hpp>
#include <scrubjay/messages/room_markers.hpp>
#include <scrubjay/mission/observer.hpp>
#include <string>
#include <vector>

namespace scrubjay::ros {

/// A part of the robot that is fixed to another one.
struct FixedLink {
  std::string parent;
  std::string name;
  Transform pose;  ///< on the parent
};

/// A wheel, which turns about its y axis.
struct WheelLink {
  std::string joint;
  FixedLink link;
};

struct PublicationParams {
  std::string node = "/scrubjay";  ///< full name of the node that speaks
  FrameNames frames{};
  std::string description{};        ///< URDF of the robot; empty: none is published
  std::string scenario{};           ///< YAML: all that is needed to repeat the run; empty: none is published
  std::vector<FixedLink> fixed{};   ///< the lidar aside, whose place is the robot model's
  std::optional<WheelLink> left{};  ///< none: no joint states
  std::optional<WheelLink> right{};
  std::optional<std::int64_t> epoch{};  ///< time of stamp 0 [ns]; none: the system has it at the first frame
  bool simulated = false;               ///< /clock is published, and its time is everybody's
  double map_interval = 5.0;            ///< between two whole maps, unless it grew [s]
  double map_update_interval = 1.0;     ///< between two updates of what changed [s]
  double rooms_interval = 10.0;         ///< between two maps that are split into rooms, at least, as often as they have
                                        ///< kRoomsSize cells, and once more [s]
  double path_interval = 10.0;          ///< of the path, which is told whole and grows [s]
  double slow_interval = 1.0;           ///< of battery, mode and diagnostics, unless they changed [s]
  LogQueue* log = nullptr;              ///< whose lines go to /rosout, too; must outlive it
};

/// Publishes, at every frame, odometry, transforms and what the robot senses; a map whole when it grew and every few
/// seconds, and what changed of it in between; the rooms of a whole map, where they aren't those of the last; what is
/// slow, once a second or when it changes. What the robot does, and what is told by log(), goes to /rosout.
///
/// `odom` is dead reckoning, which never jumps; what the localizer knows better is between `map` and `odom` (REP-105).
class Publications final : public Observer {
 public:
  /// A map so large takes some 10 ms to split.
  static constexpr std::size_t kRoomsSize = 250'000;  // [cells]

  /// The sinks must outlive it.
  Publications(const RobotModel& robot, PublicationParams params, std::vector<MessageSink*> sinks);

  void notify(const Snapshot& now) override;
  /// The map as the mission left it, and where it went: what came after the last notify() of it, too.
  void finish(GridView<const LogOdds> map);
  /// A line for /rosout, from any thread; the next notify() or finish() publishes it. Levels: Log's.
  void log(std::uint8_t level, const std::string& text);

 private:
  template <Message M>
  void publish(const Topic<M>& topic, const M& message);
  std::int64_t nanoseconds(double stamp) const;
  Header header(const std::string& frame) const { return {time_from_nanoseconds(now_), frame}; }
  void begin();
  void publish_constants();
  void publish_transforms(const Snapshot& now);
  void publish_wheels();
  void publish_senses(const Snapshot& now);
  void publish_states(const Snapshot& now);
  void publish_battery(const Battery& battery);
  void publish_diagnostics(const Snapshot& now);
  void publish_map(const Snapshot& now);
  void publish_whole_map(GridView<const LogOdds> map);
  void publish_rooms(GridView<const LogOdds> map);
  void publish_ways(const Snapshot& now);
  LogQueue& lines() { return params_.log != nullptr ? *params_.log : log_; }
  void log_changes(const Snapshot& now);
  void publish_log();
  bool is_due(double& last, double interval) const;

  RobotModel robot_;
  PublicationParams params_;
  std::vector<MessageSink*> sinks_;
  DeadReckoning odometry_;

  bool begun_ = false;
  double stamp_ = 0.0;      // of the frame at hand [s]
  std::int64_t epoch_ = 0;  // [ns]
  std::int64_t now_ = 0;    // the same by the clock of all [ns]
  double left_angle_ = 0.0;
  double right_angle_ = 0.0;

  // What was published last, and when [s].
  double slow_stamp_;
  double path_stamp_;
  double ways_stamp_;
  double map_stamp_;
  double map_update_stamp_;
  double rooms_stamp_;
  std::optional<Frame> last_frame_;
  GridGeometry map_geometry_;
  CellRect map_cells_;          // of the map, that were published
  CellRect pending_change_;     // of it, since then
  bool rooms_pending_ = false;  // a whole map was published since they were looked for
  RoomMap rooms_;
  std::vector<Point2> plan_;
  std::vector<Pose2> path_;
  std::string doing_;
  LogQueue log_;  // unless there is another one
};

}  // namespace scrubjay::ros

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <scrubjay/messages/diagnostics.hpp>
#include <scrubjay/messages/publications.hpp>

namespace scrubjay::ros {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kPathStep = 0.05;      // between two poses of the path [m]
constexpr double kFrontierSize = 0.05;  // of a point [m]
constexpr double kSilence = 1.0;        // of a robot that sends 66 frames a second, worth a line [s]

/// As rcl names the logger of a node (rcl/logging_rosout.c): `/robot1/scrubjay` is `robot1.scrubjay`.
std::string logger_name(std::string node) {
  node.erase(0, 1);
  std::ranges::replace(node, '/', '.');
  return node;
}

bool is_battery_changed(const Battery& a, const Battery& b) {
  return a.charger != b.charger;
}

/// The smallest rectangle with all cells of a map that hold any evidence.
CellRect evidence_in(GridView<const LogOdds> map) {
  CellRect cells;
  for (std::int32_t y = 0; y < map.geometry.height; ++y) {
    const LogOdds* row = map.cells + static_cast<std::size_t>(y) * static_cast<std::size_t>(map.geometry.width);
    const LogOdds* end = row + map.geometry.width;
    const LogOdds* first = std::find_if(row, end, [](LogOdds cell) { return cell != 0; });
    if (first == end) continue;
    const auto* last = end;
    while (last[-1] == 0) --last;
    cells =
        bounding(cells, {{static_cast<std::int32_t>(first - row), y}, {static_cast<std::int32_t>(last - row), y + 1}});
  }
  return cells;
}

/// Turned about y, by `angle`, and then placed.
Transform turned_wheel(const Transform& mount, double angle) {
  const SinCos half = sin_cos(0.5 * wrap_angle(angle));
  const Quaternion& q = mount.rotation;
  return {mount.translation,
          {q.x * half.cos - q.z * half.sin, q.y * half.cos + q.w * half.sin, q.z * half.cos + q.x * half.sin,
           q.w * half.cos - q.y * half.sin}};
}

}  // namespace

Publications::Publications(const RobotModel& robot, PublicationParams params, std::vector<MessageSink*> sinks)
    : robot_(robot),
      params_(std::move(params)),
      sinks_(std::move(sinks)),
      odometry_(robot.drive),
      slow_stamp_(kNever),
      path_stamp_(kNever),
      ways_stamp_(kNever),
      map_stamp_(kNever),
      map_update_stamp_(kNever),
      rooms_stamp_(kNever) {}

template <Message M>
void Publications::publish(const Topic<M>& topic, const M& message) {
  const auto bytes = std::make_shared<const Bytes>(encode(message));
  for (MessageSink* sink : sinks_) sink->publish(topic, now_, bytes);
}

bool Publications::is_due(double& last, double interval) const {
  // Stamps are sums of ticks: a second may be a little less than one.
  if (stamp_ - last < interval - 1e-6) return false;
  last = stamp_;
  return true;
}

void Publications::notify(const Snapshot& now) {
  stamp_ = now.frame.stamp;
  if (!begun_) begin();
  now_ = nanoseconds(stamp_);
  if (params_.simulated) publish(kClockTopic, Clock{time_from_nanoseconds(now_)});
  if (!last_frame_) publish_constants();
  publish_transforms(now);
  publish_wheels();
  publish_senses(now);
  publish_states(now);
  publish_map(now);
  const std::size_t times = 1 + now.map.geometry.size() / kRoomsSize;
  if (rooms_pending_ && is_due(rooms_stamp_, static_cast<double>(times) * params_.rooms_interval)) {
    publish_rooms(now.map);
  }
  publish_ways(now);
  log_changes(now);
  publish_log();
  last_frame_ = now.frame;
  last_frame_->scan.reset();  // whose ranges are the robot's
}

std::int64_t Publications::nanoseconds(double stamp) const {
  return epoch_ + std::llround(stamp * 1e9);
}

void Publications::begin() {
  begun_ = true;
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  epoch_ = params_.epoch.value_or(std::chrono::nanoseconds(now).count() - nanoseconds(stamp_));
}

/// What never changes.
void Publications::publish_constants() {
  TFMessage fixed;
  if (robot_.lidar) {
    fixed.transforms.push_back(
        transform_stamped(header(params_.frames.base), params_.frames.scan, robot_.lidar->mount));
  }
  for (const FixedLink& link : params_.fixed) {
    if (robot_.lidar && link.name == params_.frames.scan) continue;
    fixed.transforms.push_back({header(link.parent), link.name, link.pose});
  }
  if (!fixed.transforms.empty()) publish(kTfStaticTopic, fixed);
  if (!params_.description.empty()) publish(kRobotDescriptionTopic, String{params_.description});
  if (!params_.scenario.empty()) publish(kScenarioTopic, String{params_.scenario});
}

void Publications::publish_transforms(const Snapshot& now) {
  const PoseEstimate& odometry = odometry_.update(now.frame);
  publish(kOdomTopic, odometry_message(header(params_.frames.odom), params_.frames.base, odometry));
  const Pose2 odom_in_map = now.estimate.pose * inverse(odometry.pose);
  publish(kTfTopic, TFMessage{{transform_stamped(header(params_.frames.map), params_.frames.odom, odom_in_map),
                               transform_stamped(header(params_.frames.odom), params_.frames.base, odometry.pose)}});
  if (now.frame.odometry) {
    if (!last_frame_ || !last_frame_->odometry) return;
    const Pose2 step = inverse(*last_frame_->odometry) * *now.frame.odometry;
    const double turn = 0.5 * robot_.drive.wheel_separation * step.yaw;
    left_angle_ += (step.x - turn) / robot_.drive.wheel_radius;
    right_angle_ += (step.x + turn) / robot_.drive.wheel_radius;
  } else {
    left_angle_ += now.frame.left_travel / robot_.drive.wheel_radius;
    right_angle_ += now.frame.right_travel / robot_.drive.wheel_radius;
  }
}

void Publications::publish_wheels() {
  if (!params_.left || !params_.right) return;
  JointState joints{header(""), {params_.left->joint, params_.right->joint}, {left_angle_, right_angle_}, {}, {}};
  publish(kJointStatesTopic, joints);
  TFMessage wheels;
  for (const auto& [wheel, angle] :
       {std::pair(&*params_.left, left_angle_), std::pair(&*params_.right, right_angle_)}) {
    wheels.transforms.push_back({header(wheel->link.parent), wheel->link.name, turned_wheel(wheel->link.pose, angle)});
  }
  publish(kTfTopic, wheels);
}

void Publications::publish_senses(const Snapshot& now) {
  const Frame& frame = now.frame;
  if (frame.scan) {
    const Header seen{time_from_nanoseconds(nanoseconds(frame.scan->stamp)), params_.frames.scan};
    publish(kScanTopic, scan_message(seen, *frame.scan));
  }
  if (!robot_.open_interface) return;
  publish(kBumperTopic, bumper_message(header(params_.frames.base), frame));
  publish(kCliffTopic, cliff_message(header(params_.frames.base), frame));
  if (frame.wheel_dropped() && !(last_frame_ && last_frame_->wheel_dropped())) publish(kWheeldropTopic, Empty{});
  if (!last_frame_ || last_frame_->infrared_omni != frame.infrared_omni) {
    publish(kIrOmniTopic, UInt16{frame.infrared_omni});
  }
}

void Publications::publish_states(const Snapshot& now) {
  const Frame& frame = now.frame;
  const bool due = is_due(slow_stamp_, params_.slow_interval);
  if (due) publish_diagnostics(now);
  if (!robot_.open_interface) return;
  if (due || last_frame_->mode != frame.mode) {
    publish(kModeTopic, Mode{header(params_.frames.base), static_cast<std::uint8_t>(frame.mode)});
  }
  if (due || is_battery_changed(last_frame_->battery, frame.battery)) publish_battery(frame.battery);
}

void Publications::publish_battery(const Battery& battery) {
  publish(kVoltageTopic, Float32{static_cast<float>(battery.voltage)});
  publish(kCurrentTopic, Float32{static_cast<float>(battery.current)});
  publish(kChargeTopic, Float32{static_cast<float>(battery.charge)});
  publish(kCapacityTopic, Float32{static_cast<float>(battery.capacity)});
  const double ratio = battery.capacity > 0.0 ? battery.charge / battery.capacity : 0.0;
  publish(kChargeRatioTopic, Float32{static_cast<float>(ratio)});
  publish(kTemperatureTopic, Int16{static_cast<std::int16_t>(std::lround(battery.temperature))});
  publish(kChargingStateTopic, ChargingState{header(params_.frames.base), static_cast<std::uint8_t>(battery.charger)});
  publish(kBatteryStateTopic, battery_message(header(params_.frames.base), battery));
}

void Publications::publish_diagnostics(const Snapshot& now) {
  std::vector<DiagnosticStatus> all{robot_status(robot_, now.frame, now.decision.doing)};
  if (robot_.open_interface) all.push_back(battery_status(now.frame.battery));
  for (MessageSink* sink : sinks_) {
    if (std::optional<DiagnosticStatus> status = sink->status()) all.push_back(std::move(*status));
  }
  for (DiagnosticStatus& status : all) status.name = params_.node.substr(1) + ": " + status.name;
  publish(kDiagnosticsTopic, DiagnosticArray{header(""), std::move(all)});
}

void Publications::publish_map(const Snapshot& now) {
  const GridGeometry& grid = now.map.geometry;
  if (!(grid == map_geometry_)) {
    const CellIndex shift = shift_between(map_geometry_, grid);
    map_cells_ = moved(map_cells_, shift);
    pending_change_ = moved(pending_change_, shift);
    map_geometry_ = grid;
  }
  pending_change_ = bounding(pending_change_, now.changed);
  if (pending_change_.empty() || !is_due(map_update_stamp_, params_.map_update_interval)) return;
  // What may have changed reaches beyond what did: only evidence makes it grow.
  const auto within = [&](const CellRect& cells) { return bounding(map_cells_, cells) == map_cells_; };
  const bool grew = !within(pending_change_) && !within(evidence_in(now.map));
  if (grew || stamp_ - map_stamp_ >= params_.map_interval) return publish_whole_map(now.map);
  pending_change_ = intersection(pending_change_, map_cells_);
  if (pending_change_.empty()) return;
  publish(kMapUpdatesTopic, map_update_message(header(params_.frames.map), now.map, map_cells_, pending_change_));
  pending_change_ = {};
}

void Publications::publish_whole_map(GridView<const LogOdds> map) {
  map_geometry_ = map.geometry;
  map_stamp_ = stamp_;
  pending_change_ = {};
  rooms_pending_ = true;
  map_cells_ = evidence_in(map);
  if (!map_cells_.empty()) publish(kMapTopic, map_message(header(params_.frames.map), map, map_cells_));
}

void Publications::publish_rooms(GridView<const LogOdds> map) {
  rooms_pending_ = false;
  RoomMap rooms = split_into_rooms(map);
  const bool none = rooms.rooms.empty() && rooms_.rooms.empty();
  if (none || rooms == rooms_) return;
  rooms_ = std::move(rooms);
  publish(kRoomsTopic, room_markers(header(params_.frames.map), rooms_));
}

void Publications::publish_ways(const Snapshot& now) {
  const Pose2& pose = now.estimate.pose;
  if (path_.empty() || (pose.position() - path_.back().position()).norm() >= kPathStep) path_.push_back(pose);
  if (is_due(path_stamp_, params_.path_interval)) publish(kPathTopic, path_message(header(params_.frames.map), path_));
  if (!is_due(ways_stamp_, params_.slow_interval)) return;
  if (!std::ranges::equal(plan_, now.plan)) {
    plan_.assign(now.plan.begin(), now.plan.end());
    publish(kPlanTopic, path_message(header(params_.frames.map), now.plan));
  }
  std::vector<Point2> frontiers;
  for (const Leftover& left : now.leftovers) frontiers.push_back(left.where);
  publish(kFrontiersTopic, points_message(header(params_.frames.map), "frontiers", frontiers, kFrontierSize));
}

void Publications::finish(GridView<const LogOdds> map) {
  if (!begun_) return;
  publish_whole_map(map);
  publish_rooms(map);
  publish(kPathTopic, path_message(header(params_.frames.map), path_));
  publish_log();
}

void Publications::log(std::uint8_t level, const std::string& text) {
  lines().add(level, text);
}

void Publications::log_changes(const Snapshot& now) {
  if (robot_.open_interface && last_frame_ && stamp_ - last_frame_->stamp > kSilence) {
    log(Log::kWarn, "the robot was silent for " + std::to_string(std::lround(stamp_ - last_frame_->stamp)) + " s");
  }
  if (now.decision.doing == doing_) return;
  doing_ = now.decision.doing;
  if (!doing_.empty()) log(Log::kInfo, doing_);
}

void Publications::publish_log() {
  for (LogLine& line : lines().take()) {
    publish(kRosoutTopic,
            Log{time_from_nanoseconds(now_), line.level, logger_name(params_.node), std::move(line.text), "", "", 0});
  }
}

}  // namespace scrubjay::ros

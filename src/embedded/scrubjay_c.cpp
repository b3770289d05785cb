#include <scrubjay/scrubjay_c.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <scrubjay/behavior/edge_follow.hpp>
#include <scrubjay/embedded/embedded_mission.hpp>

namespace {

/// The channel's other end is the caller: who is asked for bytes gives what was fed and isn't read yet.
class FedChannel final : public scrubjay::ByteChannel {
 public:
  FedChannel(scrubjay_send send, void* user) : send_(send), user_(user) {}

  void feed(std::span<const std::uint8_t> bytes, double stamp) {
    bytes_ = bytes;
    stamp_ = stamp;
  }
  bool empty() const { return bytes_.empty(); }

  scrubjay::ByteRead read(std::span<std::uint8_t> buffer) override {
    const std::size_t count = std::min(buffer.size(), bytes_.size());
    if (count > 0) std::memcpy(buffer.data(), bytes_.data(), count);
    bytes_ = bytes_.subspan(count);
    return {count, stamp_, true};
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    return send_ == nullptr || send_(user_, bytes.data(), bytes.size()) != 0;
  }

 private:
  scrubjay_send send_;
  void* user_;
  std::span<const std::uint8_t> bytes_;
  double stamp_ = 0.0;
};

scrubjay::RobotModel model_of(const scrubjay_config& config) {
  scrubjay::RobotModel model;
  model.radius = config.robot_radius;
  model.drive.wheel_separation = config.wheel_separation;
  model.drive.wheel_radius = config.wheel_radius;
  return model;
}

scrubjay::GridGeometry geometry_of(const scrubjay_config& config) {
  return {config.resolution, {config.origin_x, config.origin_y}, config.map_width, config.map_height};
}

bool is_length(double value) {
  return std::isfinite(value) && value > 0.0;
}

bool is_side(std::int32_t cells) {
  return cells >= 1 && cells <= SCRUBJAY_MAX_SIDE;
}

bool has_sound_map(const scrubjay_config& config) {
  return is_side(config.map_width) && is_side(config.map_height) && is_length(config.resolution) &&
         std::isfinite(config.origin_x) && std::isfinite(config.origin_y);
}

bool has_sound_robot(const scrubjay_config& config) {
  return is_length(config.robot_radius) && is_length(config.wheel_separation) && is_length(config.wheel_radius);
}

}  // namespace

struct scrubjay_mission {  // NOLINT(readability-identifier-naming): as C has it
  scrubjay_mission(const scrubjay_config& config, scrubjay::LogOdds* cells)
      : channel(config.send, config.user),
        behavior(model_of(config), scrubjay::Random(config.seed)),
        loop(channel, model_of(config), {geometry_of(config), cells}, behavior) {}

  /// In memory that is there; the global ones belong to a heap.
  static void* operator new(std::size_t /*size*/, void* memory) { return memory; }
  static void operator delete(void* /*mission*/, void* /*memory*/) {}

  FedChannel channel;
  scrubjay::EdgeFollow behavior;
  scrubjay::EmbeddedMission loop;
  double last_stamp = -std::numeric_limits<double>::infinity();
};

static_assert(sizeof(scrubjay_mission) <= SCRUBJAY_MISSION_SIZE, "SCRUBJAY_MISSION_SIZE promises less than it takes");
static_assert(alignof(scrubjay_mission) <= SCRUBJAY_ALIGNMENT, "SCRUBJAY_ALIGNMENT promises less than it takes");

scrubjay_config scrubjay_default_config() {
  const scrubjay::RobotModel robot;
  scrubjay_config config{};
  config.map_width = config.map_height = 100;
  config.resolution = 0.05;
  config.origin_x = config.origin_y = -2.5;
  config.robot_radius = robot.radius;
  config.wheel_separation = robot.drive.wheel_separation;
  config.wheel_radius = robot.drive.wheel_radius;
  config.seed = 1;
  return config;
}

scrubjay_status scrubjay_create(void* memory, size_t size, const scrubjay_config* config, scrubjay_mission** mission) {
  if (mission == nullptr) return SCRUBJAY_NULL;
  *mission = nullptr;
  if (memory == nullptr || config == nullptr) return SCRUBJAY_NULL;
  if (!has_sound_map(*config)) return SCRUBJAY_BAD_MAP;
  if (!has_sound_robot(*config)) return SCRUBJAY_BAD_ROBOT;
  if (reinterpret_cast<std::uintptr_t>(memory) % SCRUBJAY_ALIGNMENT != 0) return SCRUBJAY_MISALIGNED;
  if (size < SCRUBJAY_MISSION_SIZE + geometry_of(*config).size()) return SCRUBJAY_TOO_SMALL;
  auto* cells = static_cast<scrubjay::LogOdds*>(memory) + SCRUBJAY_MISSION_SIZE;
  std::memset(cells, 0, geometry_of(*config).size());
  *mission = new (memory) scrubjay_mission(*config, cells);
  return SCRUBJAY_OK;
}

scrubjay_status scrubjay_feed(scrubjay_mission* mission, const uint8_t* bytes, size_t count, double stamp) {
  if (mission == nullptr || (bytes == nullptr && count > 0)) return SCRUBJAY_NULL;
  if (!std::isfinite(stamp) || stamp < mission->last_stamp) return SCRUBJAY_BAD_STAMP;
  mission->last_stamp = stamp;
  mission->channel.feed({bytes, count}, stamp);
  do {
    mission->loop.step();
  } while (!mission->channel.empty());
  return SCRUBJAY_OK;
}

scrubjay_status scrubjay_stop(scrubjay_mission* mission) {
  if (mission == nullptr) return SCRUBJAY_NULL;
  mission->loop.stop();
  return SCRUBJAY_OK;
}

scrubjay_motion scrubjay_get_motion(const scrubjay_mission* mission) {
  const scrubjay::Motion& motion = mission->loop.motion();
  return {motion.linear, motion.angular};
}

scrubjay_pose scrubjay_get_pose(const scrubjay_mission* mission) {
  const scrubjay::Pose2& pose = mission->loop.estimate().pose;
  return {pose.x, pose.y, pose.yaw};
}

scrubjay_map scrubjay_get_map(const scrubjay_mission* mission) {
  const auto map = mission->loop.map();
  const scrubjay::GridGeometry& grid = map.geometry;
  return {grid.width, grid.height, grid.resolution, grid.origin.x(), grid.origin.y(), map.cells};
}

scrubjay_link scrubjay_get_link(const scrubjay_mission* mission) {
  switch (mission->loop.link()) {
    case scrubjay::LinkState::Alive:
      return SCRUBJAY_LINK_ALIVE;
    case scrubjay::LinkState::Silent:
      return SCRUBJAY_LINK_SILENT;
    case scrubjay::LinkState::Closed:
      return SCRUBJAY_LINK_CLOSED;
  }
  return SCRUBJAY_LINK_CLOSED;
}

scrubjay_counters scrubjay_get_counters(const scrubjay_mission* mission) {
  const scrubjay::OiRobot& robot = mission->loop.robot();
  const auto& stream = robot.counters();
  return {stream.frames, stream.lost, stream.skipped, robot.rejected_values()};
}

int scrubjay_is_done(const scrubjay_mission* mission) {
  return mission->loop.done() ? 1 : 0;
}

int8_t scrubjay_occupancy(int8_t cell) {
  return scrubjay::trinary(cell);
}

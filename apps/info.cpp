/// \file
/// `scrubjay info FILE`: what is this file.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag.hpp>
#include <scrubjay/io/calibration_file.hpp>
#include <scrubjay/io/carmen_log.hpp>
#include <scrubjay/io/file_kind.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/octomap_file.hpp>
#include <scrubjay/io/recording.hpp>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/io/scenario_file.hpp>
#include <scrubjay/io/trajectory_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/world/score.hpp>

#include "commands.hpp"

namespace scrubjay::apps {
namespace {

std::string describe_recording(const std::filesystem::path& path) {
  RecordingReader recording(path);
  std::size_t received = 0;
  std::size_t sent = 0;
  double first = 0.0;
  double last = 0.0;
  bool any = false;
  while (const auto chunk = recording.next()) {
    (chunk->direction == Direction::Received ? received : sent) += chunk->bytes.size();
    if (!any) first = chunk->stamp;
    any = true;
    last = chunk->stamp;
  }
  const auto& end = recording.mission_end();
  return fmt::format("length: {:.3f} s\nreceived: {} bytes\nsent: {} bytes\nwhole: {}\n{}{}", last - first, received,
                     sent, recording.cut() ? "no, cut or damaged at the end" : "yes",
                     end ? fmt::format("ended: {}, after {} frames\n", end->why, end->frames) : "",
                     recording.scenario());
}

std::string describe_world(const std::filesystem::path& path) {
  const World world = read_world(path);
  const std::vector<SolidSegment> solids = solid_segments(world);
  Point2 low(0.0, 0.0);
  Point2 high(0.0, 0.0);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Segment2& s = solids[i].segment;
    low = i == 0 ? s.a.cwiseMin(s.b).eval() : low.cwiseMin(s.a).cwiseMin(s.b).eval();
    high = i == 0 ? s.a.cwiseMax(s.b).eval() : high.cwiseMax(s.a).cwiseMax(s.b).eval();
  }
  std::string text =
      fmt::format("name: {}\nsize: {:.2f} x {:.2f} m\nwalls: {}\nfurniture: {}\nsegments: {}\n", world.name,
                  high.x() - low.x(), high.y() - low.y(), world.walls.size(), world.furniture.size(), solids.size());
  text += fmt::format("doors: {}\ncliffs: {}\ncarpets: {}\ndirt: {}\nvirtual walls: {}\ndock: {}\n", world.doors.size(),
                      world.cliffs.size(), world.carpets.size(), world.dirt.size(), world.virtual_walls.size(),
                      world.dock ? "yes" : "no");
  if (world.start) {
    text += fmt::format("start: {}, {}, {}\n", world.start->x, world.start->y, world.start->yaw);
  }
  return text;
}

std::string describe_map(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  const OccupancyGrid map = read_map(path, &warnings);
  for (const std::string& warning : warnings) fmt::print(stderr, "scrubjay: {}\n", warning);
  const auto count = [&](auto wanted) { return std::count_if(map.cells.begin(), map.cells.end(), wanted); };
  std::string text =
      fmt::format("size: {} x {} cells of {} m\norigin: {}, {}\n", map.geometry.width, map.geometry.height,
                  map.geometry.resolution, map.geometry.origin.x(), map.geometry.origin.y());
  return text + fmt::format("free: {}\noccupied: {}\nunknown: {}\n",
                            count([](Occupancy c) { return c >= kFree && c <= kFreeUpTo; }),
                            count([](Occupancy c) { return c >= kOccupiedFrom; }),
                            count([](Occupancy c) { return c == kUnknown; }));
}

std::string describe_robot(const std::filesystem::path& path) {
  const sim::RobotSpec robot = read_robot(path);
  return fmt::format("name: {}\nradius: {} m\nwheel separation: {} m\nwheel radius: {} m\nlight sensors: {}\n",
                     robot.name, robot.model.radius, robot.model.drive.wheel_separation, robot.model.drive.wheel_radius,
                     robot.model.has_light_sensors ? kLightSensorCount : 0);
}

std::string describe_trajectory(const std::filesystem::path& path) {
  const std::vector<StampedPose> trajectory = read_trajectory(path);
  double length = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length += (trajectory[i].pose.position() - trajectory[i - 1].pose.position()).norm();
  }
  return fmt::format("poses: {}\nlength: {:.3f} m\n", trajectory.size(), length);
}

std::string describe_carmen_log(const std::filesystem::path& path) {
  const CarmenLog log = read_carmen_log(path);
  double driven = 0.0;
  for (std::size_t i = 1; i < log.records.size(); ++i) {
    driven += (log.records[i].odometry.position() - log.records[i - 1].odometry.position()).norm();
  }
  const double first = log.lidar.angle_min;
  return fmt::format(
      "length: {:.3f} s\nscans: {}\nbeams: {}, from {:g} to {:g} degrees\ndriven: {:.1f} m by the wheels\n"
      "odometry records: {}\nrecords out of order: {}\n",
      log.duration(), log.scans.size(), log.lidar.beams, degrees(first),
      degrees(first + (log.lidar.beams - 1) * log.lidar.angle_increment), driven, log.records.size() - log.scans.size(),
      log.late);
}

std::string describe_octomap(const std::filesystem::path& path) {
  const OctomapHead head = read_octomap_head(path);
  return fmt::format("voxels: {} m\nnodes: {}\n", head.resolution, head.nodes);
}

std::string describe_calibration(const std::filesystem::path& path) {
  const CalibrationRecord record = read_calibration(path);
  std::string text = fmt::format("model: {}\n", record.model);
  const auto add = [&](const char* name, double Calibration::*factor) {
    text += fmt::format("{}: {:.4f}", name, record.calibration.*factor);
    if (record.deviation) text += fmt::format(" +- {:.4f}", (*record.deviation).*factor);
    text += '\n';
  };
  add("left wheel", &Calibration::left);
  add("right wheel", &Calibration::right);
  add("axle", &Calibration::axle);
  text += fmt::format("drives: {}\n", record.drives.size());
  if (!record.date.empty()) text += fmt::format("date: {}\n", record.date);
  return text;
}

std::string describe_bag(const std::filesystem::path& path) {
  const std::unique_ptr<BagReader> bag = open_bag(path);
  std::vector<std::size_t> counts;
  std::optional<std::int64_t> first;
  std::int64_t last = 0;
  while (const auto message = bag->next()) {
    counts.resize(std::max(counts.size(), message->topic + 1));
    ++counts[message->topic];
    if (!first) first = message->nanoseconds;
    last = message->nanoseconds;
  }
  const std::vector<BagTopic>& topics = bag->topics();
  counts.resize(topics.size());
  std::string text =
      fmt::format("length: {:.3f} s\nwhole: {}\ntopics: {}\n", first ? 1e-9 * static_cast<double>(last - *first) : 0.0,
                  bag->cut() ? "no, cut or damaged at the end" : "yes", topics.size());
  for (std::size_t i = 0; i < topics.size(); ++i) {
    text += fmt::format("  {:<24} {:>8}  {}{}\n", topics[i].name, counts[i], topics[i].type,
                        topics[i].qos.durability == ros::Durability::TransientLocal ? ", latched" : "");
  }
  return text;
}

std::string describe(FileKind kind, const std::string& file) {
  switch (kind) {
    case FileKind::Recording:
      return describe_recording(file);
    case FileKind::World:
    case FileKind::HouseExpoPlan:
      return describe_world(file);
    case FileKind::MapYaml:
      return describe_map(file);
    case FileKind::Scenario:
      return scenario_text(read_scenario(file));
    case FileKind::Image: {
      const Image image = read_image(file);
      return fmt::format("size: {} x {} pixels\nchannels: {}\n", image.width, image.height, image.channels);
    }
    case FileKind::Urdf:
      return describe_robot(file);
    case FileKind::Trajectory:
      return describe_trajectory(file);
    case FileKind::CarmenLog:
      return describe_carmen_log(file);
    case FileKind::Octomap:
      return describe_octomap(file);
    case FileKind::Calibration:
      return describe_calibration(file);
    case FileKind::Bag:
      return describe_bag(file);
    case FileKind::Unknown:
      break;
  }
  throw Error(
      file +
      ": is none of a world, map, plan, recording, bag, CARMEN log, scenario, robot, calibration, trajectory, OctoMap "
      "tree or image; want one of these");
}

void info(const std::string& file) {
  const FileKind kind = file_kind(file);
  const std::string description = describe(kind, file);  // throws before anything is printed
  fmt::print("{}: {}\n{}", file, to_string(kind), description);
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App* command = app.add_subcommand("info", "Tell what a file is, and what it holds");
  const auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "any file of scrubjay's")->required();
  command->callback([file] { info(*file); });
}

}  // namespace scrubjay::apps

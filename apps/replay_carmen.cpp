#include "replay_carmen.hpp"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <limits>
#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/carmen_robot.hpp>
#include <scrubjay/io/octomap_file.hpp>
#include <scrubjay/io/relations_file.hpp>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/localization/given_poses.hpp>
#include <scrubjay/localization/scan_matching.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/paced_robot.hpp>
#include <scrubjay/mission/track.hpp>

#include "audience.hpp"
#include "interrupt.hpp"
#include "passenger.hpp"
#include "summary.hpp"

namespace scrubjay::apps {
namespace {

constexpr double kResolution = 0.05;    // [m]
constexpr double kRobotRadius = 0.2;    // of the robots that made the classic logs, about [m]
constexpr double kForwardCone = 180.0;  // [degrees]

/// The log's own poses, from its first one.
std::vector<StampedPose> reference_of(const CarmenLog& log) {
  std::vector<StampedPose> poses = logged_poses(log);
  const Pose2 map_from_log = inverse(poses.front().pose);
  for (StampedPose& at : poses) at.pose = map_from_log * at.pose;
  return poses;
}

double within(const char* flag, double value, double least, double most, const char* unit) {
  if (value >= least && value <= most) return value;
  throw Error(fmt::format("{} is {}; want {} to {} {}", flag, value, least, most, unit));
}

/// What the flags ask for, checked.
struct Setup {
  std::string poses;
  RobotModel robot;
  double resolution = kResolution;  ///< [m]
  LidarMapperParams mapper;
};

Setup make_setup(const CarmenFlags& flags, const CarmenLog& log) {
  Setup setup;
  setup.poses = flags.poses.value_or("scan-matching");
  if (setup.poses != "log" && setup.poses != "odometry" && setup.poses != "scan-matching") {
    throw Error(fmt::format("--poses is '{}'; want log, odometry or scan-matching", setup.poses));
  }
  setup.robot = robot_of(log, within("--robot-radius", flags.robot_radius.value_or(kRobotRadius), 0, 10, "m"));
  setup.resolution = within("--resolution", flags.resolution.value_or(kResolution), 0.005, 10, "m");
  setup.mapper.robot_radius = setup.robot.radius;
  setup.mapper.max_range = within("--max-range", flags.max_range.value_or(setup.mapper.max_range), 0.1, 1000, "m");
  setup.mapper.forward_cone =
      radians(within("--forward-cone", flags.forward_cone.value_or(kForwardCone), 1, 180, "degrees"));
  return setup;
}

std::unique_ptr<Localizer> make_localizer(const Setup& setup, const CarmenLog& log, const Mapper& mapper) {
  if (setup.poses == "log") return std::make_unique<GivenPoses>(reference_of(log));
  if (setup.poses == "odometry") return std::make_unique<DeadReckoning>(setup.robot.drive);
  return std::make_unique<ScanMatching>(setup.robot, mapper);
}

/// The relations of --relations and their clock's offset, found before the run so that none is in vain.
struct Judge {
  std::vector<Relation> relations;
  double offset = 0.0;
};

std::optional<Judge> find_judge(const CarmenFlags& flags, const CarmenLog& log) {
  if (!flags.relations) return std::nullopt;
  Judge judge{read_relations(*flags.relations), 0.0};
  const auto offset = relation_offset(at_logged_stamps(log, logged_poses(log)), judge.relations);
  if (!offset) {
    throw Error(fmt::format("{}: these relations don't fit the poses in {} at any time; want those of this very run",
                            *flags.relations, log.name));
  }
  judge.offset = *offset;
  return judge;
}

double cpu_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of a robot that no file describes.
Scenario nameless() {
  Scenario scenario;
  scenario.model.clear();
  scenario.strategy.clear();
  return scenario;
}

RunResult run_log(const Setup& setup, const CarmenLog& log, double speed, Publishing* publishing,
                  const std::stop_token& stop) {
  CarmenRobot robot(log);
  std::optional<PacedRobot> paced;
  if (speed > 0.0) paced.emplace(robot, speed);
  LidarMapper mapper(setup.robot, setup.resolution, setup.mapper);
  const std::unique_ptr<Localizer> localizer = make_localizer(setup, log, mapper);
  Passenger passenger;
  constexpr double kForEver = std::numeric_limits<double>::infinity();
  Mission mission(paced ? static_cast<Robot&>(*paced) : robot, *localizer, mapper, passenger, {kForEver});
  constexpr double kEveryFrame = 0.0;
  Track track(kEveryFrame);
  mission.watch(track);
  if (publishing != nullptr) mission.watch(publishing->begin(nameless(), setup.robot, run_time(speed)));

  const auto begin = std::chrono::steady_clock::now();
  const double cpu_begin = cpu_time();
  RunResult run;
  run.report = mission.run(stop);
  if (publishing != nullptr) publishing->finish(mapper.map(), run.report);
  run.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  run.cpu_time = cpu_time() - cpu_begin;
  run.map = mapper.occupancy();
  run.trajectory = track.points();
  run.robot_radius = setup.robot.radius;
  run.has_bumper = false;
  return run;
}

LogReference compare_with_log(const RunResult& run, const std::string& poses, const CarmenLog& log,
                              const std::optional<Judge>& judge) {
  LogReference reference;
  reference.log = log_stem(log.name);
  reference.poses = poses;
  reference.trajectory = reference_of(log);
  reference.trajectory.resize(run.trajectory.size());  // as far as it came
  reference.error = trajectory_error(run.trajectory, reference.trajectory);
  if (judge) {
    reference.relations = relation_error(at_logged_stamps(log, run.trajectory), judge->relations, judge->offset);
  }
  return reference;
}

void print_log_summary(const RunResult& run, const std::filesystem::path& folder, const OutputFlags& flags) {
  if (flags.json) return fmt::print("{}", metrics_json(run));
  if (flags.quiet) return;
  const LogReference& reference = *run.reference;
  fmt::print("{:.0f} s, {:.1f} m by the wheels, poses: {}\n", run.report.time, run.report.distance, reference.poses);
  fmt::print("against the log's poses: {:.3f} m RMS, {:.3f} m at the end\n", reference.error.ate,
             reference.error.final_distance);
  if (const auto& error = reference.relations) {
    fmt::print("relations: {} of {}, {:.3f} +- {:.3f} m, {:.2f} +- {:.2f} degrees\n", error->matched, error->relations,
               error->translation.mean, error->translation.deviation, degrees(error->rotation.mean),
               degrees(error->rotation.deviation));
  }
  if (run.cpu_time > 0.0) {
    fmt::print("{:.0f} times real time ({:.2f} s)\n", run.report.time / run.cpu_time, run.wall_time);
  }
  fmt::print("picture: {}\n", (folder / "map.png").string());
}

}  // namespace

std::string log_stem(const std::filesystem::path& log) {
  const std::filesystem::path name = log.extension() == ".gz" ? log.stem() : log.filename();
  return name.stem().string();
}

void add_carmen_flags(CLI::App& command, CarmenFlags& flags) {
  const char* group = "Of CARMEN logs";
  command.add_option("--poses", flags.poses, "log, odometry, scan-matching (scan-matching)")->group(group);
  command.add_option("--resolution", flags.resolution, "side of a map cell [m] (0.05)")->check(number)->group(group);
  command.add_option("--forward-cone", flags.forward_cone, "beams to use, either way of straight ahead [deg] (180)")
      ->check(number)
      ->group(group);
  command.add_option("--robot-radius", flags.robot_radius, "floor under it is free [m] (0.2)")
      ->check(number)
      ->group(group);
  command.add_option("--max-range", flags.max_range, "of beams that mark anything [m] (20)")
      ->check(number)
      ->group(group);
  command.add_option("--relations", flags.relations, "verified relative poses to judge the trajectory by")
      ->group(group);
}

double replay_speed(const ReplayFlags& flags) {
  return flags.speed.value_or(flags.ros.wanted ? 1.0 : 0.0);
}

std::filesystem::path replay_folder(const ReplayFlags& flags) {
  return flags.out ? std::filesystem::path(*flags.out) : std::filesystem::path("out") / log_stem(flags.log);
}

void replay_carmen(const ReplayFlags& flags) {
  const CarmenLog log = read_carmen_log(flags.log);
  const Setup setup = make_setup(flags.carmen, log);
  const std::optional<Judge> judge = find_judge(flags.carmen, log);
  const RunFolder folder = prepare_results(replay_folder(flags), flags.octomap);
  const Interrupt interrupt;
  Audience audience(flags.ros, flags.output.quiet);
  RunResult run = run_log(setup, log, replay_speed(flags), audience.publishing(), interrupt.token());
  audience.finish();
  run.reference = compare_with_log(run, setup.poses, log, judge);
  write_run(folder.path(), run);
  if (flags.octomap.file) write_octomap(*flags.octomap.file, run.map, flags.octomap.height);
  print_log_summary(run, folder.path(), flags.output);
}

}  // namespace scrubjay::apps

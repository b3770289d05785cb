#include "logged_scans.hpp"

#include <filesystem>
#include <map>
#include <scrubjay/io/carmen_robot.hpp>

namespace scrubjay::bench {
namespace {

LoggedScans read(const std::filesystem::path& file) {
  LoggedScans out;
  if (!std::filesystem::exists(file)) return out;
  CarmenLog log = read_carmen_log(file);
  out.robot = robot_of(log, 0.0);
  CarmenRobot robot(log);
  for (const CarmenRecord& record : log.records) {
    const auto frame = robot.next();
    if (frame->scan) out.scans.push_back({record.pose, *frame->scan});
  }
  out.ranges = std::move(log.ranges);  // where the scans' ranges stay
  return out;
}

}  // namespace

const LoggedScans& logged_scans(benchmark::State& state, const std::string& name) {
  static std::map<std::string, LoggedScans> logs;
  const auto file = std::filesystem::path(SCRUBJAY_SHARED_DATA) / "carmen" / (name + ".log.gz");
  if (!logs.contains(name)) logs.emplace(name, read(file));
  const LoggedScans& log = logs.at(name);
  if (log.scans.empty()) state.SkipWithError(("there is no ../shared/data/carmen/" + name + ".log.gz").c_str());
  return log;
}

LidarMapper map_of(const LoggedScans& log) {
  LidarMapperParams params;
  params.max_range = 20.0;
  params.robot_radius = 0.0;
  LidarMapper mapper(log.robot, 0.05, params);
  Frame frame;
  PoseEstimate estimate;
  for (const LoggedScan& logged : log.scans) {
    frame.scan = logged.scan;
    estimate.pose = logged.pose;
    mapper.update(frame, estimate);
  }
  return mapper;
}

}  // namespace scrubjay::bench

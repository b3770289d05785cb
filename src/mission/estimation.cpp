#include <scrubjay/error.hpp>
#include <scrubjay/localization/scan_matching.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <scrubjay/mission/estimation.hpp>

namespace scrubjay {
namespace {

std::unique_ptr<Mapper> make_mapper(const Scenario& scenario, const RobotModel& robot) {
  if (!robot.lidar) return std::make_unique<ContactMapper>(robot, scenario.resolution);
  LidarMapperParams params;
  params.robot_radius = scenario.robot_radius.value_or(robot.radius);
  if (scenario.forward_cone) params.forward_cone = *scenario.forward_cone;
  return std::make_unique<LidarMapper>(robot, scenario.resolution, params);
}

std::unique_ptr<Localizer> make_localizer(const Scenario& scenario, const RobotModel& robot, const Mapper& mapper) {
  const std::string_view name = scenario.localizer.empty() ? default_localizer(robot) : scenario.localizer;
  if (name == "odometry") return std::make_unique<DeadReckoning>(robot.drive);
  if (name != "scan-matching") {
    throw Error("there is no localizer '" + std::string(name) + "'; want odometry or scan-matching");
  }
  if (!robot.lidar) throw Error("scan-matching wants a lidar, which this robot hasn't; want odometry");
  return std::make_unique<ScanMatching>(robot, mapper);
}

}  // namespace

std::string_view default_localizer(const RobotModel& robot) {
  return robot.lidar ? "scan-matching" : "odometry";
}

Estimation make_estimation(const Scenario& scenario, const RobotModel& robot) {
  Estimation estimation;
  estimation.mapper = make_mapper(scenario, robot);
  estimation.localizer = make_localizer(scenario, robot, *estimation.mapper);
  return estimation;
}

}  // namespace scrubjay

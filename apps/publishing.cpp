#include "publishing.hpp"

#include <scrubjay/io/robot_description.hpp>
#include <scrubjay/io/scenario_file.hpp>

#include "data_folder.hpp"

namespace scrubjay::apps {

bool is_bag(const std::filesystem::path& recording) {
  return recording.extension() != ".oilog";
}

Publishing::Publishing(const std::optional<std::filesystem::path>& bag, bool zstd) {
  if (!bag) return;
  bag_ = std::make_unique<BagRecorder>(make_bag_writer(*bag, zstd));
  sinks_.push_back(bag_.get());
}

ros::Publications& Publishing::begin(const Scenario& scenario, const RobotModel& robot, bool simulated) {
  RobotDescription body = read_robot_description(robot_file(scenario.model));
  ros::PublicationParams params;
  params.description = std::move(body.urdf);
  params.scenario = scenario_text(scenario);
  params.fixed = std::move(body.fixed);
  params.left = std::move(body.left);
  params.right = std::move(body.right);
  params.simulated = simulated;
  if (simulated) params.epoch = 0;
  return publications_.emplace(robot, std::move(params), sinks_);
}

void Publishing::finish(GridView<const LogOdds> map) {
  if (publications_) publications_->finish(map);
}

void Publishing::close() {
  if (bag_) bag_->close();
}

}  // namespace scrubjay::apps

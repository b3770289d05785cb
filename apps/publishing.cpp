#include "publishing.hpp"

#include <fmt/format.h>

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

Observer& Publishing::begin(const Scenario& scenario, const RobotModel& robot, RunTime time) {
  RobotDescription body = read_robot_description(robot_file(scenario.model));
  ros::PublicationParams params;
  params.description = std::move(body.urdf);
  params.scenario = scenario_text(scenario);
  params.fixed = std::move(body.fixed);
  params.left = std::move(body.left);
  params.right = std::move(body.right);
  params.simulated = time != RunTime::Real;
  if (params.simulated) params.epoch = 0;
  publications_.emplace(robot, std::move(params), sinks_);
  if (time == RunTime::Free) return *publications_;
  using WhenFull = BackgroundObserver::WhenFull;
  return background_.emplace(*publications_, time == RunTime::Real ? WhenFull::LeaveOut : WhenFull::Wait);
}

void Publishing::finish(GridView<const LogOdds> map) {
  if (!publications_) return;
  if (background_) {
    background_->finish();
    if (const std::uint64_t lost = background_->left_out(); lost > 0) {
      fmt::print(stderr, "scrubjay: {} ticks were neither published nor recorded: too many waited\n", lost);
    }
  }
  publications_->finish(map);
}

void Publishing::close() {
  if (bag_) bag_->close();
}

}  // namespace scrubjay::apps

#include "publishing.hpp"

#include <fmt/format.h>

#include <scrubjay/io/robot_description.hpp>
#include <scrubjay/io/scenario_file.hpp>

#include "data_folder.hpp"
#include "ros_node.hpp"

namespace scrubjay::apps {
namespace {

std::string beginning(const Scenario& scenario) {
  std::string text = scenario.strategy.empty() ? "begins, driven by others" : "begins: " + scenario.strategy;
  if (!scenario.model.empty()) text += " with " + scenario.model;
  if (!scenario.world.empty()) text += " in " + scenario.world;
  return text;
}

std::string ending(const Report& report) {
  return fmt::format("ends: {} after {:.0f} s, {:.1f} m driven, {} bumps", to_string(report.ended), report.time,
                     report.distance, report.bumps);
}

std::uint8_t level_of(Ended ended) {
  if (ended == Ended::RobotGone) return ros::Log::kError;
  return ended == Ended::Stuck ? ros::Log::kWarn : ros::Log::kInfo;
}

}  // namespace

bool is_bag(const std::filesystem::path& recording) {
  return recording.extension() != ".oilog";
}

Publishing::Publishing(const std::optional<std::filesystem::path>& bag, bool zstd) {
  if (!bag) return;
  bag_ = std::make_unique<BagRecorder>(make_bag_writer(*bag, zstd));
  sinks_.push_back(bag_.get());
}

void Publishing::tell(RosNode& node) {
  sinks_.push_back(&node.sink());
  node_ = &node;
}

Observer& Publishing::begin(const Scenario& scenario, const RobotModel& robot, RunTime time) {
  ros::PublicationParams params;
  if (!scenario.model.empty()) {
    RobotDescription body = read_robot_description(robot_file(scenario.model));
    params.description = std::move(body.urdf);
    params.scenario = scenario_text(scenario);
    params.fixed = std::move(body.fixed);
    params.left = std::move(body.left);
    params.right = std::move(body.right);
  }
  params.simulated = time != RunTime::Real;
  if (params.simulated) params.epoch = 0;
  if (node_ != nullptr) {
    params.node = node_->name();
    params.log = &node_->log();
  }
  publications_.emplace(robot, std::move(params), sinks_);
  publications_->log(ros::Log::kInfo, beginning(scenario));
  if (time == RunTime::Free) return *publications_;
  using WhenFull = BackgroundObserver::WhenFull;
  return background_.emplace(*publications_, time == RunTime::Real ? WhenFull::LeaveOut : WhenFull::Wait);
}

void Publishing::finish(GridView<const LogOdds> map, const Report& report) {
  if (!publications_) return;
  if (background_) {
    background_->finish();
    if (const std::uint64_t lost = background_->left_out(); lost > 0) {
      const std::string line = fmt::format("{} ticks were neither published nor recorded: too many waited", lost);
      fmt::print(stderr, "scrubjay: {}\n", line);
      publications_->log(ros::Log::kWarn, line);
    }
  }
  if (node_ != nullptr) node_->sum_up();
  publications_->log(level_of(report.ended), ending(report));
  publications_->finish(map);
}

void Publishing::close() {
  if (bag_) bag_->close();
}

}  // namespace scrubjay::apps

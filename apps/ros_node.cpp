#include "ros_node.hpp"

#include <fmt/format.h>

#include <scrubjay/error.hpp>
#include <scrubjay/ros2/bridge.hpp>
#include <scrubjay/ros2/environment.hpp>
#include <scrubjay/ros2/ordered_robot.hpp>
#include <scrubjay/ros2/placed_localizer.hpp>
#include <scrubjay/ros2/remote_drive.hpp>

namespace scrubjay::apps {
namespace {

constexpr double kPatience = 1.0;  // with what is still to be sent at the end [s]

/// As the command line had them; a process has one.
ros::RosArguments& ros_arguments() {
  static ros::RosArguments arguments;
  return arguments;
}

void tell(const std::string& line) {
  fmt::print(stderr, "scrubjay: {}\n", line);
}

ros::ParticipantOptions options_of(const RosFlags& flags, bool quiet) {
  std::optional<ros::Distribution> distro;
  if (flags.distro) {
    distro = ros::distribution_named(*flags.distro);
    if (!distro) {
      throw Error(fmt::format("--ros-distro is {}; want humble, iron, jazzy, kilted or rolling", *flags.distro));
    }
  }
  const ros::Environment environment = ros::read_environment(ros::process_variable, distro);
  std::vector<std::string> warnings = environment.warnings;
  ros::ParticipantOptions options = ros::participant_options(environment, ros_arguments(), warnings);
  if (quiet) return options;
  for (const std::string& warning : warnings) tell(warning);
  options.tell = tell;
  return options;
}

/// Others steer by their commands.
class RemoteSteering final : public Steering {
 public:
  RemoteSteering(const RobotModel& robot, ros::Commands::Tell tell)
      : commands_({robot.max_linear_speed, robot.max_angular_speed}, std::move(tell)) {}

  ros::Commands& commands() { return commands_; }
  std::unique_ptr<Behavior> behavior(const RobotModel& robot) override {
    return std::make_unique<ros::RemoteDrive>(robot, commands_);
  }
  std::unique_ptr<Robot> between(Robot& robot) override {
    return std::make_unique<ros::OrderedRobot>(robot, commands_);
  }
  void correct(Estimation& estimation, const RobotModel& robot) override {
    // Scan matching knows better: its map would be torn.
    if (robot.lidar) return;
    estimation.localizer = std::make_unique<ros::PlacedLocalizer>(std::move(estimation.localizer), commands_);
  }

 private:
  ros::Commands commands_;
};

}  // namespace

struct RosNode::State {
  State(const RosFlags& flags, bool is_quiet) : quiet(is_quiet), bridge(options_of(flags, quiet), ros::kTopics) {}
  bool quiet;
  std::optional<RemoteSteering> steering;  // outlives the bridge, whose threads fill it
  ros::Bridge bridge;
};

void add_ros_distro_flag(CLI::App& command, RosFlags& flags) {
  command.add_option("--ros-distro", flags.distro, "humble, iron, jazzy, kilted or rolling\n($ROS_DISTRO, or jazzy)");
}

void add_ros_flags(CLI::App& command, RosFlags& flags) {
  command.add_flag("--ros2", flags.wanted, "be a node of ROS 2; simulated in real time then");
  add_ros_distro_flag(command, flags);
}

void take_ros_words(std::vector<std::string>& words) {
  ros_arguments() = ros::take_ros_arguments(words);
}

RosNode::RosNode(const RosFlags& flags, bool quiet) : state_(std::make_unique<State>(flags, quiet)) {}
RosNode::~RosNode() = default;

ros::MessageSink& RosNode::sink() {
  return state_->bridge;
}

Steering& RosNode::steering(const RobotModel& robot) {
  state_->bridge.listen(state_->steering.emplace(robot, state_->quiet ? nullptr : tell).commands());
  return *state_->steering;
}

void RosNode::finish() {
  state_->bridge.flush(kPatience);
  if (!state_->steering || state_->quiet) return;
  const ros::CommandTally tally = state_->steering->commands().tally();
  if (tally.malformed + tally.out_of_range + tally.other_frame == 0) return;
  tell(fmt::format("refused {} messages that nobody could read, and {} that asked for what can't be", tally.malformed,
                   tally.out_of_range + tally.other_frame));
}

}  // namespace scrubjay::apps

#include "ros_node.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <scrubjay/error.hpp>
#include <scrubjay/ros2/bridge.hpp>
#include <scrubjay/ros2/ordered_robot.hpp>
#include <scrubjay/ros2/placed_localizer.hpp>
#include <scrubjay/ros2/remote_drive.hpp>
#include <thread>

#include "ros_options.hpp"

namespace scrubjay::apps {
namespace {

constexpr double kPatience = 1.0;                  // with what is still to be sent at the end [s]
constexpr std::chrono::seconds kBetweenLooks(10);  // at what others do: they find us within a few

/// Told of to whoever sits before the terminal, and to /rosout. From any thread.
class Teller {
 public:
  explicit Teller(bool quiet) : quiet_(quiet) {}
  Teller(const Teller&) = delete;
  Teller& operator=(const Teller&) = delete;
  ~Teller() { release(); }

  void tell(std::uint8_t level, const std::string& line) {
    log_.add(level, line);
    if (quiet_) return;
    const std::scoped_lock lock(mutex_);
    if (held_) {
      held_->push_back(line);
    } else {
      print(line);
    }
  }
  void hold() {
    const std::scoped_lock lock(mutex_);
    held_.emplace();
  }
  void release() {
    const std::scoped_lock lock(mutex_);
    if (held_) std::ranges::for_each(*held_, print);
    held_.reset();
  }
  ros::LogQueue& log() { return log_; }

 private:
  static void print(const std::string& line) {
    const char* over_progress = ::isatty(STDERR_FILENO) != 0 ? "\r\033[K" : "";
    // Not by fmt::print, which throws where nobody listens any more, as on a terminal that is gone.
    std::fputs(fmt::format("{}scrubjay: {}\n", over_progress, line).c_str(), stderr);
  }

  bool quiet_;
  ros::LogQueue log_;
  std::mutex mutex_;
  std::optional<std::vector<std::string>> held_;
};

ros::ParticipantOptions options_of(const RosFlags& flags, Teller& teller) {
  std::vector<std::string> warnings;
  ros::ParticipantOptions options = ros_options(flags, warnings);
  for (const std::string& warning : warnings) teller.tell(ros::Log::kWarn, warning);
  options.tell = [&teller](const std::string& line) { teller.tell(ros::Log::kWarn, line); };
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
  State(const RosFlags& flags, bool quiet)
      : teller(quiet), options(options_of(flags, teller)), bridge(options, ros::kTopics) {}

  void watch(const std::stop_token& end);
  void tell_unheard();
  void tell_refused();
  void tell_lost();

  Teller teller;
  ros::ParticipantOptions options;
  std::optional<RemoteSteering> steering;  // outlives the bridge, whose threads fill it
  ros::Bridge bridge;
  std::mutex mutex;  // of what follows
  bool looked = false;
  std::uint64_t refused = 0;                                                 // of which was told
  std::jthread watcher{[this](const std::stop_token& end) { watch(end); }};  // uses all that is before it
};

/// Others may want to know while the run goes on.
void RosNode::State::watch(const std::stop_token& end) {
  std::mutex waiting;
  std::condition_variable_any never;
  std::unique_lock lock(waiting);
  while (!never.wait_for(lock, end, kBetweenLooks, [] { return false; }) && !end.stop_requested()) {
    tell_unheard();
    tell_refused();
  }
}

void RosNode::State::tell_unheard() {
  const std::scoped_lock lock(mutex);
  if (std::exchange(looked, true)) return;
  const std::vector<std::string> unheard = bridge.participant().unheard();
  if (unheard.size() == ros::kTopics.size()) {
    teller.tell(ros::Log::kWarn, "nobody listens to any topic of ours; scrubjay doctor --ros2 tells who is there");
  } else if (!unheard.empty()) {
    // As is usual: nobody needs to be told who didn't ask.
    teller.log().add(ros::Log::kInfo, fmt::format("nobody listens to {}", fmt::join(unheard, ", ")));
  }
}

void RosNode::State::tell_refused() {
  const std::scoped_lock lock(mutex);
  if (!steering) return;
  const ros::CommandTally tally = steering->commands().tally();
  const std::uint64_t all = tally.malformed + tally.out_of_range + tally.other_frame;
  if (all == std::exchange(refused, all)) return;
  teller.tell(ros::Log::kWarn,
              fmt::format("refused {} messages that nobody could read, and {} that asked for what can't "
                          "be",
                          tally.malformed, tally.out_of_range + tally.other_frame));
}

void RosNode::State::tell_lost() {
  const ros::WriterTally tally = bridge.tally();
  if (tally.dropped + tally.refused == 0) return;
  teller.tell(ros::Log::kWarn,
              fmt::format("of {} messages, {} weren't sent as too many waited, and {} as Fast DDS refused them",
                          tally.published + tally.dropped + tally.refused, tally.dropped, tally.refused));
}

RosNode::RosNode(const RosFlags& flags, bool quiet) : state_(std::make_unique<State>(flags, quiet)) {}
RosNode::~RosNode() = default;

std::string RosNode::name() const {
  return state_->options.names.full_name();
}

ros::MessageSink& RosNode::sink() {
  return state_->bridge;
}

ros::LogQueue& RosNode::log() {
  return state_->teller.log();
}

Steering& RosNode::steering(const RobotModel& robot) {
  const std::scoped_lock lock(state_->mutex);
  const auto tell = [teller = &state_->teller](const std::string& line) { teller->tell(ros::Log::kWarn, line); };
  state_->bridge.listen(state_->steering.emplace(robot, tell).commands());
  return *state_->steering;
}

void RosNode::hold_lines() {
  state_->teller.hold();
}

void RosNode::sum_up() {
  state_->tell_unheard();
  state_->tell_refused();
  state_->tell_lost();
}

void RosNode::finish() {
  state_->bridge.flush(kPatience);
  state_->teller.release();
}

}  // namespace scrubjay::apps

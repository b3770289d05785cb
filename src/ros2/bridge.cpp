#include <scrubjay/messages/std_msgs.hpp>
#include <scrubjay/ros2/bridge.hpp>

namespace scrubjay::ros {
namespace {

// A reader that asks for no more than best effort hears writers of either kind. What is late is worth nothing.
constexpr Qos kNewest{Reliability::BestEffort, Durability::Volatile, 1};
constexpr Qos kEveryOne{.depth = 10};

/// A topic that others steer by, and what takes its messages.
struct Heard {
  TopicInfo topic;
  void (*take)(Commands& commands, Commands::Bytes message);
};

template <auto kTake>
void pass_on(Commands& commands, Commands::Bytes message) {
  (commands.*kTake)(message);
}

template <std::uint8_t kBit>
void pass_on_led(Commands& commands, Commands::Bytes message) {
  commands.take_led(kBit, message);
}

constexpr std::array kHeard{
    Heard{{"cmd_vel", kTypeOf<Twist>, kNewest}, pass_on<&Commands::take_twist>},
    Heard{{"cmd_vel", kTypeOf<TwistStamped>, kNewest}, pass_on<&Commands::take_twist_stamped>},
    Heard{{"goal_pose", kTypeOf<PoseStamped>, kEveryOne}, pass_on<&Commands::take_goal>},
    Heard{{"initialpose", kTypeOf<PoseWithCovarianceStamped>, kEveryOne}, pass_on<&Commands::take_initial_pose>},
    Heard{{"dock", kTypeOf<Empty>, kEveryOne}, pass_on<&Commands::take_dock>},
    Heard{{"undock", kTypeOf<Empty>, kEveryOne}, pass_on<&Commands::take_undock>},
    Heard{{"define_song", kTypeOf<DefineSong>, kEveryOne}, pass_on<&Commands::take_song>},
    Heard{{"play_song", kTypeOf<PlaySong>, kEveryOne}, pass_on<&Commands::take_play>},
    Heard{{"power_led", kTypeOf<UInt8MultiArray>, kEveryOne}, pass_on<&Commands::take_power_led>},
    Heard{{"set_ascii", kTypeOf<UInt8MultiArray>, kEveryOne}, pass_on<&Commands::take_digits>},
    Heard{{"debris_led", kTypeOf<Bool>, kEveryOne}, pass_on_led<oi::Leds::kDebris>},
    Heard{{"spot_led", kTypeOf<Bool>, kEveryOne}, pass_on_led<oi::Leds::kSpot>},
    Heard{{"dock_led", kTypeOf<Bool>, kEveryOne}, pass_on_led<oi::Leds::kDock>},
    Heard{{"check_led", kTypeOf<Bool>, kEveryOne}, pass_on_led<oi::Leds::kCheckRobot>}};

}  // namespace

std::vector<Endpoint> bridge_endpoints(const NodeNames& names, std::span<const TopicInfo> written) {
  std::vector<Endpoint> endpoints;
  const auto add = [&](bool writes, const TopicInfo& topic) {
    endpoints.push_back({writes, names.topic(topic.name), std::string(topic.type.name), std::string(topic.type.hash),
                         topic.qos, names.full_name()});
  };
  for (const TopicInfo& topic : written) add(true, topic);
  for (const Heard& heard : kHeard) add(false, heard.topic);
  return endpoints;
}

Bridge::Bridge(ParticipantOptions options, std::span<const TopicInfo> topics) : participant_(std::move(options)) {
  for (const TopicInfo& topic : topics) {
    writers_.emplace(topic.name, &participant_.write(topic.name, topic.type, topic.qos));
  }
}

void Bridge::listen(Commands& commands) {
  for (const Heard& heard : kHeard) {
    const auto take = [&commands, pass = heard.take](Commands::Bytes message) { pass(commands, message); };
    participant_.read(heard.topic.name, heard.topic.type, heard.topic.qos, take);
  }
}

WriterTally Bridge::tally() const {
  WriterTally sum;
  for (const auto& [topic, writer] : writers_) {
    const WriterTally one = writer->tally();
    sum.published += one.published;
    sum.dropped += one.dropped;
    sum.refused += one.refused;
  }
  return sum;
}

std::optional<DiagnosticStatus> Bridge::status() {
  const WriterTally sum = tally();
  const std::uint64_t lost = sum.dropped + sum.refused;
  const bool more = lost > std::exchange(lost_, lost);
  DiagnosticStatus status;
  status.name = "messages";
  status.level = more ? DiagnosticStatus::kWarn : DiagnosticStatus::kOk;
  status.message = more ? "not all messages are sent" : "messages are sent";
  status.values = {{"published", std::to_string(sum.published)},
                   {"dropped", std::to_string(sum.dropped)},
                   {"refused by DDS", std::to_string(sum.refused)}};
  return status;
}

void Bridge::publish(const TopicInfo& topic, std::int64_t, const std::shared_ptr<const Bytes>& bytes) {
  const auto found = writers_.find(topic.name);
  if (found != writers_.end()) found->second->publish(bytes);
}

}  // namespace scrubjay::ros

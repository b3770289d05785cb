#include <scrubjay/messages/std_msgs.hpp>
#include <scrubjay/ros2/bridge.hpp>

namespace scrubjay::ros {
namespace {

// A reader that asks for no more than best effort hears writers of either kind. What is late is worth nothing.
constexpr Qos kNewest{Reliability::BestEffort, Durability::Volatile, 1};
constexpr Qos kEveryOne{.depth = 10};

}  // namespace

Bridge::Bridge(ParticipantOptions options, std::span<const TopicInfo> topics) : participant_(std::move(options)) {
  for (const TopicInfo& topic : topics) {
    writers_.emplace(topic.name, &participant_.write(topic.name, topic.type, topic.qos));
  }
}

void Bridge::listen(Commands& commands) {
  const auto read = [&](const char* topic, const MessageType& type, const Qos& qos,
                        void (Commands::*take)(Commands::Bytes)) {
    participant_.read(topic, type, qos,
                      [&commands, take](std::span<const std::byte> message) { (commands.*take)(message); });
  };
  read("cmd_vel", kTypeOf<Twist>, kNewest, &Commands::take_twist);
  read("cmd_vel", kTypeOf<TwistStamped>, kNewest, &Commands::take_twist_stamped);
  read("goal_pose", kTypeOf<PoseStamped>, kEveryOne, &Commands::take_goal);
  read("initialpose", kTypeOf<PoseWithCovarianceStamped>, kEveryOne, &Commands::take_initial_pose);
  read("dock", kTypeOf<Empty>, kEveryOne, &Commands::take_dock);
  read("undock", kTypeOf<Empty>, kEveryOne, &Commands::take_undock);
  read("define_song", kTypeOf<DefineSong>, kEveryOne, &Commands::take_song);
  read("play_song", kTypeOf<PlaySong>, kEveryOne, &Commands::take_play);
  read("power_led", kTypeOf<UInt8MultiArray>, kEveryOne, &Commands::take_power_led);
  read("set_ascii", kTypeOf<UInt8MultiArray>, kEveryOne, &Commands::take_digits);
  for (const auto& [topic, bit] :
       {std::pair("debris_led", oi::Leds::kDebris), std::pair("spot_led", oi::Leds::kSpot),
        std::pair("dock_led", oi::Leds::kDock), std::pair("check_led", oi::Leds::kCheckRobot)}) {
    participant_.read(topic, kTypeOf<Bool>, kEveryOne,
                      [&commands, led = bit](std::span<const std::byte> message) { commands.take_led(led, message); });
  }
}

void Bridge::publish(const TopicInfo& topic, std::int64_t, const std::shared_ptr<const Bytes>& bytes) {
  const auto found = writers_.find(topic.name);
  if (found != writers_.end()) found->second->publish(bytes);
}

}  // namespace scrubjay::ros

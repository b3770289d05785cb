// The other end of the benchmarks of ROS 2, a process of its own: listens until it is told to end, and then prints how
// long messages were on their way.
//
//   listener DOMAIN TOPIC...
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <future>
#include <map>
#include <mutex>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/std_msgs.hpp>
#include <scrubjay/messages/topics.hpp>
#include <scrubjay/ros2/participant.hpp>
#include <string>
#include <vector>

namespace {

using namespace scrubjay;
using Clock = std::chrono::steady_clock;

/// Since the time at which a message was made [ms], if it begins with a header, whose clock is ours.
double age(std::span<const std::byte> message) {
  if (message.size() < 12) return 0.0;
  std::int32_t seconds = 0;
  std::uint32_t nanoseconds = 0;
  std::memcpy(&seconds, message.data() + 4, sizeof seconds);
  std::memcpy(&nanoseconds, message.data() + 8, sizeof nanoseconds);
  const auto made = std::chrono::seconds(seconds) + std::chrono::nanoseconds(nanoseconds);
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch() - made).count();
}

void print(const std::string& topic, std::vector<double>& ages) {
  std::sort(ages.begin(), ages.end());
  const auto quantile = [&](std::size_t percent) { return ages.empty() ? 0.0 : ages[ages.size() * percent / 100]; };
  fmt::print("{} {} {:.4f} {:.4f}\n", topic, ages.size(), quantile(50), quantile(99));
}

int listen(int domain, const std::vector<std::string>& topics) {
  std::mutex mutex;
  std::map<std::string, std::vector<double>> ages;
  std::promise<void> end;
  {
    ros::ParticipantOptions options{.domain = domain};
    options.discovery.range = ros::DiscoveryRange::Localhost;
    options.most_read = 8U << 20U;
    ros::Participant participant(options);
    for (const ros::TopicInfo& topic : ros::kTopics) {
      const std::string name(topic.name);
      if (std::find(topics.begin(), topics.end(), name) == topics.end()) continue;
      participant.read(name, topic.type, topic.qos, [&, name](std::span<const std::byte> message) {
        const double time = age(message);
        const std::scoped_lock lock(mutex);
        ages[name].push_back(time);
      });
    }
    participant.read("end_of_benchmark", ros::kTypeOf<ros::Empty>, {}, [&](auto) { end.set_value(); });
    end.get_future().wait();
  }
  for (const std::string& topic : topics) print(topic, ages[topic]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  return listen(std::atoi(argv[1]), {argv + 2, argv + argc});
}

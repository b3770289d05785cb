// What it costs to be a node of ROS 2, with a listener in a process of its own, over UDP on the loopback device. What
// counts is in the counters: a run takes the time that it takes.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <scrubjay/mapping/growing_map.hpp>
#include <scrubjay/messages/publications.hpp>
#include <scrubjay/mission/background_observer.hpp>
#include <scrubjay/ros2/bridge.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "ros2/fresh_domain.hpp"

namespace scrubjay::bench {
namespace {

using Clock = std::chrono::steady_clock;
using ros::Bytes;

constexpr auto kTick = std::chrono::milliseconds(10);  // 100 Hz
constexpr std::int32_t kSide = 2000;                   // of a map of 4 MB [cells]

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Of this process, all its threads [s].
double cpu_time() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

ros::ParticipantOptions options_in(int domain) {
  ros::ParticipantOptions options{.domain = domain};
  options.discovery.range = ros::DiscoveryRange::Localhost;
  return options;
}

/// How long the messages of a topic were on their way.
struct OneWay {
  double messages = 0;
  double p50 = 0.0;  // [ms]
  double p99 = 0.0;  // [ms]
};

/// Another process that listens to these topics of a participant of ours.
class Listener {
 public:
  Listener(int domain, ros::Participant& participant, const std::vector<std::string>& topics)
      : participant_(participant), end_(participant.write("end_of_benchmark", ros::kTypeOf<ros::Empty>)) {
    std::string command = std::string(SCRUBJAY_LISTENER) + " " + std::to_string(domain);
    for (const std::string& topic : topics) command += " " + topic;
    process_ = ::popen(command.c_str(), "r");
    if (process_ == nullptr) throw std::runtime_error("the listener can't be started");
    while (end_.readers() == 0) std::this_thread::sleep_for(kTick);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));  // the other topics match, and all is quiet
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() {
    if (process_ != nullptr) finish();
  }

  std::map<std::string, OneWay> finish() {
    participant_.flush(5.0);
    end_.publish(encode(ros::Empty{}));
    participant_.flush(5.0);
    std::string text(4096, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), process_));
    ::pclose(std::exchange(process_, nullptr));
    std::map<std::string, OneWay> times;
    std::istringstream lines(text);
    std::string topic;
    for (OneWay time; lines >> topic >> time.messages >> time.p50 >> time.p99;) times[topic] = time;
    return times;
  }

 private:
  ros::Participant& participant_;
  ros::Writer& end_;
  std::FILE* process_ = nullptr;
};

/// All of it known.
GrowingMap known_map() {
  GrowingMap map(0.05);
  map.cover(CellRect{{0, 0}, {kSide, kSide}});
  std::fill_n(map.view().cells, map.view().geometry.size(), LogOdds{-50});
  return map;
}

ros::Header header_now() {
  const auto now = std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch());
  return {ros::time_from_nanoseconds(now.count()), "map"};
}

void report(benchmark::State& state, const OneWay& time, double sent) {
  state.counters["p50_ms"] = time.p50;
  state.counters["p99_ms"] = time.p99;
  state.counters["lost"] = sent - time.messages;
}

/// So many messages at 100 Hz, one way.
template <ros::Message M>
void one_way(benchmark::State& state, const ros::Topic<M>& topic, M message, int count) {
  const ros::FreshDomain domain;
  ros::Participant participant(options_in(domain.number()));
  ros::Writer& writer = participant.write(topic.name, topic.type, topic.qos);
  Listener listener(domain.number(), participant, {std::string(topic.name)});
  for ([[maybe_unused]] const auto& _ : state) {
    auto next = Clock::now();
    for (int i = 0; i < count; ++i) {
      std::this_thread::sleep_until(next += kTick);
      message.header = header_now();
      Bytes bytes = encode(message);
      // Its way begins when it is handed over: the time in its header is the first thing behind the encapsulation.
      const ros::Time now = header_now().stamp;
      std::memcpy(bytes.data() + 4, &now.sec, sizeof now.sec);
      std::memcpy(bytes.data() + 8, &now.nanosec, sizeof now.nanosec);
      writer.publish(std::move(bytes));
    }
  }
  report(state, listener.finish()[std::string(topic.name)], count);
}

void RosMapOneWay(benchmark::State& state) {
  ros::OccupancyGrid map;
  map.info.width = map.info.height = kSide;
  map.data.assign(static_cast<std::size_t>(kSide) * kSide, 0);
  one_way(state, ros::kMapTopic, std::move(map), 300);
}
BENCHMARK(RosMapOneWay)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

void RosOdomOneWay(benchmark::State& state) {
  one_way(state, ros::kOdomTopic, ros::Odometry{}, 500);
}
BENCHMARK(RosOdomOneWay)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Odometry at 100 Hz and a map of 4 MB each second, and nothing else: what of a core it takes.
void RosOdomAndMap(benchmark::State& state) {
  constexpr int kTicks = 1000;
  const ros::FreshDomain domain;
  ros::Participant participant(options_in(domain.number()));
  ros::Writer& odom = participant.write(ros::kOdomTopic.name, ros::kOdomTopic.type, ros::kOdomTopic.qos);
  ros::Writer& map = participant.write(ros::kMapTopic.name, ros::kMapTopic.type, ros::kMapTopic.qos);
  Listener listener(domain.number(), participant, {"odom", "map"});
  const GrowingMap known = known_map();
  const double begin = cpu_time();
  for ([[maybe_unused]] const auto& _ : state) {
    auto next = Clock::now();
    for (int i = 0; i < kTicks; ++i) {
      std::this_thread::sleep_until(next += kTick);
      odom.publish(encode(ros::odometry_message(header_now(), "base_footprint", {})));
      if (i % 100 == 50)
        map.publish(encode(ros::map_message(header_now(), known.view(), cells_of(known.view().geometry))));
    }
  }
  state.counters["cpu_percent"] = 100.0 * (cpu_time() - begin) / (kTicks * 0.01);
  const auto times = listener.finish();
  state.counters["lost"] = kTicks * 1.01 - times.at("odom").messages - times.at("map").messages;
}
BENCHMARK(RosOdomAndMap)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

enum Watched { ByNobody, InTheLoop, InTheBackground };

/// A loop of 100 Hz with a map of 4 MB, and all topics of a Roomba: how much later than it should a tick is over, and
/// what of a core it takes.
void RosControlLoop(benchmark::State& state) {
  constexpr int kTicks = 1000;
  const auto watched = static_cast<Watched>(state.range(0));
  const ros::FreshDomain domain;
  ros::Bridge bridge(options_in(domain.number()), ros::kTopics);
  std::vector<std::string> topics;
  for (const ros::TopicInfo& topic : ros::kTopics) topics.emplace_back(topic.name);
  Listener listener(domain.number(), bridge.participant(), topics);

  GrowingMap map = known_map();
  const PoseEstimate estimate;
  const Decision decision{{}, "looking", false};
  const auto begin = Clock::now() + 10 * kTick;
  RobotModel robot;
  robot.open_interface = true;
  ros::PublicationParams params;
  params.epoch = std::chrono::nanoseconds(begin.time_since_epoch()).count();
  params.map_interval = 1.0;
  params.left = ros::WheelLink{"left", {"base_link", "left", {}}};
  params.right = ros::WheelLink{"right", {"base_link", "right", {}}};
  ros::Publications publications(robot, std::move(params), {&bridge});
  std::optional<BackgroundObserver> background;
  Observer* observer = nullptr;
  if (watched == InTheLoop) observer = &publications;
  if (watched == InTheBackground) observer = &background.emplace(publications);

  const double begin_cpu = cpu_time();
  std::vector<double> late;
  for ([[maybe_unused]] const auto& _ : state) {
    for (int i = 0; i < kTicks; ++i) {
      std::this_thread::sleep_until(begin + i * kTick);
      Frame frame;
      frame.stamp = 0.01 * i;
      frame.left_travel = frame.right_travel = 0.002;
      const std::int32_t at = 100 + i;
      const CellRect changed = i == 0 ? cells_of(map.view().geometry) : CellRect{{at, at}, {at + 20, at + 20}};
      map.view()[{at, at}] = static_cast<LogOdds>(i % 50);
      if (observer != nullptr) observer->notify({frame, estimate, std::as_const(map).view(), decision, changed});
      late.push_back(std::chrono::duration<double, std::micro>(Clock::now() - (begin + i * kTick)).count());
    }
  }
  if (background) background->finish();
  state.counters["cpu_percent"] = 100.0 * (cpu_time() - begin_cpu) / (kTicks * 0.01);
  state.counters["late_p50_us"] = quantile(late, 0.5);
  state.counters["late_p99_us"] = quantile(late, 0.99);
  state.counters["late_max_us"] = quantile(late, 1.0);
  state.counters["odom_p50_ms"] = listener.finish().at("odom").p50;
}
BENCHMARK(RosControlLoop)
    ->Arg(ByNobody)
    ->Arg(InTheLoop)
    ->Arg(InTheBackground)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace scrubjay::bench

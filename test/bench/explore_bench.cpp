// The whole loop as `scrubjay explore` wires it, and what each of its steps costs.
#include <benchmark/benchmark.h>

#include <array>
#include <iterator>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/mission/track.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <string>

#include "recorded_run.hpp"

namespace scrubjay::bench {
namespace {

/// Half an hour of `edge-follow` an iteration: simulation, bytes, odometry, mapping and behavior. x_real_time is
/// simulated seconds per second of CPU time.
void Explore(benchmark::State& state, const std::string& profile, int rooms) {
  const Stage stage(rooms);
  const sim::NoiseProfile floor = noise(profile);
  const RobotModel model;
  double simulated = 0.0;
  for (auto _ : state) {
    sim::SimulatedRoomba roomba(stage.world, stage.index, {}, floor, Random(1), stage.start);
    OiRobot robot(roomba, model);
    DeadReckoning localizer(model.drive);
    ContactMapper mapper(model, 0.05);
    const auto strategy = make_strategy("edge-follow", {.robot = model, .random = Random(2)});
    Mission mission(robot, localizer, mapper, *strategy, {1800.0});
    Track track;
    mission.watch(track);
    simulated += mission.run({}).time;
  }
  state.counters["segments"] = static_cast<double>(stage.index.segments().size());
  state.counters["x_real_time"] = benchmark::Counter(simulated, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(Explore, none, "none", kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Explore, hard_floor, "hard-floor", kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Explore, none_12000, "none", kEstate)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Explore, hard_floor_12000, "hard-floor", kEstate)->Unit(benchmark::kMillisecond);

struct Step {
  const char* name;
  void (*play)(const RecordedRun&);
};

constexpr Step kSteps[] = {{"body", play_body},         {"firmware", play_firmware},
                           {"oi_robot", play_oi_robot}, {"odometry", play_odometry},
                           {"mapper", play_mapper},     {"behavior", play_mapper_and_behavior}};

/// Nanoseconds of CPU time a tick that each step takes, played alone, and its share of their sum in percent.
void StepsOfExplore(benchmark::State& state, const std::string& profile) {
  const RecordedRun& run = recorded_run("edge-follow", profile);
  std::array<double, std::size(kSteps)> spent{};
  for (auto _ : state) {
    for (std::size_t i = 0; i < spent.size(); ++i) {
      const double begin = thread_cpu_time();
      kSteps[i].play(run);
      spent[i] += thread_cpu_time() - begin;
    }
  }
  spent.back() -= spent[spent.size() - 2];  // the mapper ran along with the behavior
  double sum = 0.0;
  for (const double part : spent) sum += part;
  const double ticks = static_cast<double>(run.ticks.size()) * static_cast<double>(state.iterations());
  for (std::size_t i = 0; i < spent.size(); ++i) {
    state.counters[std::string(kSteps[i].name) + "_ns"] = 1e9 * spent[i] / ticks;
    state.counters[std::string(kSteps[i].name) + "_%"] = 100.0 * spent[i] / sum;
  }
  state.counters["sum_ns"] = 1e9 * sum / ticks;
}
BENCHMARK_CAPTURE(StepsOfExplore, none, "none")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(StepsOfExplore, hard_floor, "hard-floor")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench

// The simulated Roomba with its whole sensor suite, driven as a strategy drove it: an iteration plays ten minutes of
// its commands. x_real_time is simulated seconds per second of CPU time.
#include <benchmark/benchmark.h>

#include <array>
#include <scrubjay/simulation/simulated_roomba.hpp>

#include "recorded_run.hpp"

namespace scrubjay::bench {
namespace {

void report(benchmark::State& state, const RecordedRun& run) {
  const double ticks = static_cast<double>(run.ticks.size()) * static_cast<double>(state.iterations());
  state.counters["segments"] = static_cast<double>(run.stage.index.segments().size());
  state.counters["x_real_time"] = benchmark::Counter(sim::kTick * ticks, benchmark::Counter::kIsRate);
  state.counters["tick"] = benchmark::Counter(ticks, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Wheels, contact and senses.
void Body(benchmark::State& state, const char* strategy, const char* profile, int rooms) {
  const RecordedRun& run = recorded_run(strategy, profile, rooms);
  for (auto _ : state) play_body(run);
  report(state, run);
}
BENCHMARK_CAPTURE(Body, edge_follow_none, "edge-follow", "none", kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, edge_follow_hard_floor, "edge-follow", "hard-floor", kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, random_3_none, "random-3", "none", kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, random_3_hard_floor, "random-3", "hard-floor", kHouse)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, edge_follow_none_12000, "edge-follow", "none", kEstate)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, edge_follow_hard_floor_12000, "edge-follow", "hard-floor", kEstate)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, random_3_none_12000, "random-3", "none", kEstate)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(Body, random_3_hard_floor_12000, "random-3", "hard-floor", kEstate)->Unit(benchmark::kMillisecond);

/// The same with the firmware before it, as a client on the other end of the wire meets it: bytes in, bytes out.
void BodyAndFirmware(benchmark::State& state, const char* profile) {
  const RecordedRun& run = recorded_run("edge-follow", profile);
  const Stage& stage = run.stage;
  std::array<std::uint8_t, 512> buffer;
  for (auto _ : state) {
    sim::SimulatedRoomba roomba(stage.world, stage.index, {}, noise(profile), Random(1), stage.start);
    for (const RecordedTick& tick : run.ticks) {
      if (!tick.commands.empty()) roomba.write(tick.commands);
      benchmark::DoNotOptimize(roomba.read(buffer));
    }
  }
  report(state, run);
}
BENCHMARK_CAPTURE(BodyAndFirmware, none, "none")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BodyAndFirmware, hard_floor, "hard-floor")->Unit(benchmark::kMillisecond);

/// From a world, as read, to a robot that can drive in it.
void BuildSimulation(benchmark::State& state) {
  const int rooms = static_cast<int>(state.range(0));
  const World world = make_world(rooms);
  const Pose2 start{2.0, 2.0, 0.0};
  std::size_t segments = 0;
  for (auto _ : state) {
    const SegmentIndex index(solid_segments(world));
    const sim::SimulatedRoomba roomba(world, index, {}, {}, Random(1), start);
    benchmark::DoNotOptimize(roomba.truth());
    segments = index.segments().size();
  }
  state.counters["segments"] = static_cast<double>(segments);
}
BENCHMARK(BuildSimulation)->Arg(kHouse)->Arg(kEstate)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace scrubjay::bench

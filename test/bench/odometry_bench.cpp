// Dead reckoning, a tick an iteration.
#include <benchmark/benchmark.h>

#include <array>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/odometry/encoder.hpp>
#include <scrubjay/odometry/odometry.hpp>

namespace scrubjay {
namespace {

/// Ways of the wheels in a tick: straight on, gentle arcs and turns on the spot.
std::array<WheelTravel, 256> some_travel() {
  Random random(1);
  std::array<WheelTravel, 256> travel;
  for (std::size_t i = 0; i < travel.size(); ++i) {
    const double left = random.uniform(-0.0045, 0.0045);
    travel[i] = {left, i % 4 == 0 ? left : random.uniform(-0.0045, 0.0045)};
  }
  return travel;
}

void UpdateOdometry(benchmark::State& state) {
  const auto travel = some_travel();
  Odometry odometry({});
  std::size_t tick = 0;
  for (auto _ : state) {
    ++tick;
    benchmark::DoNotOptimize(odometry.update(travel[tick % travel.size()], 0.015 * static_cast<double>(tick)));
  }
}
BENCHMARK(UpdateOdometry);

void UpdateOdometryAtRest(benchmark::State& state) {
  Odometry odometry({});
  std::size_t tick = 0;
  for (auto _ : state) benchmark::DoNotOptimize(odometry.update({}, 0.015 * static_cast<double>(++tick)));
}
BENCHMARK(UpdateOdometryAtRest);

void AdvanceEncoder(benchmark::State& state) {
  Encoder encoder;
  std::uint16_t reading = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reading = static_cast<std::uint16_t>(reading + 13));
    benchmark::DoNotOptimize(encoder.advance(reading, 100));
  }
}
BENCHMARK(AdvanceEncoder);

}  // namespace
}  // namespace scrubjay

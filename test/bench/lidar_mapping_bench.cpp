// Maps from logs of real robots: 5 cm, 20 m, every cell along each beam, the map's growing and all else included. Items
// are beams. With -DSCRUBJAY_PEERS=ON (./dev bench-peers), MRPT and OctoMap map the same scans at the same poses.
#include "logged_scans.hpp"

namespace scrubjay::bench {
namespace {

void LidarMapping(benchmark::State& state, const char* name) {
  const LoggedScans& log = logged_scans(state, name);
  for ([[maybe_unused]] const auto& _ : state) benchmark::DoNotOptimize(map_of(log).map().cells);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * log.beams());
}
BENCHMARK_CAPTURE(LidarMapping, intel, kIntel)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(LidarMapping, freiburg_079, kFreiburg)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench

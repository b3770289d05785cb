// Planning over a large building (4000 x 4000 cells of 5 cm, half known) and over a house (300 x 300).
#include <benchmark/benchmark.h>

#include <scrubjay/planning/path_search.hpp>
#include <vector>

#include "large_map.hpp"

namespace scrubjay::bench {
namespace {

/// Rooms a side.
constexpr std::int32_t kLargeBuilding = 40;
constexpr std::int32_t kSmallHouse = 3;

CostMap costs_of(const LargeMap& map) {
  CostMap costs({});
  costs.update(map.view(), cells_of(map.view().geometry));
  return costs;
}

void CostMapFromNothing(benchmark::State& state) {
  const LargeMap map(static_cast<std::int32_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(costs_of(map).view().cells);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(map.view().geometry.size()));
}
BENCHMARK(CostMapFromNothing)->Arg(kSmallHouse)->Arg(kLargeBuilding)->Unit(benchmark::kMillisecond);

/// A scan of 3.5 m: 140 x 140 cells may have changed; a person of 6 x 6 cells came or went.
void CostMapUpdate(benchmark::State& state) {
  LargeMap map(static_cast<std::int32_t>(state.range(0)));
  CostMap costs = costs_of(map);
  const CellRect changed{{5, 5}, {145, 145}};
  LogOdds value = 50;
  for (auto _ : state) {
    for (std::int32_t y = 50; y < 56; ++y) {
      for (std::int32_t x = 50; x < 56; ++x) map.view()[{x, y}] = value;
    }
    value = static_cast<LogOdds>(-value);
    benchmark::DoNotOptimize(costs.update(map.view(), changed));
  }
}
BENCHMARK(CostMapUpdate)->Arg(kSmallHouse)->Arg(kLargeBuilding)->Unit(benchmark::kMicrosecond);

/// The same, when nothing changed its class.
void CostMapUpdateOfNothing(benchmark::State& state) {
  const LargeMap map(static_cast<std::int32_t>(state.range(0)));
  CostMap costs = costs_of(map);
  for (auto _ : state) benchmark::DoNotOptimize(costs.update(map.view(), {{5, 5}, {145, 145}}));
}
BENCHMARK(CostMapUpdateOfNothing)->Arg(kSmallHouse)->Arg(kLargeBuilding)->Unit(benchmark::kMicrosecond);

/// From one corner to the other.
void FindAcross(benchmark::State& state) {
  const LargeMap map(static_cast<std::int32_t>(state.range(0)));
  const CostMap costs = costs_of(map);
  PathSearch search;
  std::size_t length = 0;
  for (auto _ : state) length = search.find(costs.view(), map.near_corner(), map.far_corner()).size();
  state.counters["cells_of_path"] = static_cast<double>(length);
}
BENCHMARK(FindAcross)->Arg(kSmallHouse)->Arg(kLargeBuilding)->Unit(benchmark::kMillisecond);

void SpreadOverAll(benchmark::State& state) {
  const LargeMap map(static_cast<std::int32_t>(state.range(0)));
  const CostMap costs = costs_of(map);
  PathSearch search;
  for (auto _ : state) {
    search.spread(costs.view(), map.near_corner());
    benchmark::DoNotOptimize(search.cost_to(map.far_corner()));
  }
  std::size_t reached = 0;
  for (std::int32_t y = 0; y < costs.view().geometry.height; ++y) {
    for (std::int32_t x = 0; x < costs.view().geometry.width; ++x) {
      reached += search.cost_to({x, y}) < PathSearch::kNever ? 1u : 0u;
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(reached));
}
BENCHMARK(SpreadOverAll)->Arg(kSmallHouse)->Arg(kLargeBuilding)->Unit(benchmark::kMillisecond);

void Simplify(benchmark::State& state) {
  const LargeMap map(static_cast<std::int32_t>(state.range(0)));
  const CostMap costs = costs_of(map);
  const std::vector<CellIndex> path = PathSearch().find(costs.view(), map.near_corner(), map.far_corner());
  std::size_t corners = 0;
  for (auto _ : state) corners = simplify(costs.view(), path).size();
  state.counters["corners"] = static_cast<double>(corners);
}
BENCHMARK(Simplify)->Arg(kSmallHouse)->Arg(kLargeBuilding)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench

#include <benchmark/benchmark.h>

#include <algorithm>
#include <bench/large_map.hpp>
#include <scrubjay/exploration/frontier_map.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {
namespace {

void FrontiersFromNothing(benchmark::State& state) {
  const bench::LargeMap map(static_cast<std::int32_t>(state.range(0)));
  for (auto _ : state) {
    FrontierMap frontiers;
    frontiers.update(map.view(), cells_of(map.view().geometry));
    benchmark::DoNotOptimize(frontiers.frontiers().data());
    state.counters["frontiers"] = static_cast<double>(frontiers.frontiers().size());
  }
}
BENCHMARK(FrontiersFromNothing)->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond);

// A robot in an unknown room sees all of its surroundings up to 3.5 m; and, with the next update, nothing again.
void FrontiersAfterOneScan(benchmark::State& state) {
  const auto rooms = static_cast<std::int32_t>(state.range(0));
  bench::LargeMap map(rooms);
  CellIndex room{rooms / 2, rooms / 2};
  while (map.is_known(room)) ++room.x;
  const Point2 center = map.view().geometry.center({room.x * map.kRoomSide + 50, room.y * map.kRoomSide + 50});
  const CellRect changed = cells_around(map.view().geometry, center, 3.5);
  std::vector<CellIndex> seen;
  visit_disc(map.view().geometry, center, 3.5, [&](CellIndex cell) {
    if (map.view()[cell] == 0) seen.push_back(cell);
  });
  FrontierMap frontiers;
  frontiers.update(map.view(), cells_of(map.view().geometry));
  bool known = false;
  for (auto _ : state) {
    state.PauseTiming();
    known = !known;
    for (const CellIndex cell : seen) map.view()[cell] = known ? -60 : 0;
    state.ResumeTiming();
    frontiers.update(map.view(), changed);
    benchmark::DoNotOptimize(frontiers.frontiers().data());
  }
}
BENCHMARK(FrontiersAfterOneScan)->Arg(10)->Arg(40)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace scrubjay

// Rooms of a large building (4000 x 4000 cells of 5 cm, half known) and of a house (300 x 300).
#include <benchmark/benchmark.h>

#include <scrubjay/mapping/rooms.hpp>

#include "large_map.hpp"

namespace scrubjay::bench {
namespace {

/// Rooms a side.
constexpr std::int32_t kRoomsOfBuilding = 40;
constexpr std::int32_t kRoomsOfHouse = 3;

void SplitIntoRooms(benchmark::State& state) {
  const LargeMap map(static_cast<std::int32_t>(state.range(0)));
  std::size_t rooms = 0;
  for (auto _ : state) rooms = split_into_rooms(map.view()).rooms.size();
  state.counters["rooms"] = static_cast<double>(rooms);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(map.view().geometry.size()));
}
BENCHMARK(SplitIntoRooms)->Arg(kRoomsOfHouse)->Arg(kRoomsOfBuilding)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace scrubjay::bench

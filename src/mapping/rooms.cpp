#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/mapping/rooms.hpp>
#include <string>
#include <utility>

#include "basin_graph.hpp"
#include "basins.hpp"
#include "clearance.hpp"
#include "floor.hpp"

namespace scrubjay {
namespace {

/// Clearance in the middle of a strip of floor of this width [cells]: 1 for one cell, 1.5 for two.
double half_width(double width, double resolution) {
  return std::min(0.5 * (width / resolution + 1.0), static_cast<double>(kMaxClearance));
}
SquaredClearance squared(double clearance) {
  return static_cast<SquaredClearance>(clearance * clearance);
}
double strip_width(SquaredClearance clearance) {
  return 2.0 * std::sqrt(static_cast<double>(clearance)) - 1.0;
}

/// How much clearance there is on both sides of a door or an opening, by the clearance in it.
std::vector<SquaredClearance> least_peaks(const RoomParams& params, double resolution) {
  const SquaredClearance widest = squared(half_width(params.widest_opening, resolution));
  const SquaredClearance least = squared(half_width(params.least_width, resolution));
  std::vector<SquaredClearance> peaks(widest + 1U);
  for (std::size_t saddle = 0; saddle < peaks.size(); ++saddle) {
    const double width = strip_width(static_cast<SquaredClearance>(saddle)) * resolution;
    const double widening = width <= params.widest_door ? params.door_widening : params.opening_widening;
    peaks[saddle] = std::max(least, squared(half_width(widening * width, resolution)));
  }
  return peaks;
}

/// Floor, flooded: basins, and how they hang together.
struct Flooded {
  Floor floor;
  std::vector<SquaredClearance> least_peaks;
  std::vector<SquaredClearance> clearance;
  std::vector<BasinLabel> basins;
  BasinGraph graph;
};

Flooded flood(Floor floor, const RoomParams& params) {
  std::vector<SquaredClearance> peaks = least_peaks(params, floor.geometry.resolution);
  const auto reach = static_cast<std::int32_t>(std::sqrt(*std::max_element(peaks.begin(), peaks.end()))) + 1;
  std::vector<SquaredClearance> clearance = squared_clearance(floor.view(), std::min(reach, kMaxClearance));
  const GridView<const SquaredClearance> view{floor.geometry, clearance.data()};
  std::vector<BasinLabel> basins = flood_basins(view, peaks);
  BasinGraph graph({floor.geometry, basins.data()}, view);
  return {std::move(floor), std::move(peaks), std::move(clearance), std::move(basins), std::move(graph)};
}

CellIndex cell_of(const Saddle& saddle, const GridGeometry& grid) {
  const auto width = static_cast<std::size_t>(grid.width);
  return {static_cast<std::int32_t>(saddle.cell % width), static_cast<std::int32_t>(saddle.cell / width)};
}

/// How far it is from a saddle, as the crow flies, to where the two basins that meet there have a clearance of `wide`,
/// in both together [cells]. Infinite if that is farther than `reach` in either.
double passage_length(const Flooded& flooded, BasinLabel a, BasinLabel b, CellIndex saddle, SquaredClearance wide,
                      std::int32_t reach) {
  const GridGeometry& grid = flooded.floor.geometry;
  const CellRect around = intersection(grown({saddle, {saddle.x + 1, saddle.y + 1}}, reach), cells_of(grid));
  double to_a = std::numeric_limits<double>::infinity();
  double to_b = to_a;
  for (std::int32_t y = around.low.y; y < around.high.y; ++y) {
    for (std::int32_t x = around.low.x; x < around.high.x; ++x) {
      const std::size_t cell = grid.index({x, y});
      if (flooded.clearance[cell] < wide) continue;
      const double dx = x - saddle.x;
      const double dy = y - saddle.y;
      const BasinLabel basin = flooded.graph.basin(flooded.basins[cell]);
      if (basin == a) to_a = std::min(to_a, dx * dx + dy * dy);
      if (basin == b) to_b = std::min(to_b, dx * dx + dy * dy);
    }
  }
  return std::sqrt(to_a) + std::sqrt(to_b);
}

/// True if what is narrow around a saddle is as short as a wall is thick. Straight on from between the two ends of a
/// wall, by d, squared clearance is by d^2 more than it was there.
bool is_doorway(const Flooded& flooded, BasinLabel a, BasinLabel b, const Saddle& saddle, double thickest_wall) {
  const GridGeometry& grid = flooded.floor.geometry;
  const SquaredClearance wide = flooded.least_peaks[saddle.clearance];
  const double longest =
      thickest_wall / grid.resolution + 2.0 * std::sqrt(std::max(0.0, static_cast<double>(wide) - saddle.clearance));
  const auto reach = static_cast<std::int32_t>(longest) + 1;
  return passage_length(flooded, a, b, cell_of(saddle, grid), wide, reach) <= longest;
}

/// Joins basins between which there is a narrow stretch, but no doorway, the widest stretch first.
void join_along_passages(Flooded& flooded, const RoomParams& params) {
  struct Meeting {
    Saddle saddle;
    BasinLabel a = 0;
    BasinLabel b = 0;
  };
  std::vector<Meeting> meetings;
  BasinGraph& graph = flooded.graph;
  for (BasinLabel a = 1; a < graph.end(); ++a) {
    for (const auto& [b, saddle] : graph.neighbours(a)) {
      if (a < b) meetings.push_back({saddle, a, b});
    }
  }
  std::stable_sort(meetings.begin(), meetings.end(), [](const Meeting& left, const Meeting& right) {
    return left.saddle.clearance > right.saddle.clearance;
  });
  for (const Meeting& meeting : meetings) {
    const BasinLabel a = graph.basin(meeting.a);
    const BasinLabel b = graph.basin(meeting.b);
    // Basins that meet elsewhere, too, and wider, were judged there.
    if (a == b || graph.neighbours(a).at(b).cell != meeting.saddle.cell) continue;
    if (!is_doorway(flooded, a, b, meeting.saddle, params.thickest_wall)) graph.join(std::max(a, b), std::min(a, b));
  }
}

/// Numbers of the rooms that basins are, the largest first.
std::vector<RoomLabel> numbers_of(const BasinGraph& graph) {
  std::vector<BasinLabel> basins;
  for (BasinLabel basin = 1; basin < graph.end(); ++basin) {
    if (graph.is_basin(basin)) basins.push_back(basin);
  }
  constexpr std::size_t kMost = std::numeric_limits<RoomLabel>::max();
  if (basins.size() > kMost) {
    throw Error("RoomParams: the map falls into " + std::to_string(basins.size()) + " rooms; want a least_area that " +
                "leaves " + std::to_string(kMost) + " at most");
  }
  std::stable_sort(basins.begin(), basins.end(),
                   [&](BasinLabel a, BasinLabel b) { return graph.area(a) > graph.area(b); });
  std::vector<RoomLabel> numbers(graph.end(), kNoRoom);
  for (std::size_t i = 0; i < basins.size(); ++i) numbers[basins[i]] = static_cast<RoomLabel>(i + 1);
  for (BasinLabel basin = 1; basin < graph.end(); ++basin) numbers[basin] = numbers[graph.basin(basin)];
  return numbers;
}

/// What is summed up over a room's cells, and the clearance of the free ones.
struct Tally {
  double x = 0.0;
  double y = 0.0;
  double cells = 0.0;
  SquaredClearance widest = 0;
  double nearest = std::numeric_limits<double>::infinity();  ///< to the centroid, among the widest, squared
};

void label_cells(RoomMap& rooms, const Flooded& flooded, GridView<const LogOdds> map,
                 const std::vector<RoomLabel>& numbers) {
  const GridGeometry& grid = flooded.floor.geometry;
  const CellIndex corner = flooded.floor.corner;
  std::vector<Tally> tallies(rooms.rooms.size());
  const auto for_each_cell = [&](auto&& visit) {
    for (std::int32_t y = 0; y < grid.height; ++y) {
      for (std::int32_t x = 0; x < grid.width; ++x) {
        const std::size_t cell = grid.index({x, y});
        const RoomLabel label = numbers[flooded.basins[cell]];
        if (label == kNoRoom) continue;
        visit(CellIndex{x + corner.x, y + corner.y}, rooms.rooms[label - 1U], tallies[label - 1U],
              flooded.clearance[cell]);
      }
    }
  };
  for_each_cell([&](CellIndex cell, Room& room, Tally& tally, SquaredClearance clearance) {
    rooms.labels[map.geometry.index(cell)] = room.label;
    room.bounds = bounding(room.bounds, {cell, {cell.x + 1, cell.y + 1}});
    tally.x += cell.x;
    tally.y += cell.y;
    tally.cells += 1.0;
    if (is_free(map[cell])) tally.widest = std::max(tally.widest, clearance);
  });
  for_each_cell([&](CellIndex cell, Room& room, Tally& tally, SquaredClearance clearance) {
    if (clearance < tally.widest || (tally.widest > 0 && !is_free(map[cell]))) return;
    const double dx = cell.x - tally.x / tally.cells;
    const double dy = cell.y - tally.y / tally.cells;
    if (dx * dx + dy * dy >= tally.nearest) return;
    tally.nearest = dx * dx + dy * dy;
    room.center = map.geometry.center(cell);
  });
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    rooms.rooms[i].area = tallies[i].cells * grid.resolution * grid.resolution;
  }
}

std::vector<Doorway> doorways_of(const Flooded& flooded, const std::vector<RoomLabel>& numbers) {
  const GridGeometry& grid = flooded.floor.geometry;
  std::vector<Doorway> doorways;
  for (BasinLabel a = 1; a < flooded.graph.end(); ++a) {
    for (const auto& [b, saddle] : flooded.graph.neighbours(a)) {
      if (numbers[a] > numbers[b]) continue;
      doorways.push_back({numbers[a], numbers[b], grid.center(cell_of(saddle, grid)),
                          strip_width(saddle.clearance) * grid.resolution});
    }
  }
  std::sort(doorways.begin(), doorways.end(), [](const Doorway& left, const Doorway& right) {
    return std::pair(left.first, left.second) < std::pair(right.first, right.second);
  });
  return doorways;
}

}  // namespace

RoomMap split_into_rooms(GridView<const LogOdds> map, const RoomParams& params) {
  const double resolution = map.geometry.resolution;
  RoomMap rooms{map.geometry, std::vector<RoomLabel>(map.geometry.size(), kNoRoom), {}, {}};
  Floor floor = free_floor(map);
  if (floor.cells.empty()) return rooms;
  const auto cells = [&](double length) { return static_cast<std::int32_t>(std::floor(length / resolution + 0.5)); };
  clear_things(floor, cells(params.largest_thing), cells(params.wall_hole));

  Flooded flooded = flood(std::move(floor), params);
  join_along_passages(flooded, params);
  flooded.graph.join_small(static_cast<std::size_t>(std::ceil(params.least_area / (resolution * resolution) - 1e-6)));

  const std::vector<RoomLabel> numbers = numbers_of(flooded.graph);
  const RoomLabel last = numbers.empty() ? kNoRoom : *std::max_element(numbers.begin(), numbers.end());
  for (RoomLabel label = 0; label < last; ++label) {
    rooms.rooms.push_back({static_cast<RoomLabel>(label + 1), 0.0, {0.0, 0.0}, {}});
  }
  label_cells(rooms, flooded, map, numbers);
  rooms.doorways = doorways_of(flooded, numbers);
  return rooms;
}

}  // namespace scrubjay

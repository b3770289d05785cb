#include "floor.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace scrubjay {
namespace {

/// The smallest rectangle that holds all free cells.
CellRect free_cells_of(GridView<const LogOdds> map) {
  CellRect rect;
  for (std::int32_t y = 0; y < map.geometry.height; ++y) {
    const LogOdds* begin = map.cells + map.geometry.index({0, y});
    const LogOdds* end = begin + map.geometry.width;
    const LogOdds* first = std::find_if(begin, end, is_free);
    if (first == end) continue;
    const LogOdds* last = end;
    while (!is_free(last[-1])) --last;
    const CellIndex low{static_cast<std::int32_t>(first - begin), y};
    rect = bounding(rect, {low, {static_cast<std::int32_t>(last - begin), y + 1}});
  }
  return rect;
}

/// Cells of a row that are no floor, and the thing that they are of.
struct Run {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  std::int32_t y = 0;
  std::uint32_t thing = 0;
};

/// Things as sets of runs, less than `gap` cells of floor apart along either axis.
class Things {
 public:
  Things(GridView<const std::uint8_t> floor, std::int32_t gap) : gap_(gap) {
    const auto gap_rows = static_cast<std::size_t>(gap);
    std::vector<std::size_t> begins;  // of each row's runs
    for (std::int32_t y = 0; y < floor.geometry.height; ++y) {
      begins.push_back(runs_.size());
      add_row(floor, y);
      for (std::size_t back = 1; back <= std::min(gap_rows, begins.size() - 1); ++back) {
        const auto below = begins.end() - 1 - static_cast<std::ptrdiff_t>(back);
        join_rows({runs_.data() + below[0], runs_.data() + below[1]},
                  {runs_.data() + begins.back(), runs_.data() + runs_.size()});
      }
    }
  }

  const std::vector<Run>& runs() const { return runs_; }
  const CellRect& bounds(const Run& run) { return bounds_[root(run.thing)]; }

 private:
  void add_row(GridView<const std::uint8_t> floor, std::int32_t y) {
    const std::uint8_t* row = floor.cells + floor.geometry.index({0, y});
    const std::uint8_t* end = row + floor.geometry.width;
    for (const std::uint8_t* cell = row;;) {
      const std::uint8_t* first = std::find(cell, end, std::uint8_t{0});
      if (first == end) return;
      cell = std::find(first, end, std::uint8_t{1});
      const Run run{static_cast<std::int32_t>(first - row), static_cast<std::int32_t>(cell - row), y,
                    static_cast<std::uint32_t>(parents_.size())};
      parents_.push_back(run.thing);
      bounds_.push_back({{run.begin, y}, {run.end, y + 1}});
      if (run.begin > 0 && run.begin - runs_.back().end < gap_) join(run.thing, runs_.back().thing);
      runs_.push_back(run);
    }
  }

  /// Joins what is near among the runs of a row and those of another one.
  void join_rows(std::span<const Run> below, std::span<const Run> here) {
    auto a = below.begin();
    auto b = here.begin();
    while (a != below.end() && b != here.end()) {
      if (a->begin - b->end < gap_ && b->begin - a->end < gap_) join(a->thing, b->thing);
      // The one that ends first is near to nothing further.
      if (a->end < b->end) {
        ++a;
      } else {
        ++b;
      }
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) return;
    parents_[std::max(a, b)] = std::min(a, b);
    bounds_[std::min(a, b)] = bounding(bounds_[a], bounds_[b]);
  }

  std::uint32_t root(std::uint32_t thing) {
    while (parents_[thing] != thing) {
      parents_[thing] = parents_[parents_[thing]];
      thing = parents_[thing];
    }
    return thing;
  }

  std::int32_t gap_;
  std::vector<Run> runs_;
  std::vector<std::uint32_t> parents_;
  std::vector<CellRect> bounds_;
};

}  // namespace

Floor free_floor(GridView<const LogOdds> map) {
  const CellRect rect = free_cells_of(map);
  if (rect.empty()) return {};
  const CellRect ringed = grown(rect, 1);
  Floor floor;
  floor.corner = ringed.low;
  const double resolution = map.geometry.resolution;
  floor.geometry = {resolution, map.geometry.origin + resolution * Point2(ringed.low.x, ringed.low.y),
                    ringed.high.x - ringed.low.x, ringed.high.y - ringed.low.y};
  floor.cells.assign(floor.geometry.size(), 0);
  for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
    const LogOdds* from = map.cells + map.geometry.index({rect.low.x, y});
    std::uint8_t* to = floor.cells.data() + floor.geometry.index({1, y - ringed.low.y});
    for (std::int32_t x = 0; x < rect.high.x - rect.low.x; ++x) to[x] = static_cast<std::uint8_t>(is_free(from[x]));
  }
  return floor;
}

void clear_things(Floor& floor, std::int32_t largest, std::int32_t gap) {
  Things things(floor.view(), std::max(gap, 1));
  for (const Run& run : things.runs()) {
    const CellRect& bounds = things.bounds(run);
    // What is around the floor doesn't stand on it, however small it is.
    if (bounds.contains({0, 0})) continue;
    if (bounds.high.x - bounds.low.x > largest || bounds.high.y - bounds.low.y > largest) continue;
    const std::size_t begin = floor.geometry.index({run.begin, run.y});
    std::fill_n(floor.cells.begin() + static_cast<std::ptrdiff_t>(begin), run.end - run.begin, std::uint8_t{1});
  }
}

}  // namespace scrubjay

#include "progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace scrubjay::apps {
namespace {

/// What is known of the map, and the share of the reachable floor in it.
struct Known {
  std::size_t cells = 0;
  double coverage = 0.0;
};

Known count_known(GridView<const LogOdds> map, const GroundTruth* truth) {
  Known known;
  std::size_t covered = 0;
  for (std::int32_t y = 0; y < map.geometry.height; ++y) {
    for (std::int32_t x = 0; x < map.geometry.width; ++x) {
      const Occupancy value = trinary(map[{x, y}]);
      if (value == kUnknown) continue;
      ++known.cells;
      if (truth == nullptr) continue;
      const CellIndex there = truth->geometry.cell_at(map.geometry.center({x, y}));
      covered +=
          value == kFree && truth->geometry.contains(there) && truth->cells[truth->geometry.index(there)].reachable;
    }
  }
  if (truth != nullptr && truth->reachable_count > 0) {
    known.coverage = static_cast<double>(covered) / static_cast<double>(truth->reachable_count);
  }
  return known;
}

}  // namespace

bool progress_wanted(bool quiet) {
  return !quiet && isatty(STDERR_FILENO) != 0;
}

Progress::~Progress() {
  if (any_) fmt::print(stderr, "\r\033[K");
}

void Progress::notify(const Snapshot& now) {
  constexpr int kTicksPerLook = 64;  // at the clock, which costs as much as a tick's work
  if (++ticks_ % kTicksPerLook != 0) return;
  const Clock::time_point clock = Clock::now();
  if (clock - shown_ < std::chrono::milliseconds(200)) return;
  shown_ = clock;
  show(now, clock);
}

void Progress::show(const Snapshot& now, Clock::time_point clock) {
  any_ = true;
  const double elapsed = std::chrono::duration<double>(clock - begin_).count();
  const Known known = count_known(now.map, truth_);
  const std::string share = truth_ != nullptr ? fmt::format("{:6.0f} x  {:3.0f} % covered  ", now.frame.stamp / elapsed,
                                                            100.0 * known.coverage)
                                              : "";
  const std::string line =
      fmt::format("{:6.0f} s  {:7} cells  {}{}", now.frame.stamp, known.cells, share, now.decision.doing);
  fmt::print(stderr, "\r\033[K{:.79}", line);
  std::fflush(stderr);
}

}  // namespace scrubjay::apps

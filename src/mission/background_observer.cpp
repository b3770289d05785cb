#include <sched.h>

#include <algorithm>
#include <scrubjay/mission/background_observer.hpp>
#include <utility>

namespace scrubjay {
namespace {

/// Copies these cells, which are the same ones in both grids but for their index.
void copy_cells(GridView<const LogOdds> from, const CellRect& cells, GridView<LogOdds> to, const CellIndex& shift) {
  for (std::int32_t y = cells.low.y; y < cells.high.y; ++y) {
    const LogOdds* row = &from[{cells.low.x, y}];
    std::copy(row, row + (cells.high.x - cells.low.x), &to[{cells.low.x + shift.x, y + shift.y}]);
  }
}

/// Whoever wakes this thread keeps the processor (sched(7), SCHED_BATCH): it is the mission, in the midst of a tick.
void never_push_ahead() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_BATCH, &none);  // if that fails, it goes on as it was
}

GridGeometry grid_of(const CellRect& cells) {
  return {.width = cells.high.x - cells.low.x, .height = cells.high.y - cells.low.y};
}

}  // namespace

BackgroundObserver::BackgroundObserver(Observer& observer, WhenFull when_full, std::size_t most_waiting)
    : observer_(observer),
      when_full_(when_full),
      most_waiting_(most_waiting),
      thread_([this](const std::stop_token& end) { run(end); }) {}

BackgroundObserver::Kept BackgroundObserver::keep(const Snapshot& now, const CellRect& changed) {
  Kept kept{now.frame, {}, now.estimate, now.decision, now.map.geometry, changed, {}, {}, {}};
  if (now.frame.scan) kept.ranges.assign(now.frame.scan->ranges.begin(), now.frame.scan->ranges.end());
  if (!changed.empty()) {
    const GridGeometry grid = grid_of(changed);
    kept.cells.resize(grid.size());
    copy_cells(now.map, changed, {grid, kept.cells.data()}, {-changed.low.x, -changed.low.y});
  }
  kept.plan.assign(now.plan.begin(), now.plan.end());
  kept.leftovers.assign(now.leftovers.begin(), now.leftovers.end());
  return kept;
}

void BackgroundObserver::notify(const Snapshot& now) {
  const GridGeometry& grid = now.map.geometry;
  if (!(grid == last_geometry_)) owed_change_ = moved(owed_change_, shift_between(last_geometry_, grid));
  last_geometry_ = grid;
  CellRect changed = intersection(bounding(owed_change_, now.changed), cells_of(grid));
  if (changed.empty()) changed = {};
  {
    std::unique_lock lock(mutex_);
    if (when_full_ == WhenFull::Wait) {
      changed_.wait(lock, [this] { return failure_ || waiting_.size() < most_waiting_; });
    }
    rethrow();
    if (waiting_.size() >= most_waiting_) {
      ++left_out_;
      return owe(now, changed);
    }
  }
  Kept kept = keep(now, changed);
  kept.frame.left_travel += std::exchange(owed_left_, 0.0);
  kept.frame.right_travel += std::exchange(owed_right_, 0.0);
  owed_change_ = {};
  {
    const std::scoped_lock lock(mutex_);
    waiting_.push_back(std::move(kept));
  }
  changed_.notify_all();
}

void BackgroundObserver::owe(const Snapshot& now, const CellRect& changed) {
  owed_change_ = changed;
  owed_left_ += now.frame.left_travel;
  owed_right_ += now.frame.right_travel;
}

void BackgroundObserver::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return failure_ || (waiting_.empty() && !busy_); });
  rethrow();
}

std::uint64_t BackgroundObserver::left_out() const {
  const std::scoped_lock lock(mutex_);
  return left_out_;
}

/// With the mutex held.
void BackgroundObserver::rethrow() {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void BackgroundObserver::run(const std::stop_token& end) {
  never_push_ahead();
  std::unique_lock lock(mutex_);
  while (!end.stop_requested() && changed_.wait(lock, end, [this] { return !waiting_.empty(); })) {
    Kept kept = std::move(waiting_.front());
    waiting_.pop_front();
    busy_ = true;
    lock.unlock();
    std::exception_ptr failure;
    try {
      show(kept);
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    busy_ = false;
    if (failure) failure_ = failure;
    if (waiting_.empty() || when_full_ == WhenFull::Wait || failure) changed_.notify_all();
  }
}

void BackgroundObserver::show(Kept& kept) {
  if (kept.frame.scan) kept.frame.scan->ranges = kept.ranges;
  follow(kept);
  observer_.notify(
      {kept.frame, kept.estimate, {geometry_, map_.data()}, kept.decision, kept.changed, kept.plan, kept.leftovers});
}

void BackgroundObserver::follow(const Kept& kept) {
  if (!(geometry_ == kept.geometry)) {
    std::vector<LogOdds> grown(kept.geometry.size());
    const CellIndex shift = shift_between(geometry_, kept.geometry);
    copy_cells({geometry_, map_.data()}, cells_of(geometry_), {kept.geometry, grown.data()}, shift);
    geometry_ = kept.geometry;
    map_ = std::move(grown);
  }
  copy_cells({grid_of(kept.changed), kept.cells.data()}, cells_of(grid_of(kept.changed)), {geometry_, map_.data()},
             kept.changed.low);
}

}  // namespace scrubjay

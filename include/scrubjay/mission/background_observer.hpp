/// \file
/// Watching a mission from another thread.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <scrubjay/mission/observer.hpp>
#include <thread>
#include <vector>

namespace scrubjay {

/// Has another observer watch from a thread of its own, so that the mission never waits for what that one does: a tick
/// costs a copy of its frame, its scan and the cells that changed. The other sees the same snapshots in the same order,
/// over a map that this keeps up with the mission's.
///
/// Where so many wait that no more are kept, a tick is left out: its travel and its changes come with the next one that
/// isn't, its scan is lost. A robot whose time can stand still may wait instead.
class BackgroundObserver final : public Observer {
 public:
  static constexpr std::size_t kMostWaiting = 1024;  ///< 15 s of a Roomba
  enum class WhenFull { LeaveOut, Wait };

  /// `observer` must outlive it, and is used by its thread alone until finish().
  explicit BackgroundObserver(Observer& observer, WhenFull when_full = WhenFull::LeaveOut,
                              std::size_t most_waiting = kMostWaiting);
  BackgroundObserver(const BackgroundObserver&) = delete;
  BackgroundObserver& operator=(const BackgroundObserver&) = delete;

  /// Throws what the other one threw since it was last told.
  void notify(const Snapshot& now) override;
  /// Waits until the other one has seen everything; it is the caller's own again. Throws what it threw.
  void finish();
  /// Ticks that were left out.
  std::uint64_t left_out() const;

 private:
  /// A snapshot that owns what it tells.
  struct Kept {
    Frame frame;
    std::vector<float> ranges;
    PoseEstimate estimate;
    Decision decision;
    GridGeometry geometry;
    CellRect changed;
    std::vector<LogOdds> cells;  // in there, row by row
    std::vector<Point2> plan;
    std::vector<Leftover> leftovers;
  };

  static Kept keep(const Snapshot& now, const CellRect& changed);
  void owe(const Snapshot& now, const CellRect& changed);
  void run(const std::stop_token& end);
  void show(Kept& kept);
  void follow(const Kept& kept);
  void rethrow();

  Observer& observer_;
  WhenFull when_full_;
  std::size_t most_waiting_;
  // The mission's side: what was left out.
  CellRect owed_change_;
  GridGeometry last_geometry_;
  double owed_left_ = 0.0;   // [m]
  double owed_right_ = 0.0;  // [m]

  mutable std::mutex mutex_;  // of all until the map
  std::condition_variable_any changed_;
  std::deque<Kept> waiting_;
  bool busy_ = false;
  std::uint64_t left_out_ = 0;
  std::exception_ptr failure_;

  // The other side: the mission's map as it was at the snapshot that is shown.
  GridGeometry geometry_;
  std::vector<LogOdds> map_;
  std::jthread thread_;  // the last member: it uses all others
};

}  // namespace scrubjay

/// \file
/// Shortest paths over a cost map.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <scrubjay/planning/cost_map.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// Searches on the 8-connected grid; a diagonal step needs both cells beside it passable. Costs are metres of open
/// floor. Same input, same path: ties are broken by a fixed order. Keeps its memory, 4 bytes a cell, from one search to
/// the next. Maps of more than 16384 cells a side are refused with an Error.
///
/// A step costs the mean of its two cells' costs, and 17/12 as much if it is diagonal (0.2 % more than it is long).
/// Where the disc can't be at the start (a wall that was seen late), it is let out: over the impassable cells within
/// `let_out` to passable ones, the nearest first; others only where those belong to an island no larger than what it is
/// let out from.
class PathSearch {
 public:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  /// `let_out` [m]: the default is a Roomba's diameter.
  explicit PathSearch(double let_out = 0.35) : let_out_(let_out) {}

  /// The cheapest path between two cells, both included; empty if there is none. A* (Hart, Nilsson, Raphael, 1968).
  /// From where the disc can't be, it is let out to passable cells near by; a goal must be passable.
  std::vector<CellIndex> find(GridView<const TravelCost> costs, CellIndex from, CellIndex to);

  /// Works out the cheapest ways from one cell to all cells that cost at most `max_cost` (Dijkstra, 1959).
  /// `costs` must stay as they are until the last call of cost_to() or path_to().
  void spread(GridView<const TravelCost> costs, CellIndex from, double max_cost = kNever);
  /// What the way of the last spread() to a cell costs; kNever where it didn't get. What it cost to be let out counts
  /// from the nearest way out, which is free.
  double cost_to(CellIndex cell) const;
  /// That way, both ends included; empty where it didn't get.
  std::vector<CellIndex> path_to(CellIndex cell) const;

 private:
  using Label = std::uint32_t;  // what the way to a cell costs, in 1/768 of a cell of open floor

  struct Entry {
    std::uint32_t place;  // column, row, and the direction in which the cell was entered
    Label label;
  };
  struct WayOut {
    CellIndex cell;
    Label label;
  };
  struct Seed {
    CellIndex cell;
    Label label;
    std::uint32_t total;  // with what is estimated of the rest of the way
  };
  static constexpr std::size_t kBuckets = 256;

  void begin(GridView<const TravelCost> costs, CellIndex from);
  void find_ways_out();
  template <typename Estimate>
  void search(const Estimate& estimate, CellIndex to);
  template <typename Estimate>
  void run(const Estimate& estimate, std::span<const Seed> seeds);
  template <typename Estimate>
  void expand(const Estimate& estimate, const Entry& entry);
  template <typename Estimate>
  void expand_all(const Estimate& estimate, const Entry& entry);
  template <typename Estimate>
  void run_on(const Estimate& estimate, Entry entry, std::uint32_t step);
  template <typename Estimate>
  void offer(const Estimate& estimate, const Entry& from, std::uint32_t direction, std::uint32_t step);
  template <typename Estimate>
  std::uint32_t bucket_of(const Estimate& estimate, const Entry& entry) const;
  std::size_t index_of(const Entry& entry) const;
  bool is_even(const Entry& entry) const;
  Label label_at(std::size_t index) const { return stored_[index] - base_; }
  Label label_of(CellIndex cell) const { return label_at(costs_.geometry.index(cell)); }
  void set_label(std::size_t index, Label label) { stored_[index] = label + base_; }
  bool reached(CellIndex cell) const;
  CellIndex step_back(CellIndex cell) const;
  std::vector<CellIndex> way_to(CellIndex cell) const;

  double let_out_;
  GridView<const TravelCost> costs_;
  std::array<std::ptrdiff_t, 8> offsets_{};  // of a cell's neighbours in storage
  CellIndex from_;
  Label max_label_ = 0;  // what is dearer isn't worked out
  Label free_ = 0;       // what it cost to be let out to the nearest passable cell

  // Labels are stored with base_ added. What earlier searches left lies below base_, wraps around and so looks too dear
  // to have been reached: no memory needs clearing until the numbers are used up.
  std::vector<Label> stored_;
  Label base_ = 0;
  Label used_ = 0;  // this search's labels are all below it
  std::array<std::vector<Entry>, kBuckets> buckets_;
  std::vector<WayOut> ways_out_;  // nearest first
  std::uint32_t goal_ = 0;        // its place
  std::uint32_t horizon_ = 0;     // the last bucket that is worked on ahead of its turn
  std::size_t settled_ = 0;
};

/// The corners of a path, as points: cells are left out where the straight line is passable and no dearer than the
/// cells that it replaces, beyond a small allowance. The first and the last cell's centres stay.
std::vector<Point2> simplify(GridView<const TravelCost> costs, const std::vector<CellIndex>& path);

/// True if all cells that the line passes are passable.
bool line_is_passable(GridView<const TravelCost> costs, const Point2& from, const Point2& to);

}  // namespace scrubjay

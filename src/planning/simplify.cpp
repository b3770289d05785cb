#include <algorithm>
#include <cmath>
#include <numbers>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/planning/path_search.hpp>

namespace scrubjay {
namespace {

// Longer legs save nothing, and looking at them takes time by the square of their length.
constexpr std::size_t kLongestLeg = 200;  // [cells of the path]
// A straight line may be this much dearer than what it replaces: part of it, and a part of a cell.
constexpr double kAllowance = 1.02;
constexpr double kAllowedCells = 0.25;

double factor(TravelCost cost) {
  return 1.0 + cost / kCostUnit;
}

double step_cost(GridView<const TravelCost> costs, CellIndex a, CellIndex b) {
  const double length = a.x != b.x && a.y != b.y ? std::numbers::sqrt2 : 1.0;
  return 0.5 * length * (factor(costs[a]) + factor(costs[b]));
}

/// What it costs to drive a line within the map [cells of open floor], read every half cell.
double line_cost(GridView<const TravelCost> costs, const Point2& from, const Point2& to) {
  const double length = (to - from).norm() / costs.geometry.resolution;
  const int pieces = std::max(1, static_cast<int>(std::ceil(2.0 * length)));
  double sum = 0.0;
  for (int i = 0; i < pieces; ++i) {
    sum += factor(costs[costs.geometry.cell_at(from + (to - from) * ((i + 0.5) / pieces))]);
  }
  return sum * length / pieces;
}

}  // namespace

bool line_is_passable(GridView<const TravelCost> costs, const Point2& from, const Point2& to) {
  bool passable = true;
  visit_line(costs.geometry, from, to,
             [&](CellIndex cell) { passable = passable && costs.contains(cell) && costs[cell] != kNoWay; });
  return passable;
}

std::vector<Point2> simplify(GridView<const TravelCost> costs, const std::vector<CellIndex>& path) {
  std::vector<Point2> corners;
  if (path.empty()) return corners;
  const auto center = [&](std::size_t i) { return costs.geometry.center(path[i]); };
  corners.push_back(center(0));
  for (std::size_t anchor = 0; anchor + 1 < path.size();) {
    std::size_t next = anchor + 1;
    double replaced = step_cost(costs, path[anchor], path[next]);
    while (next + 1 < path.size() && next - anchor < kLongestLeg) {
      replaced += step_cost(costs, path[next], path[next + 1]);
      const bool straight = line_is_passable(costs, center(anchor), center(next + 1)) &&
                            line_cost(costs, center(anchor), center(next + 1)) <= kAllowance * replaced + kAllowedCells;
      if (!straight) break;
      ++next;
    }
    corners.push_back(center(next));
    anchor = next;
  }
  return corners;
}

}  // namespace scrubjay

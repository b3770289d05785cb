#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/world/start.hpp>
#include <set>
#include <utility>

namespace scrubjay {
namespace {

constexpr double kStep = 0.1;     ///< of the lattice of places [m]
constexpr double kAir = 0.02;     ///< that a robot has around it, at least [m]
constexpr int kFarthest = 1'000;  ///< steps from the first place: a world without walls ends somewhere

bool is_over_cliff(const World& world, const Point2& place, double radius) {
  return std::any_of(world.cliffs.begin(), world.cliffs.end(), [&](const Polygon& cliff) {
    if (contains(cliff, place)) return true;
    for (std::size_t i = 0; i < cliff.size(); ++i) {
      const Segment2 edge{cliff[i], cliff[(i + 1) % cliff.size()]};
      if ((nearest_point(edge, place) - place).norm() < radius) return true;
    }
    return false;
  });
}

}  // namespace

std::vector<Pose2> starting_poses(const World& world, const SegmentIndex& index, const Pose2& first, double radius,
                                  std::size_t count) {
  std::vector<Pose2> places{first};
  using Node = std::pair<std::int32_t, std::int32_t>;
  std::set<Node> seen{{0, 0}};
  std::deque<Node> open{{0, 0}};
  const double apart = 3.0 * radius;
  while (places.size() < count && !open.empty()) {
    const auto [x, y] = open.front();
    open.pop_front();
    const Point2 place = first.position() + kStep * Point2(x, y);
    const bool is_free = std::all_of(places.begin(), places.end(),
                                     [&](const Pose2& other) { return (other.position() - place).norm() >= apart; });
    if (is_free) places.push_back({place.x(), place.y(), first.yaw});
    for (const Node& next : std::array<Node, 4>{{{x + 1, y}, {x, y + 1}, {x - 1, y}, {x, y - 1}}}) {
      if (std::max(std::abs(next.first), std::abs(next.second)) > kFarthest || !seen.insert(next).second) continue;
      const Point2 there = first.position() + kStep * Point2(next.first, next.second);
      // Neighbours are less than a radius apart: no wall is stepped over.
      if (index.distance(there, radius + kAir) < radius + kAir || is_over_cliff(world, there, radius)) continue;
      open.push_back(next);
    }
  }
  if (places.size() < count) {
    throw Error("there is room for " + std::to_string(places.size()) +
                " robots around the start; want no more, or a larger world");
  }
  return places;
}

}  // namespace scrubjay

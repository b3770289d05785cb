#include <cstdio>
#include <scrubjay/error.hpp>
#include <scrubjay/world/start.hpp>

namespace scrubjay {
namespace {

[[noreturn]] void refuse(const Pose2& start, const std::string& where, double radius) {
  char text[96];
  std::snprintf(text, sizeof text, "the start (%.3f, %.3f) ", start.x, start.y);
  char want[96];
  std::snprintf(want, sizeof want, "; want a place %.4g m from everything, the robot's radius", radius);
  throw Error(text + where + want);
}

/// Whether a place is beyond the box around everything solid. An empty world has no outside.
bool is_outside(const std::vector<SolidSegment>& solids, const Point2& place) {
  if (solids.empty()) return false;
  Point2 low = solids.front().segment.a;
  Point2 high = low;
  for (const SolidSegment& solid : solids) {
    for (const Point2& end : {solid.segment.a, solid.segment.b}) {
      low = low.cwiseMin(end);
      high = high.cwiseMax(end);
    }
  }
  return (place.array() < low.array()).any() || (place.array() > high.array()).any();
}

}  // namespace

void expect_room(const World& world, const SegmentIndex& index, const Pose2& start, double radius) {
  const Point2 place = start.position();
  for (const Furniture& piece : world.furniture) {
    for (const Polygon& part : piece.parts) {
      if (contains(part, place)) refuse(start, "lies within the " + piece.name, radius);
    }
  }
  for (const Polygon& cliff : world.cliffs) {
    if (contains(cliff, place)) refuse(start, "lies over a cliff", radius);
  }
  if (is_outside(solid_segments(world), place)) refuse(start, "lies outside of all walls", radius);
  constexpr double kSlack = 1e-3;
  const double distance = index.distance(place, radius);
  if (distance >= radius - kSlack) return;
  char text[64];
  std::snprintf(text, sizeof text, "is %.3f m from a wall", distance);
  refuse(start, text, radius);
}

}  // namespace scrubjay

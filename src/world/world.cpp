#include <algorithm>
#include <scrubjay/world/world.hpp>

namespace scrubjay {
namespace {

void add_closed(const Polygon& polygon, std::uint32_t piece, std::vector<SolidSegment>& out) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    out.push_back({{polygon[i], polygon[(i + 1) % polygon.size()]}, piece});
  }
}

Point2 left_of(const Point2& from, const Point2& to) {
  const Point2 along = (to - from).normalized();
  return {-along.y(), along.x()};
}

}  // namespace

std::vector<SolidSegment> solid_segments(const World& world) {
  std::vector<SolidSegment> out;
  std::uint32_t piece = 0;
  for (const Wall& wall : world.walls) {
    for (std::size_t i = 1; i < wall.points.size(); ++i) out.push_back({{wall.points[i - 1], wall.points[i]}, piece});
    ++piece;
  }
  for (const Furniture& furniture : world.furniture) {
    for (const Polygon& part : furniture.parts) add_closed(part, piece, out);
    ++piece;
  }
  for (const Door& door : world.doors) {
    if (door.open) continue;
    out.push_back({door.leaf, piece});
    ++piece;
  }
  return out;
}

Wall thick_wall(const std::vector<Point2>& line, double thickness) {
  std::vector<Point2> left;
  std::vector<Point2> right;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point2 before = left_of(line[i > 0 ? i - 1 : 0], line[i > 0 ? i : 1]);
    const Point2 after = i + 1 < line.size() ? left_of(line[i], line[i + 1]) : before;
    // The mitre lies on the bisector, the farther out the sharper the corner; a hairpin is cut off.
    constexpr double kSharpest = 0.2;
    const Point2 mitre = (before + after) / std::max(1.0 + before.dot(after), kSharpest);
    left.push_back(line[i] + 0.5 * thickness * mitre);
    right.push_back(line[i] - 0.5 * thickness * mitre);
  }
  Wall wall{left};
  wall.points.insert(wall.points.end(), right.rbegin(), right.rend());
  wall.points.push_back(left.front());
  return wall;
}

Polygon disc(const Point2& center, double radius, int sides) {
  Polygon corners;
  for (int i = 0; i < sides; ++i) corners.push_back(center + radius * direction(2.0 * kPi * i / sides));
  return corners;
}

Polygon box(const Point2& center, const Point2& size, double yaw) {
  const Pose2 pose{center.x(), center.y(), yaw};
  const Point2 half = 0.5 * size;
  return {pose * Point2(-half.x(), -half.y()), pose * Point2(half.x(), -half.y()), pose * Point2(half.x(), half.y()),
          pose * Point2(-half.x(), half.y())};
}

bool contains(const Polygon& polygon, const Point2& p) {
  // Even-odd rule: edges that a ray to the right crosses. Half-open in y, so that a corner counts once.
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& a = polygon[i];
    const Point2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

}  // namespace scrubjay

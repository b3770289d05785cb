/// \file
/// Ground truth as plain data: everything that a robot can meet, in the world's frame (metres, radians).
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <string>
#include <vector>

namespace scrubjay {

using Polygon = std::vector<Point2>;  ///< closed: the last corner joins the first

/// A polyline, the face of a wall; one that closes repeats its first point at the end.
struct Wall {
  std::vector<Point2> points;
};

/// A thing that stands on the floor, as the parts that touch it: one polygon, or the four legs of a table.
struct Furniture {
  std::string name;
  std::vector<Polygon> parts;
};

/// A doorway; a wall while it is closed.
struct Door {
  Segment2 leaf;
  bool open = true;
};

/// Floor with its own grip.
struct Carpet {
  Polygon outline;
  double slip = 0.0;  ///< share of the wheels' travel that is lost, 0 to 1
};

struct DirtSpot {
  Point2 center{0.0, 0.0};
  double radius = 0.1;       ///< [m]
  std::uint8_t level = 100;  ///< what the dirt detector says over it, 1 to 255
};

/// An infrared fence: a beam from the pose, as wide as `half_angle` on either side.
struct VirtualWall {
  Pose2 pose;
  double range = 2.0;       ///< [m]
  double half_angle = 0.1;  ///< [rad]
};

/// The home base. The pose is that of its face, looking out into the room.
struct Dock {
  Pose2 pose;
};

struct World {
  std::string name;
  std::vector<Wall> walls;
  std::vector<Furniture> furniture;
  std::vector<Door> doors;
  std::vector<Polygon> cliffs;  ///< floor that isn't there
  std::vector<Carpet> carpets;
  std::vector<DirtSpot> dirt;
  std::vector<VirtualWall> virtual_walls;
  std::optional<Dock> dock;
  std::optional<Pose2> start;
};

/// One straight piece of what blocks a robot, and which thing it belongs to.
struct SolidSegment {
  Segment2 segment;
  std::uint32_t piece = 0;  ///< counts walls, furniture and closed doors, in that order: shares one surface colour
};

/// All that blocks a robot. The dock doesn't: it is flat enough to be driven on.
std::vector<SolidSegment> solid_segments(const World& world);

/// The outline of a wall of `thickness` > 0 along an open polyline of two points or more, half of it to each side, with
/// mitred corners and flush ends.
Wall thick_wall(const std::vector<Point2>& line, double thickness);

/// A polygon of `sides` corners on the circle.
Polygon disc(const Point2& center, double radius, int sides = 16);
/// A rectangle of `size` around `center`, turned by `yaw`.
Polygon box(const Point2& center, const Point2& size, double yaw);

bool contains(const Polygon& polygon, const Point2& p);

}  // namespace scrubjay

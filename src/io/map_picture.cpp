#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <scrubjay/io/drawing.hpp>
#include <scrubjay/io/map_picture.hpp>
#include <scrubjay/messages/room_markers.hpp>
#include <string>

#include "picture_frame.hpp"
#include "picture_style.hpp"
#include "picture_symbols.hpp"

namespace scrubjay {
namespace {

/// A rectangle of the map's frame that grows around what it is given [m].
struct Extent {
  Point2 low = Point2::Constant(std::numeric_limits<double>::infinity());
  Point2 high = -low;

  void include(const Point2& p, double margin = 0.0) {
    constexpr double kFarthest = 1e6;  // [m]; what is farther, or isn't finite, must not shrink the rest to a dot
    if (!(p.cwiseAbs().maxCoeff() < kFarthest)) return;
    low = low.cwiseMin(p - Point2::Constant(margin));
    high = high.cwiseMax(p + Point2::Constant(margin));
  }
};

Extent extent_of(const MapPicture& picture) {
  Extent extent;
  const GridGeometry& cells = picture.map.geometry;
  for (std::int32_t y = 0; y < cells.height; ++y) {
    for (std::int32_t x = 0; x < cells.width; ++x) {
      if (picture.map[{x, y}] >= 0) extent.include(cells.center({x, y}), cells.resolution / 2.0);
    }
  }
  for (const Segment2& wall : picture.true_walls) {
    extent.include(wall.a);
    extent.include(wall.b);
  }
  for (const Pose2& pose : picture.trajectory) extent.include(pose.position(), picture.robot_radius);
  for (const auto& pose : {picture.robot, picture.start, picture.dock}) {
    if (pose) extent.include(pose->position(), picture.robot_radius);
  }
  if (extent.low.x() > extent.high.x()) extent.include(Point2(0.0, 0.0), 0.5);
  return extent;
}

/// From the map's frame to the page.
struct Projection {
  Point2 corner;  ///< upper left of the map's part of the page, in the map's frame [m]
  double pixels_per_metre = 0.0;
  Point2 offset{0.0, 0.0};  ///< the same corner on the page [pixels]

  Point2 operator()(const Point2& p) const {
    return {offset.x() + (p.x() - corner.x()) * pixels_per_metre, offset.y() + (corner.y() - p.y()) * pixels_per_metre};
  }
  /// Middle of a pixel of the map's part.
  Point2 point_at(int x, int y) const {
    return {corner.x() + (x + 0.5) / pixels_per_metre, corner.y() - (y + 0.5) / pixels_per_metre};
  }
  CanvasPose operator()(const Pose2& pose) const { return {(*this)(pose.position()), pose.yaw}; }
};

double pixels_per_cell(double longer_side) {
  constexpr double kWanted = 1200.0, kMost = 8000.0;  // [pixels]
  const double wanted = std::clamp(std::round(kWanted / longer_side), 4.0, 24.0);
  return std::min(wanted, kMost / longer_side);
}

/// Lays `color_of(cell)` over every pixel of every known cell; unknown is the page itself.
template <typename ColorOf>
void draw_cells(Canvas& canvas, const MapPicture& picture, const PageLayout& page, const Projection& to_page,
                ColorOf color_of) {
  const GridGeometry& cells = picture.map.geometry;
  for (int y = 0; y < page.map_height; ++y) {
    for (int x = 0; x < page.map_width; ++x) {
      const CellIndex cell = cells.cell_at(to_page.point_at(x, y));
      if (!cells.contains(cell) || picture.map[cell] < 0) continue;
      canvas.blend(page.map_left + x, page.map_top + y, color_of(picture.map[cell]));
    }
  }
}

Color paper(Occupancy) {
  return style::kPaper;
}
Color ink(Occupancy cell) {
  return faded(style::kInk, static_cast<double>(cell) / kOccupied);
}

Color color_of(RoomLabel label) {
  const ros::ColorRGBA color = ros::room_color(label);
  const auto channel = [](float share) { return static_cast<std::uint8_t>(255.0F * share + 0.5F); };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

void draw_rooms(Canvas& canvas, const RoomMap& rooms, const PageLayout& page, const Projection& to_page) {
  constexpr double kOpacity = 0.3;
  if (rooms.rooms.empty()) return;
  for (int y = 0; y < page.map_height; ++y) {
    for (int x = 0; x < page.map_width; ++x) {
      const CellIndex cell = rooms.geometry.cell_at(to_page.point_at(x, y));
      if (!rooms.geometry.contains(cell) || rooms.view()[cell] == kNoRoom) continue;
      canvas.blend(page.map_left + x, page.map_top + y, faded(color_of(rooms.view()[cell]), kOpacity));
    }
  }
}

void draw_room_labels(Canvas& canvas, const RoomMap& rooms, const Projection& to_page) {
  constexpr int kScale = 3;
  for (const Room& room : rooms.rooms) {
    const std::string label = std::to_string(room.label);
    const Point2 center = to_page(room.center);
    canvas.draw_text(static_cast<int>(std::lround(center.x())) - text_width(label, kScale) / 2,
                     static_cast<int>(std::lround(center.y())) - 7 * kScale / 2, label, kScale, style::kInk);
  }
}

void draw_metre_lines(Canvas& canvas, const PageLayout& page, const Projection& to_page) {
  if (to_page.pixels_per_metre < 20.0) return;
  const double right = to_page.corner.x() + page.map_width / to_page.pixels_per_metre;
  const double bottom = to_page.corner.y() - page.map_height / to_page.pixels_per_metre;
  for (double x = std::ceil(to_page.corner.x()); x < right; x += 1.0) {
    const int column = static_cast<int>(std::lround(to_page(Point2{x, bottom}).x()));
    canvas.fill_rectangle(column, page.map_top, 1, page.map_height, style::kMetreLines);
  }
  for (double y = std::ceil(bottom); y < to_page.corner.y(); y += 1.0) {
    const int row = static_cast<int>(std::lround(to_page(Point2{right, y}).y()));
    canvas.fill_rectangle(page.map_left, row, page.map_width, 1, style::kMetreLines);
  }
}

void draw_trajectory(Canvas& canvas, const std::vector<Pose2>& trajectory, const Projection& to_page) {
  constexpr double kStep = 1.5;  // shorter steps don't show [pixels]
  if (trajectory.empty()) return;
  Point2 last = to_page(trajectory.front().position());
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    const Point2 next = to_page(trajectory[i].position());
    if ((next - last).norm() < kStep && i + 1 < trajectory.size()) continue;
    const double share = static_cast<double>(i) / static_cast<double>(trajectory.size() - 1);
    canvas.draw_polyline(std::array{last, next}, 2.4, mix(style::kPathBegin, style::kPathEnd, share));
    last = next;
  }
}

void draw_marks(Canvas& canvas, const MapPicture& picture, const Projection& to_page) {
  const double radius = std::max(picture.robot_radius * to_page.pixels_per_metre, 7.0);
  if (picture.dock) draw_dock(canvas, to_page(*picture.dock), std::max(0.3 * to_page.pixels_per_metre, 18.0));
  if (picture.start) draw_start(canvas, to_page(*picture.start), std::clamp(radius, 14.0, 26.0));
  for (const Point2& bump : picture.bumps) draw_bump(canvas, to_page(bump), 8.0);
  for (const Point2& left : picture.left) draw_left(canvas, to_page(left), 13.0);
  if (picture.robot) draw_robot(canvas, to_page(*picture.robot), radius);
  for (const Point2& stuck : picture.stuck) draw_stuck(canvas, to_page(stuck), 22.0);
}

}  // namespace

Image draw_map(const MapPicture& picture) {
  const GridGeometry& cells = picture.map.geometry;
  const Extent extent = extent_of(picture);
  // Whole cells and one around them, so that cell edges fall on pixel edges.
  const auto outward = [&](double value, double origin, double sign) {
    return origin + (sign * std::ceil(sign * (value - origin) / cells.resolution - 1e-6) + sign) * cells.resolution;
  };
  const Point2 low{outward(extent.low.x(), cells.origin.x(), -1.0), outward(extent.low.y(), cells.origin.y(), -1.0)};
  const Point2 high{outward(extent.high.x(), cells.origin.x(), 1.0), outward(extent.high.y(), cells.origin.y(), 1.0)};
  const Point2 size = (high - low) / cells.resolution;  // [cells]
  const double per_cell = pixels_per_cell(size.maxCoeff());
  const auto pixels = [&](double side) { return std::max(1, static_cast<int>(std::lround(side * per_cell))); };

  Projection to_page{{low.x(), high.y()}, per_cell / cells.resolution};
  const PageLayout page = lay_out_page(picture, pixels(size.x()), pixels(size.y()), to_page.pixels_per_metre);
  to_page.offset = Point2(page.map_left, page.map_top);

  Canvas canvas(page.width, page.height, style::kUnknownGround);
  draw_cells(canvas, picture, page, to_page, paper);
  draw_rooms(canvas, picture.rooms, page, to_page);
  draw_metre_lines(canvas, page, to_page);
  for (const Segment2& wall : picture.true_walls) {
    canvas.draw_polyline(std::array{to_page(wall.a), to_page(wall.b)}, 3.0, style::kTrueWall);
  }
  draw_cells(canvas, picture, page, to_page, ink);
  draw_room_labels(canvas, picture.rooms, to_page);
  draw_trajectory(canvas, picture.trajectory, to_page);
  draw_marks(canvas, picture, to_page);
  draw_frame(canvas, picture, page, to_page.pixels_per_metre, extent.high - extent.low);
  return canvas.image();
}

}  // namespace scrubjay

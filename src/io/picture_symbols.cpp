#include "picture_symbols.hpp"

#include <algorithm>
#include <array>

#include "picture_style.hpp"

namespace scrubjay {

Point2 CanvasPose::ahead(double forward, double left) const {
  const Point2 along = direction(heading);
  return {at.x() + forward * along.x() - left * along.y(), at.y() - forward * along.y() - left * along.x()};
}

void draw_robot(Canvas& canvas, const CanvasPose& pose, double radius) {
  canvas.fill_disc(pose.at, radius + 2.0, faded(style::kWhite, 0.7));
  canvas.fill_disc(pose.at, radius, style::kRobot);
  canvas.draw_circle(pose.at, radius - 1.0, 2.0, style::kRobotRim);
  const std::array<Point2, 4> arrow{pose.ahead(0.68 * radius, 0.0), pose.ahead(-0.42 * radius, 0.46 * radius),
                                    pose.ahead(-0.18 * radius, 0.0), pose.ahead(-0.42 * radius, -0.46 * radius)};
  canvas.fill_polygon(arrow, style::kWhite);
}

void draw_start(Canvas& canvas, const CanvasPose& pose, double size) {
  const double radius = 0.36 * size;
  canvas.fill_disc(pose.at, radius + 2.5, faded(style::kWhite, 0.9));
  const std::array<Point2, 3> nose{pose.ahead(radius + 0.38 * size, 0.0), pose.ahead(radius - 1.0, 0.26 * size),
                                   pose.ahead(radius - 1.0, -0.26 * size)};
  canvas.fill_polygon(nose, style::kStart);
  canvas.draw_circle(pose.at, radius, 0.2 * size, style::kStart);
}

void draw_dock(Canvas& canvas, const CanvasPose& face, double width) {
  const double depth = 0.42 * width, half = width / 2.0, corner = 0.12 * width;
  const std::array<Point2, 6> body{face.ahead(0.0, half),
                                   face.ahead(-depth + corner, half),
                                   face.ahead(-depth, half - corner),
                                   face.ahead(-depth, corner - half),
                                   face.ahead(-depth + corner, -half),
                                   face.ahead(0.0, -half)};
  canvas.draw_polyline(body, 4.0, faded(style::kWhite, 0.7));
  canvas.fill_polygon(body, style::kDock);
  for (const double side : {-1.0, 1.0}) {  // the charging contacts
    const std::array<Point2, 2> contact{face.ahead(-0.14 * width, side * 0.12 * width),
                                        face.ahead(-0.14 * width, side * 0.3 * width)};
    canvas.draw_polyline(contact, std::max(2.0, 0.1 * width), style::kWhite);
  }
}

void draw_bump(Canvas& canvas, const Point2& at, double size) {
  const double half = size / 2.0;
  for (const double side : {-1.0, 1.0}) {
    const std::array<Point2, 2> stroke{at + Point2{-half, -side * half}, at + Point2{half, side * half}};
    canvas.draw_polyline(stroke, std::max(1.6, 0.24 * size), style::kBump);
  }
}

void draw_left(Canvas& canvas, const Point2& at, double size) {
  const double half = size / 2.0;
  const std::array<Point2, 5> diamond{at + Point2{0.0, -half}, at + Point2{half, 0.0}, at + Point2{0.0, half},
                                      at + Point2{-half, 0.0}, at + Point2{0.0, -half}};
  canvas.draw_polyline(diamond, 4.5, faded(style::kWhite, 0.8));
  canvas.draw_polyline(diamond, 2.4, style::kLeft);
}

void draw_stuck(Canvas& canvas, const Point2& at, double size) {
  const double half = 0.58 * size;
  const std::array<Point2, 3> sign{at + Point2{0.0, -0.6 * size}, at + Point2{half, 0.45 * size},
                                   at + Point2{-half, 0.45 * size}};
  const std::array<Point2, 4> outline{sign[0], sign[1], sign[2], sign[0]};
  canvas.draw_polyline(outline, 4.5, style::kInk);
  canvas.fill_polygon(sign, style::kStuck);
  const std::array<Point2, 2> stroke{at + Point2{0.0, -0.18 * size}, at + Point2{0.0, 0.1 * size}};
  canvas.draw_polyline(stroke, 0.14 * size, style::kInk);
  canvas.fill_disc(at + Point2{0.0, 0.31 * size}, 0.085 * size, style::kInk);
}

}  // namespace scrubjay

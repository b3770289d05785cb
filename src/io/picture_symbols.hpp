/// \file
/// The symbols of map pictures, in the map and in its legend alike.
#pragma once

#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/io/drawing.hpp>

namespace scrubjay {

/// A place on a canvas and a heading as the eye sees it: counter-clockwise from the right [rad].
struct CanvasPose {
  Point2 at;
  double heading = 0.0;

  /// The pixel `forward` ahead of here and `left` to the side.
  Point2 ahead(double forward, double left) const;
};

void draw_robot(Canvas& canvas, const CanvasPose& pose, double radius);
void draw_start(Canvas& canvas, const CanvasPose& pose, double size);
void draw_dock(Canvas& canvas, const CanvasPose& face, double width);
void draw_bump(Canvas& canvas, const Point2& at, double size);
void draw_left(Canvas& canvas, const Point2& at, double size);
void draw_stuck(Canvas& canvas, const Point2& at, double size);

}  // namespace scrubjay

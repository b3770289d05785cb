#include <cmath>
#include <scrubjay/localization/wall_compass.hpp>

namespace scrubjay {
namespace {

constexpr double kOutlier = 3.0;  // a wall that is as far askew counts half (Cauchy) [standard deviations]

/// Four times the angle of a wall in the map.
double quadruple(const StraightWall& wall, double yaw) {
  return 4.0 * (atan2(wall.along.y(), wall.along.x()) + yaw);
}

/// How they stand together, by their lengths.
Point2 axis_of(std::span<const StraightWall> walls, double yaw) {
  Point2 sum(0.0, 0.0);
  for (const StraightWall& wall : walls) sum += wall.length * direction(quadruple(wall, yaw));
  return sum;
}

}  // namespace

std::optional<HeadingError> WallCompass::read(std::span<const StraightWall> walls, double yaw) {
  const bool begins = axis_.isZero(0.0);
  const Point2 axis = begins ? axis_of(walls, yaw) : axis_;
  const double axis_angle = atan2(axis.y(), axis.x());
  double length = 0.0;
  double square_length = 0.0;
  HeadingError error;
  Point2 seen(0.0, 0.0);
  for (const StraightWall& wall : walls) {
    length += wall.length;
    const double angle = quadruple(wall, yaw);
    const double off = 0.25 * wrap_angle(axis_angle - angle);
    if (std::fabs(off) > params_.gate) continue;
    square_length += wall.length;
    const double variance = wall.angle_variance + params_.deviation * params_.deviation;
    const double weight = 1.0 / (variance + off * off / (kOutlier * kOutlier));
    error.off += weight * off;
    error.information += weight;
    seen += weight * direction(angle);
  }
  if (square_length == 0.0 || square_length < params_.least_share * length) return std::nullopt;
  axis_ += seen;
  if (begins) return std::nullopt;
  error.off /= error.information;
  error.information *= params_.trust;
  return error;
}

}  // namespace scrubjay

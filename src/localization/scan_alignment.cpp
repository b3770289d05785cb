#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <scrubjay/localization/scan_alignment.hpp>

namespace scrubjay {
namespace {

constexpr double kFarthest = 2.0;        // ends farther than this from their lines are of something else [cells] ...
constexpr double kFarthestSigmas = 3.0;  // ... if it is as many standard deviations, too
constexpr double kSmallMove = 1e-5;      // ends the search [m]
constexpr double kSmallTurn = 1e-5;      // ends the search [rad]
constexpr double kSameWall = 0.97;       // cosine between a line and the wall that an end is of, if they are one
constexpr CellIndex kNowhere{std::numeric_limits<std::int32_t>::min(), 0};

double square(double x) {
  return x * x;
}

/// Across the wall that an end is of (`wall` is 0 for none), if the line is a piece of that.
const Point2& normal_of(const SurfaceLine& line, const Point2& wall) {
  return std::fabs(line.normal.dot(wall)) > kSameWall ? wall : line.normal;
}

Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, angle_difference(a.yaw, b.yaw)};
}

}  // namespace

ScanAlignment ScanAligner::align(std::span<const ScanEnd> ends, const SurfaceMap& surfaces,
                                 const LikelihoodField& field, const PosePrior& prior, const Pose2& start) {
  pairings_.assign(ends.size(), {kNowhere, std::nullopt});
  Pose2 pose = start;
  Slope slope;
  for (int iteration = 0; iteration < params_.max_iterations; ++iteration) {
    slope = slope_at(pose, ends, surfaces, field);
    const Eigen::Vector3d pull = slope.pull - prior.information * difference(pose, prior.pose);
    const Eigen::Vector3d move = (slope.information + prior.information).ldlt().solve(pull);
    pose = {pose.x + move.x(), pose.y + move.y(), wrap_angle(pose.yaw + move.z())};
    if (std::fabs(move.x()) + std::fabs(move.y()) < kSmallMove && std::fabs(move.z()) < kSmallTurn) break;
  }
  return {pose, slope.information, slope.support};
}

/// Across a line that the beam meets at an angle of this cosine to its normal.
ScanAligner::Uncertainty ScanAligner::uncertainty(const ScanEnd& end, double cosine, double of_line) const {
  const double of_end = variance_across(end, cosine) + square(params_.blur);
  const double beams = std::max(1.0, params_.shared * cosine / end.width);
  return {of_end + of_line, of_end + beams * of_line};
}

ScanAligner::Slope ScanAligner::slope_at(const Pose2& pose, std::span<const ScanEnd> ends, const SurfaceMap& surfaces,
                                         const LikelihoodField& field) {
  const double near = square(kFarthest * field.geometry().resolution);
  const double per_square_outlier = 1.0 / square(params_.outlier);
  const SinCos heading = sin_cos(pose.yaw);
  Slope sum;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Point2 arm = turned(heading, ends[i].point);
    const Point2 end = pose.position() + arm;
    const CellIndex cell = field.geometry().cell_at(end);
    Pairing& pairing = pairings_[i];
    const Point2 view = turned(heading, ends[i].view);
    if (!(cell == pairing.cell)) pairing = {cell, surfaces.line_at(cell, view, field)};
    if (!pairing.line) continue;

    const Point2 wall = turned(heading, ends[i].normal);
    const Point2& normal = normal_of(*pairing.line, wall);
    const double distance = normal.dot(end - pairing.line->point);
    const Uncertainty error = uncertainty(ends[i], std::fabs(normal.dot(view)), pairing.line->variance);
    if (square(distance) > std::max(near, square(kFarthestSigmas) * error.shared)) continue;
    const double outlying = square(distance) * per_square_outlier;
    const double fit = error.shared / (error.shared + outlying);
    const double weight = params_.trust * fit / error.shared;
    const Eigen::Vector3d by_pose(normal.x(), normal.y(), normal.y() * arm.x() - normal.x() * arm.y());
    sum.information.noalias() += weight * by_pose * by_pose.transpose();
    sum.pull -= weight * distance * by_pose;
    sum.support += error.own / (error.own + outlying);
  }
  return sum;
}

}  // namespace scrubjay

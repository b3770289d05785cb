#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/localization/scan_matching.hpp>

namespace scrubjay {
namespace {

constexpr double kWindowSigmas = 3.0;    // standard deviations of odometry that the search goes
constexpr double kLeastVariance = 1e-9;  // the first pose is known for certain, but nothing divides by that

const LidarModel& lidar_of(const RobotModel& robot) {
  if (!robot.lidar) throw Error("scan matching wants a robot with a lidar; this one has none");
  return *robot.lidar;
}

Point2 turned(const SinCos& turn, const Point2& v) {
  return {turn.cos * v.x() - turn.sin * v.y(), turn.sin * v.x() + turn.cos * v.y()};
}

double square(double x) {
  return x * x;
}

/// Covariance of a pose that `moved` from one of covariance `before` through a motion that errs by `noise`.
Eigen::Matrix3d spread(const Eigen::Matrix3d& before, const Point2& moved, double way_noise, double turn_noise) {
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 2) = -moved.y();
  shear(1, 2) = moved.x();
  const Eigen::Matrix3d carried = shear * before * shear.transpose();
  Eigen::Matrix3d after = 0.5 * (carried + carried.transpose());  // symmetric to the last bit
  after.diagonal() += Eigen::Vector3d(square(way_noise), square(way_noise), square(turn_noise));
  return after;
}

}  // namespace

ScanMatching::ScanMatching(const RobotModel& robot, const Mapper& mapper, const ScanMatchingParams& params)
    : mapper_(mapper),
      params_(params),
      lidar_(lidar_of(robot)),
      odometry_(robot.drive),
      scan_points_(lidar_, {params.max_range}),
      search_(params.beam_weight),
      aligner_(params.alignment) {}

const PoseEstimate& ScanMatching::update(const Frame& frame) {
  field_.follow(mapper_.map(), mapper_.changed());
  reckon(frame);
  if (frame.scan) match(frame);
  return estimate_;
}

/// The pose by odometry since the last match.
void ScanMatching::reckon(const Frame& frame) {
  const PoseEstimate& odometry = odometry_.update(frame);
  const Pose2 step = inverse(last_odometry_) * odometry.pose;
  last_odometry_ = odometry.pose;
  way_ += std::sqrt(step.position().squaredNorm());
  turn_ += std::fabs(step.yaw);
  estimate_.pose = anchor_.pose * (inverse(odometry_at_anchor_) * odometry.pose);
  const MotionNoise& noise = params_.motion;
  estimate_.covariance = spread(anchor_.covariance, estimate_.pose.position() - anchor_.pose.position(),
                                noise.way_per_way * way_ + noise.way_per_turn * turn_,
                                noise.turn_per_turn * turn_ + noise.turn_per_way * way_);
  estimate_.twist = odometry.twist;
  estimate_.twist_covariance = odometry.twist_covariance;
}

void ScanMatching::match(const Frame& frame) {
  if (started_ && way_ < params_.min_travel && turn_ < params_.min_turn) return;
  take(frame);
  if (ends_.empty()) return;
  if (lay_over_map() || !started_) anchor();
  started_ = true;
  remember();
}

/// The ends of the frame's scan.
void ScanMatching::take(const Frame& frame) {
  ends_.clear();
  for (const Beam& beam : scan_points_.beams(*frame.scan, frame.stamp, estimate_.twist)) {
    if (!beam.hit) continue;
    const Point2 back = beam.origin - beam.end;
    const double range = std::sqrt(back.squaredNorm());
    ends_.push_back({beam.end, back / range, params_.end_noise + lidar_.noise + lidar_.noise_per_range * range});
  }
  search_ends_.clear();
  const std::size_t stride = std::max<std::size_t>(1, ends_.size() / static_cast<std::size_t>(params_.search_beams));
  for (std::size_t i = 0; i < ends_.size(); i += stride) search_ends_.push_back(ends_[i].point);
}

/// True if the scan told where the robot is.
bool ScanMatching::lay_over_map() {
  const GridView<const LogOdds> map = mapper_.map();
  if (map.geometry.size() == 0) return false;
  const int known = count_known(map);
  Eigen::Matrix3d covariance = estimate_.covariance;
  covariance.diagonal().array() += kLeastVariance;
  ScanAlignment aligned = match_within(covariance);
  if (aligned.support < params_.doubtful_share * known) {
    // Wheels slip at times by far more than they ever do otherwise.
    Eigen::Vector3d wide(params_.window, params_.window, params_.window_angle);
    wide /= kWindowSigmas;
    const Eigen::Matrix3d slipped = covariance + Eigen::Matrix3d(wide.cwiseAbs2().asDiagonal());
    const ScanAlignment elsewhere = match_within(slipped);
    if (elsewhere.support > params_.slip_gain * aligned.support) {
      aligned = elsewhere;
      covariance = slipped;
    }
  }
  if (aligned.support < params_.min_support || aligned.support < params_.min_share * known) return false;
  estimate_.pose = aligned.pose;
  // The inverse of a symmetric matrix is one but for rounding.
  const Eigen::Matrix3d fused = (covariance.inverse() + aligned.information).inverse();
  estimate_.covariance = 0.5 * (fused + fused.transpose());
  return true;
}

/// Matches the scan near the pose by odometry, which errs by `covariance`.
ScanAlignment ScanMatching::match_within(const Eigen::Matrix3d& covariance) {
  const PosePrior prior{estimate_.pose, covariance.inverse()};
  const double reach = kWindowSigmas * std::sqrt(std::max(covariance(0, 0), covariance(1, 1)));
  const double reach_angle = kWindowSigmas * std::sqrt(covariance(2, 2));
  const SearchWindow window{
      std::max(1, static_cast<std::int32_t>(std::ceil(std::min(reach, params_.window) / field_.geometry().resolution))),
      std::min(reach_angle, params_.window_angle)};
  return aligner_.align(ends_, surfaces_, field_, prior, search_.best(search_ends_, field_, prior, window));
}

/// How many ends of the scan lie, by odometry, where the map knows anything.
int ScanMatching::count_known(GridView<const LogOdds> map) const {
  int known = 0;
  const SinCos heading = sin_cos(estimate_.pose.yaw);
  for (const ScanEnd& end : ends_) {
    const CellIndex c = map.geometry.cell_at(estimate_.pose.position() + turned(heading, end.point));
    known += map.contains(c) && map[c] != 0;
  }
  return known;
}

/// Odometry counts from here on.
void ScanMatching::anchor() {
  anchor_ = estimate_;
  odometry_at_anchor_ = last_odometry_;
  way_ = turn_ = 0.0;
}

/// The scan becomes a part of what later ones are laid over.
void ScanMatching::remember() {
  const SinCos heading = sin_cos(estimate_.pose.yaw);
  for (const ScanEnd& end : ends_) {
    surfaces_.add(estimate_.pose.position() + turned(heading, end.point), turned(heading, end.view), end.noise, field_);
  }
}

}  // namespace scrubjay

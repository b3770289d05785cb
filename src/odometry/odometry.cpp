#include <cmath>
#include <scrubjay/odometry/arc.hpp>
#include <scrubjay/odometry/odometry.hpp>

namespace scrubjay {
namespace {

constexpr double kClockSetBack = 1.0;  // stamps that go back by less are only late [s]

}  // namespace

Odometry::Odometry(const DifferentialDrive& drive, const WheelNoise& noise, const Pose2& start)
    : drive_(drive), noise_(noise) {
  estimate_.pose = start;
}

const PoseEstimate& Odometry::update(const WheelTravel& travel, double stamp) {
  if (travel.left != 0.0 || travel.right != 0.0) {
    const Arc arc = arc_of(travel, drive_);
    Pose2& pose = estimate_.pose;
    const SinCos middle = sin_cos(pose.yaw + 0.5 * arc.turn);
    propagate(travel, middle.sin, middle.cos);
    const double reach = chord(arc);
    pose.x += reach * middle.cos;
    pose.y += reach * middle.sin;
    pose.yaw = wrap_angle(pose.yaw + arc.turn);
  }
  update_twist(travel, stamp);
  return estimate_;
}

const PoseEstimate& Odometry::follow(const Pose2& pose, double stamp) {
  const Pose2 step = pose == estimate_.pose ? Pose2{} : inverse(estimate_.pose) * pose;
  const double distance = std::sqrt(step.x * step.x + step.y * step.y);
  const Arc arc{std::copysign(distance, step.x), step.yaw};
  const double lead = 0.5 * arc.turn * drive_.wheel_separation;
  const WheelTravel travel{arc.length - lead, arc.length + lead};
  if (travel.left != 0.0 || travel.right != 0.0) {
    const SinCos middle = sin_cos(estimate_.pose.yaw + 0.5 * arc.turn);
    propagate(travel, middle.sin, middle.cos);
    estimate_.pose = pose;
  }
  update_twist(travel, stamp);
  return estimate_;
}

void Odometry::propagate(const WheelTravel& travel, double middle_sin, double middle_cos) {
  const double length = 0.5 * (travel.right + travel.left);
  const double dx = -length * middle_sin;  // how position moves with heading
  const double dy = length * middle_cos;
  Eigen::Matrix3d& p = estimate_.covariance;

  // F P F^T for F = [1 0 dx; 0 1 dy; 0 0 1], symmetric.
  const double xx = p(0, 0) + dx * (2.0 * p(0, 2) + dx * p(2, 2));
  const double yy = p(1, 1) + dy * (2.0 * p(1, 2) + dy * p(2, 2));
  const double xy = p(0, 1) + dy * p(0, 2) + dx * p(1, 2) + dx * dy * p(2, 2);
  const double xt = p(0, 2) + dx * p(2, 2);
  const double yt = p(1, 2) + dy * p(2, 2);
  const double tt = p(2, 2);

  // + G diag(q_right, q_left) G^T, G's columns being the pose's derivative by each wheel's travel.
  const double per_turn = 1.0 / drive_.wheel_separation;
  const double rx = 0.5 * middle_cos + 0.5 * per_turn * dx;
  const double ry = 0.5 * middle_sin + 0.5 * per_turn * dy;
  const double lx = 0.5 * middle_cos - 0.5 * per_turn * dx;
  const double ly = 0.5 * middle_sin - 0.5 * per_turn * dy;
  const double qr = noise_.right_variance_per_metre * std::fabs(travel.right);
  const double ql = noise_.left_variance_per_metre * std::fabs(travel.left);
  p(0, 0) = xx + qr * rx * rx + ql * lx * lx;
  p(1, 1) = yy + qr * ry * ry + ql * ly * ly;
  p(2, 2) = tt + (qr + ql) * per_turn * per_turn;
  p(0, 1) = p(1, 0) = xy + qr * rx * ry + ql * lx * ly;
  p(0, 2) = p(2, 0) = xt + (qr * rx - ql * lx) * per_turn;
  p(1, 2) = p(2, 1) = yt + (qr * ry - ql * ly) * per_turn;
}

void Odometry::update_twist(const WheelTravel& travel, double stamp) {
  // A clock that was set back starts a new interval, or the twist would stand still until it has caught up.
  if (!started_ || stamp < twist_stamp_ - kClockSetBack) {
    started_ = true;
    since_twist_ = {};
    twist_stamp_ = stamp;
    return;
  }
  since_twist_.left += travel.left;
  since_twist_.right += travel.right;
  const double interval = stamp - twist_stamp_;
  if (interval < kTwistInterval) return;

  const Arc arc = arc_of(since_twist_, drive_);
  estimate_.twist = {arc.length / interval, 0.0, arc.turn / interval};
  const double qr = noise_.right_variance_per_metre * std::fabs(since_twist_.right);
  const double ql = noise_.left_variance_per_metre * std::fabs(since_twist_.left);
  const double per_turn = 1.0 / drive_.wheel_separation;
  const double per_square = 1.0 / (interval * interval);
  Eigen::Matrix3d& p = estimate_.twist_covariance;
  p(0, 0) = 0.25 * (qr + ql) * per_square;
  p(2, 2) = (qr + ql) * per_turn * per_turn * per_square;
  p(0, 2) = p(2, 0) = 0.5 * (qr - ql) * per_turn * per_square;
  since_twist_ = {};
  twist_stamp_ = stamp;
}

}  // namespace scrubjay

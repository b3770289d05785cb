#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <scrubjay/odometry/arc.hpp>
#include <scrubjay/odometry/calibration_fit.hpp>

namespace scrubjay {
namespace {

using Factors = Eigen::Vector3d;  // left, right, axle

constexpr int kMaxSteps = 30;
constexpr int kMaxHalvings = 10;
constexpr double kSettled = 1e-6;  // a step by less ends the search; no robot is that constant
constexpr double kDelta = 1e-6;    // of the difference quotients

Calibration as_calibration(const Factors& factors) {
  return {factors[0], factors[1], factors[2]};
}

bool plausible(const Factors& factors) {
  return (factors.array() > 0.5).all() && (factors.array() < 2.0).all();  // false for what is no number
}

/// All that can be measured of an end, as a vector: x, y, distance, turn.
using End = Eigen::Vector4d;

End as_vector(const EndOfDrive& end) {
  return {end.offset->x(), end.offset->y(), *end.distance, *end.turn};
}

/// How an end moves with each factor, by central differences.
Eigen::Matrix<double, 4, 3> derivative(std::span<const WheelTravel> travel, const DifferentialDrive& drive,
                                       const Factors& at) {
  Eigen::Matrix<double, 4, 3> columns;
  for (int i = 0; i < 3; ++i) {
    const Factors step = kDelta * Factors::Unit(i);
    columns.col(i) = (as_vector(end_of(travel, drive, as_calibration(at + step))) -
                      as_vector(end_of(travel, drive, as_calibration(at - step)))) /
                     (2.0 * kDelta);
  }
  return columns;
}

/// What random errors of the wheels make of the end's x, y and yaw.
Eigen::Matrix3d scatter(const MeasuredDrive& measured, const DifferentialDrive& drive,
                        const CalibrationFitParams& params) {
  Odometry odometry(drive, params.noise);
  for (const WheelTravel& tick : measured.travel) odometry.update(tick, 0.0);
  return odometry.estimate().covariance;
}

/// The quadratic that a Gauss-Newton step goes to the bottom of.
struct Normal {
  Eigen::Matrix3d information;
  Factors gradient;
};

class Objective {
 public:
  Objective(const DifferentialDrive& drive, const CalibrationFitParams& params) : drive_(drive), params_(params) {
    const auto say = [&](const Factors& row, double error) { prior_ += row * row.transpose() / (error * error); };
    say({0.5, 0.5, 0.0}, params.scale_error);
    say({-1.0, 1.0, 0.0}, params.mismatch_error);
    say({0.0, 0.0, 1.0}, params.axle_error);
  }

  Normal at(std::span<const MeasuredDrive> drives, const Factors& factors) const {
    Normal normal{prior_, prior_ * (Factors::Ones() - factors)};
    for (const MeasuredDrive& measured : drives) add(measured, factors, normal);
    return normal;
  }

 private:
  void add(const MeasuredDrive& measured, const Factors& factors, Normal& normal) const {
    const End told = as_vector(end_of(measured.travel, drive_, as_calibration(factors)));
    const Eigen::Matrix<double, 4, 3> slope = derivative(measured.travel, drive_, factors);
    const Eigen::Matrix3d spread = scatter(measured, drive_, params_);
    const double length = params_.ruler * params_.ruler;
    if (measured.end.offset) {
      const double aslant = params_.ruler_aslant * measured.end.offset->norm();
      const Eigen::Matrix2d weight =
          (spread.topLeftCorner<2, 2>() + (length + aslant * aslant) * Eigen::Matrix2d::Identity()).inverse();
      const Eigen::Matrix<double, 2, 3> rows = slope.topRows<2>();
      normal.information += rows.transpose() * weight * rows;
      normal.gradient += rows.transpose() * weight * (*measured.end.offset - told.head<2>());
    }
    if (measured.end.distance) {
      const Point2 outwards = told[2] > 0.0 ? Point2(told.head<2>() / told[2]) : Point2(1.0, 0.0);
      const double variance = length + outwards.dot(spread.topLeftCorner<2, 2>() * outwards);
      add_row(slope.row(2), (*measured.end.distance - told[2]), variance, normal);
    }
    if (measured.end.turn) {
      const double variance = params_.protractor * params_.protractor + spread(2, 2);
      add_row(slope.row(3), (*measured.end.turn - told[3]), variance, normal);
    }
  }

  static void add_row(const Eigen::RowVector3d& row, double off, double variance, Normal& normal) {
    normal.information += row.transpose() * row / variance;
    normal.gradient += row.transpose() * (off / variance);
  }

  DifferentialDrive drive_;
  CalibrationFitParams params_;
  Eigen::Matrix3d prior_ = Eigen::Matrix3d::Zero();
};

}  // namespace

EndOfDrive end_of(std::span<const WheelTravel> travel, const DifferentialDrive& drive, const Calibration& calibration) {
  EndOfDrive end{Point2(0.0, 0.0), 0.0, 0.0};
  for (const WheelTravel& tick : travel) {
    const Arc arc = arc_of(calibrated(tick, calibration), drive);
    *end.offset += chord(arc) * direction(*end.turn + 0.5 * arc.turn);
    *end.turn += arc.turn;
  }
  end.distance = end.offset->norm();
  return end;
}

std::optional<CalibrationFit> fit_calibration(std::span<const MeasuredDrive> drives, const DifferentialDrive& drive,
                                              const CalibrationFitParams& params, const Calibration& start) {
  const Objective objective(drive, params);
  Factors factors(start.left, start.right, start.axle);
  for (int i = 0; i < kMaxSteps; ++i) {
    const Normal normal = objective.at(drives, factors);
    Factors step = normal.information.llt().solve(normal.gradient);
    if (step.norm() <= kSettled) {
      const Factors deviation = normal.information.inverse().diagonal().cwiseSqrt();
      return CalibrationFit{as_calibration(factors + step), as_calibration(deviation)};
    }
    // An end swings round with the turns before it: a step may go far beyond what the slope is good for.
    for (int halvings = 0; !plausible(factors + step); ++halvings, step *= 0.5) {
      if (halvings == kMaxHalvings) return std::nullopt;
    }
    factors += step;
  }
  return std::nullopt;
}

}  // namespace scrubjay

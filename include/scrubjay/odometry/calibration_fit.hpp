/// \file
/// Calibration from drives whose end somebody measured.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <scrubjay/odometry/calibration.hpp>
#include <scrubjay/odometry/odometry.hpp>
#include <span>

namespace scrubjay {

/// Where a drive ended, seen from where it began. Whatever was measured counts.
struct EndOfDrive {
  std::optional<Point2> offset{};    ///< of the end, x forward and y left, as the robot stood at the start [m]
  std::optional<double> distance{};  ///< from start to end, when the start's heading isn't known well enough [m]
  std::optional<double> turn{};      ///< all of it, whole turns included; positive is to the left [rad]

  bool operator==(const EndOfDrive&) const = default;
};

/// What the wheels told of a drive, and what was measured of it.
struct MeasuredDrive {
  std::span<const WheelTravel> travel;  ///< tick by tick, as the encoders tell
  EndOfDrive end;
};

/// Our own guesses: what somebody with a tape measure on a floor can do, and how far robots are off.
struct CalibrationFitParams {
  double ruler = 0.003;              ///< standard deviation of a measured length [m] ...
  double ruler_aslant = 0.01;        ///< ... and of an offset, as a share of it: the start's heading is never exact
  double protractor = radians(1.0);  ///< of a measured turn [rad]
  // Before anything is measured:
  double scale_error = 0.05;     ///< of the wheels' mean factor; carpets take up to 8 %
  double mismatch_error = 0.02;  ///< of the difference between the wheels' factors
  double axle_error = 0.15;      ///< of the axle's factor
  WheelNoise noise{};            ///< by which wheels err at random
};

/// The factors with their standard deviations.
struct CalibrationFit {
  Calibration calibration;
  Calibration deviation;
};

/// Where a drive ended by the wheels' account and a calibration. All of EndOfDrive.
EndOfDrive end_of(std::span<const WheelTravel> travel, const DifferentialDrive& drive, const Calibration& calibration);

/// The calibration under which the drives end where they were measured to: maximum a posteriori by Gauss-Newton, its
/// steps halved until they end at plausible factors, over the wheels' whole way, so errors may be large and drives may
/// have any shape. Each measurement weighs by what the ruler and the wheels' random errors leave of it; what no drive
/// tells of stays near 1, with the deviation to show for it.
///
/// A square to the left and one to the right tell the wheels' ratio from the axle, whose errors look alike in one alone
/// (Borenstein and Feng, 1996); neither tells the wheels' common scale, which a straight does. That drives of any shape
/// make a least-squares problem is Antonelli, Chiaverini, Fusco, *A Calibration Method for Odometry of Mobile Robots
/// Based on the Least-Squares Technique*, IEEE Transactions on Robotics 21(5), 2005.
///
/// The search begins at `start`: give what the drives before the last one told, since a robot that is far off ends its
/// squares far away, and a search from there may end in a valley of its own.
///
/// None if it doesn't settle on factors between 0.5 and 2: something was measured wrongly.
std::optional<CalibrationFit> fit_calibration(std::span<const MeasuredDrive> drives, const DifferentialDrive& drive,
                                              const CalibrationFitParams& params = {}, const Calibration& start = {});

}  // namespace scrubjay

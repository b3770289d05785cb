/// \file
/// Drives a robot through figures, takes what somebody measures of each, and finds its wheels' factors.
#pragma once

#include <scrubjay/behavior/leg_drive.hpp>
#include <scrubjay/odometry/calibration_fit.hpp>
#include <scrubjay/robot/robot.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <stop_token>
#include <string_view>
#include <vector>

namespace scrubjay {

/// What a robot can be sent to drive. The squares, one each way, are UMBmark's: Borenstein and Feng, 1996.
enum class CalibrationFigure : std::uint8_t { Spin, Straight, SquareLeft, SquareRight };

/// "spin", "straight", "square-left", "square-right".
std::string_view to_string(CalibrationFigure figure);
/// Throws Error, which names the nearest, for a name that is none of these.
CalibrationFigure figure_of(std::string_view name);

/// How large the figures are. The squares are small enough for a room, the straight is as long as a tape measure on a
/// floor makes worthwhile: 3 mm in 2 m are 0.15 %.
struct CalibrationFigures {
  double side = 1.0;      ///< of the squares [m]
  double straight = 2.0;  ///< [m]
  int turns = 10;         ///< of a spin, once the axle is known well enough to count them
};

/// A drive as a calibration was made from it. Numbers are a square's x and y [m], a straight's distance [m] or a spin's
/// turn [rad].
struct CalibrationDrive {
  CalibrationFigure figure = CalibrationFigure::Spin;
  std::vector<double> measured{};
  std::vector<double> residual{};  ///< what the factors leave of it: measured, less what the wheels tell under them

  bool operator==(const CalibrationDrive&) const = default;
};

/// How many numbers are measured of a figure.
inline std::size_t number_count(CalibrationFigure figure) {
  return figure == CalibrationFigure::SquareLeft || figure == CalibrationFigure::SquareRight ? 2 : 1;
}

/// One drive after another, each by what those before it told, so that a robot that is far off soon drives figures that
/// close. Nothing here knows whether the robot is real.
class CalibrationSession {
 public:
  explicit CalibrationSession(const RobotModel& robot, const CalibrationFigures& figures = {});

  /// What the figure is to end with, if all goes well: a whole number of turns, so that only the rest must be measured;
  /// it is one turn as long as more couldn't be told apart.
  EndOfDrive plan(CalibrationFigure figure) const;

  /// Drives the figure. `robot` tells its travel as its model would have it. Throws Error (Kind::Failure) if the robot
  /// was blocked, went silent, or somebody asked to stop; nothing is kept of such a drive.
  void drive(Robot& robot, CalibrationFigure figure, const std::stop_token& stop);
  /// What was measured of that drive, and nothing else of the EndOfDrive. Throws Error if no wheels could have done
  /// that; it can then be measured again.
  void measure(const EndOfDrive& end);

  const CalibrationFit& fit() const { return fit_; }

  /// All drives so far, under the factors as they are now.
  std::vector<CalibrationDrive> drives() const;

 private:
  struct Logged {
    CalibrationFigure figure;
    std::vector<WheelTravel> travel;  // by the encoders
    EndOfDrive measured;
  };
  std::vector<Leg> legs(CalibrationFigure figure) const;

  RobotModel robot_;
  CalibrationFigures figures_;
  CalibrationFit fit_;
  std::vector<Logged> logged_;
};

}  // namespace scrubjay

/// \file
/// Drives along a path.
#pragma once

#include <cstddef>
#include <optional>
#include <scrubjay/robot/motion.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// Defaults are fractions of what the robot can; lengths suit robots of a hand's breadth to two.
struct PathTrackerParams {
  double max_linear = 0.0;                ///< [m/s]; 0: the robot's own
  double max_angular = 0.0;               ///< [rad/s]; 0: a comfortable share of the robot's own
  double lookahead = 0.25;                ///< [m]
  double cut = 0.02;                      ///< corners are cut by no more than this: there, it looks less far [m]
  double turn_in_place = radians(45.0);   ///< heading errors beyond this are turned away on the spot [rad]
  double braking = 0.2;                   ///< counted on before corners and the end [m/s^2]
  double turn_braking = 1.5;              ///< counted on before a wanted heading [rad/s^2]
  double reached = 0.05;                  ///< this near to its end, the path is done [m]
  double heading_reached = radians(3.0);  ///< the same for a final heading [rad]
};

/// Regulated pure pursuit: Coulter, *Implementation of the Pure Pursuit Path Tracking Algorithm*, 1992, slowed down in
/// curves and before the end (Macenski et al., *Regulated Pure Pursuit for Robot Path Tracking*, 2023).
///
///     Along --heading error beyond turn_in_place--> Turning --nearly turned away--> Along
///     Along, Turning --end reached--> Facing the final heading --reached--> Arrived
class PathTracker {
 public:
  explicit PathTracker(const RobotModel& robot, const PathTrackerParams& params = {});

  /// Begins a path (its first point is about where the robot is), to end with this heading, if any [rad].
  /// An empty path is done at once.
  void follow(std::vector<Point2> path, std::optional<double> heading = std::nullopt);
  struct Step {
    Motion motion;
    bool arrived = false;
  };
  Step track(const Pose2& pose);
  /// What is still to be driven: from the robot's place on it to its end. Valid until the next call of a method.
  std::span<const Point2> ahead() const { return std::span(path_).subspan(next_ == 0 ? 0 : next_ - 1); }
  /// Length of that [m].
  double remaining() const;
  /// How far the robot is from its path [m].
  double off_path(const Point2& position) const;
  /// With the robot's own limits in the place of zeros.
  const PathTrackerParams& params() const { return params_; }

 private:
  enum class State : std::uint8_t { Along, Turning, Facing, Arrived };

  void move_on(const Point2& position);
  Point2 target() const;
  Step along(const Pose2& pose);
  Step face(const Pose2& pose);
  Motion turn(double error) const;
  double allowed_speed(const Point2& position) const;

  PathTrackerParams params_;
  double max_wheel_speed_;    // [m/s]
  double half_axle_;          // [m]
  std::vector<Point2> path_;  // the point before next_ is the robot's place on the path
  std::size_t next_ = 0;      // the point that is driven to
  std::optional<double> heading_;
  State state_ = State::Arrived;
};

}  // namespace scrubjay

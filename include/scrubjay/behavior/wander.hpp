/// \file
/// Drive for ever without hitting anything, so that every place is seen (Basal, De Montfort: the wandering robot).
#pragma once

#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/obstacles.hpp>
#include <scrubjay/behavior/scan_guard.hpp>
#include <scrubjay/behavior/scan_outlook.hpp>
#include <scrubjay/geometry/random.hpp>

namespace scrubjay {

/// Our own choice, but where a source is named.
struct WanderParams {
  double speed = 0.3;         ///< at most, and the robot's own at most [m/s]
  double blind_speed = 0.12;  ///< without a lidar: stops over what light sensors see ahead [m/s]
  double turn_rate = 1.2;     ///< [rad/s]
  double braking = 0.3;       ///< that the robot can do at least [m/s^2] (Roomba: create_autonomy)
  double reaction = 0.2;      ///< until it begins to brake, on top of the scan's age: a turn of an LDS-01 [s]
  double margin = 0.05;       ///< kept around the disc [m]
  double slim_margin = 0.01;  ///< ... where it can't go anywhere otherwise [m]
  double stop_before = 0.03;  ///< a way that is clear for less is over [m]
  double least_leg = 0.12;    ///< a way that is clear for less isn't begun [m]
  double back_weight = 0.2;   ///< of a way back to where it comes from, beside others as long
  double back_off = 0.05;     ///< after a touch [m]
};

/// `wander`. With a lidar it turns to a way that is drawn by chance, the square of its length being its weight, and
/// drives some part of it; as it moves straight on or turns on the spot, what the last scan shows clear is clear. A
/// robot without one drives until its light sensors or its bumper tell of something, and turns away from it.
///
///     Driving --something ahead, or driven far enough--> Turning --turned, and clear ahead--> Driving
///        `--touched--> BackingOff --far enough--> Turning
///
/// A turn keeps the side that it began with until it ends before a way that is clear.
class Wander final : public Behavior {
 public:
  Wander(const RobotModel& robot, Random random, const WanderParams& params = {});

  Decision decide(const Situation& situation) override;

 private:
  enum class State : std::uint8_t { Driving, Turning, BackingOff };

  void look(const Situation& now);
  void look_around(const Situation& now);
  Decision drive(const Situation& now);
  Decision turn(const Situation& now);
  Decision back_off(const Frame& frame);
  void begin_turn(double stamp);
  bool aim(const Pose2& pose);
  std::optional<double> draw_heading(const Pose2& pose);
  bool may_set_off(const Pose2& pose) const;
  void set_off(const Pose2& pose);
  double clear_ahead(const Pose2& pose) const;
  double safe_speed(double clear, double scan_age) const;

  RobotModel robot_;
  WanderParams params_;
  Random random_;
  ObstacleSense sense_;
  Obstacles obstacles_;  // of the last frame; a virtual wall only as it appears
  bool was_fenced_ = false;
  ScanGuard guard_;
  ScanOutlook outlook_;
  std::optional<double> scan_stamp_;  // of the last scan's arrival [s]
  Pose2 scan_pose_;                   // where outlook_ is seen from

  State state_ = State::Turning;
  double yaw_ = 0.0;         // at the last frame [rad]
  int side_ = 0;             // that it turns to: 1 left, -1 right, 0 not chosen yet
  double to_turn_ = 0.0;     // to the left, yet [rad]
  double turned_ = 0.0;      // since the turn began, either way [rad]
  double turn_since_ = 0.0;  // [s]
  Obstacles met_;            // what the turn is for
  Point2 leg_from_{0.0, 0.0};
  double leg_ = 0.0;         // to be driven [m]
  bool by_touch_ = false;    // light signals don't count until they are gone
  double back_until_ = 0.0;  // [s]
};

}  // namespace scrubjay

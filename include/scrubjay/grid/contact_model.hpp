/// \file
/// Inverse sensor model of a robot that maps by touch and by light.
#pragma once

#include <optional>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/robot_model.hpp>

namespace scrubjay {

/// What a reading says of a cell, as the occupancy that it leaves where nothing was known. A cell counts as occupied
/// from 0.65 on, so no single bump or signal makes a wall. Our own choice, tried on the worlds of this repository.
struct ContactModelParams {
  double swept = 0.1;               ///< the robot's disc was over it
  double grazed = 0.25;             ///< cells whose centre is this near to the shell count as not swept [cells]
  double lit = 0.64;                ///< a light signal's range ends there
  double beam = 0.4;                ///< a light signal's beam went through it
  double bumped = 0.62;             ///< on the contact arc, where a light sensor tells which part of it
  double no_floor = 0.99;           ///< a cliff sensor is over it: nothing to be driven over twice
  double bumped_blindly = 0.56;     ///< on the contact arc of the half that was hit, no sensor telling more
  double max_light_range = 0.12;    ///< farther signals say nothing: colour and slant weigh too much [m]
  double touch_range = 0.04;        ///< a light range up to this explains a bump [m]
  double travel_step = 0.02;        ///< readings count again after this way ... [m]
  double turn_step = radians(4.0);  ///< ... or this turn [rad]
};

/// Marks what a frame at a pose says into log-odds cells: the disc swept is free; a bump marks the contact arc of the
/// half that was hit; a light signal marks an obstacle at its sensor's bearing, at the range that its strength implies;
/// a cliff is an obstacle, too.
///
/// Readings count once a step of way or turn, so standing still makes nothing more certain than it is.
class ContactModel {
 public:
  explicit ContactModel(const RobotModel& robot, const ContactModelParams& params = {});

  /// Cells outside of the grid are left out. The pose must be finite.
  void integrate(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid);
  /// No cell farther than this from the pose is touched [m].
  double reach() const { return robot_.radius + params_.max_light_range + params_.touch_range; }
  /// True if `integrate` would touch cells for this frame at this pose.
  bool wants(const Frame& frame, const Pose2& pose) const;

 private:
  bool moved(const Pose2& pose) const;
  bool turned(const Pose2& pose) const;
  bool bump_began(const Frame& frame) const;
  bool cliff_began(const Frame& frame) const;
  void mark_swept(const Pose2& pose, GridView<LogOdds> grid) const;
  void mark_light(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) const;
  void mark_cliffs(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) const;
  void mark_bump(const Frame& frame, const Pose2& pose, GridView<LogOdds> grid) const;

  RobotModel robot_;
  ContactModelParams params_;
  LogOdds swept_, lit_, beam_, no_floor_, bumped_, bumped_blindly_;
  std::optional<Pose2> last_swept_;
  std::optional<Pose2> last_sensed_;
  bool was_bumped_left_ = false;
  bool was_bumped_right_ = false;
  std::uint8_t last_cliff_flags_ = 0;
};

}  // namespace scrubjay

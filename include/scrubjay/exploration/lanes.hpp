/// \file
/// Straight lanes over unknown floor: where to drive next to sweep most in the least time.
#pragma once

#include <optional>
#include <scrubjay/exploration/sweep_gain.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/path_search.hpp>

namespace scrubjay {

/// A straight way of the disc's middle.
struct Lane {
  Point2 from{0.0, 0.0};
  double heading = 0.0;  ///< [rad]
  double length = 0.0;   ///< 0: a place to stand on [m]

  Point2 at(double way) const { return from + way * direction(heading); }
  Point2 to() const { return at(length); }
};

struct LaneParams {
  double max_length = 8.0;    ///< [m]
  double most_known = 0.4;    ///< of floor within a lane that is swept already, at a stretch [m]
  double tidiness = 0.15;     ///< floor that it is worth to leave the rest with a metre less of border [m^2/m]
  double least_area = 0.01;   ///< a drive that would sweep less isn't worth it [m^2]
  double lane_speed = 0.19;   ///< over unknown floor, turns and stops aside [m/s]
  double travel_speed = 0.3;  ///< over known floor [m/s]
  double turn_rate = 1.0;     ///< [rad/s]
  double stop = 1.5;          ///< what it takes to stop and set out again [s]
};

/// What lanes are laid over: all of the same map.
struct LaneFloor {
  const SweepGain& gain;
  GridView<const TravelCost> costs;
  const PathSearch& ways;  ///< spread from the robot
  std::optional<Bounds2> within;
};

/// The lane that sweeps most for the time that it takes to get there and along it, of those that begin at known floor
/// up to `reach` [m] of way from the robot. Lanes run along and across `axis` [rad], in which the walls run.
///
/// Of two lanes that sweep as much, the one is better that leaves the unknown floor with a shorter border: beside what
/// is known, a disc's width apart, or in a gap. So they line up, into spirals or rows, whichever takes fewer turns.
std::optional<Lane> best_lane(const LaneFloor& floor, const Pose2& robot, double axis, double reach,
                              const LaneParams& params = {});

/// The place up to `reach` [m] of way from the robot where the disc would sweep most for the time to get there: for
/// what is too little for a lane.
std::optional<Lane> best_spot(const LaneFloor& floor, const Pose2& robot, double reach, const LaneParams& params = {});

}  // namespace scrubjay

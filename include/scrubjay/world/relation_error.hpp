/// \file
/// How well a trajectory agrees with relative poses that people verified.
#pragma once

#include <cstddef>
#include <optional>
#include <scrubjay/geometry/stamped_pose.hpp>
#include <span>

namespace scrubjay {

/// The pose of a robot at one time, seen from its pose at another.
struct Relation {
  double from = 0.0;  ///< [s]
  double to = 0.0;    ///< [s]
  Pose2 motion;       ///< pose at `to` in the robot's frame at `from`
};

struct ErrorStatistics {
  double mean = 0.0;
  double deviation = 0.0;  ///< standard deviation
  double max = 0.0;
};

/// Both errors of a relation are taken from inverse(relation) * (what the trajectory has instead): how long its
/// translation is, and how far it turns, either way. R. Kuemmerle et al., *On Measuring the Accuracy of SLAM
/// Algorithms*, Autonomous Robots 27, 2009, sec. 3. Nothing is aligned, and an error is counted where it arises.
struct RelationError {
  std::size_t relations = 0;            ///< that there are
  std::size_t matched = 0;              ///< with both times on the trajectory; all below is of these
  double offset = 0.0;                  ///< a relation's time is a trajectory's stamp plus this [s]
  ErrorStatistics translation;          ///< [m]
  ErrorStatistics translation_squared;  ///< [m^2]
  ErrorStatistics rotation;             ///< [rad]
  ErrorStatistics rotation_squared;     ///< [rad^2]
};

/// Stamps farther apart than this have nothing known between them [s].
inline constexpr double kLongestGap = 3.0;

/// Where a trajectory was at `stamp`: between its poses before and after, in proportion of time. None before its
/// beginning, after its end, and in gaps longer than kLongestGap. Stamps must not go back.
std::optional<Pose2> pose_at(std::span<const StampedPose> trajectory, double stamp);

RelationError relation_error(std::span<const StampedPose> trajectory, std::span<const Relation> relations,
                             double offset);

/// The offset between the clock of the relations and that of a trajectory, found by how the robot moved.
///
/// Every offset at which the two overlap is tried, in steps of 0.2 s and then finer around the best, and scored by the
/// sum of 1 - (error / tolerance)^2 over the relations that fit within 0.1 m and 0.1 rad; the others count nothing, so
/// wrong ones don't hurt. Only relations over less than 20 s with some motion in them are looked at, for what stands
/// still fits everywhere. None if less than half of them fit at the best offset.
///
/// The trajectory should be a good one, such as a log's own poses; the offset then holds for all others of its clock.
std::optional<double> relation_offset(std::span<const StampedPose> trajectory, std::span<const Relation> relations);

}  // namespace scrubjay

/// \file
/// A body in a small world.
#pragma once

#include <cmath>
#include <scrubjay/simulation/roomba_body.hpp>
#include <utility>
#include <vector>

namespace scrubjay::test {

inline constexpr double kTick = sim::kTick;
inline constexpr double kRadius = 0.1735;  ///< of a Roomba 600 [m]
inline constexpr double kAxle = 0.235;     ///< of the same [m]

inline int ticks_in(double seconds) {
  return static_cast<int>(std::lround(seconds / kTick));
}

/// World, index and body, which refer to each other.
class Stage {
 public:
  explicit Stage(World scenery, const Pose2& start = {}, const sim::NoiseProfile& noise = {}, std::uint64_t seed = 1,
                 const sim::RobotSpec& spec = {})
      : world(std::move(scenery)), index(solid_segments(world)), body(world, index, spec, noise, Random(seed), start) {}
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Drives with these wheel speeds [m/s] for about `seconds`.
  const sim::BodySenses& drive(double left, double right, double seconds) {
    for (int i = ticks_in(seconds); i > 1; --i) body.tick({left, right});
    return body.tick({left, right});
  }
  /// One tick without driving: what it feels where it is.
  const sim::BodySenses& feel() { return body.tick({}); }
  const Pose2& pose() const { return body.truth().pose; }
  /// From the middle of the robot to the nearest wall [m].
  double clearance() const { return index.distance(pose().position(), 10.0); }

  World world;
  SegmentIndex index;
  sim::RoombaBody body;
};

inline World with_walls(std::vector<Wall> walls) {
  World world;
  world.walls = std::move(walls);
  return world;
}

/// A room without anything in it, its lower left corner at the origin.
inline World room(double width, double height) {
  return with_walls({{{{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}, {0.0, 0.0}}}});
}

/// A piece of wall, square to the line from `from` in direction `bearing` [rad], `distance` [m] away.
inline Wall facing(const Point2& from, double bearing, double distance, double half_width) {
  const Point2 middle = from + distance * direction(bearing);
  const Point2 aside = half_width * direction(bearing + 0.5 * kPi);
  return {{middle - aside, middle + aside}};
}

}  // namespace scrubjay::test

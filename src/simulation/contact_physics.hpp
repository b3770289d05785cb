/// \file
/// Box2D, moving one disc among walls.
#pragma once

#include <box2d/box2d.h>

#include <memory>
#include <scrubjay/simulation/disc.hpp>
#include <scrubjay/world/world.hpp>
#include <span>
#include <vector>

namespace scrubjay::sim {

/// Resolves contact between a robot's disc and the world.
///
/// The body doesn't rotate here: a disc's heading doesn't touch anything, and the simulation keeps it in double
/// precision, which also keeps the C library's sine out of the results. Robots that touch nothing needn't come here.
class ContactPhysics {
 public:
  ContactPhysics(std::span<const SolidSegment> solids, double radius, double friction);

  /// What else there is now, besides the solids. Their count must stay.
  void place_others(std::span<const Disc> others);
  /// Where the disc gets when it tries to go from `from` by `step` [m] in `dt` [s].
  Point2 push(const Point2& from, const Point2& step, double dt);

 private:
  std::unique_ptr<b2World> world_;
  b2Body* robot_ = nullptr;
  std::vector<b2Body*> others_;
  float friction_;
};

}  // namespace scrubjay::sim

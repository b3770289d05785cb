/// \file
/// What to do next, given frame, pose and map.
#pragma once

#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/motion.hpp>
#include <span>

namespace scrubjay {

/// What a behavior knows when it decides.
struct Situation {
  const Frame& frame;
  const PoseEstimate& estimate;
  GridView<const LogOdds> map;
  CellRect changed;  ///< the cells that may have changed since the last decision
};

struct Decision {
  Motion motion;
  const char* doing = "";  ///< in a word or two, for people; a string literal
  bool done = false;       ///< nothing is left to do
};

/// Something that a behavior would have gone to, and hasn't.
struct Leftover {
  Point2 where{0.0, 0.0};  ///< in the map's frame [m]
  double size = 0.0;       ///< how long or wide it is [m]
  const char* why = "";    ///< it was left, in a few words; a string literal
};

class Behavior {
 public:
  virtual ~Behavior() = default;
  virtual Decision decide(const Situation& situation) = 0;
  /// What is left as things stand; valid until the next decision.
  virtual std::span<const Leftover> leftovers() const { return {}; }
  /// The way that it means to drive, in the map's frame, if it plans one; valid until the next decision.
  virtual std::span<const Point2> plan() const { return {}; }
};

}  // namespace scrubjay

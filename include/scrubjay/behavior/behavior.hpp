/// \file
/// What to do next, given frame, pose and map.
#pragma once

#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/robot/frame.hpp>
#include <scrubjay/robot/motion.hpp>

namespace scrubjay {

/// What a behavior knows when it decides.
struct Situation {
  const Frame& frame;
  const PoseEstimate& estimate;
  GridView<const LogOdds> map;
};

struct Decision {
  Motion motion;
  const char* doing = "";  ///< in a word or two, for people; a string literal
  bool done = false;       ///< nothing is left to do
};

class Behavior {
 public:
  virtual ~Behavior() = default;
  virtual Decision decide(const Situation& situation) = 0;
};

}  // namespace scrubjay

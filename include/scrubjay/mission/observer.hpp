/// \file
/// Those who watch a mission and never steer it.
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/robot/frame.hpp>

namespace scrubjay {

/// All that is known at one tick. Refers to what is overwritten by the next one.
struct Snapshot {
  const Frame& frame;
  const PoseEstimate& estimate;
  GridView<const LogOdds> map;
  const Decision& decision;
  CellRect changed{};                     ///< cells of the map that may have changed since the snapshot before
  std::span<const Point2> plan{};         ///< Behavior::plan()
  std::span<const Leftover> leftovers{};  ///< Behavior::leftovers()
};

class Observer {
 public:
  virtual ~Observer() = default;
  virtual void notify(const Snapshot& snapshot) = 0;
};

}  // namespace scrubjay

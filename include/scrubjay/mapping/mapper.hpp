/// \file
/// Frames at poses become a map.
#pragma once

#include <scrubjay/geometry/pose_estimate.hpp>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <scrubjay/mapping/occupancy_grid.hpp>
#include <scrubjay/robot/frame.hpp>

namespace scrubjay {

class Mapper {
 public:
  virtual ~Mapper() = default;
  virtual void update(const Frame& frame, const PoseEstimate& estimate) = 0;
  /// The cells of map() that the last update may have changed; none if it changed nothing. A map that grew keeps what
  /// it held: those cells moved, and are no change.
  virtual CellRect changed() const = 0;
  /// The map so far; valid until the next update.
  virtual GridView<const LogOdds> map() const = 0;
  /// The map so far, for people and files: nav2's trinary values.
  virtual OccupancyGrid occupancy() const = 0;
};

}  // namespace scrubjay

/// \file
/// A robot in a drawn house, of which it knows a part.
#pragma once

#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/navigator.hpp>
#include <string>
#include <vector>

#include "planning/ideal_drive.hpp"
#include "planning/map_drawing.hpp"

namespace scrubjay::test {

/// Sees, each tick, the true cells within `sight` of it; walls stop its wheels, as a wall does.
class House {
 public:
  House(const RobotModel& robot, MapDrawing truth, MapDrawing known, const Pose2& start, double sight = 1.0)
      : robot_(robot), truth_(std::move(truth)), known_(std::move(known)), drive_(robot, start), sight_(sight) {
    changed_ = known_.all();
  }

  MapDrawing& truth() { return truth_; }
  /// Changes the house, and the robot knows at once.
  void change_openly(const CellRect& cells, char mark) {
    truth_.set(cells, mark);
    known_.set(cells, mark);
    changed_ = bounding(changed_, cells);
  }
  const Pose2& pose() const { return drive_.pose(); }
  double stamp() const { return drive_.stamp(); }
  /// How near its middle came to an occupied cell's centre [m].
  double nearest() const { return nearest_; }

  /// Looks around, and calls `decide(Situation)` for a motion, which it carries out.
  template <typename Decide>
  void tick(Decide&& decide) {
    look();
    Frame frame;
    frame.stamp = drive_.stamp();
    PoseEstimate estimate;
    estimate.pose = drive_.pose();
    const Motion motion = decide(Situation{frame, estimate, known_.view(), changed_});
    changed_ = {};
    const IdealDrive before = drive_;
    drive_.drive(motion);
    const double clearance = distance_to_wall(drive_.pose().position());
    if (clearance < robot_.radius && clearance < distance_to_wall(before.pose().position())) {
      drive_ = before;
      drive_.stand_still();
    }
    nearest_ = std::min(nearest_, clearance);
  }

 private:
  void look() {
    const CellRect seen = cells_around(truth_.view().geometry, drive_.pose().position(), sight_);
    for (std::int32_t y = seen.low.y; y < seen.high.y; ++y) {
      for (std::int32_t x = seen.low.x; x < seen.high.x; ++x) {
        if (known_.view()[{x, y}] == truth_.view()[{x, y}]) continue;
        known_.view()[{x, y}] = truth_.view()[{x, y}];
        changed_ = bounding(changed_, {{x, y}, {x + 1, y + 1}});
      }
    }
  }
  double distance_to_wall(const Point2& p) const {
    double nearest = 1.0;
    const GridGeometry& grid = truth_.view().geometry;
    const CellRect near = cells_around(grid, p, 0.5);
    for (std::int32_t y = near.low.y; y < near.high.y; ++y) {
      for (std::int32_t x = near.low.x; x < near.high.x; ++x) {
        if (truth_.view()[{x, y}] > 0) nearest = std::min(nearest, (grid.center({x, y}) - p).norm());
      }
    }
    return nearest;
  }

  RobotModel robot_;
  MapDrawing truth_;
  MapDrawing known_;
  CellRect changed_;
  IdealDrive drive_;
  double sight_;
  double nearest_ = 1.0;
};

}  // namespace scrubjay::test

/// \file
/// A world drawn in text, and a disc with a lidar that drives in it, without noise.
#pragma once

#include <cmath>
#include <limits>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <string>
#include <vector>

namespace scrubjay::test {

/// Rows from the top one down, a character a cell of 10 cm: '#' is a wall, 'g' is glass, which the lidar doesn't see,
/// 'r' is where the robot starts. The map's origin is the drawing's lower left corner.
class DrawnWorld {
 public:
  static constexpr double kCell = 0.1;  ///< [m]

  explicit DrawnWorld(const std::vector<std::string>& rows) : rows_(rows) {
    grid_.resolution = kCell;
    grid_.width = static_cast<std::int32_t>(rows.front().size());
    grid_.height = static_cast<std::int32_t>(rows.size());
  }
  char& at(CellIndex c) {
    return rows_[static_cast<std::size_t>(grid_.height - 1 - c.y)][static_cast<std::size_t>(c.x)];
  }
  char at(CellIndex c) const {
    return rows_[static_cast<std::size_t>(grid_.height - 1 - c.y)][static_cast<std::size_t>(c.x)];
  }
  const GridGeometry& grid() const { return grid_; }
  void replace(char what, char by) {
    for (std::string& row : rows_) {
      for (char& c : row) c = c == what ? by : c;
    }
  }
  Point2 find(char what) const {
    for (std::int32_t y = 0; y < grid_.height; ++y) {
      for (std::int32_t x = 0; x < grid_.width; ++x) {
        if (at({x, y}) == what) return grid_.center({x, y});
      }
    }
    return {0.0, 0.0};
  }
  bool blocks_light(CellIndex c) const { return !grid_.contains(c) || at(c) == '#'; }
  bool blocks(CellIndex c) const { return blocks_light(c) || at(c) == 'g'; }

 private:
  std::vector<std::string> rows_;
  GridGeometry grid_;
};

/// Drives a behavior through a drawn world, in closed loop: each scan is drawn into the map as certain.
class DrawnRun {
 public:
  static constexpr double kTick = 0.05;  ///< [s]
  static constexpr int kTicksPerScan = 4;
  static constexpr double kRange = 1.5;  ///< of the lidar [m]

  DrawnRun(DrawnWorld& drawn, Behavior& driven) : world(drawn), behavior(driven) {
    const Point2 start = world.find('r');
    estimate.pose = {start.x(), start.y(), 0.3};
    map.cover(start, 0.5);
  }

  static RobotModel robot() {
    RobotModel model;
    model.open_interface = false;
    model.radius = 0.105;
    model.max_linear_speed = 0.22;
    model.max_angular_speed = 2.84;
    model.lidar = LidarModel{};
    model.lidar->mount = {};
    model.lidar->max_range = kRange;
    return model;
  }

  /// One tick; false once the behavior is done.
  bool step() {
    frame.stamp = kTick * static_cast<double>(++ticks);
    changed = {};
    frame.scan.reset();
    if (ticks % kTicksPerScan == 0) scan();
    decision = behavior.decide({frame, estimate, map.view(), changed});
    if (!decision.done) move(decision.motion);
    return !decision.done;
  }
  /// True if it is done within that time.
  bool run(double seconds) {
    for (double end = frame.stamp + seconds; frame.stamp < end;) {
      if (!step()) return true;
    }
    return false;
  }
  /// What the map says of a cell of the drawing.
  Occupancy known(CellIndex c) const {
    const CellIndex cell = map.view().geometry.cell_at(world.grid().center(c));
    return map.view().contains(cell) ? trinary(map.view()[cell]) : kUnknown;
  }

  DrawnWorld& world;
  Behavior& behavior;
  GrowingMap map{DrawnWorld::kCell};
  PoseEstimate estimate;
  Frame frame;
  Decision decision;
  CellRect changed;
  std::int64_t ticks = 0;
  int touches = 0;  ///< ticks in which it drove against something

 private:
  static constexpr LogOdds kFloor = -60;
  static constexpr LogOdds kSolid = 60;

  void scan() {
    ranges_.assign(360, 0.0f);
    const Point2 from = estimate.pose.position();
    map.cover(from, kRange + DrawnWorld::kCell);
    changed = cells_around(map.view().geometry, from, kRange + DrawnWorld::kCell);
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      const Point2 beam = direction(estimate.pose.yaw + radians(1.0) * static_cast<double>(i));
      ranges_[i] = static_cast<float>(cast(from, beam));
    }
    frame.scan = LaserScan{.stamp = frame.stamp,
                           .angle_increment = radians(1.0),
                           .range_min = 0.01,
                           .range_max = kRange,
                           .ranges = ranges_};
  }
  double cast(const Point2& from, const Point2& beam) {
    bool open = true;
    double range = std::numeric_limits<double>::infinity();
    visit_line(world.grid(), from, from + kRange * beam, [&](CellIndex c) {
      if (!open) return;
      const Point2 center = world.grid().center(c);
      open = !world.blocks_light(c);
      map.view()[map.view().geometry.cell_at(center)] = open ? kFloor : kSolid;
      if (!open) range = (center - from).norm() - 0.5 * DrawnWorld::kCell;
    });
    return range;
  }
  void move(const Motion& motion) {
    const Pose2 next = estimate.pose * Pose2{motion.linear * kTick, 0.0, motion.angular * kTick};
    bool free = true;
    visit_disc(world.grid(), next.position(), robot().radius - 0.02,
               [&](CellIndex c) { free = free && !world.blocks(c); });
    touches += free ? 0 : 1;
    estimate.pose = free ? next : Pose2{estimate.pose.x, estimate.pose.y, next.yaw};
    frame.left_travel = frame.right_travel = free ? motion.linear * kTick : 0.0;
  }

  std::vector<float> ranges_;
};

}  // namespace scrubjay::test

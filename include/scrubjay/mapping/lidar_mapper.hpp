/// \file
/// A growing map from a lidar.
#pragma once

#include <cstdint>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/fill_line.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <scrubjay/mapping/mapper.hpp>
#include <scrubjay/mapping/scan_points.hpp>
#include <scrubjay/robot/robot_model.hpp>
#include <span>
#include <vector>

namespace scrubjay {

/// Inverse sensor model of a beam, as occupancy left where nothing was known (Thrun, Burgard, Fox, *Probabilistic
/// Robotics*, table 9.2). Hit and miss are our own choice, tried on two logs of real robots and in our worlds with the
/// noise of LDS-01: more for hits makes walls whole that few scans saw, and thick, so that the floor beside them is
/// lost; more for misses, the reverse.
struct LidarMapperParams {
  double hit = 0.70;   ///< where a beam ended; above 0.5. From 0.66 on, one return makes an obstacle
  double miss = 0.32;  ///< what a beam went through; below 0.5. Twice makes free floor
  /// Hits go into the map this far behind the beam's end [cells]: the noise of ranges scatters them to both sides of a
  /// surface, and where that lies on a border of cells, the floor before it is to stay free.
  double hit_depth = 0.2;
  double max_range = 20.0;      ///< returns from farther away only clear what the beam went through, up to here [m]
  double forward_cone = kPi;    ///< only beams within this of straight ahead, either way, are used [rad]
  double robot_radius = 0.105;  ///< floor that the robot stands on is free; 0: says nothing [m]
};

/// Each scan adds its evidence to every cell along its beams. Beams that were measured while the robot moved start from
/// where the robot was then, by its twist. Unknown beyond a beam's end stays unknown; clamped evidence lets what moved
/// fade.
///
/// A cell hears of one scan once, however many beams met it: as occupied if any of them ended there, else as free. So a
/// wall seen at a grazing angle isn't eaten by the beams that pass it on their way, and what is near the sensor, where
/// beams lie close, becomes no more certain than what is far. (As in OctoMap: Hornung et al., *OctoMap: An Efficient
/// Probabilistic 3D Mapping Framework Based on Octrees*, 2013, sec. 5.1.) Cells that lie whole under the robot are
/// free, whatever a beam says; they, too, hear of it once a scan.
class LidarMapper final : public Mapper {
 public:
  /// The map covers `reach` [m] around its origin from the start, and grows from there; what comes out is the same.
  /// Throws Error for a robot without a lidar, and for parameters out of their range.
  LidarMapper(const RobotModel& robot, double resolution, const LidarMapperParams& params = {}, double reach = 0.0);

  /// Frames without a scan change nothing. Throws Error if the pose is not finite or too far away to have a map.
  void update(const Frame& frame, const PoseEstimate& estimate) override;
  CellRect changed() const override { return changed_; }
  GridView<const LogOdds> map() const override { return map_.view(); }
  OccupancyGrid occupancy() const override { return map_.occupancy(); }

 private:
  /// In cells from the map frame's origin.
  struct Line {
    Point2 from;
    Point2 to;
    bool hit;
  };

  Bounds2 place(std::span<const Beam> beams, const Pose2& pose);
  void make_room(const Bounds2& bounds);
  void draw(const Pose2& pose);
  void add_to_map(const Bounds2& bounds);

  LidarMapperParams params_;
  LogOdds hit_;
  std::uint8_t miss_;  // taken from a cell
  ScanPoints points_;
  GrowingMap map_;
  CellRect changed_;
  std::vector<Line> lines_;          // the scan's beams
  std::vector<LineWalk> walks_;      // and the cells of each of them in the patch
  GridGeometry patch_;               // of the scan's marks: the cells that this scan may change
  CellIndex patch_corner_;           // counted in cells from the map frame's origin
  std::vector<std::uint8_t> marks_;  // row by row; all clear between two updates
};

}  // namespace scrubjay

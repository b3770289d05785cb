/// \file
/// All rays of a scan from one place at once.
#pragma once

#include <scrubjay/robot/robot_model.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <span>
#include <vector>

namespace scrubjay::sim {

/// Draws each segment near the sensor into the few beams that can meet it, where the nearest one stays: a depth buffer
/// in polar coordinates. A ray by itself has to look for its segments anew, and a scan has hundreds from one place.
///
/// Ranges are those of SegmentIndex::cast for the same rays, to the last bit (test/bench/lidar_bench has the figures).
class ScanCaster {
 public:
  /// `index` must outlive it.
  ScanCaster(const SegmentIndex& index, const LidarModel& lidar);

  /// What each beam meets up to the lidar's largest range, from the sensor's pose in the world; infinity where it meets
  /// nothing [m]. Good until the next call.
  std::span<const double> cast(const Pose2& sensor);
  /// Unit vectors of the beams in the sensor's frame.
  std::span<const Point2> beams() const { return beams_; }

 private:
  static constexpr double kMargin = 0.5;  ///< candidates stay good until the sensor has moved by this [m]

  /// A segment as the ray test wants it: one end and the way to the other.
  struct Piece {
    double ax, ay, dx, dy;
  };
  /// Where a piece is, seen from the sensor.
  struct View {
    double squared_distance;  ///< of its nearest point [m^2]
    double from, to;          ///< bearings of its ends, roughly [rad]
  };

  std::span<const double> cast_singly(const Point2& origin);
  void look_around(const Point2& origin);
  void turn_beams(double yaw);
  void view_pieces(const Point2& origin);
  void draw(const Piece& piece, const View& view, const Pose2& sensor);
  void draw_edge_on(const Piece& piece, const View& view, const Pose2& sensor);
  template <typename DrawBeams>
  void for_beams(double from, double to, double yaw, const DrawBeams& draw_beams) const;

  const SegmentIndex* index_;
  LidarModel lidar_;
  double beams_per_turn_;
  std::vector<Point2> beams_;
  Point2 center_{0.0, 0.0};  // where it looked around last
  bool fresh_ = false;
  std::vector<std::uint32_t> found_;
  std::vector<Piece> pieces_;
  std::vector<View> views_;
  // By beam: the direction in the world, and the range so far. Apart, so that the compiler can take several at once.
  std::vector<double> direction_x_;
  std::vector<double> direction_y_;
  std::vector<double> ranges_;
};

}  // namespace scrubjay::sim

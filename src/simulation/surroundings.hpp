/// \file
/// The little that is near a robot, so that its senses needn't ask the whole world every tick.
#pragma once

#include <scrubjay/simulation/disc.hpp>
#include <scrubjay/world/segment_index.hpp>
#include <scrubjay/world/world.hpp>
#include <span>
#include <vector>

namespace scrubjay::sim {

struct NearSegment {
  Segment2 segment;
  Point2 normal{0.0, 0.0};  ///< unit vector
  double albedo = 1.0;
  Point2 nearest{0.0, 0.0};  ///< point of it nearest to the robot's middle
  double distance = 0.0;     ///< ... and how far that is [m]
};

/// Everything within `reach` of the robot, asked for again only when it has moved by kMargin.
class Surroundings {
 public:
  /// `world` and `index` must outlive this. `albedo` is by piece.
  Surroundings(const World& world, const SegmentIndex& index, std::vector<double> albedo, double reach);

  void move_to(const Point2& robot);
  /// What else there is now, besides the world, seen from `robot`: as polygons, white and hardly larger than the discs.
  void place_others(std::span<const Disc> others, const Point2& robot);
  /// Segments that may be within reach, with their nearest points.
  std::span<const NearSegment> segments() const { return near_; }
  /// Distance from the robot to the nearest segment, or `reach` if that is less [m].
  double clearance() const { return clearance_; }

  bool over_cliff(const Point2& p) const;
  double carpet_slip(const Point2& p) const;
  std::uint8_t dirt(const Point2& p) const;

 private:
  static constexpr double kMargin = 0.2;  ///< [m]

  void refresh(const Point2& robot);
  void add_others(const Point2& robot);

  const World* world_;
  const SegmentIndex* index_;
  std::vector<double> albedo_;
  double reach_;
  Point2 center_{0.0, 0.0};
  bool fresh_ = false;
  double clearance_ = 0.0;
  std::vector<std::uint32_t> found_;
  std::vector<NearSegment> near_;   // first those of the world, then those of the others
  std::size_t world_segments_ = 0;  // of them
  std::vector<Disc> others_;
  std::vector<const Polygon*> near_cliffs_;
  std::vector<const Carpet*> near_carpets_;
  std::vector<const DirtSpot*> near_dirt_;
};

}  // namespace scrubjay::sim

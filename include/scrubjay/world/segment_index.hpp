/// \file
/// Exact rays and distances over many segments: the one index that all simulated senses share.
#pragma once

#include <cstdint>
#include <limits>
#include <scrubjay/world/world.hpp>
#include <span>
#include <vector>

namespace scrubjay {

struct RayHit {
  double range = std::numeric_limits<double>::infinity();  ///< [m]
  std::uint32_t segment = 0;                               ///< index of the segment hit; meaningless on a miss
};

/// Segments bucketed in a uniform grid, walked cell by cell along a ray (Amanatides and Woo, *A Fast Voxel Traversal
/// Algorithm for Ray Tracing*, 1987). Read-only after it was built, so threads may share it.
///
/// Results are those of a search through all segments, to the last bit: the grid decides only what is looked at.
class SegmentIndex {
 public:
  /// Coordinates must be finite.
  explicit SegmentIndex(std::vector<SolidSegment> segments);

  std::span<const SolidSegment> segments() const { return segments_; }
  /// Nearest hit of the ray from `origin` along the unit vector `direction`, up to `max_range`; else infinity.
  /// Of segments hit at the same range, the first one counts. `origin` may lie anywhere.
  RayHit cast(const Point2& origin, const Point2& direction, double max_range) const;
  /// Indices of the segments that come within `radius` of `center`, ascending, each once; `found` is overwritten.
  void within(const Point2& center, double radius, std::vector<std::uint32_t>& found) const;
  /// Distance from `p` to the nearest segment, up to `max_distance`; else infinity.
  double distance(const Point2& p, double max_distance) const;

 private:
  /// A segment as the ray test wants it: one end and the way to the other.
  struct Piece {
    double ax, ay, dx, dy;
  };
  struct CellRange {
    std::int32_t x_begin, x_end, y_begin, y_end;  ///< half-open
  };

  void choose_grid();
  void fill_buckets();
  template <typename Visit>
  void visit_cells(const Segment2& segment, const Visit& visit) const;
  CellRange cells_around(const Point2& center, double radius) const;
  void nearest_in_row(const Point2& p, std::int32_t y, std::int32_t x_begin, std::int32_t x_end, double& squared) const;

  std::vector<SolidSegment> segments_;
  Point2 low_{0.0, 0.0};   ///< corner of the grid [m]
  Point2 high_{0.0, 0.0};  ///< opposite corner [m]
  double cell_ = 1.0;      ///< side of a bucket [m]
  double per_cell_ = 1.0;  ///< 1 / cell_
  std::int32_t width_ = 0;
  std::int32_t height_ = 0;
  // Buckets, row by row: those of cell c are [offsets_[c], offsets_[c + 1]) of both arrays, ascending by index.
  // Pieces are copied into each bucket that they cross: a ray then reads one stretch of memory a cell.
  std::vector<std::uint32_t> offsets_;
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace scrubjay

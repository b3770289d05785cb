/// \file
/// Where surfaces run, finer than the cells of a map.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/localization/likelihood_field.hpp>
#include <vector>

namespace scrubjay {

/// A piece of a wall, as straight as it looks over five cells.
struct SurfaceLine {
  Point2 point{0.0, 0.0};   ///< on it [m]
  Point2 normal{0.0, 0.0};  ///< unit vector across it, either way
  double variance = 0.0;    ///< of what it was made of, across it [m^2]

  double distance(const Point2& p) const { return normal.dot(p - point); }
};

/// Remembers the mean of the beam ends in each cell of a map, weighed by how sure they are: cells of 5 cm then hold
/// walls to a few millimetres, and a map goes on without a step where its cells do. (GMapping keeps such means:
/// G. Grisetti, C. Stachniss, W. Burgard, *Improved Techniques for Grid Mapping with Rao-Blackwellized Particle
/// Filters*, T-RO 2007.) And from where a cell was seen: a thin wall has two faces within a line's reach, and nobody
/// sees both at once.
///
/// Whether there still is anything, the map tells: cells with nothing occupied around them (LikelihoodField::at is 0)
/// count no longer. Memory is taken in tiles, where beams end.
class SurfaceMap {
 public:
  /// A beam ended at `p`, seen along the unit vector `view` (back to its origin), by the latest reckoning; `noise` > 0
  /// is its standard deviation [m]. All finite.
  void add(const Point2& p, const Point2& view, double noise, const LikelihoodField& field);

  /// The line of least squares through the means around the field's cell `c`, as far as they were seen from the side of
  /// the line that `view` looks from; none where they make no line. Where no beam was seen to end, as on a map that
  /// somebody else made, it runs through the centres of the occupied cells.
  std::optional<SurfaceLine> line_at(CellIndex c, const Point2& view, const LikelihoodField& field) const;

 private:
  static constexpr int kTileBits = 4;  // tiles of 16 x 16 cells

  /// Means of the beam ends in a cell.
  struct Surface {
    float x = 0.0F;       // from the cell's centre [m]
    float y = 0.0F;       // [m]
    float view_x = 0.0F;  // of the unit vectors back
    float view_y = 0.0F;
    float weight = 0.0F;  // in beams that are sure to 1 cm
  };

  CellIndex place(CellIndex c, const GridGeometry& grid) const;
  const Surface* find(CellIndex place) const;
  Surface& at(CellIndex place);
  void cover(CellIndex tile);
  std::size_t tile_index(CellIndex tile) const;
  static std::size_t surface_index(std::int32_t number, CellIndex place);

  std::optional<Point2> anchor_;    // a cell corner of the map, from which places count however the map grows
  CellRect tiles_;                  // that tile_ covers
  std::vector<std::int32_t> tile_;  // number of each of tiles_ in surfaces_; -1 where no beam ended
  std::vector<Surface> surfaces_;   // tile after tile
};

}  // namespace scrubjay

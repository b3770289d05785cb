/// \file
/// How well a beam's end fits each cell of a map, kept as the map changes.
#pragma once

#include <cstdint>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

/// The lookup table of E. Olson, *Real-Time Correlative Scan Matching*, ICRA 2009, sec. III: a beam that ends d cells
/// away from the nearest occupied cell fits by 1 - (d / 3)^2, and by 0 from 3 cells on: a quadratic log-likelihood, cut
/// off so that what isn't in the map counts but once.
///
/// Only cells that crossed the border between occupied and not are worked on, so following a map costs what changed in
/// it, and one look at each cell that may have.
class LikelihoodField {
 public:
  using Fit = std::uint8_t;
  static constexpr Fit kBest = 255;          ///< of a beam that ends in an occupied cell
  static constexpr std::int32_t kBlock = 4;  ///< side of a block of offsets [cells]

  /// Follows `map`, in which nothing but `changed` changed since the last call, unless it grew.
  void follow(GridView<const LogOdds> map, const CellRect& changed);

  const GridGeometry& geometry() const { return geometry_; }
  /// Of a beam that ends in the cell; 0 outside of the map.
  Fit at(CellIndex c) const { return geometry_.contains(c) ? fits_[geometry_.index(c)] : Fit{0}; }
  /// No less than the fit at any of the cells c + (0 ... kBlock - 1, 0 ... kBlock - 1).
  Fit bound(CellIndex c) const {
    const CellIndex block{(c.x >> kBlockBits) + 1, (c.y >> kBlockBits) + 1};
    return blocks_.contains(block) ? bounds_[blocks_.index(block)] : Fit{0};
  }

 private:
  static constexpr int kBlockBits = 2;

  void lay_out(const GridGeometry& geometry);
  void occupy(CellIndex c);
  void vacate(CellIndex c);
  void raise(CellIndex c, Fit fit);

  GridGeometry geometry_;
  std::vector<Fit> fits_;
  GridGeometry blocks_;  // (X, Y) bounds 2 * kBlock - 1 columns from kBlock * (X - 1) on, and as many rows
  std::vector<Fit> bounds_;
};

}  // namespace scrubjay

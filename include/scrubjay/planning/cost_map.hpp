/// \file
/// What it costs a disc to be in a cell: obstacles inflated by its radius, and dear floor beside them.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

/// How much dearer than open floor it is to drive through a cell, in steps of 1/kCostUnit: a metre costs
/// 1 + cost / kCostUnit. kNoWay where the disc can't be.
using TravelCost = std::uint8_t;
inline constexpr TravelCost kNoWay = 255;
inline constexpr double kCostUnit = 32.0;

struct CostMapParams {
  double radius = 0.105;            ///< of the disc [m]
  double margin = 0.02;             ///< kept free around it besides [m]
  double comfort = 0.25;            ///< beyond the margin, obstacles make floor dearer up to here [m]
  double dearness = 4.0;            ///< ... by this factor where it is dearest, right at the margin; 1 to 7
  std::optional<Bounds2> within{};  ///< floor to stay on, in the map's frame; there is no way outside
  bool through_unknown = false;     ///< unknown floor may be driven over (a robot that feels its way) or not
};

/// Follows a map that changes and grows. Obstacles are the cells that are occupied (trinary), and the unknown ones
/// unless the way may lead through them; what lies outside of the map counts as unknown.
///
/// Distances are exact, from cell centre to cell centre (in two passes: Felzenszwalb and Huttenlocher, *Distance
/// Transforms of Sampled Functions*, 2012, with the second one cut to the reach). The disc can't be where an obstacle's
/// centre is nearer than radius + margin. An obstacle may reach half a cell nearer than its centre, and so may the disc
/// leave its cell's centre; the margin and the sides' rounding up to whole cells make good for that: at 5 cm, a Roomba
/// (0.1735 m) needs a gap of 7 free cells, 0.35 m, and a Burger (0.105 m) one of 5 cells, 0.25 m.
///
/// From the margin outwards, costs fall as the square of what is left to `comfort`, to 0 there.
class CostMap {
 public:
  explicit CostMap(const CostMapParams& params);

  /// Takes over what changed: outside of `changed`, `map` holds what it held at the last update (moved by whole cells,
  /// if it grew), and unknown cells where it had none. Costs time by the size of what really changed its class in
  /// there. Returns the cells whose cost may have changed; cells that only moved haven't.
  CellRect update(GridView<const LogOdds> map, const CellRect& changed);
  GridView<const TravelCost> view() const { return {geometry_, costs_.data()}; }
  const CostMapParams& params() const { return params_; }
  /// False for cells outside of the map, too.
  bool passable(CellIndex cell) const { return geometry_.contains(cell) && view()[cell] != kNoWay; }

 private:
  void start_over(const GridGeometry& geometry);
  CellRect follow(const GridGeometry& geometry);
  CellRect take_classes(GridView<const LogOdds> map, const CellRect& rect);
  void recompute(const CellRect& rect);
  void fence_off(const CellRect& rect);
  void recompute_band(const CellRect& band);
  void sum_up_columns(const CellRect& band, std::int32_t left, std::int32_t width);

  CostMapParams params_;
  GridGeometry geometry_;
  std::vector<TravelCost> costs_;
  std::vector<std::uint8_t> obstacles_;  // 1 or 0 a cell, as in the map at the last update
  std::int32_t reach_ = 0;               // obstacles farther than this cost nothing [cells]
  std::vector<TravelCost> cost_at_;      // by squared distance [cells^2], up to reach_^2
  std::vector<std::uint8_t> above_;      // scratch: distance to the next obstacle of the column, cut at reach_ + 1
  std::vector<std::int16_t> squared_;    // scratch: squared distance along the column, a row of it
  std::vector<std::int16_t> nearest_;    // scratch: squared distance, a row of it
};

}  // namespace scrubjay

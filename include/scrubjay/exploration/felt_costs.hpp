/// \file
/// Where a disc can be, by the map and by what it felt.
#pragma once

#include <optional>
#include <scrubjay/exploration/floor_layer.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/planning/cost_map.hpp>

namespace scrubjay {

/// A cost map with the places taken out where the disc's middle couldn't get, whatever the map shows: it touched
/// something, or met a cliff or the beam of a virtual wall; and with all that lies out of bounds.
class FeltCosts {
 public:
  explicit FeltCosts(const CostMapParams& params, const std::optional<Bounds2>& within = std::nullopt)
      : costs_(params), within_(within) {}

  /// As CostMap::update.
  void update(GridView<const LogOdds> map, const CellRect& changed);
  GridView<const TravelCost> view() const { return felt_.view(); }
  bool passable(CellIndex cell) const { return felt_[cell] != kNoWay; }
  /// False for what lies out of bounds.
  bool allowed(const Point2& p) const { return !within_ || within_->contains(p); }

  /// The disc's middle can't get there; or must never: that is forgiven by nothing.
  void block(const Point2& p, bool for_good = false);
  /// It did.
  void unblock(const Point2& p);
  /// Forgives all that it can.
  void unblock_all();
  bool any_blocked() const { return felt_count_ > 0; }

 private:
  enum class Block : std::uint8_t { None, Felt, ForGood };

  void take(CellIndex cell);

  CostMap costs_;
  std::optional<Bounds2> within_;
  FloorLayer<TravelCost> felt_{kNoWay};
  FloorLayer<Block> blocked_;
  int felt_count_ = 0;
};

}  // namespace scrubjay

#include <scrubjay/exploration/felt_costs.hpp>

namespace scrubjay {

void FeltCosts::update(GridView<const LogOdds> map, const CellRect& changed) {
  const bool grown = !(felt_.geometry() == map.geometry);
  CellRect taken = costs_.update(map, changed);
  felt_.follow(map.geometry);
  blocked_.follow(map.geometry);
  if (grown) taken = cells_of(map.geometry);
  for (std::int32_t y = taken.low.y; y < taken.high.y; ++y) {
    for (std::int32_t x = taken.low.x; x < taken.high.x; ++x) take({x, y});
  }
}

void FeltCosts::block(const Point2& p, bool for_good) {
  const CellIndex cell = felt_.geometry().cell_at(p);
  if (!felt_.contains(cell) || blocked_[cell] == Block::ForGood) return;
  const bool was_felt = blocked_[cell] == Block::Felt;
  blocked_.at(cell) = for_good ? Block::ForGood : Block::Felt;
  felt_count_ += (for_good ? 0 : 1) - (was_felt ? 1 : 0);
  take(cell);
}

void FeltCosts::unblock(const Point2& p) {
  const CellIndex cell = felt_.geometry().cell_at(p);
  if (blocked_[cell] != Block::Felt) return;
  blocked_.at(cell) = Block::None;
  --felt_count_;
  take(cell);
}

void FeltCosts::unblock_all() {
  const GridGeometry& map = felt_.geometry();
  for (std::int32_t y = 0; y < map.height && felt_count_ > 0; ++y) {
    for (std::int32_t x = 0; x < map.width; ++x) unblock(map.center({x, y}));
  }
}

void FeltCosts::take(CellIndex cell) {
  const bool out = blocked_[cell] != Block::None || !allowed(felt_.geometry().center(cell));
  felt_.at(cell) = out ? kNoWay : costs_.view()[cell];
}

}  // namespace scrubjay

#include <scrubjay/exploration/approach.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {
namespace {

bool disc_fits(GridView<const LogOdds> map, CellIndex cell, double radius) {
  bool fits = true;
  visit_disc(map.geometry, map.geometry.center(cell), radius,
             [&](CellIndex near) { fits = fits && trinary(map[near]) != kOccupied; });
  return fits;
}

}  // namespace

std::optional<CellIndex> Approach::nearest_reached(GridView<const LogOdds> map, const PathSearch& ways,
                                                   CellIndex target, double disc) {
  if (round_of_.size() != map.geometry.size()) {
    round_of_.assign(map.geometry.size(), 0);
    round_ = 0;
  }
  ++round_;
  found_.clear();
  const auto visit = [&](CellIndex cell) {
    if (!map.contains(cell) || trinary(map[cell]) != kFree) return;
    std::uint32_t& round = round_of_[map.geometry.index(cell)];
    if (round == round_) return;
    round = round_;
    if (disc > 0.0 && !disc_fits(map, cell, disc)) return;
    found_.push_back(cell);
  };
  visit(target);
  for (std::size_t next = 0; next < found_.size(); ++next) {
    const CellIndex cell = found_[next];
    if (ways.cost_to(cell) != PathSearch::kNever) return cell;
    visit({cell.x - 1, cell.y});
    visit({cell.x + 1, cell.y});
    visit({cell.x, cell.y - 1});
    visit({cell.x, cell.y + 1});
  }
  return std::nullopt;
}

}  // namespace scrubjay

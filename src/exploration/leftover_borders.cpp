#include <scrubjay/exploration/leftover_borders.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {
namespace {

class BorderLister {
 public:
  BorderLister(const SweepGain& gain, GridView<const TravelCost> costs, const PathSearch& ways)
      : gain_(gain), costs_(costs), ways_(ways), map_(gain.geometry()), why_(map_.size(), nullptr) {
    for (std::int32_t y = 0; y < map_.height; ++y) {
      for (std::int32_t x = 0; x < map_.width; ++x) why_[map_.index({x, y})] = why({x, y});
    }
  }

  std::vector<Leftover> list(double least) {
    std::vector<Leftover> leftovers;
    for (std::int32_t y = 0; y < map_.height; ++y) {
      for (std::int32_t x = 0; x < map_.width; ++x) {
        if (why_[map_.index({x, y})] == nullptr) continue;
        const Leftover border = take({x, y});
        if (border.size > least - 0.5 * map_.resolution) leftovers.push_back(border);
      }
    }
    return leftovers;
  }

 private:
  /// Null for what isn't left: free, occupied, beside a wall, away from free floor, or within reach.
  const char* why(CellIndex cell) const {
    const bool border = gain_.free({cell.x - 1, cell.y}) || gain_.free({cell.x + 1, cell.y}) ||
                        gain_.free({cell.x, cell.y - 1}) || gain_.free({cell.x, cell.y + 1});
    if (!border) return nullptr;
    if (gain_.out_of_bounds(cell)) return "out of bounds";
    if (gain_.given_up(cell)) return "given up";
    if (!gain_.wanted(cell)) return nullptr;
    bool room = false;
    bool reached = false;
    visit_disc(map_, map_.center(cell), gain_.radius(), [&](CellIndex c) {
      room = room || costs_[c] != kNoWay;
      reached = reached || (costs_[c] != kNoWay && ways_.cost_to(c) < PathSearch::kNever);
    });
    if (reached) return nullptr;
    return room ? "no way there" : "too narrow for the robot";
  }

  /// The connected border of one reason that the cell belongs to.
  Leftover take(CellIndex first) {
    const char* reason = why_[map_.index(first)];
    std::vector<CellIndex> cells{first};
    why_[map_.index(first)] = nullptr;
    Point2 sum{0.0, 0.0};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const CellIndex cell = cells[i];
      sum += map_.center(cell);
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const CellIndex near{cell.x + dx, cell.y + dy};
          if (!map_.contains(near) || why_[map_.index(near)] != reason) continue;
          why_[map_.index(near)] = nullptr;
          cells.push_back(near);
        }
      }
    }
    const auto count = static_cast<double>(cells.size());
    return {sum / count, count * map_.resolution, reason};
  }

  const SweepGain& gain_;
  GridView<const TravelCost> costs_;
  const PathSearch& ways_;
  GridGeometry map_;
  std::vector<const char*> why_;  // a cell is left, if it is; string literals
};

}  // namespace

std::vector<Leftover> borders_left(const SweepGain& gain, GridView<const TravelCost> costs, const PathSearch& ways,
                                   double least) {
  return BorderLister(gain, costs, ways).list(least);
}

}  // namespace scrubjay

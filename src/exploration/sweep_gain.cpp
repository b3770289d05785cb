#include <algorithm>
#include <cmath>
#include <scrubjay/exploration/sweep_gain.hpp>

namespace scrubjay {
namespace {

constexpr LogOdds kWall = 90;  // p = 0.989: felt or seen a dozen times

}  // namespace

void SweepGain::begin(const GridGeometry& map) {
  const auto steps_within = [&](double radius) {
    std::vector<Step> steps;
    const auto reach = static_cast<std::int32_t>(std::ceil(radius / map.resolution));
    for (std::int32_t y = -reach; y <= reach; ++y) {
      for (std::int32_t x = -reach; x <= reach; ++x) {
        const double distance = map.resolution * std::sqrt(static_cast<double>(x * x + y * y));
        if (distance < radius) steps.push_back({x, y});
      }
    }
    return steps;
  };
  disc_ = steps_within(params_.radius - params_.grazed * map.resolution);
  beside_wall_ = steps_within(params_.beside_wall);
}

void SweepGain::update(GridView<const LogOdds> map, const CellRect& changed) {
  if (class_.geometry().size() == 0) begin(map.geometry);
  const bool grown_map = !(class_.geometry() == map.geometry);
  class_.follow(map.geometry);
  gain_.follow(map.geometry);
  tries_.follow(map.geometry);
  const CellRect all = cells_of(map.geometry);
  // New cells are wanted ones that no count knows yet; what is counted is counted again, since growth is rare.
  if (grown_map) {
    for (std::int32_t y = 0; y < all.high.y; ++y) {
      for (std::int32_t x = 0; x < all.high.x; ++x) gain_.at({x, y}) = 0;
    }
    for (std::int32_t y = 0; y < all.high.y; ++y) {
      for (std::int32_t x = 0; x < all.high.x; ++x) {
        if (wanted({x, y})) count({x, y}, 1);
      }
    }
  }
  const auto reach = static_cast<std::int32_t>(std::ceil(params_.beside_wall / map.geometry.resolution));
  // New cells may lie beside old walls, or out of bounds.
  const CellRect taken = grown_map ? all : intersection(grown(changed, reach), all);
  for (std::int32_t y = taken.low.y; y < taken.high.y; ++y) {
    for (std::int32_t x = taken.low.x; x < taken.high.x; ++x) {
      const Class now = classify(map, {x, y});
      if (now != class_[{x, y}]) change({x, y}, now);
    }
  }
}

SweepGain::Class SweepGain::classify(GridView<const LogOdds> map, CellIndex cell) const {
  const Occupancy value = trinary(map[cell]);
  if (value == kFree) return Class::Free;
  if (value == kOccupied) return map[cell] >= kWall || class_[cell] == Class::Wall ? Class::Wall : Class::Occupied;
  if (params_.within && !params_.within->contains(map.geometry.center(cell))) return Class::OutOfBounds;
  const bool beside = std::any_of(beside_wall_.begin(), beside_wall_.end(), [&](Step step) {
    const CellIndex near{cell.x + step.x, cell.y + step.y};
    return map.contains(near) && map[near] >= kOccupiedLogOdds;
  });
  if (beside) return Class::BesideWall;
  return tries_[cell] >= params_.tries ? Class::GivenUp : Class::Wanted;
}

void SweepGain::change(CellIndex cell, Class to) {
  const Class from = class_[cell];
  class_.at(cell) = to;
  if (to == Class::Wall) ++walls_;
  if (from == Class::Wall) ++refuted_;
  if (from == Class::Wanted) count(cell, -1);
  if (to == Class::Wanted) count(cell, 1);
  if (to != Class::Free) return;
  ++freed_;
  for (std::int32_t dy = -1; dy <= 1; ++dy) {
    for (std::int32_t dx = -1; dx <= 1; ++dx) {
      const CellIndex near{cell.x + dx, cell.y + dy};
      if (!class_.contains(near) || tries_[near] == 0) continue;
      --tries_.at(near);
      if (class_[near] == Class::GivenUp) change(near, Class::Wanted);
    }
  }
}

void SweepGain::count(CellIndex cell, int by) {
  for (const Step& step : disc_) {
    const CellIndex center{cell.x + step.x, cell.y + step.y};
    if (gain_.contains(center)) gain_.at(center) = static_cast<std::uint16_t>(gain_[center] + by);
  }
}

void SweepGain::tried(CellIndex cell) {
  if (!class_.contains(cell) || class_[cell] != Class::Wanted) return;
  if (++tries_.at(cell) >= params_.tries) change(cell, Class::GivenUp);
}

}  // namespace scrubjay

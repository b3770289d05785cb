#include <algorithm>
#include <array>
#include <scrubjay/localization/likelihood_field.hpp>

namespace scrubjay {
namespace {

constexpr std::int32_t kReach = 2;  // cells that an occupied one reaches, either way
constexpr std::int32_t kSide = 2 * kReach + 1;

/// 255 * (1 - d^2 / 9), rounded, around an occupied cell.
constexpr std::array<std::array<LikelihoodField::Fit, kSide>, kSide> kKernel = [] {
  std::array<std::array<LikelihoodField::Fit, kSide>, kSide> kernel{};
  for (std::int32_t y = -kReach; y <= kReach; ++y) {
    for (std::int32_t x = -kReach; x <= kReach; ++x) {
      const std::int32_t squared = x * x + y * y;
      kernel[static_cast<std::size_t>(y + kReach)][static_cast<std::size_t>(x + kReach)] =
          static_cast<LikelihoodField::Fit>((LikelihoodField::kBest * (9 - squared) + 4) / 9);
    }
  }
  return kernel;
}();

LikelihoodField::Fit kernel(std::int32_t x, std::int32_t y) {
  return kKernel[static_cast<std::size_t>(y + kReach)][static_cast<std::size_t>(x + kReach)];
}

bool occupied(LogOdds cell) {
  return cell >= kOccupiedLogOdds;
}

/// The cells that an occupied one reaches.
CellRect reached(CellIndex c, const GridGeometry& grid) {
  return intersection({{c.x - kReach, c.y - kReach}, {c.x + kReach + 1, c.y + kReach + 1}}, cells_of(grid));
}

}  // namespace

void LikelihoodField::follow(GridView<const LogOdds> map, const CellRect& changed) {
  CellRect rect = intersection(changed, cells_of(map.geometry));
  if (!(map.geometry == geometry_)) {
    // Maps grow by doubling, so starting over costs constant time a cell in the long run.
    lay_out(map.geometry);
    rect = cells_of(map.geometry);
  }
  for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
    const LogOdds* cells = map.cells + map.geometry.index({0, y});
    const Fit* fits = fits_.data() + map.geometry.index({0, y});
    // Blocks of cells without news, which are nearly all, are told by a loop that the compiler makes vectors of
    // (LikelihoodFieldFollows in test/bench/scan_matching_bench.cpp).
    constexpr std::int32_t kStretch = 64;
    for (std::int32_t begin = rect.low.x; begin < rect.high.x; begin += kStretch) {
      const std::int32_t end = std::min(begin + kStretch, rect.high.x);
      std::uint8_t news = 0;
      for (std::int32_t x = begin; x < end; ++x) {
        news |= static_cast<std::uint8_t>(occupied(cells[x]) != (fits[x] == kBest));
      }
      if (news == 0) continue;
      for (std::int32_t x = begin; x < end; ++x) {
        if (occupied(cells[x]) == (fits[x] == kBest)) continue;
        if (occupied(cells[x])) {
          occupy({x, y});
        } else {
          vacate({x, y});
        }
      }
    }
  }
}

void LikelihoodField::lay_out(const GridGeometry& geometry) {
  geometry_ = geometry;
  fits_.assign(geometry.size(), Fit{0});
  // One more before the first cell, from which offsets lead into the map.
  blocks_.width = (geometry.width >> kBlockBits) + 2;
  blocks_.height = (geometry.height >> kBlockBits) + 2;
  bounds_.assign(blocks_.size(), Fit{0});
}

void LikelihoodField::occupy(CellIndex c) {
  const CellRect rect = reached(c, geometry_);
  for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
    for (std::int32_t x = rect.low.x; x < rect.high.x; ++x) raise({x, y}, kernel(x - c.x, y - c.y));
  }
}

void LikelihoodField::raise(CellIndex c, Fit fit) {
  Fit& at = fits_[geometry_.index(c)];
  if (fit <= at) return;
  at = fit;
  // The blocks that bound this cell: its own, and the one before where that reaches as far.
  for (std::int32_t y = (c.y - kBlock + 1) >> kBlockBits; y <= c.y >> kBlockBits; ++y) {
    for (std::int32_t x = (c.x - kBlock + 1) >> kBlockBits; x <= c.x >> kBlockBits; ++x) {
      Fit& bound = bounds_[blocks_.index({x + 1, y + 1})];
      bound = std::max(bound, fit);
    }
  }
}

/// Bounds stay as they are: no less than what they bound, if no longer the least such.
void LikelihoodField::vacate(CellIndex c) {
  fits_[geometry_.index(c)] = 0;
  const CellRect rect = reached(c, geometry_);
  for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
    for (std::int32_t x = rect.low.x; x < rect.high.x; ++x) {
      Fit best = 0;
      const CellRect around = reached({x, y}, geometry_);
      for (std::int32_t v = around.low.y; v < around.high.y; ++v) {
        for (std::int32_t u = around.low.x; u < around.high.x; ++u) {
          // What this field holds for occupied; the map is ahead of it by the cells that are still to be looked at.
          if (fits_[geometry_.index({u, v})] == kBest) best = std::max(best, kernel(u - x, v - y));
        }
      }
      fits_[geometry_.index({x, y})] = best;
    }
  }
}

}  // namespace scrubjay

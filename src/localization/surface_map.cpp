#include <algorithm>
#include <array>
#include <cmath>
#include <scrubjay/localization/surface_map.hpp>

namespace scrubjay {
namespace {

constexpr std::int32_t kAround = 2;  // of the neighbourhood that makes a line, either way [cells]
constexpr std::size_t kAcross = 2 * kAround + 1;
constexpr float kFirmWeight = 255.0F;  // a mean over more would never move again
constexpr double kLineWeight = 100.0;  // what one cell may weigh in a line
constexpr double kMaxRoundness = 0.4;  // of a line: variance across it to variance along it
constexpr double kMinLength = 0.5;     // of a line: standard deviation along it [cells]
constexpr double kRangeNoise = 0.1;    // of a mean, across a line; added to what is measured [cells]

/// Sums of weighted points.
struct Moments {
  double weight = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

  void add(double w, const Point2& p) {
    weight += w;
    x += w * p.x();
    y += w * p.y();
    xx += w * p.x() * p.x();
    xy += w * p.x() * p.y();
    yy += w * p.y() * p.y();
  }
};

/// A cell's mean.
struct Sighting {
  Point2 point;  // [cells]
  Point2 view;
  double weight = 0.0;
};

/// The line of least squares through points given in cells around (0, 0).
std::optional<SurfaceLine> line_through(const Moments& m) {
  if (m.weight <= 0.0) return std::nullopt;
  const double mean_x = m.x / m.weight;
  const double mean_y = m.y / m.weight;
  const double xx = m.xx / m.weight - mean_x * mean_x;
  const double xy = m.xy / m.weight - mean_x * mean_y;
  const double yy = m.yy / m.weight - mean_y * mean_y;
  const double half_sum = 0.5 * (xx + yy);
  const double half_difference = 0.5 * (xx - yy);
  const double root = std::sqrt(half_difference * half_difference + xy * xy);
  const double along = half_sum + root;
  const double across = half_sum - root + kRangeNoise * kRangeNoise;
  if (along < kMinLength * kMinLength || across > kMaxRoundness * along) return std::nullopt;
  // The eigenvector of the smaller eigenvalue, from whichever row of the matrix is longer.
  Point2 normal = half_difference > 0.0 ? Point2(-xy, half_difference + root) : Point2(root - half_difference, -xy);
  normal /= std::sqrt(normal.squaredNorm());
  return SurfaceLine{{mean_x, mean_y}, normal, across};
}

}  // namespace

void SurfaceMap::add(const Point2& p, const Point2& view, double noise, const LikelihoodField& field) {
  if (!anchor_) anchor_ = field.geometry().origin;
  const CellIndex c = field.geometry().cell_at(p);
  const Point2 center = field.geometry().center(c);
  Surface& surface = at(place(c, field.geometry()));
  if (surface.weight > 0.0F && field.at(c) == 0) surface = {};
  const float weight = static_cast<float>(1e-4 / (noise * noise));
  surface.weight = std::min(surface.weight + weight, kFirmWeight);
  const float share = std::min(1.0F, weight / surface.weight);
  surface.x += share * (static_cast<float>(p.x() - center.x()) - surface.x);
  surface.y += share * (static_cast<float>(p.y() - center.y()) - surface.y);
  surface.view_x += share * (static_cast<float>(view.x()) - surface.view_x);
  surface.view_y += share * (static_cast<float>(view.y()) - surface.view_y);
}

std::optional<SurfaceLine> SurfaceMap::line_at(CellIndex c, const Point2& view, const LikelihoodField& field) const {
  const double per_metre = 1.0 / field.geometry().resolution;
  const CellIndex here = place(c, field.geometry());
  std::array<Sighting, kAcross * kAcross> sightings;
  std::size_t count = 0;
  Moments told;  // by the map alone
  for (std::int32_t y = -kAround; y <= kAround; ++y) {
    for (std::int32_t x = -kAround; x <= kAround; ++x) {
      const Surface* surface = find({here.x + x, here.y + y});
      if (surface == nullptr || surface->weight == 0.0F) {
        if (field.at({c.x + x, c.y + y}) == LikelihoodField::kBest) told.add(1.0, {x, y});
      } else if (field.at({c.x + x, c.y + y}) > 0) {
        sightings[count++] = {{x + per_metre * surface->x, y + per_metre * surface->y},
                              {surface->view_x, surface->view_y},
                              std::min<double>(surface->weight, kLineWeight)};
      }
    }
  }
  const auto seen_from = [&](const Point2& side) {
    Moments seen;
    for (std::size_t i = 0; i < count; ++i) {
      if (sightings[i].view.dot(side) > 0.0) seen.add(sightings[i].weight, sightings[i].point);
    }
    return line_through(seen);
  };
  std::optional<SurfaceLine> line = count > 0 ? seen_from(view) : line_through(told);
  if (line && count > 0) {
    // Who looks along a wall may do so in nearly the same direction from either side of it: the line tells the sides.
    line = seen_from(line->normal.dot(view) > 0.0 ? line->normal : Point2(-line->normal));
  }
  if (line) line->variance *= field.geometry().resolution * field.geometry().resolution;
  if (line) line->point = field.geometry().center(c) + field.geometry().resolution * line->point;
  return line;
}

CellIndex SurfaceMap::place(CellIndex c, const GridGeometry& grid) const {
  const Point2 shift = (grid.origin - anchor_.value_or(grid.origin)) / grid.resolution;
  return {c.x + static_cast<std::int32_t>(std::floor(shift.x() + 0.5)),
          c.y + static_cast<std::int32_t>(std::floor(shift.y() + 0.5))};
}

const SurfaceMap::Surface* SurfaceMap::find(CellIndex place) const {
  const CellIndex tile{place.x >> kTileBits, place.y >> kTileBits};
  if (!tiles_.contains(tile)) return nullptr;
  const std::int32_t number = tile_[tile_index(tile)];
  return number < 0 ? nullptr : &surfaces_[surface_index(number, place)];
}

SurfaceMap::Surface& SurfaceMap::at(CellIndex place) {
  const CellIndex tile{place.x >> kTileBits, place.y >> kTileBits};
  if (!tiles_.contains(tile)) cover(tile);
  std::int32_t& number = tile_[tile_index(tile)];
  if (number < 0) {
    constexpr std::size_t kTileSize = std::size_t{1} << (2 * kTileBits);
    number = static_cast<std::int32_t>(surfaces_.size() / kTileSize);
    surfaces_.resize(surfaces_.size() + kTileSize);
  }
  return surfaces_[surface_index(number, place)];
}

std::size_t SurfaceMap::tile_index(CellIndex tile) const {
  return static_cast<std::size_t>(tile.y - tiles_.low.y) * static_cast<std::size_t>(tiles_.high.x - tiles_.low.x) +
         static_cast<std::size_t>(tile.x - tiles_.low.x);
}

std::size_t SurfaceMap::surface_index(std::int32_t number, CellIndex place) {
  constexpr std::int32_t kMask = (1 << kTileBits) - 1;
  const std::int32_t in_tile = ((place.y & kMask) << kTileBits) + (place.x & kMask);
  return (static_cast<std::size_t>(number) << (2 * kTileBits)) + static_cast<std::size_t>(in_tile);
}

/// Makes room in the index, half as much again as there is on the side that must move.
void SurfaceMap::cover(CellIndex tile) {
  constexpr std::int32_t kSpare = 4;  // [tiles]
  const CellRect from = tiles_;
  CellRect to = bounding(from, {tile, {tile.x + 1, tile.y + 1}});
  const std::int32_t spare_x = kSpare + (from.high.x - from.low.x) / 2;
  const std::int32_t spare_y = kSpare + (from.high.y - from.low.y) / 2;
  if (to.low.x < from.low.x || from.empty()) to.low.x -= spare_x;
  if (to.low.y < from.low.y || from.empty()) to.low.y -= spare_y;
  if (to.high.x > from.high.x || from.empty()) to.high.x += spare_x;
  if (to.high.y > from.high.y || from.empty()) to.high.y += spare_y;

  const auto width = static_cast<std::size_t>(to.high.x - to.low.x);
  std::vector<std::int32_t> tiles(width * static_cast<std::size_t>(to.high.y - to.low.y), -1);
  for (std::int32_t y = from.low.y; y < from.high.y; ++y) {
    for (std::int32_t x = from.low.x; x < from.high.x; ++x) {
      tiles[static_cast<std::size_t>(y - to.low.y) * width + static_cast<std::size_t>(x - to.low.x)] =
          tile_[tile_index({x, y})];
    }
  }
  tiles_ = to;
  tile_ = std::move(tiles);
}

}  // namespace scrubjay

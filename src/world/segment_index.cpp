#include <algorithm>
#include <cmath>
#include <scrubjay/world/segment_index.hpp>

namespace scrubjay {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Buckets overlap by this share of their side, so that rounding in a ray's walk can't step past a segment.
constexpr double kOverlap = 1e-6;

/// Where a ray runs through an axis-parallel box: [enter, leave], empty if enter > leave.
struct RayInterval {
  double enter, leave;
};

void clip(double origin, double inverse_direction, double low, double high, RayInterval& interval) {
  if (std::isinf(inverse_direction)) {
    if (!(origin >= low && origin <= high)) interval.leave = -kInfinity;
    return;
  }
  const double a = (low - origin) * inverse_direction;
  const double b = (high - origin) * inverse_direction;
  interval.enter = std::max(interval.enter, std::min(a, b));
  interval.leave = std::min(interval.leave, std::max(a, b));
}

}  // namespace

SegmentIndex::SegmentIndex(std::vector<SolidSegment> segments) : segments_(std::move(segments)) {
  choose_grid();
  fill_buckets();
}

void SegmentIndex::choose_grid() {
  if (segments_.empty()) {
    offsets_.assign(1, 0);
    return;
  }
  low_ = high_ = segments_.front().segment.a;
  for (const SolidSegment& solid : segments_) {
    low_ = low_.cwiseMin(solid.segment.a).cwiseMin(solid.segment.b);
    high_ = high_.cwiseMax(solid.segment.a).cwiseMax(solid.segment.b);
  }
  // About kCellsPerSegment cells a segment, but no smaller than kSmallestCell (world_bench, Cast, has the figures), and
  // no more than kMostCells in all, however far apart a few segments lie.
  constexpr double kCellsPerSegment = 3.0;
  constexpr double kSmallestCell = 0.15;
  constexpr double kMostCells = 4e6;
  const Point2 size = high_ - low_;
  const double count = static_cast<double>(segments_.size());
  cell_ = std::max(kSmallestCell, std::sqrt(size.x() * size.y() / (kCellsPerSegment * count)));
  cell_ = std::max({cell_, std::sqrt(size.x() * size.y() / kMostCells), size.maxCoeff() / kMostCells});
  low_.array() -= 2.0 * kOverlap * cell_;
  per_cell_ = 1.0 / cell_;
  width_ = static_cast<std::int32_t>((high_.x() - low_.x()) * per_cell_ + 2.0 * kOverlap) + 1;
  height_ = static_cast<std::int32_t>((high_.y() - low_.y()) * per_cell_ + 2.0 * kOverlap) + 1;
  high_ = low_ + cell_ * Point2(width_, height_);
  offsets_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) + 1, 0);
}

/// Calls `visit(cell)` for every cell that the segment comes near: row by row, the stretch that it spans there.
template <typename Visit>
void SegmentIndex::visit_cells(const Segment2& segment, const Visit& visit) const {
  const Point2 low_end = segment.a.y() <= segment.b.y() ? segment.a : segment.b;
  const Point2 high_end = segment.a.y() <= segment.b.y() ? segment.b : segment.a;
  const double rise = high_end.y() - low_end.y();
  const double margin = kOverlap * cell_;
  const auto column = [&](double x) {
    return std::clamp(static_cast<std::int32_t>((x - low_.x()) * per_cell_), 0, width_ - 1);
  };
  const auto row = [&](double y) {
    return std::clamp(static_cast<std::int32_t>((y - low_.y()) * per_cell_), 0, height_ - 1);
  };
  const std::int32_t last_row = row(high_end.y() + margin);
  for (std::int32_t y = row(low_end.y() - margin); y <= last_row; ++y) {
    const double floor_y = low_.y() + y * cell_ - margin;
    const double ceiling_y = low_.y() + (y + 1) * cell_ + margin;
    // A segment lower than the margin is taken whole: its slope says nothing.
    const double from = rise > margin ? std::clamp((floor_y - low_end.y()) / rise, 0.0, 1.0) : 0.0;
    const double to = rise > margin ? std::clamp((ceiling_y - low_end.y()) / rise, 0.0, 1.0) : 1.0;
    const double x0 = low_end.x() + from * (high_end.x() - low_end.x());
    const double x1 = low_end.x() + to * (high_end.x() - low_end.x());
    const std::int32_t last_column = column(std::max(x0, x1) + margin);
    for (std::int32_t x = column(std::min(x0, x1) - margin); x <= last_column; ++x) {
      visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
    }
  }
}

void SegmentIndex::fill_buckets() {
  // Counting sort: how many per cell, where each cell ends, then filled from the back.
  for (const SolidSegment& solid : segments_) {
    visit_cells(solid.segment, [&](std::size_t cell) { ++offsets_[cell]; });
  }
  std::uint32_t total = 0;
  for (std::uint32_t& offset : offsets_) offset = total += offset;
  pieces_.resize(total);
  ids_.resize(total);
  for (std::size_t i = segments_.size(); i-- > 0;) {
    const Segment2& s = segments_[i].segment;
    const Piece piece{s.a.x(), s.a.y(), s.b.x() - s.a.x(), s.b.y() - s.a.y()};
    visit_cells(s, [&](std::size_t cell) {
      const std::uint32_t place = --offsets_[cell];
      pieces_[place] = piece;
      ids_[place] = static_cast<std::uint32_t>(i);
    });
  }
}

RayHit SegmentIndex::cast(const Point2& origin, const Point2& direction, double max_range) const {
  RayHit hit;
  const double ox = origin.x();
  const double oy = origin.y();
  const double dx = direction.x();
  const double dy = direction.y();
  const double per_dx = 1.0 / dx;
  const double per_dy = 1.0 / dy;
  RayInterval inside{0.0, max_range};
  clip(ox, per_dx, low_.x(), high_.x(), inside);
  clip(oy, per_dy, low_.y(), high_.y(), inside);
  if (!(inside.enter <= inside.leave) || width_ == 0) return hit;

  const double start_x = (ox + inside.enter * dx - low_.x()) * per_cell_;
  const double start_y = (oy + inside.enter * dy - low_.y()) * per_cell_;
  auto x = std::clamp(static_cast<std::int32_t>(start_x), 0, width_ - 1);
  auto y = std::clamp(static_cast<std::int32_t>(start_y), 0, height_ - 1);
  const std::int32_t step_x = dx < 0.0 ? -1 : 1;
  const std::int32_t step_y = dy < 0.0 ? -1 : 1;
  // Ranges at which the ray leaves this column and this row; never, where it runs along them.
  double leave_x = std::isinf(per_dx) ? kInfinity : (low_.x() + (x + (dx > 0.0)) * cell_ - ox) * per_dx;
  double leave_y = std::isinf(per_dy) ? kInfinity : (low_.y() + (y + (dy > 0.0)) * cell_ - oy) * per_dy;
  const double across_x = cell_ * std::fabs(per_dx);
  const double across_y = cell_ * std::fabs(per_dy);

  double best = std::nextafter(max_range, kInfinity);
  while (true) {
    const std::size_t cell =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    for (std::uint32_t i = offsets_[cell]; i != offsets_[cell + 1]; ++i) {
      // ray_hit() of segment2.hpp, with its divisions put off until there is a hit.
      const Piece& piece = pieces_[i];
      const double to_x = piece.ax - ox;
      const double to_y = piece.ay - oy;
      const double cross = dx * piece.dy - dy * piece.dx;
      const double offset = to_x * dy - to_y * dx;
      double range;
      if (cross == 0.0) [[unlikely]] {
        range = ray_hit(segments_[ids_[i]].segment, origin, direction);
      } else {
        const double sign = cross > 0.0 ? 1.0 : -1.0;
        const double ahead = to_x * piece.dy - to_y * piece.dx;
        if (offset * sign < 0.0 || offset * sign > cross * sign || ahead * sign < 0.0) continue;
        range = ahead / cross;
      }
      if (range < best || (range == best && ids_[i] < hit.segment)) {
        best = range;
        hit = {range, ids_[i]};
      }
    }
    const double leave = std::min(leave_x, leave_y);
    if (best <= leave || leave > inside.leave) return hit;
    if (leave_x < leave_y) {
      x += step_x;
      if (x < 0 || x >= width_) return hit;
      leave_x += across_x;
    } else {
      y += step_y;
      if (y < 0 || y >= height_) return hit;
      leave_y += across_y;
    }
  }
}

/// Cells that a disc may overlap, clipped to the grid.
SegmentIndex::CellRange SegmentIndex::cells_around(const Point2& center, double radius) const {
  const auto place = [&](double offset, std::int32_t count) {
    return static_cast<std::int32_t>(std::clamp(std::floor(offset * per_cell_), -1.0, static_cast<double>(count)));
  };
  return {std::max(place(center.x() - radius - low_.x(), width_), 0),
          std::min(place(center.x() + radius - low_.x(), width_) + 1, width_),
          std::max(place(center.y() - radius - low_.y(), height_), 0),
          std::min(place(center.y() + radius - low_.y(), height_) + 1, height_)};
}

void SegmentIndex::within(const Point2& center, double radius, std::vector<std::uint32_t>& found) const {
  found.clear();
  const CellRange range = cells_around(center, radius);
  for (std::int32_t y = range.y_begin; y < range.y_end; ++y) {
    for (std::int32_t x = range.x_begin; x < range.x_end; ++x) {
      const std::size_t cell =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      for (std::uint32_t i = offsets_[cell]; i != offsets_[cell + 1]; ++i) {
        if (squared_distance(segments_[ids_[i]].segment, center) <= radius * radius) found.push_back(ids_[i]);
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

/// Lowers `squared` to the squared distance of the nearest segment in cells [x_begin, x_end) of row `y`.
void SegmentIndex::nearest_in_row(const Point2& p, std::int32_t y, std::int32_t x_begin, std::int32_t x_end,
                                  double& squared) const {
  if (y < 0 || y >= height_) return;
  const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
  x_begin = std::clamp(x_begin, 0, width_);
  x_end = std::clamp(x_end, x_begin, width_);
  const std::uint32_t end = offsets_[row + static_cast<std::size_t>(x_end)];
  for (std::uint32_t i = offsets_[row + static_cast<std::size_t>(x_begin)]; i != end; ++i) {
    squared = std::min(squared, squared_distance(segments_[ids_[i]].segment, p));
  }
}

double SegmentIndex::distance(const Point2& p, double max_distance) const {
  if (width_ == 0) return kInfinity;
  // Rings of cells around the one that is nearest to p, until what is further out must be farther than what was found.
  const Point2 inside = p.cwiseMax(low_).cwiseMin(high_);
  const auto x = std::clamp(static_cast<std::int32_t>((inside.x() - low_.x()) * per_cell_), 0, width_ - 1);
  const auto y = std::clamp(static_cast<std::int32_t>((inside.y() - low_.y()) * per_cell_), 0, height_ - 1);
  const std::int32_t last_ring = std::max({x, width_ - 1 - x, y, height_ - 1 - y});
  double squared = kInfinity;
  for (std::int32_t ring = 0; ring <= last_ring; ++ring) {
    // Cells of this ring are at least (ring - 1) cells from `inside`, and no nearer to p.
    const double nearest_possible = (ring - 1) * cell_;
    if (nearest_possible > 0.0 &&
        nearest_possible * nearest_possible > std::min(squared, max_distance * max_distance)) {
      break;
    }
    nearest_in_row(p, y - ring, x - ring, x + ring + 1, squared);
    if (ring == 0) continue;
    nearest_in_row(p, y + ring, x - ring, x + ring + 1, squared);
    for (std::int32_t row = y - ring + 1; row < y + ring; ++row) {
      if (x - ring >= 0) nearest_in_row(p, row, x - ring, x - ring + 1, squared);
      if (x + ring < width_) nearest_in_row(p, row, x + ring, x + ring + 1, squared);
    }
  }
  const double distance = std::sqrt(squared);
  return distance <= max_distance ? distance : kInfinity;
}

}  // namespace scrubjay

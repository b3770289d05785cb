#include <cmath>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/localization/straight_walls.hpp>

namespace scrubjay {
namespace {

constexpr std::size_t kFewest = 10;     // ends of a wall
constexpr std::size_t kNeighbours = 2;  // on either side, with which an end is averaged to tell a bend from noise
constexpr double kShortest = 0.6;       // [m]
constexpr double kStraight = 3.0;       // standard deviations of chi-square that a line may be worse than expected
constexpr double kGap = 0.3;            // between ends of one wall, on top of ...
constexpr double kGapSigmas = 3.0;      // ... as many standard deviations [m]
constexpr int kDeepest = 50;         // times that a run of ends is taken in two: bounds what a scan of nonsense costs
constexpr double kRoughness = 1e-3;  // no wall is straighter than that; standard deviation [m]

struct Line {
  Point2 mean{0.0, 0.0};
  Point2 along{1.0, 0.0};
  double spread = 0.0;  // variance along it [m^2]
};

/// The line of least squares. The noise of ranges is taken out of the second moments: it stretches a wall that is seen
/// aslant towards the robot, and so would turn it.
Line line_through(std::span<const ScanEnd> ends) {
  double weight = 0.0;
  Point2 sum(0.0, 0.0);
  for (const ScanEnd& end : ends) {
    const double w = 1.0 / (end.noise * end.noise);
    weight += w;
    sum += w * end.point;
  }
  const Point2 mean = sum / weight;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (const ScanEnd& end : ends) {
    const double w = 1.0 / (end.noise * end.noise);
    const Point2 p = end.point - mean;
    xx += w * p.x() * p.x() - end.view.x() * end.view.x();
    xy += w * p.x() * p.y() - end.view.x() * end.view.y();
    yy += w * p.y() * p.y() - end.view.y() * end.view.y();
  }
  const double half_sum = 0.5 * (xx + yy) / weight;
  const double half_difference = 0.5 * (xx - yy) / weight;
  xy /= weight;
  const double root = std::sqrt(half_difference * half_difference + xy * xy);
  return {mean, direction(0.5 * atan2(xy, half_difference)), half_sum + root};
}

/// How ends lie along their line.
struct Residuals {
  double mean_square = 0.0;  // of the distances from it, in variances
  double information = 0.0;  // of its direction [1/rad^2]
};

Residuals residuals(std::span<const ScanEnd> ends, const Line& line) {
  const Point2 normal(-line.along.y(), line.along.x());
  Residuals found;
  for (const ScanEnd& end : ends) {
    const Point2 p = end.point - line.mean;
    const double variance = variance_across(end, normal.dot(end.view)) + kRoughness * kRoughness;
    const double across = normal.dot(p);
    const double along = line.along.dot(p);
    found.mean_square += across * across / variance;
    found.information += along * along / variance;
  }
  found.mean_square /= static_cast<double>(ends.size());
  return found;
}

/// The mean of an end and its neighbours, less noisy than each.
Point2 smoothed(std::span<const ScanEnd> ends, std::size_t i) {
  Point2 sum(0.0, 0.0);
  for (std::size_t j = i - kNeighbours; j <= i + kNeighbours; ++j) sum += ends[j].point;
  return sum / (2.0 * kNeighbours + 1.0);
}

/// Where ends lie farthest from the chord between the first and the last of them. There must be kFewest.
std::size_t bend_of(std::span<const ScanEnd> ends) {
  const std::size_t last = ends.size() - 1 - kNeighbours;
  const Point2 from = smoothed(ends, kNeighbours);
  const Segment2 chord{from, smoothed(ends, last)};
  std::size_t bend = kNeighbours + 1;
  double farthest = -1.0;
  for (std::size_t i = kNeighbours + 1; i < last; ++i) {
    const double off = squared_distance(chord, smoothed(ends, i));
    if (off <= farthest) continue;
    farthest = off;
    bend = i;
  }
  return bend;
}

/// Walls among the ends from `first` to before `last`, between which there is no gap.
void split(std::span<const ScanEnd> all, std::size_t first, std::size_t last, int depth,
           std::vector<StraightWall>& walls) {
  const std::size_t count = last - first;
  if (count < kFewest || depth > kDeepest) return;
  const std::span<const ScanEnd> ends = all.subspan(first, count);
  const Line line = line_through(ends);
  const Residuals off = residuals(ends, line);
  if (off.mean_square < 1.0 + kStraight * std::sqrt(2.0 / static_cast<double>(count))) {
    const double length = line.spread > 0.0 ? std::sqrt(12.0 * line.spread) : 0.0;  // as if they were spread evenly
    if (length >= kShortest) walls.push_back({first, count, line.along, length, 1.0 / off.information});
  } else {
    const std::size_t bend = first + bend_of(ends);
    split(all, first, bend, depth + 1, walls);
    split(all, bend, last, depth + 1, walls);
  }
}

}  // namespace

void find_straight_walls(std::span<const ScanEnd> ends, std::vector<StraightWall>& walls) {
  walls.clear();
  std::size_t first = 0;
  for (std::size_t i = 1; i <= ends.size(); ++i) {
    if (i < ends.size()) {
      const double gap = std::sqrt((ends[i].point - ends[i - 1].point).squaredNorm());
      if (gap < kGap + kGapSigmas * ends[i].noise) continue;
    }
    split(ends, first, i, 0, walls);
    first = i;
  }
}

}  // namespace scrubjay

#include <cmath>
#include <initializer_list>
#include <scrubjay/behavior/outlook.hpp>

namespace scrubjay {
namespace {

/// What a disc would meet on a straight drive.
struct Drive {
  double length = 0.0;   ///< until something stands in the way, or the map ends [m]
  double unknown = 0.0;  ///< share of the length over unknown floor [m]
};

bool occupied(GridView<const LogOdds> map, const Point2& p) {
  const CellIndex cell = map.geometry.cell_at(p);
  return map.contains(cell) && map[cell] >= kOccupiedLogOdds;
}

Drive look_along(GridView<const LogOdds> map, const Standpoint& from, double heading, double sight) {
  const Point2 forward = direction(heading);
  const Point2 aside = from.radius * Point2(-forward.y(), forward.x());
  const double step = map.geometry.resolution;
  Drive drive;
  for (double way = 0.0; way < sight; way += step) {
    const Point2 middle = from.position + way * forward;
    const CellIndex cell = map.geometry.cell_at(middle);
    if (!map.contains(cell)) return drive;
    // The disc's front and both of its sides; at first the sides may still touch what the robot stands at.
    if (occupied(map, middle + from.radius * forward)) return drive;
    constexpr double kDiagonal = 0.70710678118654752;
    const Point2 front = middle + kDiagonal * from.radius * forward;
    if (occupied(map, front + kDiagonal * aside) || occupied(map, front - kDiagonal * aside)) return drive;
    if (way > from.radius && (occupied(map, middle + aside) || occupied(map, middle - aside))) return drive;
    drive.length = way;
    if (trinary(map[cell]) == kUnknown) drive.unknown += step;
  }
  return drive;
}

struct Choice {
  double heading = 0.0;
  double score = -1.0;
};

template <typename Score>
Choice best_heading(const Standpoint& from, Random& random, const OutlookParams& params, Score&& score) {
  const double first = random.uniform(-kPi, kPi);
  Choice best{wrap_angle(from.obstacle + kPi), -1.0};
  for (int i = 0; i < params.headings; ++i) {
    const double heading = wrap_angle(first + 2.0 * kPi * i / params.headings);
    if (std::fabs(angle_difference(heading, from.obstacle)) < params.berth) continue;
    const double value = score(heading);
    if (value > best.score) best = {heading, value};
  }
  return best;
}

}  // namespace

std::optional<double> heading_to_unknown(GridView<const LogOdds> map, const Standpoint& from, Random& random,
                                         const OutlookParams& params) {
  const Choice best = best_heading(from, random, params, [&](double heading) {
    return look_along(map, from, heading, params.sight).unknown * random.uniform(0.5, 1.0);
  });
  if (best.score < params.worthwhile) return std::nullopt;
  return best.heading;
}

double longest_heading(GridView<const LogOdds> map, const Standpoint& from, Random& random,
                       const OutlookParams& params) {
  return best_heading(from, random, params,
                      [&](double heading) { return look_along(map, from, heading, params.sight).length; })
      .heading;
}

bool beside_known_floor(GridView<const LogOdds> map, const Standpoint& at, double heading) {
  // An edge that was followed has a lane of known floor along it, a robot wide. Behind lies what the drive up to the
  // edge has swept. In a corner one side lies within a wall, so one side is enough.
  constexpr double kBehind = radians(120.0);
  int known = 0;
  for (const double along : {at.obstacle + kPi / 2.0, at.obstacle - kPi / 2.0}) {
    if (std::fabs(angle_difference(along, heading)) > kBehind) continue;
    for (const double distance : {1.35, 1.6}) {
      const CellIndex cell = map.geometry.cell_at(at.position + distance * at.radius * direction(along));
      known += map.contains(cell) && trinary(map[cell]) != kUnknown;
    }
  }
  return known >= 2;
}

}  // namespace scrubjay

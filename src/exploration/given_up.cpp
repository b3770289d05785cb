#include <algorithm>
#include <cstdlib>
#include <scrubjay/exploration/given_up.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {

GivenUp::Surroundings GivenUp::look(GridView<const LogOdds> map, const Point2& center) const {
  Surroundings found;
  visit_disc(map.geometry, center, params_.surroundings, [&](CellIndex cell) {
    const Occupancy value = trinary(map[cell]);
    found.free += value == kFree ? 1 : 0;
    found.occupied += value == kOccupied ? 1 : 0;
  });
  const double r = map.geometry.resolution;
  const double area = kPi * params_.surroundings * params_.surroundings;  // the map's or not
  found.unknown = static_cast<int>(area / (r * r)) - found.free - found.occupied;
  return found;
}

// A share of the surroundings, in cells.
int GivenUp::cells(GridView<const LogOdds> map, double share) const {
  const double r = map.geometry.resolution;
  return static_cast<int>(share * kPi * params_.surroundings * params_.surroundings / (r * r));
}

int GivenUp::wanted_change(GridView<const LogOdds> map, int tries) const {
  double share = params_.change;
  for (int i = 1; i < tries && share < params_.most_change; ++i) share *= 2.0;
  return cells(map, std::min(share, params_.most_change));
}

bool GivenUp::changed(const Surroundings& then, GridView<const LogOdds> map, const Point2& center, int least) const {
  const Surroundings now = look(map, center);
  return std::abs(now.free - then.free) + std::abs(now.occupied - then.occupied) > least;
}

bool GivenUp::is_at(const Entry& entry, const Point2& goal) const {
  return (entry.goal - goal).squaredNorm() <= params_.place * params_.place;
}

GivenUp::Entry& GivenUp::entry_at(GridView<const LogOdds> map, const Point2& goal) {
  for (Entry& entry : entries_) {
    if (is_at(entry, goal)) return entry;
  }
  const Surroundings around = look(map, goal);
  entries_.push_back({goal, around, around.unknown});
  return entries_.back();
}

void GivenUp::remember(GridView<const LogOdds> map, const Point2& goal, const Point2& robot) {
  Entry& entry = entry_at(map, goal);
  ++entry.tries;
  entry.around_goal = look(map, entry.goal);
  entry.robot = robot;
  entry.around_robot = look(map, robot);
}

void GivenUp::remember_seen(GridView<const LogOdds> map, const Point2& goal, double stamp) {
  Entry& entry = entry_at(map, goal);
  const Surroundings around = look(map, entry.goal);
  if (around.unknown < entry.least_unknown - cells(map, params_.change)) {
    entry.least_unknown = around.unknown;
    entry.visits = 0;
  }
  if (entry.visits > 0 && stamp - entry.visited < params_.visit) return;
  entry.visited = stamp;
  if (++entry.visits < params_.visits) return;
  entry.visits = 0;
  remember(map, entry.goal, entry.goal);
}

void GivenUp::forgive(const Point2& goal) {
  std::erase_if(entries_, [&](const Entry& entry) { return is_at(entry, goal); });
}

bool GivenUp::holds(GridView<const LogOdds> map, const Point2& goal) const {
  for (const Entry& entry : entries_) {
    if (!is_at(entry, goal)) continue;
    const int least = wanted_change(map, entry.tries);
    if (entry.tries > 0 && !changed(entry.around_goal, map, entry.goal, least) &&
        !changed(entry.around_robot, map, entry.robot, least)) {
      return true;
    }
  }
  return false;
}

}  // namespace scrubjay

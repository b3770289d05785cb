#include <algorithm>
#include <array>
#include <cmath>
#include <scrubjay/exploration/lanes.hpp>

namespace scrubjay {
namespace {

// A lane begins where the disc has only just come upon unknown floor: no more of it lies over that.
constexpr double kMostAtStart = 0.5;

bool can_be(const LaneFloor& floor, const Point2& p) {
  const CellIndex cell = floor.costs.geometry.cell_at(p);
  if (!floor.costs.contains(cell)) return !floor.within || floor.within->contains(p);
  return floor.costs[cell] != kNoWay;
}

/// What a lane's next step adds.
struct Slice {
  int fresh = 0;       ///< cells newly swept
  int open_sides = 0;  ///< of it, beyond which unknown floor is left
};

class LaneFinder {
 public:
  LaneFinder(const LaneFloor& floor, const Pose2& robot, const LaneParams& params)
      : floor_(floor),
        robot_(robot),
        params_(params),
        geometry_(floor.costs.geometry),
        half_(static_cast<int>(std::floor(floor.gain.radius() / geometry_.resolution))),
        least_cells_(params.least_area / (geometry_.resolution * geometry_.resolution) - 0.5) {}

  void try_lanes(CellIndex start, double cost, double axis) {
    const bool here = start == geometry_.cell_at(robot_.position());
    const Point2 from = here ? robot_.position() : geometry_.center(start);
    for (int quarter = 0; quarter < 4; ++quarter) {
      const double heading = wrap_angle(axis + quarter * 0.5 * kPi);
      try_lane({from, heading, 0.0}, time_to(from, here ? 0.0 : cost, heading));
    }
  }

  void try_spot(CellIndex at, double cost) {
    const Point2 from = geometry_.center(at);
    take({from, 0.0, 0.0}, floor_.gain.gain(at), time_to(from, cost, std::nullopt));
  }

  std::optional<Lane> best() const { return best_worth_ > 0.0 ? std::optional(best_) : std::nullopt; }

 private:
  double time_to(const Point2& from, double cost, std::optional<double> heading) const {
    const Point2 way = from - robot_.position();
    double time = params_.stop;
    double yaw = robot_.yaw;
    if (way.norm() > 0.05) {
      const double bearing = atan2(way.y(), way.x());
      time +=
          params_.stop + std::fabs(angle_difference(bearing, yaw)) / params_.turn_rate + cost / params_.travel_speed;
      yaw = bearing;
    }
    const double turn = heading ? std::fabs(angle_difference(*heading, yaw)) : 0.0;
    return time + turn / params_.turn_rate + (turn > radians(15.0) ? params_.stop : 0.0);
  }

  void try_lane(Lane lane, double time_to) {
    const double step = geometry_.resolution;
    const double cell = step * step;
    const Point2 forward = direction(lane.heading);
    const Point2 aside = step * Point2(-forward.y(), forward.x());
    double worth = 0.0;
    double best_worth = 0.0;
    double last_fresh = 0.0;
    int cells = 0;
    for (double way = 0.0; way <= params_.max_length; way += step) {
      const Point2 p = lane.from + way * forward;
      if (!can_be(floor_, p)) break;
      const Slice slice = look_across(p, aside);
      if (slice.fresh == 0) {
        if (way - last_fresh > params_.most_known) break;
        continue;
      }
      last_fresh = way;
      cells += slice.fresh;
      worth += slice.fresh * cell;
      if (slice.fresh >= half_) worth += params_.tidiness * step * (1.0 - slice.open_sides);
      const double rate = worth / (time_to + way / params_.lane_speed);
      if (rate >= best_worth) {
        best_worth = rate;
        lane.length = way;
      }
    }
    if (cells < least_cells_ || best_worth <= best_worth_) return;
    best_worth_ = best_worth;
    best_ = lane;
  }

  void take(const Lane& lane, int cells, double time) {
    const double worth = cells * geometry_.resolution * geometry_.resolution / time;
    if (cells < least_cells_ || worth <= best_worth_) return;
    best_worth_ = worth;
    best_ = lane;
  }

  Slice look_across(const Point2& middle, const Point2& aside) const {
    Slice slice;
    for (int i = -half_; i <= half_; ++i) slice.fresh += wanted(middle + i * aside);
    if (slice.fresh == 0) return slice;
    const double beyond = half_ + 1.0;
    slice.open_sides = wanted(middle + beyond * aside) + wanted(middle - beyond * aside);
    return slice;
  }

  int wanted(const Point2& p) const {
    const CellIndex cell = geometry_.cell_at(p);
    if (!geometry_.contains(cell)) return !floor_.within || floor_.within->contains(p) ? 1 : 0;
    return floor_.gain.wanted(cell) ? 1 : 0;
  }

  const LaneFloor& floor_;
  Pose2 robot_;
  const LaneParams& params_;
  GridGeometry geometry_;
  int half_;  // of the disc's width [cells]
  double least_cells_;
  double best_worth_ = 0.0;
  Lane best_;
};

template <typename Visit>
void visit_reached(const LaneFloor& floor, const Pose2& robot, double reach, const Visit& visit) {
  const GridGeometry& geometry = floor.costs.geometry;
  const CellRect near = std::isfinite(reach) ? cells_around(geometry, robot.position(), reach) : cells_of(geometry);
  for (std::int32_t y = near.low.y; y < near.high.y; ++y) {
    for (std::int32_t x = near.low.x; x < near.high.x; ++x) {
      if (floor.gain.gain({x, y}) == 0 || floor.costs[{x, y}] == kNoWay) continue;
      const double cost = floor.ways.cost_to({x, y});
      if (cost <= reach && cost < PathSearch::kNever) visit(CellIndex{x, y}, cost);
    }
  }
}

}  // namespace

std::optional<Lane> best_lane(const LaneFloor& floor, const Pose2& robot, double axis, double reach,
                              const LaneParams& params) {
  LaneFinder finder(floor, robot, params);
  const CellIndex here = floor.costs.geometry.cell_at(robot.position());
  visit_reached(floor, robot, reach, [&](CellIndex cell, double cost) {
    const bool begins = floor.gain.free(cell) && floor.gain.gain(cell) <= kMostAtStart * floor.gain.most();
    if (begins || cell == here) finder.try_lanes(cell, cost, axis);
  });
  return finder.best();
}

std::optional<Lane> best_spot(const LaneFloor& floor, const Pose2& robot, double reach, const LaneParams& params) {
  LaneFinder finder(floor, robot, params);
  visit_reached(floor, robot, reach, [&](CellIndex cell, double cost) { finder.try_spot(cell, cost); });
  return finder.best();
}

}  // namespace scrubjay

#include <algorithm>
#include <cmath>
#include <scrubjay/exploration/contact_frontier.hpp>
#include <scrubjay/grid/traversal.hpp>

namespace scrubjay {
namespace {

constexpr double kCaution = 0.1;  // known floor that is left when it has slowed down for what is unknown behind it [m]
constexpr double kCreep = 0.03;   // towards what it is about to touch [m/s]
constexpr double kBlocked = 0.055;    // ahead of what it touches, and to both sides, its middle can't be [m]
constexpr double kHeldWithin = 0.02;  // [m]
constexpr double kCliffDepth = 0.3;   // [m]

CostMapParams cost_params(CostMapParams params, const RobotModel& robot) {
  params.radius = robot.radius;
  return params;
}

SweepGainParams gain_params(const RobotModel& robot, const std::optional<Bounds2>& within) {
  SweepGainParams params;
  params.radius = robot.radius;
  params.within = within;
  return params;
}

PathTrackerParams tracker_params(const ContactFrontierParams& params) {
  PathTrackerParams tracker = params.tracker;
  tracker.max_linear = params.known_speed;
  return tracker;
}

}  // namespace

ContactFrontier::ContactFrontier(const RobotModel& robot, Random random, const ContactFrontierParams& params)
    : robot_(robot),
      random_(random),
      params_(params),
      gain_(gain_params(robot, params.within)),
      costs_(cost_params(params.costs, robot), params.within),
      search_(2.0 * robot.radius),
      tracker_(robot, tracker_params(params)) {}

Decision ContactFrontier::decide(const Situation& now) {
  changes_.add(now.map.geometry, now.changed);
  watch(now);
  Decision decision;
  if (now.frame.wheel_dropped()) {
    decision = {{}, "a wheel hangs"};
  } else {
    if (state_ == State::Choose) choose(now);
    switch (state_) {
      case State::Travel:
      case State::Lane:
        decision = drive(now);
        break;
      case State::Edge:
        decision = follow_edge(now);
        break;
      case State::Retreat:
        decision = retreat(now);
        break;
      case State::Turn:
        decision = turn(now);
        break;
      case State::Choose:
        decision = {{}, "choosing"};
        break;
      case State::Done:
        decision = {{}, "done", true};
        break;
    }
  }
  motion_ = decision.motion;
  return decision;
}

/// Brings what is made of the map up to date.
void ContactFrontier::catch_up(const Situation& now) {
  const CellRect changed = changes_.take();
  gain_.update(now.map, changed);
  costs_.update(now.map, changed);
  trail_.follow(now.map.geometry);
  costs_.unblock(now.estimate.pose.position());
  look_stamp_ = now.frame.stamp;
}

/// Keeps account of the way.
void ContactFrontier::watch(const Situation& now) {
  const Pose2& pose = now.estimate.pose;
  way_ += (pose.position() - last_pose_.position()).norm();
  if (state_ == State::Edge) walls_.add(last_pose_, pose);
  const double pushed = motion_.linear * (now.frame.stamp - last_stamp_);
  pushed_ = now.frame.bumped() ? pushed_ + std::max(0.0, pushed) : 0.0;
  last_pose_ = pose;
  last_stamp_ = now.frame.stamp;
  if ((pose.position() - held_at_).norm() < kHeldWithin) return;
  held_at_ = pose.position();
  held_stamp_ = now.frame.stamp;
}

void ContactFrontier::choose(const Situation& now) {
  catch_up(now);
  if (lost()) return end(now);
  for (const double reach : {params_.near, 3.0 * params_.near, PathSearch::kNever}) {
    if (find_lane(now, reach)) return;
  }
  if (costs_.any_blocked() && gain_.freed() > forgiven_at_) {
    costs_.unblock_all();
    forgiven_at_ = gain_.freed();
    return;  // to choose again
  }
  if (shut_in(now.map.geometry) && escapes_ < params_.escapes) {
    ++escapes_;
    begin_edge(now);
    escaping_ = true;
    return;
  }
  end(now);
}

/// True if it drove through too many walls, by the map: its pose has drifted, and driving on would only smear the map.
/// Walls that were only felt prove nothing: a bumper tells where they are to within a quarter turn.
bool ContactFrontier::lost() const {
  if (!robot_.has_light_sensors) return false;
  const auto walls = static_cast<double>(gain_.walls());
  return static_cast<double>(gain_.refuted()) > std::max(params_.least_refuted, params_.most_refuted * walls);
}

void ContactFrontier::end(const Situation& now) {
  search_.spread(costs_.view(), now.map.geometry.cell_at(now.estimate.pose.position()));
  leftovers_ = borders_left(gain_, costs_.view(), search_, params_.least_leftover);
  state_ = State::Done;
}

/// Sets out for what is best within `reach` of way, if there is anything.
bool ContactFrontier::find_lane(const Situation& now, double reach) {
  const Pose2& pose = now.estimate.pose;
  search_.spread(costs_.view(), now.map.geometry.cell_at(pose.position()), reach);
  const LaneFloor floor{gain_, costs_.view(), search_, params_.within};
  std::optional<Lane> lane = best_lane(floor, pose, walls_.heading(pose.yaw), reach, params_.lanes);
  if (!lane) lane = best_spot(floor, pose, reach, params_.lanes);
  if (!lane) return false;
  set_out(now, *lane);
  return true;
}

/// True if most of the floor that is known is out of reach: then it isn't done, but stands in a place that is narrower
/// in the map than it is, and may feel its way out as it felt its way in.
bool ContactFrontier::shut_in(const GridGeometry& map) const {
  std::int64_t reached = 0;
  std::int64_t known = 0;
  for (std::int32_t y = 0; y < map.height; ++y) {
    for (std::int32_t x = 0; x < map.width; ++x) {
      if (!gain_.free({x, y}) || !costs_.passable({x, y})) continue;
      ++known;
      reached += search_.cost_to({x, y}) < PathSearch::kNever;
    }
  }
  return 2 * reached < known;
}

void ContactFrontier::set_out(const Situation& now, const Lane& lane) {
  if (!escaping_) escapes_ = 0;
  escaping_ = false;
  lane_ = lane;
  const Point2 here = now.estimate.pose.position();
  std::vector<Point2> path{here};
  if ((lane.from - here).norm() > tracker_.params().reached) {
    path = simplify(costs_.view(), search_.path_to(now.map.geometry.cell_at(lane.from)));
    if (path.size() > 1) path.erase(path.begin());
    path.insert(path.begin(), here);
    path.back() = lane.from;
  }
  state_ = State::Travel;
  tracker_.follow(std::move(path));
  deadline_ = now.frame.stamp + time_for(tracker_.remaining());
}

void ContactFrontier::begin_lane(const Situation& now) {
  state_ = State::Lane;
  tracker_.follow({lane_.from, lane_.to()});
  deadline_ = now.frame.stamp + time_for(tracker_.remaining());
}

/// In which a drive of this length should have ended, with turns.
double ContactFrontier::time_for(double way) const {
  return 15.0 + 4.0 * way / params_.unknown_speed;
}

Decision ContactFrontier::drive(const Situation& now) {
  const bool forbidden_ahead = forbidden(now.frame);
  if (touched(now) || forbidden_ahead) {
    meet(now, forbidden_ahead || now.frame.virtual_wall || now.frame.cliff_flags != 0);
    if (state_ == State::Edge) return follow_edge(now);
    if (state_ == State::Retreat) return retreat(now);
    return {{}, "choosing"};
  }
  PathTracker::Step step = tracker_.track(now.estimate.pose);
  if (step.arrived && state_ == State::Travel) {
    begin_lane(now);
    step = tracker_.track(now.estimate.pose);
  }
  if (step.arrived || now.frame.stamp > deadline_) {
    end_lane(now);
    return {{}, "choosing"};
  }
  const double allowed = allowed_speed(now);
  if (step.motion.linear > allowed) {
    const double share = allowed / step.motion.linear;
    step.motion = {share * step.motion.linear, share * step.motion.angular};
  }
  return {step.motion, state_ == State::Travel ? "on the way" : "sweeping a lane"};
}

/// Fast over known floor, slow over unknown floor, slower before something seen.
double ContactFrontier::allowed_speed(const Situation& now) const {
  const Ahead ahead = ahead_by_light(now.frame, robot_);
  const double seen = kCreep + speed_to_stop(ahead.way - params_.touch_way, params_.braking);
  const double slow = params_.unknown_speed * params_.unknown_speed;
  const double fast = params_.known_speed * params_.known_speed;
  const double sight = kCaution + (fast - slow) / (2.0 * params_.braking);
  const double known = known_ahead(now.map, now.estimate.pose, robot_.radius, sight);
  const double square = slow + 2.0 * params_.braking * std::max(0.0, known - kCaution);
  return std::min({params_.known_speed, seen, std::sqrt(square)});
}

/// A bump counts when the bumper closes; one that stays closed, when the robot pushes on against it. A cliff counts
/// when it opens, even in a turn, which might take a wheel over it; one that stays, when the robot drives on.
bool ContactFrontier::touched(const Situation& now) {
  const Frame& frame = now.frame;
  const bool bump_began = frame.bumped() && !was_bumped_;
  const bool cliff_began = (frame.cliff_flags & ~last_cliff_flags_) != 0;
  was_bumped_ = frame.bumped();
  last_cliff_flags_ = frame.cliff_flags;
  if (bump_began || cliff_began || pushed_ > params_.push) return true;
  if (motion_.linear <= 0.0) return false;
  return frame.cliff_flags != 0 || frame.virtual_wall || ahead_by_light(frame, robot_).way <= params_.touch_way;
}

/// Ahead is a place that it wouldn't get out of, once in.
bool ContactFrontier::forbidden(const Frame& frame) const {
  if (motion_.linear <= 0.0) return false;
  if (room_beside(frame, robot_) < params_.least_room) return true;
  return faces_dock(frame) && ahead_by_light(frame, robot_).way < params_.before_dock;
}

/// Something is in the way: an edge to be followed, or one that it knows, or none at all.
void ContactFrontier::meet(const Situation& now, bool no_edge) {
  catch_up(now);
  pushed_ = 0.0;
  if (!no_edge && !edge_known(now.estimate.pose)) return begin_edge(now);
  end_lane(now);
  turn_back(now);
}

/// Remembers that its middle can't get on to where it was driving, and backs off over floor that it has just driven.
void ContactFrontier::turn_back(const Situation& now) {
  const Pose2& pose = now.estimate.pose;
  catch_up(now);
  const CellIndex here = now.map.geometry.cell_at(pose.position());
  const double step = 0.5 * now.map.geometry.resolution;
  for (double aside = -kBlocked; aside <= kBlocked; aside += step) {
    const Point2 ahead = pose * Point2(kBlocked, aside);
    if (!(now.map.geometry.cell_at(ahead) == here)) costs_.block(ahead, now.frame.virtual_wall);
  }
  // Nothing tells where a cliff ends: a part of it, outwards from where it was felt.
  for (std::size_t i = 0; i < robot_.cliff_sensors.size(); ++i) {
    if ((now.frame.cliff_flags >> i & 1) == 0) continue;
    const Point2 outwards = robot_.cliff_sensors[i].normalized();
    for (double way = 0.0; way <= kCliffDepth; way += step) {
      costs_.block(pose * Point2(robot_.cliff_sensors[i] + way * outwards), true);
    }
  }
  begin_retreat(now);
}

/// What the drive was to sweep as far as it came, and hasn't, was tried once more.
void ContactFrontier::end_lane(const Situation& now) {
  catch_up(now);
  const double along =
      state_ == State::Lane ? direction(lane_.heading).dot(now.estimate.pose.position() - lane_.from) : 0.0;
  const double last = std::min(lane_.length, std::max(0.0, along) + 0.1);
  const GridGeometry& map = now.map.geometry;
  std::vector<std::size_t> tried;
  for (double way = 0.0; way <= last + 0.5 * map.resolution; way += map.resolution) {
    visit_disc(map, lane_.at(way), gain_.radius(), [&](CellIndex cell) {
      if (gain_.wanted(cell)) tried.push_back(map.index(cell));
    });
  }
  std::sort(tried.begin(), tried.end());
  tried.erase(std::unique(tried.begin(), tried.end()), tried.end());
  const auto width = static_cast<std::size_t>(map.width);
  for (const std::size_t i : tried) {
    gain_.tried({static_cast<std::int32_t>(i % width), static_cast<std::int32_t>(i / width)});
  }
  state_ = State::Choose;
}

}  // namespace scrubjay

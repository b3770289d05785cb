#include <scrubjay/planning/return_home.hpp>
#include <utility>

namespace scrubjay {
namespace {

CostMapParams of_radius(CostMapParams params, double radius) {
  params.radius = radius;
  return params;
}

}  // namespace

ReturnHome::ReturnHome(const RobotModel& robot, std::unique_ptr<Behavior> inner, const ReturnHomeParams& params)
    : inner_(std::move(inner)),
      params_(params),
      costs_(of_radius(params.costs, robot.radius)),
      navigator_(robot, params.navigator) {}

Decision ReturnHome::decide(const Situation& situation) {
  if (!home_) home_ = situation.estimate.pose;
  if (state_ == State::Done) return {{}, "home", true};
  if (state_ == State::Out) {
    const Decision decision = inner_->decide(situation);
    if (!decision.done) return decision;
    state_ = State::Homing;
    navigator_.go_to(home_->position(), home_->yaw);
  }
  // Nothing was known of the map until now: the first update takes all of it, whatever changed last.
  const CellRect changed = costs_.update(situation.map, situation.changed);
  const Frame& frame = situation.frame;
  if (state_ == State::Homing && frame.bumped()) {
    state_ = State::Backing;
    backing_until_ = frame.stamp + params_.back_off_time;
  }
  if (state_ == State::Backing && frame.stamp >= backing_until_) {
    state_ = State::Homing;
    return homing(situation, cells_of(situation.map.geometry));
  }
  if (state_ == State::Backing) return {{-params_.back_off_speed, 0.0}, "backing off"};
  return homing(situation, changed);
}

Decision ReturnHome::homing(const Situation& situation, const CellRect& costs_changed) {
  const Navigator::Step step = navigator_.step(situation, costs_.view(), costs_changed);
  if (step.travel == Travel::Driving) return {step.motion, "going home"};
  return arrive(step.travel);
}

Decision ReturnHome::arrive(Travel travel) {
  state_ = State::Done;
  const std::span<const Leftover> inner = inner_->leftovers();
  leftovers_.assign(inner.begin(), inner.end());
  if (travel == Travel::NoWay) leftovers_.push_back({home_->position(), 0.0, "home: no way back"});
  if (travel == Travel::Stalled) leftovers_.push_back({home_->position(), 0.0, "home: held up on the way back"});
  return {{}, "home", true};
}

std::span<const Leftover> ReturnHome::leftovers() const {
  if (state_ == State::Done) return leftovers_;
  return inner_->leftovers();
}

}  // namespace scrubjay

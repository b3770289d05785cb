#include <limits>
#include <scrubjay/embedded/embedded_mission.hpp>

namespace scrubjay {
namespace {

/// Nobody is there to start firmware anew once it has given up.
constexpr ReconnectionParams kForEver{.first_retry = ReconnectionParams{}.first_retry,
                                      .longest_retry = ReconnectionParams{}.longest_retry,
                                      .give_up = std::numeric_limits<double>::infinity()};

}  // namespace

EmbeddedMission::EmbeddedMission(ByteChannel& channel, const RobotModel& robot, GridView<LogOdds> map,
                                 Behavior& behavior)
    : robot_(channel, robot),
      reconnection_(kForEver),
      odometry_(robot.drive),
      model_(robot),
      map_(map),
      behavior_(behavior) {}

int EmbeddedMission::step() {
  heal();
  int frames = 0;
  while (const auto frame = robot_.poll()) {
    take(*frame);
    ++frames;
  }
  if (robot_.link() != LinkState::Alive) drive({});
  return frames;
}

/// By what the step before has found.
void EmbeddedMission::heal() {
  if (robot_.link() == LinkState::Alive) return reconnection_.alive(robot_.stamp());
  if (reconnection_.silent(robot_.stamp()) == Reconnection::Step::Retry && !done_) robot_.restart();
}

void EmbeddedMission::take(const Frame& frame) {
  const PoseEstimate& estimate = odometry_.update({frame.left_travel, frame.right_travel}, frame.stamp);
  if (done_) return;
  CellRect changed;
  if (model_.wants(frame, estimate.pose)) {
    changed = cells_around(map_.geometry, estimate.pose.position(), model_.reach());
  }
  model_.integrate(frame, estimate.pose, map_);
  const Decision decision = behavior_.decide({frame, estimate, map_, changed});
  if (decision.done) return stop();
  drive(decision.motion);
}

void EmbeddedMission::drive(const Motion& motion) {
  if (done_) return;
  motion_ = motion;
  robot_.drive(motion);
}

void EmbeddedMission::stop() {
  done_ = true;
  motion_ = {};
  robot_.stop();
}

}  // namespace scrubjay

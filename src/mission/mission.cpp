#include <cmath>
#include <scrubjay/mission/mission.hpp>

namespace scrubjay {

std::string_view to_string(Ended ended) {
  switch (ended) {
    case Ended::Done:
      return "done";
    case Ended::TimeLimit:
      return "time limit";
    case Ended::Stopped:
      return "stopped";
    case Ended::Stuck:
      return "stuck";
    case Ended::RobotGone:
      return "robot gone";
    case Ended::EndOfRecording:
      return "end of the recording";
  }
  return "";
}

Report Mission::run(std::stop_token stop) {
  while (const auto frame = robot_.next()) {
    const PoseEstimate& estimate = localizer_.update(*frame);
    mapper_.update(*frame, estimate);
    const Decision decision = behavior_.decide({*frame, estimate, mapper_.map(), mapper_.changed()});
    const Snapshot snapshot{
        *frame, estimate, mapper_.map(), decision, mapper_.changed(), behavior_.plan(), behavior_.leftovers()};
    for (Observer* observer : observers_) observer->notify(snapshot);
    count(*frame, estimate);
    if (const auto why = ended(*frame, estimate, decision, stop)) {
      report_.ended = *why;
      break;
    }
    robot_.drive(decision.motion);
  }
  // Whoever asks to stop while the robot is silent gets no frame any more.
  if (report_.ended == Ended::RobotGone && stop.stop_requested()) report_.ended = Ended::Stopped;
  robot_.stop();
  const std::span<const Leftover> left = behavior_.leftovers();
  report_.leftovers.assign(left.begin(), left.end());
  return report_;
}

void Mission::count(const Frame& frame, const PoseEstimate& estimate) {
  ++report_.frames;
  if (!first_stamp_) first_stamp_ = frame.stamp;
  report_.time = frame.stamp - *first_stamp_;
  if (frame.odometry) {
    if (last_odometry_) report_.distance += (frame.odometry->position() - last_odometry_->position()).norm();
    last_odometry_ = frame.odometry;
  } else {
    report_.distance += std::fabs(0.5 * (frame.left_travel + frame.right_travel));
  }
  report_.bumps += frame.bumped() && !was_bumped_;
  was_bumped_ = frame.bumped();
  report_.pose = estimate.pose;
}

std::optional<Ended> Mission::ended(const Frame& frame, const PoseEstimate& estimate, const Decision& decision,
                                    const std::stop_token& stop) {
  if (stop.stop_requested()) return Ended::Stopped;
  if (decision.done) return Ended::Done;
  if (report_.time >= limits_.max_time) return Ended::TimeLimit;
  if (!stuck_.update(frame, estimate.pose)) return std::nullopt;
  report_.stuck = estimate.pose.position();
  return Ended::Stuck;
}

}  // namespace scrubjay

#include <algorithm>
#include <scrubjay/robot/reconnection.hpp>

namespace scrubjay {

void Reconnection::alive(double stamp) {
  if (is_silent_) {
    ++reconnections_;
    longest_ = std::max(longest_, stamp - *last_alive_);
  }
  is_silent_ = false;
  last_alive_ = stamp;
}

Reconnection::Step Reconnection::silent(double stamp) {
  if (!last_alive_) last_alive_ = stamp;
  if (!is_silent_) {
    is_silent_ = true;
    ++silences_;
    retry_stamp_ = stamp;
    pause_ = params_.first_retry;
  }
  longest_ = std::max(longest_, stamp - *last_alive_);
  if (stamp - *last_alive_ >= params_.give_up) return Step::GiveUp;
  if (stamp < retry_stamp_) return Step::Wait;
  retry_stamp_ = stamp + pause_;
  pause_ = std::min(2.0 * pause_, params_.longest_retry);
  return Step::Retry;
}

}  // namespace scrubjay

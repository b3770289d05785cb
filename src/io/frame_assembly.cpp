#include "frame_assembly.hpp"

#include <algorithm>
#include <scrubjay/io/recording.hpp>
#include <utility>

namespace scrubjay {
namespace {

// All in [ns].
constexpr std::int64_t kHorizon = 1'000'000'000;     // how late a message may come
constexpr std::int64_t kSameTime = 500'000;          // a scan that ends so near to an odometry belongs to it
constexpr std::int64_t kLongestGap = 2'000'000'000;  // between two odometries, for a scan to have a pose between them
constexpr std::int64_t kFarAhead = 60'000'000'000;   // of the odometry before, for one to be believed by itself
constexpr std::size_t kMostWaiting = 1'000;          // scans or touches without any odometry

/// Puts it behind all that are no later.
template <class Queue, class Key>
void insert_sorted(Queue& queue, typename Queue::value_type value, const Key& key) {
  const auto behind = [&key](const auto& a, const auto& b) { return key(a) < key(b); };
  const auto place = std::upper_bound(queue.begin(), queue.end(), value, behind);
  queue.insert(place, std::move(value));
}

Pose2 between(const Pose2& a, const Pose2& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y),
          wrap_angle(a.yaw + share * angle_difference(b.yaw, a.yaw))};
}

}  // namespace

void FrameAssembly::add_odometry(std::int64_t nanoseconds, const Pose2& pose) {
  const std::optional<Odometry> newest = odometry_.empty() ? last_ : std::optional(odometry_.back());
  const auto follows = [nanoseconds](const Odometry& before) {
    return nanoseconds > before.nanoseconds && nanoseconds - before.nanoseconds <= kFarAhead;
  };
  if (!newest || follows(*newest)) {
    ahead_.reset();
  } else if (ahead_ && follows(*ahead_)) {
    --left_out_;
    odometry_.push_back(*std::exchange(ahead_, std::nullopt));
  } else {
    ++left_out_;
    if (nanoseconds > newest->nanoseconds) ahead_ = {nanoseconds, pose};
    return;
  }
  odometry_.push_back({nanoseconds, pose});
}

void FrameAssembly::add_scan(TimedScan scan) {
  insert_sorted(scans_, std::move(scan), [](const TimedScan& s) { return s.end; });
  if (scans_.size() <= kMostWaiting) return;
  scans_.pop_front();
  ++left_out_;
}

void FrameAssembly::add_touch(std::int64_t nanoseconds, const std::variant<BumperState, CliffState>& touch) {
  insert_sorted(touches_, {nanoseconds, touch}, [](const Touch& t) { return t.nanoseconds; });
  if (touches_.size() <= kMostWaiting) return;
  touches_.pop_front();
  ++left_out_;
}

std::optional<FrameAssembly::Made> FrameAssembly::next() {
  if (odometry_.empty()) return std::nullopt;
  const Odometry odometry = odometry_.front();
  if (!finished_ && odometry_.back().nanoseconds - odometry.nanoseconds < kHorizon) return std::nullopt;
  if (auto made = scan_before(odometry)) return made;
  Made made = make(odometry.nanoseconds, odometry.pose);
  if (!scans_.empty() && scans_.front().end <= odometry.nanoseconds + kSameTime) take_scan(made);
  last_ = odometry;
  odometry_.pop_front();
  return made;
}

/// A frame of a scan that ended before `odometry`, and not right then.
std::optional<FrameAssembly::Made> FrameAssembly::scan_before(const Odometry& odometry) {
  while (!scans_.empty() && scans_.front().end < odometry.nanoseconds - kSameTime) {
    const std::int64_t end = scans_.front().end;
    const bool between_two =
        last_ && end >= last_->nanoseconds && odometry.nanoseconds - last_->nanoseconds <= kLongestGap;
    if (!between_two) {
      scans_.pop_front();
      ++left_out_;
      continue;
    }
    const double share =
        static_cast<double>(end - last_->nanoseconds) / static_cast<double>(odometry.nanoseconds - last_->nanoseconds);
    Made made = make(end, between(last_->pose, odometry.pose, share));
    take_scan(made);
    return made;
  }
  return std::nullopt;
}

FrameAssembly::Made FrameAssembly::make(std::int64_t nanoseconds, const Pose2& pose) {
  Made made;
  made.frame.stamp = stamp_from_nanoseconds(nanoseconds);
  made.frame.odometry = pose;
  feel(nanoseconds + kSameTime, made.frame);
  return made;
}

/// The bumper was hit if it was so at any time since the frame before; all else is as it was last.
void FrameAssembly::feel(std::int64_t until, Frame& frame) {
  frame.bump_left = bumper_.left;
  frame.bump_right = bumper_.right;
  bool first = true;
  for (; !touches_.empty() && touches_.front().nanoseconds <= until; touches_.pop_front()) {
    const Touch& touch = touches_.front();
    if (const auto* cliff = std::get_if<CliffState>(&touch.state)) cliff_ = *cliff;
    const auto* bumper = std::get_if<BumperState>(&touch.state);
    if (bumper == nullptr) continue;
    bumper_ = *bumper;
    frame.bump_left = bumper_.left || (frame.bump_left && !first);
    frame.bump_right = bumper_.right || (frame.bump_right && !first);
    first = false;
  }
  frame.light_flags = bumper_.light_flags;
  frame.light_signal = bumper_.light_signal;
  frame.cliff_flags = cliff_.flags;
}

void FrameAssembly::take_scan(Made& made) {
  made.frame.scan = scans_.front().shape;
  made.ranges = std::move(scans_.front().ranges);
  scans_.pop_front();
}

}  // namespace scrubjay

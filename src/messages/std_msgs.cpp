#include <algorithm>
#include <limits>
#include <scrubjay/messages/std_msgs.hpp>

namespace scrubjay::ros {

constexpr std::int64_t kPerSecond = 1'000'000'000;

Time time_from_nanoseconds(std::int64_t nanoseconds) {
  using Limits = std::numeric_limits<std::int32_t>;
  const std::int64_t low = Limits::min() * kPerSecond;
  const std::int64_t high = Limits::max() * kPerSecond + (kPerSecond - 1);
  const std::int64_t held = std::clamp(nanoseconds, low, high);
  // Seconds are rounded down, so that what is left is positive before 1970, too.
  const std::int64_t sec = held >= 0 ? held / kPerSecond : -((kPerSecond - 1 - held) / kPerSecond);
  return {static_cast<std::int32_t>(sec), static_cast<std::uint32_t>(held - sec * kPerSecond)};
}

std::int64_t to_nanoseconds(const Time& time) {
  return time.sec * kPerSecond + time.nanosec;
}

}  // namespace scrubjay::ros

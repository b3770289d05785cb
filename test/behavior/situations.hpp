/// \file
/// Frames and maps made by hand, and a behavior asked about them.
#pragma once

#include <initializer_list>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/behavior/obstacles.hpp>
#include <string_view>
#include <vector>

namespace scrubjay::test {

/// A frame in which nothing is near.
inline Frame quiet_frame(double stamp = 0.0) {
  Frame frame;
  frame.stamp = stamp;
  frame.light_signal.fill(30);
  return frame;
}

/// The same, but a sensor sees an average surface at `range` [m].
inline Frame lit_frame(LightSensor sensor, double range) {
  Frame frame = quiet_frame();
  frame.light_signal[static_cast<std::size_t>(sensor)] = light_signal_at(range, RobotModel{});
  return frame;
}

inline Frame cliff_frame(CliffSensor sensor) {
  Frame frame = quiet_frame();
  frame.cliff_flags = static_cast<std::uint8_t>(1u << static_cast<unsigned>(sensor));
  return frame;
}

/// A map drawn with '#' occupied, '.' free and any other sign unknown; the first row is the upmost. The lowest left
/// cell has its corner at `origin`.
class DrawnMap {
 public:
  DrawnMap(std::initializer_list<std::string_view> rows, double resolution = 0.05, const Point2& origin = {0.0, 0.0}) {
    geometry_ = {resolution, origin, static_cast<std::int32_t>(rows.begin()->size()),
                 static_cast<std::int32_t>(rows.size())};
    cells_.resize(geometry_.size());
    std::int32_t y = geometry_.height;
    for (const std::string_view row : rows) {
      --y;
      for (std::int32_t x = 0; x < geometry_.width; ++x) {
        const char sign = row[static_cast<std::size_t>(x)];
        cells_[geometry_.index({x, y})] = sign == '#' ? kMaxLogOdds : sign == '.' ? -kMaxLogOdds : 0;
      }
    }
  }
  GridView<const LogOdds> view() const { return {geometry_, cells_.data()}; }

 private:
  GridGeometry geometry_;
  std::vector<LogOdds> cells_;
};

/// Asks a behavior what to do in a frame, at a pose, without a map.
inline Decision decide(Behavior& behavior, const Frame& frame, const Pose2& pose = {}) {
  PoseEstimate estimate;
  estimate.pose = pose;
  return behavior.decide({frame, estimate, {}, {}});
}

}  // namespace scrubjay::test

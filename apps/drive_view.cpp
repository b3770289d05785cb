#include "drive_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <scrubjay/geometry/angle.hpp>
#include <string_view>

#include "sensor_table.hpp"

namespace scrubjay::apps {
namespace {

constexpr std::string_view kHelp = "w a s d or arrows drive, space stops, + - speed, q quits; let go and it stops";

std::string_view mark(bool set, std::string_view name, std::string_view none) {
  return set ? name : none;
}

std::string_view reason(KeyDriver::Held held) {
  switch (held) {
    case KeyDriver::Held::No:
      break;
    case KeyDriver::Held::Bumped:
      return "BUMPED: back off or turn away";
    case KeyDriver::Held::Cliff:
      return "CLIFF: back off";
    case KeyDriver::Held::WheelHangs:
      return "A WHEEL HANGS: put it on the floor";
    case KeyDriver::Held::OnTheCharger:
      return "CHARGING: take it off the dock";
  }
  return "";
}

std::string cliff_letters(const Frame& frame) {
  constexpr std::array<std::string_view, kCliffSensorCount> kNames{"L", "FL", "FR", "R"};
  std::string text;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    text += fmt::format(" {:<2}", mark((frame.cliff_flags >> i & 1) != 0, kNames[i], "."));
  }
  return text;
}

std::string light_row(const Frame& frame) {
  std::string text = "light  ";
  for (std::size_t i = 0; i < frame.light_signal.size(); ++i) {
    text += fmt::format(" {:4}{}", frame.light_signal[i], mark(frame.sees(static_cast<LightSensor>(i)), "!", " "));
  }
  return text + "   left to right";
}

std::string shell_row(const Frame& frame) {
  return fmt::format("bumpers {:<4} {:<5}   cliffs{}   wheel drops {:<4} {:<5}", mark(frame.bump_left, "LEFT", "-"),
                     mark(frame.bump_right, "RIGHT", "-"), cliff_letters(frame),
                     mark(frame.wheel_drop_left, "LEFT", "-"), mark(frame.wheel_drop_right, "RIGHT", "-"));
}

std::string wall_row(const Frame& frame) {
  return fmt::format("wall {:<4} signal {:<5} virtual wall {:<4}   infrared {} {} {}   dirt {}",
                     mark(frame.wall, "YES", "-"), frame.wall_signal, mark(frame.virtual_wall, "YES", "-"),
                     frame.infrared_omni, frame.infrared_left, frame.infrared_right, frame.dirt);
}

std::string battery_row(const Frame& frame) {
  const Battery& b = frame.battery;
  const double share = b.capacity > 0.0 ? 100.0 * b.charge / b.capacity : 0.0;
  return fmt::format("battery {:.0f} %, {:.1f} V, {:+.2f} A, {:.0f} degrees{}   mode {}", share, b.voltage, b.current,
                     b.temperature, b.charging ? ", charging" : "", mode_name(frame.mode));
}

}  // namespace

void DriveDisplay::take(const Frame& frame) {
  if (frame.odometry) {
    if (last_odometry_) {
      driven_ += (frame.odometry->position() - last_odometry_->position()).norm();
      heading_ += angle_difference(frame.odometry->yaw, last_odometry_->yaw);
    }
    last_odometry_ = frame.odometry;
  } else {
    driven_ += std::fabs(0.5 * (frame.left_travel + frame.right_travel));
    heading_ += (frame.right_travel - frame.left_travel) / model_.drive.wheel_separation;
  }
  if (last_stamp_) {
    const double interval = frame.stamp - *last_stamp_;
    mean_interval_ = mean_interval_ == 0.0 ? interval : 0.95 * mean_interval_ + 0.05 * interval;
  }
  last_stamp_ = frame.stamp;
  if (!frame.scan) return;
  nearest_.reset();
  for (const float range : frame.scan->ranges) {
    if (frame.scan->returned(range) && (!nearest_ || range < *nearest_)) nearest_ = range;
  }
}

std::vector<std::string> DriveDisplay::lines(const Frame& frame, const Motion& motion, const KeyDriver& driver) const {
  std::vector<std::string> lines;
  lines.emplace_back(kHelp);
  lines.push_back(fmt::format("{:+.2f} m/s  {:+.0f} deg/s  at {:.0f} % of full speed   {}", motion.linear,
                              degrees(motion.angular), 100.0 * driver.speed(), reason(driver.held())));
  if (model_.open_interface) {
    lines.push_back(shell_row(frame));
    lines.push_back(wall_row(frame));
    if (model_.has_light_sensors) lines.push_back(light_row(frame));
    lines.push_back(battery_row(frame));
  } else {
    lines.push_back(nearest_ ? fmt::format("nearest thing {:.2f} m away", *nearest_) : "nothing in the lidar's reach");
  }
  const double rate = mean_interval_ > 0.0 ? 1.0 / mean_interval_ : 0.0;
  lines.push_back(fmt::format("driven {:.2f} m, heading {:+.0f} degrees, {:.0f} frames a second", driven_,
                              degrees(wrap_angle(heading_)), rate));
  return lines;
}

std::vector<std::string> DriveDisplay::lines_of_silence(double silence) {
  return {std::string(kHelp),
          fmt::format("THE ROBOT IS SILENT for {:.0f} s: it is told to stand, and looked for", std::ceil(silence))};
}

}  // namespace scrubjay::apps

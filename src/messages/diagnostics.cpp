#include <array>
#include <charconv>
#include <scrubjay/messages/diagnostics.hpp>

namespace scrubjay::ros {
namespace {

std::string name_of(oi::OiMode mode) {
  switch (mode) {
    case oi::OiMode::Off:
      return "off";
    case oi::OiMode::Passive:
      return "passive";
    case oi::OiMode::Safe:
      return "safe";
    case oi::OiMode::Full:
      return "full";
  }
  return "unknown";
}

std::string wheel_drops(const Frame& frame) {
  if (frame.wheel_drop_left && frame.wheel_drop_right) return "both";
  if (frame.wheel_dropped()) return frame.wheel_drop_left ? "left" : "right";
  return "none";
}

std::string text_of(double value, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
  return {text.data(), end};
}

void judge_robot(const Frame& frame, DiagnosticStatus& status) {
  const auto warn = [&](const char* why) {
    status.level = DiagnosticStatus::kWarn;
    status.message = why;
  };
  if (frame.mode == oi::OiMode::Off) warn("it is off, and obeys nobody");
  if (frame.mode == oi::OiMode::Passive && !frame.battery.charging) warn("it is passive, and obeys nobody");
  if (frame.wheel_dropped()) warn("a wheel has dropped");
}

void judge_battery(const Battery& battery, const BatteryLimits& limits, DiagnosticStatus& status) {
  const auto is = [&](std::byte level, const char* why) {
    if (level < status.level) return;
    status.level = level;
    status.message = why;
  };
  if (battery.charging) is(DiagnosticStatus::kOk, "charging");
  if (battery.capacity <= 0.0) {
    is(DiagnosticStatus::kWarn, "it doesn't tell its charge");
  } else if (!battery.charging) {
    const double ratio = battery.charge / battery.capacity;
    if (ratio < limits.low) is(DiagnosticStatus::kWarn, "low");
    if (ratio < limits.empty) is(DiagnosticStatus::kError, "nearly empty");
  }
  if (battery.temperature > limits.hot) is(DiagnosticStatus::kWarn, "hot");
  if (battery.charger == oi::ChargingState::Fault) is(DiagnosticStatus::kError, "it can't be charged: a fault");
}

}  // namespace

DiagnosticStatus robot_status(const RobotModel& robot, const Frame& frame, std::string_view doing) {
  DiagnosticStatus status;
  status.name = "robot";
  status.hardware_id = robot.open_interface ? "open interface" : "lidar robot";
  status.message = doing;
  status.values = {{"doing", std::string(doing)}};
  if (!robot.open_interface) return status;
  status.values.push_back({"mode", name_of(frame.mode)});
  status.values.push_back({"dropped wheels", wheel_drops(frame)});
  judge_robot(frame, status);
  return status;
}

DiagnosticStatus battery_status(const Battery& battery, const BatteryLimits& limits) {
  DiagnosticStatus status;
  status.name = "battery";
  status.hardware_id = "open interface";
  status.message = "discharging";
  if (battery.capacity > 0.0) {
    status.values.push_back({"charge [%]", text_of(100.0 * battery.charge / battery.capacity, 1)});
  }
  status.values.push_back({"voltage [V]", text_of(battery.voltage, 2)});
  status.values.push_back({"current [A]", text_of(battery.current, 2)});
  status.values.push_back({"temperature [deg C]", text_of(battery.temperature, 0)});
  status.values.push_back({"charging", battery.charging ? "yes" : "no"});
  judge_battery(battery, limits, status);
  return status;
}

}  // namespace scrubjay::ros

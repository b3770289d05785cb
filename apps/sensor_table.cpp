#include "sensor_table.hpp"

#include <fmt/format.h>

#include <array>
#include <scrubjay/oi/infrared.hpp>
#include <scrubjay/oi/sensor_views.hpp>

namespace scrubjay::apps {
namespace {

using oi::PacketId;

std::string sensor_row(std::string_view name, std::string_view values) {
  return fmt::format("{:<14}{}", name, values);
}

/// A name, and whether it is so: "left -" or "left YES". As wide either way, so that nothing jumps.
std::string flag(std::string_view name, bool set) {
  return fmt::format("{} {:<6}", name, set ? "YES" : "-");
}

PacketId nth(PacketId first, std::size_t i) {
  return static_cast<PacketId>(number(first) + i);
}

std::string cliffs(const oi::Sensors& s) {
  constexpr std::array<std::string_view, 4> kNames{"L", "FL", "FR", "R"};
  std::string text;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const bool open = s[nth(PacketId::CliffLeft, i)] != 0;
    const PacketId signal = nth(PacketId::CliffLeftSignal, i);
    const std::string value = s.has(signal) ? fmt::format("{:4}", s[signal]) : "";
    text += fmt::format("{} {}{:<3}", kNames[i], value, open ? "!" : "");
  }
  return text + "(! no floor)";
}

std::string light_signals(const oi::Sensors& s) {
  constexpr std::array<std::string_view, 6> kNames{"L", "FL", "CL", "CR", "FR", "R"};
  std::string text;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const bool sees = oi::bit(s, PacketId::LightBumper, static_cast<int>(i));
    text += fmt::format("{} {:4}{:<2}", kNames[i], s[nth(PacketId::LightBumpLeftSignal, i)], sees ? "!" : "");
  }
  return text + "(! near)";
}

std::string pressed(const oi::Sensors& s, oi::Model model) {
  const oi::PressedButtons b = oi::pressed_buttons(s, model);
  const bool create1 = model == oi::Model::Create1;
  std::string text;
  const auto add = [&](bool pressed, std::string_view name) {
    if (pressed) text += (text.empty() ? "" : ", ") + std::string(name);
  };
  add(b.clean, create1 ? "Play" : "Clean");
  add(b.spot, "Spot");
  add(b.dock, create1 ? "Advance" : "Dock");
  add(b.minute, "Minute");
  add(b.hour, "Hour");
  add(b.day, "Day");
  add(b.schedule, "Schedule");
  add(b.clock, "Clock");
  add(b.max, "Max");
  add(b.power, "Power");
  return text.empty() ? "none pressed" : text;
}

std::string infrared(const oi::Sensors& s, PacketId id, oi::Model model) {
  const auto character = static_cast<std::uint8_t>(s[id]);
  if (character == oi::no_character(model)) return "-";
  const oi::InfraredCharacter* known = oi::infrared_character(character);
  return known != nullptr ? std::string(known->name) : fmt::format("{}", character);
}

std::string infrared_row(const oi::Sensors& s, oi::Model model) {
  std::string text =
      fmt::format("top {:<16}", fmt::format("{:.15}", infrared(s, PacketId::InfraredCharacterOmni, model)));
  if (model == oi::Model::Create2) {
    text += fmt::format("left {:<16}", fmt::format("{:.15}", infrared(s, PacketId::InfraredCharacterLeft, model)));
    text += fmt::format("right {:.15}", infrared(s, PacketId::InfraredCharacterRight, model));
  }
  return text;
}

std::string overcurrents(const oi::Sensors& s, oi::Model model) {
  const oi::WheelOvercurrents o = oi::wheel_overcurrents(s);
  std::string text = flag("left wheel", o.left_wheel) + flag("right wheel", o.right_wheel);
  if (model != oi::Model::Create1) text += flag("main brush", o.main_brush) + flag("side brush", o.side_brush);
  return text;
}

void add_create2_rows(const oi::Sensors& s, std::vector<std::string>& rows) {
  rows.push_back(sensor_row("light bumper", light_signals(s)));
  rows.push_back(sensor_row("encoders", fmt::format("left {:<8}right {:<8}caster {}", s[PacketId::LeftEncoderCounts],
                                                    s[PacketId::RightEncoderCounts],
                                                    oi::stasis(s).disabled   ? "too dirty to tell"
                                                    : oi::stasis(s).toggling ? "turns"
                                                                             : "stands")));
  rows.push_back(
      sensor_row("currents [mA]", fmt::format("wheels left {:<6}right {:<6}brushes main {:<6}side {}",
                                              s[PacketId::LeftMotorCurrent], s[PacketId::RightMotorCurrent],
                                              s[PacketId::MainBrushMotorCurrent], s[PacketId::SideBrushMotorCurrent])));
}

}  // namespace

std::string_view mode_name(oi::OiMode mode) {
  constexpr std::array<std::string_view, 4> kNames{"Off", "Passive", "Safe", "Full"};
  return kNames[static_cast<std::size_t>(mode)];
}

std::string_view charging_name(const oi::Sensors& sensors) {
  constexpr std::array<std::string_view, 6> kNames{"not charging",     "reconditioning", "full charging",
                                                   "trickle charging", "waiting",        "charging fault"};
  return kNames[static_cast<std::size_t>(oi::charging_state(sensors))];
}

std::string battery_line(const oi::Sensors& s) {
  const int capacity = s[PacketId::BatteryCapacity];
  const double share = capacity > 0 ? 100.0 * s[PacketId::BatteryCharge] / capacity : 0.0;
  return fmt::format("{:.0f} % of {:.2f} Ah, {:.2f} V, {:+.2f} A, {} degrees, {}", share, 1e-3 * capacity,
                     1e-3 * s[PacketId::Voltage], 1e-3 * s[PacketId::Current], s[PacketId::Temperature],
                     charging_name(s));
}

std::vector<std::string> sensor_table(const oi::Sensors& s, oi::Model model) {
  const oi::BumpsAndWheelDrops shell = oi::bumps_and_wheel_drops(s);
  std::vector<std::string> rows;
  rows.push_back(sensor_row("bumpers", flag("left", shell.bump_left) + flag("right", shell.bump_right)));
  rows.push_back(
      sensor_row("wheel drops", flag("left", shell.wheel_drop_left) + flag("right", shell.wheel_drop_right) +
                                    (model == oi::Model::Create2 ? "" : flag("caster", shell.wheel_drop_caster))));
  rows.push_back(sensor_row("cliffs", cliffs(s)));
  rows.push_back(
      sensor_row("wall", flag("wall", s[PacketId::Wall] != 0) + flag("virtual wall", s[PacketId::VirtualWall] != 0) +
                             (s.has(PacketId::WallSignal) ? fmt::format("signal {}", s[PacketId::WallSignal]) : "")));
  if (model == oi::Model::Create2) {
    add_create2_rows(s, rows);
  } else {
    rows.push_back(
        sensor_row("travel", fmt::format("distance {:<8}angle {}", s[PacketId::Distance], s[PacketId::Angle])));
  }
  rows.push_back(sensor_row("overcurrents", overcurrents(s, model)));
  rows.push_back(sensor_row("infrared", infrared_row(s, model)));
  rows.push_back(sensor_row("buttons", pressed(s, model)));
  if (model != oi::Model::Create1) rows.push_back(sensor_row("dirt", fmt::format("{}", s[PacketId::DirtDetect])));
  return rows;
}

}  // namespace scrubjay::apps

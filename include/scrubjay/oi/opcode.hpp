/// \file
/// Every command of the Open Interface in one table: its data bytes, where it is allowed, and the mode it leads to.
///
/// Source: iRobot Create 2 Open Interface specification (2016), iRobot Create Open Interface (2006), Roomba Serial
/// Command Interface (2005).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <scrubjay/oi/mode.hpp>
#include <scrubjay/oi/model.hpp>
#include <string_view>

namespace scrubjay::oi {

/// First byte of a command. Create 1 gives four of them another meaning, and with it another name.
enum class Opcode : std::uint8_t {
  Reset = 7,
  Start = 128,
  Baud,
  Control,
  Safe,
  Full,
  Power,
  Spot,
  Clean,
  Cover = Clean,  ///< on Create 1
  Max,
  Demo = Max,  ///< on Create 1
  Drive,
  Motors,
  Leds,
  Song,
  Play,
  Sensors,
  SeekDock,
  CoverAndDock = SeekDock,  ///< on Create 1
  PwmMotors,
  PwmLowSideDrivers = PwmMotors,  ///< on Create 1
  DriveDirect,
  DrivePwm,
  DigitalOutputs,
  Stream,
  QueryList,
  PauseResumeStream,
  SendIr,
  Script,
  PlayScript,
  ShowScript,
  WaitTime,
  WaitDistance,
  WaitAngle,
  WaitEvent,
  SchedulingLeds = 162,
  DigitLedsRaw,
  DigitLedsAscii,
  Buttons,
  Schedule = 167,
  SetDayTime,
  Stop = 173,
};

/// How many data bytes follow the opcode: `fixed`, and where `per_item` isn't 0, that many more for each item counted
/// by the last of the fixed ones.
struct DataLength {
  std::uint8_t fixed = 0;
  std::uint8_t per_item = 0;

  constexpr bool variable() const { return per_item != 0; }
  bool operator==(const DataLength&) const = default;
};

struct OpcodeInfo {
  Opcode opcode{};
  std::string_view name;
  DataLength data;
  ModeSet modes;                     ///< where the robot obeys it
  std::optional<OiMode> mode_after;  ///< none: the mode stays
  ModelSet models;                   ///< that have it, under this name and with this length
};

namespace detail {

inline constexpr ModelSet kCreate2 = Model::Create2;
inline constexpr ModelSet kCreate1 = Model::Create1;
inline constexpr ModelSet kCreates = Model::Create2 | Model::Create1;
inline constexpr ModelSet kRoombas = Model::Create2 | Model::Roomba400;
inline constexpr std::optional<OiMode> kStays{};

}  // namespace detail

/// The table of commands, ascending; an opcode that differs by model has a row for each meaning.
// clang-format off
inline constexpr std::array<OpcodeInfo, 43> kOpcodes{{
    {Opcode::Reset, "reset", {0}, kAnyMode, OiMode::Off, detail::kCreate2},
    {Opcode::Start, "start", {0}, kAnyMode, OiMode::Passive, kAllModels},
    {Opcode::Baud, "baud", {1}, kListeningModes, detail::kStays, kAllModels},
    {Opcode::Control, "control", {0}, kListeningModes, OiMode::Safe, kAllModels},
    {Opcode::Safe, "safe", {0}, kListeningModes, OiMode::Safe, kAllModels},
    {Opcode::Full, "full", {0}, kListeningModes, OiMode::Full, kAllModels},
    {Opcode::Power, "power", {0}, kListeningModes, OiMode::Passive, detail::kRoombas},
    {Opcode::Spot, "spot", {0}, kListeningModes, OiMode::Passive, kAllModels},
    {Opcode::Clean, "clean", {0}, kListeningModes, OiMode::Passive, detail::kRoombas},
    {Opcode::Cover, "cover", {0}, kListeningModes, OiMode::Passive, detail::kCreate1},
    {Opcode::Max, "max", {0}, kListeningModes, OiMode::Passive, detail::kRoombas},
    {Opcode::Demo, "demo", {1}, kListeningModes, OiMode::Passive, detail::kCreate1},
    {Opcode::Drive, "drive", {4}, kActingModes, detail::kStays, kAllModels},
    {Opcode::Motors, "motors", {1}, kActingModes, detail::kStays, kAllModels},
    {Opcode::Leds, "leds", {3}, kActingModes, detail::kStays, kAllModels},
    {Opcode::Song, "song", {2, 2}, kListeningModes, detail::kStays, kAllModels},
    {Opcode::Play, "play", {1}, kActingModes, detail::kStays, kAllModels},
    {Opcode::Sensors, "sensors", {1}, kListeningModes, detail::kStays, kAllModels},
    {Opcode::SeekDock, "seek_dock", {0}, kListeningModes, OiMode::Passive, detail::kRoombas},
    {Opcode::CoverAndDock, "cover_and_dock", {0}, kListeningModes, OiMode::Passive, detail::kCreate1},
    {Opcode::PwmMotors, "pwm_motors", {3}, kActingModes, detail::kStays, detail::kCreate2},
    {Opcode::PwmLowSideDrivers, "pwm_low_side_drivers", {3}, kActingModes, detail::kStays, detail::kCreate1},
    {Opcode::DriveDirect, "drive_direct", {4}, kActingModes, detail::kStays, detail::kCreates},
    {Opcode::DrivePwm, "drive_pwm", {4}, kActingModes, detail::kStays, detail::kCreate2},
    {Opcode::DigitalOutputs, "digital_outputs", {1}, kActingModes, detail::kStays, detail::kCreate1},
    {Opcode::Stream, "stream", {1, 1}, kListeningModes, detail::kStays, detail::kCreates},
    {Opcode::QueryList, "query_list", {1, 1}, kListeningModes, detail::kStays, detail::kCreates},
    {Opcode::PauseResumeStream, "pause_resume_stream", {1}, kListeningModes, detail::kStays, detail::kCreates},
    {Opcode::SendIr, "send_ir", {1}, kActingModes, detail::kStays, detail::kCreate1},
    {Opcode::Script, "script", {1, 1}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::PlayScript, "play_script", {0}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::ShowScript, "show_script", {0}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::WaitTime, "wait_time", {1}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::WaitDistance, "wait_distance", {2}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::WaitAngle, "wait_angle", {2}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::WaitEvent, "wait_event", {1}, kListeningModes, detail::kStays, detail::kCreate1},
    {Opcode::SchedulingLeds, "scheduling_leds", {2}, kActingModes, detail::kStays, detail::kCreate2},
    {Opcode::DigitLedsRaw, "digit_leds_raw", {4}, kActingModes, detail::kStays, detail::kCreate2},
    {Opcode::DigitLedsAscii, "digit_leds_ascii", {4}, kActingModes, detail::kStays, detail::kCreate2},
    {Opcode::Buttons, "buttons", {1}, kListeningModes, detail::kStays, detail::kCreate2},
    {Opcode::Schedule, "schedule", {15}, kListeningModes, detail::kStays, detail::kCreate2},
    {Opcode::SetDayTime, "set_day_time", {3}, kListeningModes, detail::kStays, detail::kCreate2},
    {Opcode::Stop, "stop", {0}, kListeningModes, OiMode::Off, detail::kCreate2},
}};
// clang-format on

namespace detail {

inline constexpr auto kOpcodeRows = [] {
  std::array<std::array<std::uint8_t, 256>, kModelCount> rows{};  // index into kOpcodes, plus one; 0: none
  for (std::size_t i = 0; i < kOpcodes.size(); ++i) {
    for (std::size_t model = 0; model < kModelCount; ++model) {
      if (!kOpcodes[i].models.contains(static_cast<Model>(model))) continue;
      rows[model][static_cast<std::size_t>(kOpcodes[i].opcode)] = static_cast<std::uint8_t>(i + 1);
    }
  }
  return rows;
}();

}  // namespace detail

/// The row of an opcode on a model; null if the model doesn't know it. Takes any byte.
constexpr const OpcodeInfo* opcode_info(std::uint8_t opcode, Model model) {
  const std::uint8_t row = detail::kOpcodeRows[static_cast<std::size_t>(model)][opcode];
  return row == 0 ? nullptr : &kOpcodes[row - 1U];
}
constexpr const OpcodeInfo* opcode_info(Opcode opcode, Model model) {
  return opcode_info(static_cast<std::uint8_t>(opcode), model);
}

/// Whether a robot of that model obeys in that mode.
constexpr bool allowed_in(Opcode opcode, OiMode mode, Model model = Model::Create2) {
  const OpcodeInfo* info = opcode_info(opcode, model);
  return info != nullptr && info->modes.contains(mode);
}

}  // namespace scrubjay::oi

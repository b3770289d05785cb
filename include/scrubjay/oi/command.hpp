/// \file
/// Every command of the Open Interface as a struct that can't be out of range, and its bytes.
///
/// `kFields` lists a command's members in the order of the wire: encoder and decoder both follow it. Which models know
/// a command is in the table of opcodes; `kModels` tells apart the two that share an opcode and a length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <scrubjay/oi/command_values.hpp>
#include <scrubjay/oi/opcode.hpp>
#include <scrubjay/oi/sensor_id.hpp>
#include <span>
#include <tuple>
#include <variant>

namespace scrubjay::oi {

/// A command without data.
template <Opcode Op>
struct BareCommand {
  static constexpr Opcode kOpcode = Op;
  static constexpr std::tuple<> kFields{};
};

/// Reboots, which takes about 5 s and prints a banner that names the firmware (see quirks.hpp).
using Reset = BareCommand<Opcode::Reset>;
/// Wakes the interface: to Passive. The first command always.
using Start = BareCommand<Opcode::Start>;

/// Another speed of the line, from 100 ms later until power is lost.
struct Baud {
  Bounded<0, 11> code;  ///< index into kBaudRates
  static constexpr Opcode kOpcode = Opcode::Baud;
  static constexpr auto kFields = std::tuple{&Baud::code};
};

/// The older name of Safe.
using Control = BareCommand<Opcode::Control>;
/// To Safe mode.
using Safe = BareCommand<Opcode::Safe>;
/// To Full mode.
using Full = BareCommand<Opcode::Full>;
/// Powers down.
using Power = BareCommand<Opcode::Power>;
/// Cleans a spot.
using Spot = BareCommand<Opcode::Spot>;
/// Cleans.
using Clean = BareCommand<Opcode::Clean>;
/// Create 1: the demo that covers a room.
using Cover = Clean;
/// Cleans until the battery is empty.
using Max = BareCommand<Opcode::Max>;

/// Create 1: one of its demos.
struct Demo {
  Bounded<-1, 9> demo;  ///< -1 stops it
  static constexpr Opcode kOpcode = Opcode::Demo;
  static constexpr auto kFields = std::tuple{&Demo::demo};
};

/// Drives an arc.
struct Drive {
  Velocity velocity;  ///< of the centre [mm/s]
  Radius radius;      ///< [mm]
  static constexpr Opcode kOpcode = Opcode::Drive;
  static constexpr auto kFields = std::tuple{&Drive::velocity, &Drive::radius};
};

/// Cleaning motors on and off; on Create 1 the low side drivers.
struct Motors {
  std::uint8_t bits = 0;  ///< kSideBrush and its like, joined
  static constexpr std::uint8_t kSideBrush = 1;
  static constexpr std::uint8_t kVacuum = 2;
  static constexpr std::uint8_t kMainBrush = 4;
  static constexpr std::uint8_t kSideBrushClockwise = 8;
  static constexpr std::uint8_t kMainBrushReverse = 16;
  static constexpr Opcode kOpcode = Opcode::Motors;
  static constexpr auto kFields = std::tuple{&Motors::bits};
};

/// Lights; on Create 1 bit 1 is Play and bit 3 is Advance.
struct Leds {
  std::uint8_t bits = 0;             ///< kDebris and its like, joined
  std::uint8_t power_color = 0;      ///< 0 green to 255 red
  std::uint8_t power_intensity = 0;  ///< 0 off to 255 full
  static constexpr std::uint8_t kDebris = 1;
  static constexpr std::uint8_t kSpot = 2;
  static constexpr std::uint8_t kDock = 4;
  static constexpr std::uint8_t kCheckRobot = 8;
  static constexpr Opcode kOpcode = Opcode::Leds;
  static constexpr auto kFields = std::tuple{&Leds::bits, &Leds::power_color, &Leds::power_intensity};
};

/// Stores a song.
struct Song {
  SongSlot slot;
  FixedList<Note, 1, 16> notes;
  static constexpr Opcode kOpcode = Opcode::Song;
  static constexpr auto kFields = std::tuple{&Song::slot, &Song::notes};
};

/// Plays a stored song; ignored while one is playing.
struct Play {
  SongSlot slot;
  static constexpr Opcode kOpcode = Opcode::Play;
  static constexpr auto kFields = std::tuple{&Play::slot};
};

/// Asks for a packet or a group once (the Sensors command).
struct Query {
  SensorId id;
  static constexpr Opcode kOpcode = Opcode::Sensors;
  static constexpr auto kFields = std::tuple{&Query::id};
};

/// Goes home.
using SeekDock = BareCommand<Opcode::SeekDock>;
/// Create 1: the demo that covers a room and goes home.
using CoverAndDock = SeekDock;

/// Cleaning motors at a share of their power, of 127.
struct PwmMotors {
  Bounded<-127, 127> main_brush;
  Bounded<-127, 127> side_brush;
  Bounded<0, 127> vacuum;
  static constexpr ModelSet kModels = Model::Create2;
  static constexpr Opcode kOpcode = Opcode::PwmMotors;
  static constexpr auto kFields = std::tuple{&PwmMotors::main_brush, &PwmMotors::side_brush, &PwmMotors::vacuum};
};

/// Create 1: low side drivers at a share of their power, of 128.
struct PwmLowSideDrivers {
  Bounded<0, 128> driver2;
  Bounded<0, 128> driver1;
  Bounded<0, 128> driver0;
  static constexpr ModelSet kModels = Model::Create1;
  static constexpr Opcode kOpcode = Opcode::PwmLowSideDrivers;
  static constexpr auto kFields =
      std::tuple{&PwmLowSideDrivers::driver2, &PwmLowSideDrivers::driver1, &PwmLowSideDrivers::driver0};
};

/// Turns each wheel at a speed. The right one comes first.
struct DriveDirect {
  Velocity right;  ///< [mm/s]
  Velocity left;   ///< [mm/s]
  static constexpr Opcode kOpcode = Opcode::DriveDirect;
  static constexpr auto kFields = std::tuple{&DriveDirect::right, &DriveDirect::left};
};

/// Turns each wheel at a share of its power. The right one comes first.
struct DrivePwm {
  Duty right;
  Duty left;
  static constexpr Opcode kOpcode = Opcode::DrivePwm;
  static constexpr auto kFields = std::tuple{&DrivePwm::right, &DrivePwm::left};
};

/// Create 1: the cargo bay's outputs.
struct DigitalOutputs {
  Bounded<0, 7> bits;  ///< bit i: output i
  static constexpr Opcode kOpcode = Opcode::DigitalOutputs;
  static constexpr auto kFields = std::tuple{&DigitalOutputs::bits};
};

/// Has these sent every 15 ms, in a frame (see stream_parser.hpp).
struct Stream {
  FixedList<SensorId, 0, 255> ids;
  static constexpr Opcode kOpcode = Opcode::Stream;
  static constexpr auto kFields = std::tuple{&Stream::ids};
};

/// Asks for these once, without framing (see query.hpp).
struct QueryList {
  FixedList<SensorId, 0, 255> ids;
  static constexpr Opcode kOpcode = Opcode::QueryList;
  static constexpr auto kFields = std::tuple{&QueryList::ids};
};

/// Stops the stream, or starts it again with the same list.
struct PauseResumeStream {
  Bounded<0, 1> state;  ///< 1 resumes
  static constexpr Opcode kOpcode = Opcode::PauseResumeStream;
  static constexpr auto kFields = std::tuple{&PauseResumeStream::state};
};

/// Create 1: sends an infrared character by a LED on low side driver 1.
struct SendIr {
  std::uint8_t character = 0;
  static constexpr Opcode kOpcode = Opcode::SendIr;
  static constexpr auto kFields = std::tuple{&SendIr::character};
};

/// Create 1: stores a script, up to 100 bytes of commands.
struct Script {
  FixedList<std::uint8_t, 0, 100> bytes;
  static constexpr Opcode kOpcode = Opcode::Script;
  static constexpr auto kFields = std::tuple{&Script::bytes};
};

/// Create 1: runs the script.
using PlayScript = BareCommand<Opcode::PlayScript>;
/// Create 1: sends the script back.
using ShowScript = BareCommand<Opcode::ShowScript>;

/// Create 1, in scripts: waits.
struct WaitTime {
  std::uint8_t tenths = 0;  ///< [0.1 s]
  static constexpr Opcode kOpcode = Opcode::WaitTime;
  static constexpr auto kFields = std::tuple{&WaitTime::tenths};
};

/// Create 1, in scripts: waits until so far is driven; backwards is negative.
struct WaitDistance {
  std::int16_t distance = 0;  ///< [mm]
  static constexpr Opcode kOpcode = Opcode::WaitDistance;
  static constexpr auto kFields = std::tuple{&WaitDistance::distance};
};

/// Create 1, in scripts: waits until so much is turned, counter-clockwise.
struct WaitAngle {
  std::int16_t angle = 0;  ///< [deg]
  static constexpr Opcode kOpcode = Opcode::WaitAngle;
  static constexpr auto kFields = std::tuple{&WaitAngle::angle};
};

/// Create 1, in scripts: waits for an event, or with a minus for its end.
struct WaitEvent {
  std::int8_t event = 0;
  static constexpr Opcode kOpcode = Opcode::WaitEvent;
  static constexpr auto kFields = std::tuple{&WaitEvent::event};
};

/// Lights of the clock.
struct SchedulingLeds {
  std::uint8_t weekday = 0;   ///< bit 0 Sunday to bit 6 Saturday
  std::uint8_t schedule = 0;  ///< bit 0 colon, 1 PM, 2 AM, 3 clock, 4 schedule
  static constexpr Opcode kOpcode = Opcode::SchedulingLeds;
  static constexpr auto kFields = std::tuple{&SchedulingLeds::weekday, &SchedulingLeds::schedule};
};

/// Segments of the four digits, the leftmost first: bit 0 A to bit 6 G.
struct DigitLedsRaw {
  std::array<std::uint8_t, 4> digits{};
  static constexpr Opcode kOpcode = Opcode::DigitLedsRaw;
  static constexpr auto kFields = std::tuple{&DigitLedsRaw::digits};
};

/// Characters on the four digits, the leftmost first.
struct DigitLedsAscii {
  std::array<Ascii, 4> digits{};
  static constexpr Opcode kOpcode = Opcode::DigitLedsAscii;
  static constexpr auto kFields = std::tuple{&DigitLedsAscii::digits};
};

/// Presses buttons for 1/6 s.
struct Buttons {
  std::uint8_t bits = 0;  ///< as in packet 18
  static constexpr Opcode kOpcode = Opcode::Buttons;
  static constexpr auto kFields = std::tuple{&Buttons::bits};
};

/// When to clean on which days; all zeros: never.
struct Schedule {
  std::uint8_t days = 0;             ///< bit 0 Sunday to bit 6 Saturday
  std::array<TimeOfDay, 7> times{};  ///< Sunday to Saturday
  static constexpr Opcode kOpcode = Opcode::Schedule;
  static constexpr auto kFields = std::tuple{&Schedule::days, &Schedule::times};
};

/// Sets the clock.
struct SetDayTime {
  Bounded<0, 6> day;  ///< 0 is Sunday
  Hour hour;
  Minute minute;
  static constexpr Opcode kOpcode = Opcode::SetDayTime;
  static constexpr auto kFields = std::tuple{&SetDayTime::day, &SetDayTime::hour, &SetDayTime::minute};
};

/// Ends the interface: to Off, streams end, and only Start is listened to.
using Stop = BareCommand<Opcode::Stop>;

/// Any command.
using Command = std::variant<Reset, Start, Baud, Control, Safe, Full, Power, Spot, Clean, Max, Demo, Drive, Motors,
                             Leds, Song, Play, Query, SeekDock, PwmMotors, PwmLowSideDrivers, DriveDirect, DrivePwm,
                             DigitalOutputs, Stream, QueryList, PauseResumeStream, SendIr, Script, PlayScript,
                             ShowScript, WaitTime, WaitDistance, WaitAngle, WaitEvent, SchedulingLeds, DigitLedsRaw,
                             DigitLedsAscii, Buttons, Schedule, SetDayTime, Stop>;

/// Speeds of the line by the code of Baud [bit/s].
inline constexpr std::array<std::int32_t, 12> kBaudRates{300,   600,   1200,  2400,  4800,  9600,
                                                         14400, 19200, 28800, 38400, 57600, 115200};

/// The longest command is a list of 255 ids: opcode, count, ids.
inline constexpr std::size_t kMaxCommandBytes = 257;

/// A command's bytes in their own storage.
struct CommandBytes {
  std::array<std::uint8_t, kMaxCommandBytes> storage;
  std::size_t size;

  std::span<const std::uint8_t> bytes() const { return {storage.data(), size}; }
  operator std::span<const std::uint8_t>() const { return bytes(); }
};

/// Writes the command to the front of `out`, and says how many bytes that took; 0 if it doesn't fit.
[[nodiscard]] std::size_t encode(const Command& command, std::span<std::uint8_t> out);
CommandBytes encode(const Command& command);

Opcode opcode_of(const Command& command);

/// Songs that the model can store, in slots from 0 on.
constexpr int song_slots(Model model) {
  return model == Model::Create2 ? 5 : 16;
}

/// Whether that model knows the command, and has what it names: the song slot, the packets.
bool valid_on(const Command& command, Model model);

}  // namespace scrubjay::oi

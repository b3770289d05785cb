/// \file
/// The robot's side of the Open Interface: command bytes in, sensor bytes out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <scrubjay/oi/command_decoder.hpp>
#include <scrubjay/oi/mode.hpp>
#include <scrubjay/oi/quirks.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/simulation/body_senses.hpp>
#include <scrubjay/simulation/robot_spec.hpp>
#include <span>
#include <vector>

namespace scrubjay::sim {

/// What a firmware does otherwise than the specification says, on request.
struct FirmwareOptions {
  oi::FirmwareQuirks quirks{.sign_from_command = false};  ///< a perfect one by default: encoders know their direction
  std::uint16_t encoder_start = 0;                        ///< first reading of both encoders
  oi::Release release{3, 5, 2};                           ///< that it names when it boots
  bool asleep = false;                                    ///< at first: silent and deaf, see Firmware::pulse_brc
};

/// What the robot shows and plays.
struct Indicators {
  std::uint8_t leds = 0;
  std::uint8_t power_color = 0;
  std::uint8_t power_intensity = 0;
  std::array<std::uint8_t, 4> digits{};  ///< as segments or characters, as they were sent last
  std::uint8_t motors = 0;               ///< brushes and vacuum, as in the Motors command, whichever one set them
};

/// Modes, safety, stream, queries, songs, lights and buttons.
///
/// Reset loses all but the wheels' account, says what it boots, and leaves it deaf until it has (about 5 s). Answers,
/// as a real robot, don't come at once: replies and stream frames go out with the next tick.
class Firmware {
 public:
  /// OI specification, "Passive Mode" [s].
  static constexpr double kSleepAfter = 300.0;

  explicit Firmware(const RobotSpec& spec, const FirmwareOptions& options = {});

  void receive(std::span<const std::uint8_t> bytes);
  /// One stream interval (kTick) with these senses; sends what is due to `out`, at its end.
  void tick(const BodySenses& senses, std::vector<std::uint8_t>& out);

  /// The BRC pin (device detect on older robots) is pulled low for a moment, as far as it wakes: one that sleeps is Off
  /// then, and listens to Start; one in Passive mode stays awake for another kSleepAfter. Changes of the baud rate by
  /// three pulses after power-up are none of a firmware without a wire.
  void pulse_brc();
  /// Silent, and deaf to all but pulse_brc(): after Power, or after a while in Passive mode, away from its dock,
  /// without a command.
  bool asleep() const { return asleep_; }
  /// Slot of the song that is being played, if one is.
  std::optional<int> song() const { return song_left_ > 0.0 ? std::optional(song_) : std::nullopt; }
  std::uint64_t songs_played() const { return songs_played_; }

  WheelSpeeds wanted() const { return wanted_; }
  oi::OiMode mode() const { return mode_; }
  const Indicators& indicators() const { return indicators_; }
  std::uint64_t rejected_commands() const { return rejected_; }

 private:
  void obey(const oi::Command& command);
  void reboot();
  void boot_on(std::vector<std::uint8_t>& out);
  void act(const oi::Command& command);
  void drive(double left, double right);
  void enter(oi::OiMode mode);
  void answer(const oi::Command& command, std::vector<std::uint8_t>& out);
  void store(const BodySenses& senses);
  void store_travel(const BodySenses& senses);
  void store_requests();
  void forget_travel(oi::SensorId sent);
  void heed_safety(const BodySenses& senses);
  void pass_time(bool docked);
  void fall_asleep();

  RobotSpec spec_;
  oi::Model model_;
  FirmwareOptions options_;
  oi::CommandDecoder decoder_;
  oi::Sensors sensors_;
  oi::OiMode mode_ = oi::OiMode::Off;
  WheelSpeeds wanted_;
  Indicators indicators_;
  std::uint64_t rejected_ = 0;

  std::vector<oi::SensorId> stream_;
  bool streaming_ = false;
  std::vector<oi::Command> queries_;  // to be answered with the next tick

  // As requested last, in the units of the packets.
  int velocity_ = 0;
  int radius_ = 0;
  int right_velocity_ = 0;
  int left_velocity_ = 0;

  double left_before_ = 0.0;  // rolled until the last tick [m]
  double right_before_ = 0.0;
  double distance_ = 0.0;      // since it was last sent [mm]
  double angle_ = 0.0;         // the same, in the unit of its packet
  double left_counted_ = 0.0;  // by the encoders [counts]
  double right_counted_ = 0.0;

  std::array<std::vector<oi::Note>, 16> songs_;
  int song_ = 0;
  double song_left_ = 0.0;  // to be played yet [s]
  std::uint64_t songs_played_ = 0;

  bool asleep_ = false;
  double idle_ = 0.0;  // since the last command [s]

  std::uint8_t buttons_ = 0;   // pressed by command
  double buttons_left_ = 0.0;  // until they are let go [s]
  double boot_left_ = 0.0;     // until it has booted [s]
};

}  // namespace scrubjay::sim

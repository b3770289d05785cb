/// \file
/// The robot's side of the Open Interface: command bytes in, sensor bytes out.
#pragma once

#include <array>
#include <cstdint>
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
};

/// What the robot shows and plays.
struct Indicators {
  std::uint8_t leds = 0;
  std::uint8_t power_color = 0;
  std::uint8_t power_intensity = 0;
  std::array<std::uint8_t, 4> digits{};  ///< as segments or characters, as they were sent last
  std::uint8_t motors = 0;               ///< brushes and vacuum, as in the Motors command
};

/// Modes, safety, stream, queries, songs and lights.
///
/// Answers, as a real robot, don't come at once: replies and stream frames go out with the next tick.
class Firmware {
 public:
  explicit Firmware(const RobotSpec& spec, const FirmwareOptions& options = {});

  void receive(std::span<const std::uint8_t> bytes);
  /// One stream interval (kTick) with these senses; sends what is due to `out`, at its end.
  void tick(const BodySenses& senses, std::vector<std::uint8_t>& out);

  WheelSpeeds wanted() const { return wanted_; }
  oi::OiMode mode() const { return mode_; }
  const Indicators& indicators() const { return indicators_; }
  std::uint64_t rejected_commands() const { return rejected_; }

 private:
  void obey(const oi::Command& command);
  void act(const oi::Command& command);
  void drive(double left, double right);
  void enter(oi::OiMode mode);
  void answer(const oi::Command& command, std::vector<std::uint8_t>& out);
  void store(const BodySenses& senses);
  void store_travel(const BodySenses& senses);
  void store_requests();
  void forget_travel(oi::SensorId sent);
  void heed_safety(const BodySenses& senses);
  void play_on();

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
};

}  // namespace scrubjay::sim

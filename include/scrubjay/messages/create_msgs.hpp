/// \file
/// create_msgs, of AutonomyLab's create_robot.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <scrubjay/messages/std_msgs.hpp>

namespace scrubjay::ros {

struct Bumper {
  static constexpr std::string_view kType = "create_msgs/msg/Bumper";
  static constexpr std::string_view kHash = "RIHS01_b81367ac534b55b9ef16618d14f7d8da71a5b30328bf5b60b35c8140d9510102";
  Header header;
  bool is_left_pressed = false;
  bool is_right_pressed = false;
  bool is_light_left = false;
  bool is_light_front_left = false;
  bool is_light_center_left = false;
  bool is_light_center_right = false;
  bool is_light_front_right = false;
  bool is_light_right = false;
  std::uint16_t light_signal_left = 0;
  std::uint16_t light_signal_front_left = 0;
  std::uint16_t light_signal_center_left = 0;
  std::uint16_t light_signal_center_right = 0;
  std::uint16_t light_signal_front_right = 0;
  std::uint16_t light_signal_right = 0;

  static constexpr auto fields() {
    return std::tuple(
        field("header", &Bumper::header), field("is_left_pressed", &Bumper::is_left_pressed),
        field("is_right_pressed", &Bumper::is_right_pressed), field("is_light_left", &Bumper::is_light_left),
        field("is_light_front_left", &Bumper::is_light_front_left),
        field("is_light_center_left", &Bumper::is_light_center_left),
        field("is_light_center_right", &Bumper::is_light_center_right),
        field("is_light_front_right", &Bumper::is_light_front_right), field("is_light_right", &Bumper::is_light_right),
        field("light_signal_left", &Bumper::light_signal_left),
        field("light_signal_front_left", &Bumper::light_signal_front_left),
        field("light_signal_center_left", &Bumper::light_signal_center_left),
        field("light_signal_center_right", &Bumper::light_signal_center_right),
        field("light_signal_front_right", &Bumper::light_signal_front_right),
        field("light_signal_right", &Bumper::light_signal_right));
  }
  bool operator==(const Bumper&) const = default;
};

struct Cliff {
  static constexpr std::string_view kType = "create_msgs/msg/Cliff";
  static constexpr std::string_view kHash = "RIHS01_2a1473d9f0c4ef3ef9a18a76fdf6e9323ebfe760afd0757a8f7ff004f25c5980";
  Header header;
  bool is_cliff_left = false;
  bool is_cliff_front_left = false;
  bool is_cliff_right = false;
  bool is_cliff_front_right = false;

  static constexpr auto fields() {
    return std::tuple(field("header", &Cliff::header), field("is_cliff_left", &Cliff::is_cliff_left),
                      field("is_cliff_front_left", &Cliff::is_cliff_front_left),
                      field("is_cliff_right", &Cliff::is_cliff_right),
                      field("is_cliff_front_right", &Cliff::is_cliff_front_right));
  }
  bool operator==(const Cliff&) const = default;
};

struct Mode {
  static constexpr std::string_view kType = "create_msgs/msg/Mode";
  static constexpr std::string_view kHash = "RIHS01_eed2ef7aec4a3793b08babbc176eb6560d7d12e8810da38c4348717b883d70ce";
  Header header;
  std::uint8_t mode = 0;  ///< as oi::OiMode counts

  static constexpr auto fields() { return std::tuple(field("header", &Mode::header), field("mode", &Mode::mode)); }
  static constexpr auto constants() {
    return std::array{Constant{"uint8", "MODE_OFF", 0}, Constant{"uint8", "MODE_PASSIVE", 1},
                      Constant{"uint8", "MODE_SAFE", 2}, Constant{"uint8", "MODE_FULL", 3}};
  }
  bool operator==(const Mode&) const = default;
};

struct ChargingState {
  static constexpr std::string_view kType = "create_msgs/msg/ChargingState";
  static constexpr std::string_view kHash = "RIHS01_6886dd061d51ed6f15dc83fef384ddb32d7aa9527b70051acb4f17c17c266c6a";
  Header header;
  std::uint8_t state = 0;  ///< as oi::ChargingState counts

  static constexpr auto fields() {
    return std::tuple(field("header", &ChargingState::header), field("state", &ChargingState::state));
  }
  static constexpr auto constants() {
    return std::array{Constant{"uint8", "CHARGE_NONE", 0},    Constant{"uint8", "CHARGE_RECONDITION", 1},
                      Constant{"uint8", "CHARGE_FULL", 2},    Constant{"uint8", "CHARGE_TRICKLE", 3},
                      Constant{"uint8", "CHARGE_WAITING", 4}, Constant{"uint8", "CHARGE_FAULT", 5}};
  }
  bool operator==(const ChargingState&) const = default;
};

struct DefineSong {
  static constexpr std::string_view kType = "create_msgs/msg/DefineSong";
  static constexpr std::string_view kHash = "RIHS01_02bf2e20e024c5f5b24820d720bac29e5b7e6090b8a06d5555bd2ef4a0acbe37";
  std::uint8_t song = 0;            ///< 0 to 3
  std::uint8_t length = 0;          ///< 1 to 16 notes
  std::vector<std::uint8_t> notes;  ///< MIDI numbers; below 31 is a rest
  std::vector<float> durations;     ///< [s]

  static constexpr auto fields() {
    return std::tuple(field("song", &DefineSong::song), field("length", &DefineSong::length),
                      field("notes", &DefineSong::notes), field("durations", &DefineSong::durations));
  }
  bool operator==(const DefineSong&) const = default;
};

struct PlaySong {
  static constexpr std::string_view kType = "create_msgs/msg/PlaySong";
  static constexpr std::string_view kHash = "RIHS01_22df6118234c4d0f47ffaaec83fbaa557cb52475c0f31eea3123ae01f46237f5";
  std::uint8_t song = 0;  ///< 0 to 3

  static constexpr auto fields() { return std::tuple(field("song", &PlaySong::song)); }
  bool operator==(const PlaySong&) const = default;
};

}  // namespace scrubjay::ros

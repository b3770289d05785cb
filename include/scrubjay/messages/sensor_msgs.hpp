/// \file
/// sensor_msgs, as far as we use them.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <scrubjay/messages/std_msgs.hpp>

namespace scrubjay::ros {

/// See LaserScan of `robot`.
struct LaserScan {
  static constexpr std::string_view kType = "sensor_msgs/msg/LaserScan";
  static constexpr std::string_view kHash = "RIHS01_64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828";
  Header header;
  float angle_min = 0.0F;
  float angle_max = 0.0F;
  float angle_increment = 0.0F;
  float time_increment = 0.0F;
  float scan_time = 0.0F;
  float range_min = 0.0F;
  float range_max = 0.0F;
  std::vector<float> ranges;
  std::vector<float> intensities;

  static constexpr auto fields() {
    return std::tuple(field("header", &LaserScan::header), field("angle_min", &LaserScan::angle_min),
                      field("angle_max", &LaserScan::angle_max), field("angle_increment", &LaserScan::angle_increment),
                      field("time_increment", &LaserScan::time_increment), field("scan_time", &LaserScan::scan_time),
                      field("range_min", &LaserScan::range_min), field("range_max", &LaserScan::range_max),
                      field("ranges", &LaserScan::ranges), field("intensities", &LaserScan::intensities));
  }
  bool operator==(const LaserScan&) const = default;
};

struct JointState {
  static constexpr std::string_view kType = "sensor_msgs/msg/JointState";
  static constexpr std::string_view kHash = "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e";
  Header header;
  std::vector<std::string> name;
  std::vector<double> position;
  std::vector<double> velocity;
  std::vector<double> effort;

  static constexpr auto fields() {
    return std::tuple(field("header", &JointState::header), field("name", &JointState::name),
                      field("position", &JointState::position), field("velocity", &JointState::velocity),
                      field("effort", &JointState::effort));
  }
  bool operator==(const JointState&) const = default;
};

/// What isn't measured is NaN.
struct BatteryState {
  static constexpr std::string_view kType = "sensor_msgs/msg/BatteryState";
  static constexpr std::string_view kHash = "RIHS01_4bee5dfce981c98faa6828b868307a0a73f992ed0789f374ee96c8f840e69741";
  static constexpr std::uint8_t kStatusCharging = 1;
  static constexpr std::uint8_t kStatusDischarging = 2;
  static constexpr std::uint8_t kStatusNotCharging = 3;
  static constexpr std::uint8_t kTechnologyNimh = 1;
  Header header;
  float voltage = 0.0F;          ///< [V]
  float temperature = 0.0F;      ///< [deg C]
  float current = 0.0F;          ///< negative while discharging [A]
  float charge = 0.0F;           ///< [Ah]
  float capacity = 0.0F;         ///< last full capacity [Ah]
  float design_capacity = 0.0F;  ///< [Ah]
  float percentage = 0.0F;       ///< 0 to 1
  std::uint8_t power_supply_status = 0;
  std::uint8_t power_supply_health = 0;
  std::uint8_t power_supply_technology = 0;
  bool present = false;
  std::vector<float> cell_voltage;
  std::vector<float> cell_temperature;
  std::string location;
  std::string serial_number;

  static constexpr auto fields() {
    return std::tuple(field("header", &BatteryState::header), field("voltage", &BatteryState::voltage),
                      field("temperature", &BatteryState::temperature), field("current", &BatteryState::current),
                      field("charge", &BatteryState::charge), field("capacity", &BatteryState::capacity),
                      field("design_capacity", &BatteryState::design_capacity),
                      field("percentage", &BatteryState::percentage),
                      field("power_supply_status", &BatteryState::power_supply_status),
                      field("power_supply_health", &BatteryState::power_supply_health),
                      field("power_supply_technology", &BatteryState::power_supply_technology),
                      field("present", &BatteryState::present), field("cell_voltage", &BatteryState::cell_voltage),
                      field("cell_temperature", &BatteryState::cell_temperature),
                      field("location", &BatteryState::location), field("serial_number", &BatteryState::serial_number));
  }
  static constexpr auto constants() {
    return std::array{Constant{"uint8", "POWER_SUPPLY_STATUS_UNKNOWN", 0},
                      Constant{"uint8", "POWER_SUPPLY_STATUS_CHARGING", 1},
                      Constant{"uint8", "POWER_SUPPLY_STATUS_DISCHARGING", 2},
                      Constant{"uint8", "POWER_SUPPLY_STATUS_NOT_CHARGING", 3},
                      Constant{"uint8", "POWER_SUPPLY_STATUS_FULL", 4},
                      Constant{"uint8", "POWER_SUPPLY_HEALTH_UNKNOWN", 0},
                      Constant{"uint8", "POWER_SUPPLY_HEALTH_GOOD", 1},
                      Constant{"uint8", "POWER_SUPPLY_TECHNOLOGY_UNKNOWN", 0},
                      Constant{"uint8", "POWER_SUPPLY_TECHNOLOGY_NIMH", 1}};
  }
  bool operator==(const BatteryState&) const = default;
};

/// A part of markers.
struct CompressedImage {
  static constexpr std::string_view kType = "sensor_msgs/msg/CompressedImage";
  static constexpr std::string_view kHash = "RIHS01_15640771531571185e2efc8a100baf923961a4d15d5569652e6cb6691e8e371a";
  Header header;
  std::string format;
  std::vector<std::uint8_t> data;

  static constexpr auto fields() {
    return std::tuple(field("header", &CompressedImage::header), field("format", &CompressedImage::format),
                      field("data", &CompressedImage::data));
  }
  bool operator==(const CompressedImage&) const = default;
};

}  // namespace scrubjay::ros

/// \file
/// diagnostic_msgs and rcl_interfaces, as far as we use them.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <scrubjay/messages/std_msgs.hpp>

namespace scrubjay::ros {

struct KeyValue {
  static constexpr std::string_view kType = "diagnostic_msgs/msg/KeyValue";
  static constexpr std::string_view kHash = "RIHS01_d68081eaa540288c5440753baecef0c4e16e81a5f78ad68902ded5100413bb42";
  std::string key;
  std::string value;

  static constexpr auto fields() { return std::tuple(field("key", &KeyValue::key), field("value", &KeyValue::value)); }
  bool operator==(const KeyValue&) const = default;
};

struct DiagnosticStatus {
  static constexpr std::string_view kType = "diagnostic_msgs/msg/DiagnosticStatus";
  static constexpr std::string_view kHash = "RIHS01_b0e3e692ea2d54a8af2f4ef1930e81556a2db55216b771f8a7d2724ed47bf0e4";
  static constexpr std::byte kOk{0};
  static constexpr std::byte kWarn{1};
  static constexpr std::byte kError{2};

  std::byte level{};
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<KeyValue> values;

  static constexpr auto fields() {
    return std::tuple(field("level", &DiagnosticStatus::level), field("name", &DiagnosticStatus::name),
                      field("message", &DiagnosticStatus::message),
                      field("hardware_id", &DiagnosticStatus::hardware_id), field("values", &DiagnosticStatus::values));
  }
  static constexpr auto constants() {
    return std::array{Constant{"byte", "OK", 0}, Constant{"byte", "WARN", 1}, Constant{"byte", "ERROR", 2},
                      Constant{"byte", "STALE", 3}};
  }
  bool operator==(const DiagnosticStatus&) const = default;
};

struct DiagnosticArray {
  static constexpr std::string_view kType = "diagnostic_msgs/msg/DiagnosticArray";
  static constexpr std::string_view kHash = "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e";
  Header header;
  std::vector<DiagnosticStatus> status;

  static constexpr auto fields() {
    return std::tuple(field("header", &DiagnosticArray::header), field("status", &DiagnosticArray::status));
  }
  bool operator==(const DiagnosticArray&) const = default;
};

struct Log {
  static constexpr std::string_view kType = "rcl_interfaces/msg/Log";
  static constexpr std::string_view kHash = "RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac";
  static constexpr std::uint8_t kInfo = 20;
  static constexpr std::uint8_t kWarn = 30;
  static constexpr std::uint8_t kError = 40;

  Time stamp;
  std::uint8_t level = 0;
  std::string name;
  std::string msg;
  std::string file;
  std::string function;
  std::uint32_t line = 0;

  static constexpr auto fields() {
    return std::tuple(field("stamp", &Log::stamp), field("level", &Log::level), field("name", &Log::name),
                      field("msg", &Log::msg), field("file", &Log::file), field("function", &Log::function),
                      field("line", &Log::line));
  }
  static constexpr auto constants() {
    return std::array{Constant{"byte", "DEBUG", 10}, Constant{"byte", "INFO", 20}, Constant{"byte", "WARN", 30},
                      Constant{"byte", "ERROR", 40}, Constant{"byte", "FATAL", 50}};
  }
  bool operator==(const Log&) const = default;
};

}  // namespace scrubjay::ros

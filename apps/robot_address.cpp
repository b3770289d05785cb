#include "robot_address.hpp"

#include <fmt/format.h>

#include <charconv>
#include <scrubjay/error.hpp>
#include <string_view>

namespace scrubjay::apps {
namespace {

constexpr std::string_view kSerial = "serial:";
constexpr std::string_view kLog = "log:";

}  // namespace

RobotAddress parse_robot_address(const std::string& text) {
  if (text == "sim") return InSimulation{};
  if (text.starts_with(kSerial)) return parse_port(text.substr(kSerial.size()), "--robot");
  if (text.starts_with(kLog) && text.size() > kLog.size()) return InRecording{text.substr(kLog.size())};
  throw Error(fmt::format("--robot is '{}'; want sim, serial:PATH[@BAUD] or log:FILE", text));
}

SerialAddress parse_serial_robot(const std::string& text) {
  if (text.starts_with(kSerial)) return parse_port(text.substr(kSerial.size()), "--robot");
  throw Error(fmt::format("--robot is '{}'; want serial:PATH[@BAUD], as serial:/dev/ttyUSB0", text));
}

SerialAddress parse_port(const std::string& text, const std::string& flag) {
  SerialAddress address;
  const std::size_t at = text.rfind('@');
  address.path = text.substr(0, at);
  if (address.path.empty()) {
    throw Error(fmt::format("{} names no port; want its path, as /dev/ttyUSB0", flag));
  }
  if (at == std::string::npos) return address;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + at + 1, end, address.baud);
  if (error != std::errc() || stop != end || address.baud <= 0) {
    throw Error(fmt::format("{}: '{}' is no baud rate; want one, as /dev/ttyUSB0@115200", flag, text.substr(at + 1)));
  }
  return address;
}

}  // namespace scrubjay::apps

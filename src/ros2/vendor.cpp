#include "vendor.hpp"

#include <fmt/format.h>

namespace scrubjay::ros {

std::string vendor_name(std::uint8_t first, std::uint8_t second) {
  switch (first << 8 | second) {
    case 0x0101:
      return "RTI Connext";
    case 0x0103:
      return "OpenDDS";
    case 0x010b:
      return "GurumDDS";
    case 0x010f:
      return "Fast DDS";
    case 0x0110:
      return "Cyclone DDS";
    case 0x0112:
      return "RustDDS";
    default:
      return fmt::format("vendor {}.{}", first, second);
  }
}

}  // namespace scrubjay::ros

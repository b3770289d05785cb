/// \file
/// The frame of messages of RTPS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace scrubjay::ros {

/// How many bytes of an RTPS message stand before the first submessage that is a vendor's own (128 and above) or isn't
/// whole (RTPS 2.3, 8.3.3 and 9.4.5); 0 if it is no message of RTPS.
std::size_t length_of_standard_part(std::span<const std::uint8_t> message);

}  // namespace scrubjay::ros

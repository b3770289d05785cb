/// \file
/// What a robot prints while it boots, in two parts.
#pragma once

#include <scrubjay/oi/quirks.hpp>
#include <string>

namespace scrubjay::sim {

/// From power to the last line. Own guess, after "about 5 s" of the OI specification, "Reset".
inline constexpr double kBootTime = 5.0;  // [s]

/// The boot loader's lines, at once.
std::string boot_loader_banner();
/// The robot's own, when it is ready; they name its release as parse_release reads it.
std::string ready_banner(const oi::Release& release);

}  // namespace scrubjay::sim

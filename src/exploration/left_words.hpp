/// \file
/// Why a place is left unknown, in the words of every explorer.
#pragma once

namespace scrubjay {

inline constexpr const char* kTooNarrow = "too narrow for the robot";
inline constexpr const char* kGivenUp = "given up";
inline constexpr const char* kNotYet = "not reached yet";

}  // namespace scrubjay

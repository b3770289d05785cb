/// \file
/// The robot that the tests' worlds have room for.
#pragma once

namespace scrubjay {

inline constexpr double kRadius = 0.1735;  ///< of a Roomba [m]

}  // namespace scrubjay

/// \file
/// Colours of map pictures.
#pragma once

#include <scrubjay/io/drawing.hpp>

namespace scrubjay::style {

inline constexpr Color kUnknownGround{222, 222, 219};
inline constexpr Color kPaper{253, 250, 242};
inline constexpr Color kMetreLines{121, 104, 71, 22};
inline constexpr Color kInk{38, 46, 59};
inline constexpr Color kFaintInk{38, 46, 59, 150};
inline constexpr Color kTrueWall{224, 172, 140};
inline constexpr Color kPathBegin{150, 205, 214};
inline constexpr Color kPathEnd{18, 84, 156};
inline constexpr Color kRobot{244, 146, 40};
inline constexpr Color kRobotRim{122, 62, 8};
inline constexpr Color kStart{42, 145, 98};
inline constexpr Color kDock{96, 66, 140};
inline constexpr Color kBump{206, 43, 55};
inline constexpr Color kStuck{250, 190, 38};
inline constexpr Color kLeft{178, 60, 152};
inline constexpr Color kWhite{255, 255, 255};

}  // namespace scrubjay::style

/// \file
/// Rooms as markers for rviz and its like.
#pragma once

#include <scrubjay/mapping/rooms.hpp>
#include <scrubjay/messages/visualization_msgs.hpp>

namespace scrubjay::ros {

/// In which rooms are told apart, opaque: twelve go round by the labels (from 1 on), neighbours easy to tell apart.
ColorRGBA room_color(RoomLabel label);

/// Takes away what was shown, and shows each room as its floor (namespace `rooms`) and a line with its label and area
/// at its center (namespace `room_labels`), both with the label as id.
MarkerArray room_markers(const Header& header, const RoomMap& rooms);

}  // namespace scrubjay::ros

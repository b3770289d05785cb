/// \file
/// Rooms as markers for rviz and its like.
#pragma once

#include <scrubjay/mapping/rooms.hpp>
#include <scrubjay/messages/visualization_msgs.hpp>

namespace scrubjay::ros {

/// Takes away what was shown, and shows each room as its floor (namespace `rooms`) and a line with its label and area
/// at its center (namespace `room_labels`), both with the label as id. Twelve colours go round by the labels.
MarkerArray room_markers(const Header& header, const RoomMap& rooms);

}  // namespace scrubjay::ros

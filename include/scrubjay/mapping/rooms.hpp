/// \file
/// The rooms of a map: floor between walls, cut where doors are.
#pragma once

#include <cstdint>
#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

/// Number of a room of a map, from 1 on; kNoRoom for what belongs to none.
using RoomLabel = std::uint16_t;
inline constexpr RoomLabel kNoRoom = 0;

/// What makes a room. A width is that of a straight strip of floor between two walls, or of the gap in one. The
/// defaults were tried on the worlds of this repository, on maps that a noisy lidar made of them, and on HouseExpo's
/// plans.
struct RoomParams {
  double widest_door = 1.1;       ///< [m]
  double door_widening = 1.25;    ///< on both sides of a door, floor is wider than it by this factor
  double widest_opening = 2.0;    ///< of one without a door; where floor is wider than this, no room ends [m]
  double opening_widening = 1.6;  ///< the factor of what is wider than a door
  double thickest_wall = 0.4;     ///< what is narrow for longer is a passage within a room, as beside a bed [m]
  double least_width = 0.8;       ///< what is narrower everywhere is part of the room beside it [m]
  double least_area = 2.0;        ///< so is what is smaller; with no room beside it, it is none [m^2]
  double largest_thing = 1.2;     ///< what stands free and is no larger, either way, doesn't shape rooms [m]
  double wall_hole = 0.2;         ///< what is less far apart doesn't stand free of each other [m]
};

/// One room.
struct Room {
  RoomLabel label = kNoRoom;
  double area = 0.0;        ///< of its cells [m^2]
  Point2 center{0.0, 0.0};  ///< of a free cell of it: among those farthest from walls, the nearest to its centroid [m]
  CellRect bounds{};        ///< the smallest that holds its cells

  bool operator==(const Room&) const = default;
};

/// Where two rooms meet; where they do so at several places, the widest of them.
struct Doorway {
  RoomLabel first = kNoRoom;   ///< the larger room of the two
  RoomLabel second = kNoRoom;  ///< the other one
  Point2 center{0.0, 0.0};     ///< [m]
  double width = 0.0;          ///< [m], at most a cell less than it is

  bool operator==(const Doorway&) const = default;
};

/// A map's cells, and the rooms that they belong to.
struct RoomMap {
  GridGeometry geometry{};          ///< the map's
  std::vector<RoomLabel> labels{};  ///< of each cell, row-major
  std::vector<Room> rooms{};        ///< by label: the largest is the first, and label 1
  std::vector<Doorway> doorways{};  ///< by their labels

  GridView<const RoomLabel> view() const { return {geometry, labels.data()}; }
  bool operator==(const RoomMap&) const = default;
};

/// Splits what is free of a map (trinary) into rooms; the small things that stand in a room are part of it.
///
/// A watershed of the distance to what isn't free: floor is flooded from where it is widest, and rooms end where two
/// floods meet in a gap that is narrow beside the floor on both its sides, and short. So rooms are 4-connected, and
/// every free cell is in one, unless it is part of a piece of floor smaller than any. R. Bormann, F. Jordan, W. Li, J.
/// Hampp, M. Haegele, *Room Segmentation: Survey, Implementation, and Analysis*, ICRA 2016, compares the like.
///
/// Takes about a second for 4000 x 4000 cells, a few milliseconds for a home (test/bench/rooms_bench.cpp). Distances
/// are cut at 180 cells, which tells doors and openings as the defaults have them down to cells of 1 cm. Throws Error
/// if there are more rooms than labels.
RoomMap split_into_rooms(GridView<const LogOdds> map, const RoomParams& params = {});

}  // namespace scrubjay

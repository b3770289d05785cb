/// \file
/// Pictures of maps for people: what was mapped, where the robot went, and what happened there.
#pragma once

#include <optional>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/mapping/rooms.hpp>
#include <string>
#include <vector>

namespace scrubjay {

/// What a picture shows, all in the map's frame [m, rad]; what is empty is left out.
struct MapPicture {
  GridView<const Occupancy> map;
  RoomMap rooms;                     ///< each in a colour of its own, its label at its center
  std::vector<Segment2> true_walls;  ///< drawn faintly beneath the map, to compare with
  std::vector<Pose2> trajectory;     ///< from light to saturated along its course
  std::optional<Pose2> robot;
  double robot_radius = 0.1735;  ///< [m]
  std::optional<Pose2> start;
  std::optional<Pose2> dock;  ///< its face, looking out into the room
  std::vector<Point2> bumps;  ///< where the bumper was hit
  std::vector<Point2> stuck;  ///< where the robot couldn't get on
  std::vector<Point2> left;   ///< where it would have gone, and hasn't
  std::string title;
};

/// An RGBA picture, cropped to what is known, driven over or true, with a scale bar and a legend.
///
/// The longer side of the map is about 1200 pixels, but a cell has 4 pixels at least and 24 at most (fewer than 4 only
/// where the picture would otherwise pass 8000). The same input gives the same bytes.
Image draw_map(const MapPicture& picture);

}  // namespace scrubjay

/// \file
/// What a map says of the floor around a robot: where unknown floor lies, and whether an edge was met before.
#pragma once

#include <optional>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/grid/log_odds.hpp>

namespace scrubjay {

struct OutlookParams {
  int headings = 32;             ///< tried around the robot
  double sight = 8.0;            ///< how far ahead the map is read [m]
  double worthwhile = 0.15;      ///< unknown floor on the way that makes a drive worth while [m]
  double berth = radians(75.0);  ///< headings this near to the obstacle at hand aren't tried [rad]
};

/// Where a disc of `radius` [m] stands, and in which direction the obstacle that it stands at lies [rad].
struct Standpoint {
  Point2 position{0.0, 0.0};
  double radius = 0.0;
  double obstacle = 0.0;
};

/// A heading [rad] along which the disc would cross much unknown floor before it meets something; none if no heading is
/// worth while. Lengths are weighed by chance, 0.5 to 1, so that what can't be reached isn't tried for ever.
std::optional<double> heading_to_unknown(GridView<const LogOdds> map, const Standpoint& from, Random& random,
                                         const OutlookParams& params = {});

/// The heading [rad] along which the disc could drive farthest over floor that isn't occupied.
double longest_heading(GridView<const LogOdds> map, const Standpoint& from, Random& random,
                       const OutlookParams& params = {});

/// True if the floor along the obstacle that a robot has driven up to with this heading [rad] is known: then it went
/// along there before.
bool beside_known_floor(GridView<const LogOdds> map, const Standpoint& at, double heading);

}  // namespace scrubjay

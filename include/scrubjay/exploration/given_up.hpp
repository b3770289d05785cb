/// \file
/// Places that were given up, and why that may be thought over.
#pragma once

#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

/// Our own choice.
struct GivenUpParams {
  double place = 0.3;         ///< a goal this near to a remembered one is the same [m]
  double surroundings = 0.4;  ///< of the goal, and of where the robot gave it up: watched for changes [m]
  double change = 0.08;       ///< share of their cells that must become something else to forgive it; doubles each time
  double most_change = 0.5;   ///< ... up to this: a house that was rearranged is always forgiven
  int visits = 3;      ///< seen as often as this, with no less unknown around it, it is readings' noise: given up
  double visit = 4.0;  ///< ... each visit as long as this after the one before: shadows move as robots do [s]
};

/// Remembers goals by place. One is forgiven when the map has changed around it, or around where the robot was when it
/// gave up: what stood in the way may be gone, or there is more to be seen. Each time it is given up again, more must
/// change: walls that come and go with readings' noise aren't worth a way for ever.
class GivenUp {
 public:
  explicit GivenUp(const GivenUpParams& params = {}) : params_(params) {}

  /// The robot couldn't get to the goal, or couldn't see there what it wanted.
  void remember(GridView<const LogOdds> map, const Point2& goal, const Point2& robot);
  /// It saw what it wanted, at the time `stamp` [s], and shouldn't have to come again and again.
  void remember_seen(GridView<const LogOdds> map, const Point2& goal, double stamp);
  /// Something else has changed, of which the map doesn't tell.
  void forgive(const Point2& goal);
  /// True if that goal, or one near it, was given up, as far as the map tells now.
  bool holds(GridView<const LogOdds> map, const Point2& goal) const;

 private:
  /// How many cells of each class lie around a point. Cells at walls come and go with every reading's noise; counts
  /// hardly change.
  struct Surroundings {
    int free = 0;
    int occupied = 0;
    int unknown = 0;
  };
  struct Entry {
    Point2 goal;
    Surroundings around_goal;
    int least_unknown = 0;   // cells around the goal that ever were unknown
    int visits = 0;          // since there were fewer unknown cells than ever
    double visited = 0.0;    // at the last of them [s]
    int tries = 0;           // times that it was given up
    Point2 robot{0.0, 0.0};  // where it was at the last try
    Surroundings around_robot{};
  };
  Surroundings look(GridView<const LogOdds> map, const Point2& center) const;
  bool changed(const Surroundings& then, GridView<const LogOdds> map, const Point2& center, int least) const;
  int cells(GridView<const LogOdds> map, double share) const;
  int wanted_change(GridView<const LogOdds> map, int tries) const;
  Entry& entry_at(GridView<const LogOdds> map, const Point2& goal);
  bool is_at(const Entry& entry, const Point2& goal) const;

  GivenUpParams params_;
  std::vector<Entry> entries_;
};

}  // namespace scrubjay

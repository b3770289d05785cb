/// \file
/// What a disc at a place would newly sweep.
#pragma once

#include <cstdint>
#include <optional>
#include <scrubjay/exploration/floor_layer.hpp>
#include <scrubjay/geometry/bounds.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay {

struct SweepGainParams {
  double radius = 0.1735;         ///< of the disc [m]
  double grazed = 0.25;           ///< cells whose centre is this near to the shell aren't swept [cells]
  double beside_wall = 0.09;      ///< unknown cells nearer to an obstacle aren't wanted: no pass confirms them [m]
  int tries = 3;                  ///< a cell that was tried in vain this often is given up
  std::optional<Bounds2> within;  ///< in the map's frame; what lies outside isn't wanted
};

/// Keeps up with a map which unknown cells are wanted, and how many of them lie under a disc around each cell. The work
/// is by the size of the change.
///
/// A cell that was given up is forgiven one try whenever a cell beside it becomes free: it may be reached from there.
class SweepGain {
 public:
  explicit SweepGain(const SweepGainParams& params) : params_(params) {}

  /// Outside of `changed`, `map` holds what it held at the last update (moved, if it grew).
  void update(GridView<const LogOdds> map, const CellRect& changed);

  /// Unknown floor that a disc may sweep; all that lies outside of the map, too.
  bool wanted(CellIndex cell) const { return class_[cell] == Class::Wanted; }
  bool given_up(CellIndex cell) const { return class_[cell] == Class::GivenUp; }
  bool out_of_bounds(CellIndex cell) const { return class_[cell] == Class::OutOfBounds; }
  bool free(CellIndex cell) const { return class_[cell] == Class::Free; }
  /// Wanted cells within the map under a disc around the cell's centre.
  int gain(CellIndex center) const { return gain_[center]; }
  /// A drive was to sweep the cell, and hasn't.
  void tried(CellIndex cell);
  /// Cells that became free so far: grows while there is progress.
  std::int64_t freed() const { return freed_; }
  /// Walls so far, in cells that were surely occupied; and those of them that aren't any more. The disc drove through
  /// them, by the map: the pose, or the house, isn't what it was.
  std::int64_t walls() const { return walls_; }
  std::int64_t refuted() const { return refuted_; }
  const GridGeometry& geometry() const { return class_.geometry(); }
  /// Of the floor that the disc makes known [m].
  double radius() const { return params_.radius - params_.grazed * geometry().resolution; }
  /// Cells under a disc: no gain is larger.
  int most() const { return static_cast<int>(disc_.size()); }

 private:
  enum class Class : std::uint8_t { Wanted, Free, Occupied, Wall, BesideWall, GivenUp, OutOfBounds };
  struct Step {
    std::int32_t x, y;
  };

  void begin(const GridGeometry& map);
  Class classify(GridView<const LogOdds> map, CellIndex cell) const;
  void change(CellIndex cell, Class to);
  void count(CellIndex cell, int by);

  SweepGainParams params_;
  FloorLayer<Class> class_{Class::Wanted};
  FloorLayer<std::uint16_t> gain_;
  FloorLayer<std::uint8_t> tries_;
  std::vector<Step> disc_;         // cells under a disc
  std::vector<Step> beside_wall_;  // cells too near to an obstacle
  std::int64_t freed_ = 0;
  std::int64_t walls_ = 0;
  std::int64_t refuted_ = 0;
};

}  // namespace scrubjay

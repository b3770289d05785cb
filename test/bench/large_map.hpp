/// \file
/// A large, half known building for benchmarks of planning and exploration.
#pragma once

#include <algorithm>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <vector>

namespace scrubjay::bench {

/// A building of rooms x rooms rooms, each of 5 x 5 m, in cells of 5 cm, as a lidar robot would know it that has seen
/// about half of it: the same cells each time. Rooms have walls of their own (so walls are two cells thick, and of
/// those to an unknown room one is known), doors of 0.9 m to most neighbours, and round furniture. Each 13th row and
/// column of rooms, the last ones, and others by chance are known; into an unknown room, one sees through the doors of
/// known ones.
class LargeMap {
 public:
  static constexpr std::int32_t kRoomSide = 100;  ///< [cells]

  /// 40 rooms a side make 4000 x 4000 cells.
  explicit LargeMap(std::int32_t rooms = 40)
      : geometry_{0.05, {0.0, 0.0}, rooms * kRoomSide, rooms * kRoomSide}, rooms_(rooms), cells_(geometry_.size()) {
    for_each_room([this](CellIndex room) {
      if (is_known(room)) draw_room(room);
    });
    for_each_room([this](CellIndex room) {
      if (is_known(room)) draw_doors(room);
    });
  }

  GridView<LogOdds> view() { return {geometry_, cells_.data()}; }
  GridView<const LogOdds> view() const { return {geometry_, cells_.data()}; }
  /// Free floor in the lower left corner, known, and connected through known rooms with the far corner.
  CellIndex near_corner() const { return {12, 12}; }
  CellIndex far_corner() const { return {geometry_.width - 12, geometry_.height - 12}; }
  bool is_known(CellIndex room) const {
    return is_corridor(room.x) || is_corridor(room.y) || random_of(room).uniform() < 0.3;
  }

 private:
  static constexpr LogOdds kFloor = -60;
  static constexpr LogOdds kSolid = 80;
  static constexpr std::int32_t kDoorWidth = 18;
  static constexpr std::int32_t kSight = 24;  // through a door [cells]

  bool is_corridor(std::int32_t line) const { return line % 13 == 0 || line == rooms_ - 1; }
  static Random random_of(CellIndex room) {
    return Random(static_cast<std::uint64_t>(room.x) * 1000U + static_cast<std::uint64_t>(room.y));
  }

  template <typename Visit>
  void for_each_room(Visit&& visit) const {
    for (std::int32_t y = 0; y < rooms_; ++y) {
      for (std::int32_t x = 0; x < rooms_; ++x) visit(CellIndex{x, y});
    }
  }

  void draw_room(CellIndex room) {
    const CellIndex low{room.x * kRoomSide, room.y * kRoomSide};
    for (std::int32_t y = 0; y < kRoomSide; ++y) {
      for (std::int32_t x = 0; x < kRoomSide; ++x) {
        const bool wall = x == 0 || y == 0 || x == kRoomSide - 1 || y == kRoomSide - 1;
        view()[{low.x + x, low.y + y}] = wall ? kSolid : kFloor;
      }
    }
    Random random = random_of(room).fork(1);
    for (int piece = 0; piece < 3; ++piece) {
      const CellIndex middle{low.x + 30 + static_cast<std::int32_t>(random.below(40)),
                             low.y + 30 + static_cast<std::int32_t>(random.below(40))};
      draw_disc(middle, 4 + static_cast<std::int32_t>(random.below(7)), kSolid);
    }
  }

  void draw_disc(CellIndex middle, std::int32_t radius, LogOdds value) {
    for (std::int32_t y = -radius; y <= radius; ++y) {
      for (std::int32_t x = -radius; x <= radius; ++x) {
        if (x * x + y * y <= radius * radius) view()[{middle.x + x, middle.y + y}] = value;
      }
    }
  }

  void draw_doors(CellIndex room) {
    draw_door(room, {1, 0}, room);
    draw_door(room, {0, 1}, room);
    draw_door(room, {-1, 0}, {room.x - 1, room.y});
    draw_door(room, {0, -1}, {room.x, room.y - 1});
  }

  /// The door out of a known room towards its neighbour in `direction`; the door belongs to `owner`, the room on its
  /// left or below it.
  void draw_door(CellIndex room, CellIndex direction, CellIndex owner) {
    const CellIndex other{room.x + direction.x, room.y + direction.y};
    if (other.x < 0 || other.y < 0 || other.x >= rooms_ || other.y >= rooms_) return;
    const bool sideways = direction.x != 0;
    Random random = random_of(owner).fork(sideways ? 2 : 3);
    const bool along_corridor = sideways ? is_corridor(room.y) : is_corridor(room.x);
    if (random.uniform() < 0.2 && !along_corridor) return;
    const std::int32_t begin = 10 + static_cast<std::int32_t>(random.below(kRoomSide - 20 - kDoorWidth));

    // `depth` counts from our own wall outwards: 0 is our wall, 1 the other room's, and what lies beyond can be seen.
    const std::int32_t depth_end = is_known(other) ? 2 : kSight;
    for (std::int32_t depth = 0; depth < depth_end; ++depth) {
      const std::int32_t spread = depth < 2 ? 0 : depth / 2;
      const std::int32_t end = std::min(kRoomSide - 1, begin + kDoorWidth + spread);
      for (std::int32_t side = std::max(1, begin - spread); side < end; ++side) {
        const CellIndex cell = at(room, direction, depth, side);
        if (depth < 2 || view()[cell] == 0) view()[cell] = kFloor;
      }
    }
    if (is_known(other)) return;
    view()[at(room, direction, 1, begin - 1)] = kSolid;
    view()[at(room, direction, 1, begin + kDoorWidth)] = kSolid;
  }

  CellIndex at(CellIndex room, CellIndex direction, std::int32_t depth, std::int32_t side) const {
    const CellIndex low{room.x * kRoomSide, room.y * kRoomSide};
    if (direction.x > 0) return {low.x + kRoomSide - 1 + depth, low.y + side};
    if (direction.x < 0) return {low.x - depth, low.y + side};
    if (direction.y > 0) return {low.x + side, low.y + kRoomSide - 1 + depth};
    return {low.x + side, low.y - depth};
  }

  GridGeometry geometry_;
  std::int32_t rooms_;
  std::vector<LogOdds> cells_;
};

}  // namespace scrubjay::bench

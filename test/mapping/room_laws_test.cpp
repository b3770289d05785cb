/// \file
/// What holds for the rooms of any map.
#include <gtest/gtest.h>

#include <bench/large_map.hpp>
#include <scrubjay/mapping/rooms.hpp>
#include <set>
#include <utility>

namespace scrubjay {
namespace {

/// Half known, with noise on top: cells that flip, and holes.
std::vector<LogOdds> noisy(GridView<const LogOdds> map, std::uint64_t seed) {
  Random random(seed);
  std::vector<LogOdds> cells(map.cells, map.cells + map.geometry.size());
  const double share = 0.001 * static_cast<double>(seed % 4);
  for (LogOdds& cell : cells) {
    if (random.uniform() < share) cell = static_cast<LogOdds>(-cell);
    if (random.uniform() < share) cell = 0;
  }
  return cells;
}

class RoomLawsTest : public testing::TestWithParam<int> {
 protected:
  RoomLawsTest()
      : building_(4), cells_(noisy(std::as_const(building_).view(), static_cast<std::uint64_t>(GetParam()))) {
    map_ = {building_.view().geometry, cells_.data()};
    rooms_ = split_into_rooms(map_);
  }

  /// Cells of each 4-connected piece of what `belongs` lets in; pieces by the index of their first cell.
  template <typename Belongs>
  std::vector<std::size_t> pieces(Belongs&& belongs) const {
    std::vector<std::size_t> sizes(map_.geometry.size(), 0);
    std::vector<bool> seen(map_.geometry.size(), false);
    for (std::size_t first = 0; first < seen.size(); ++first) {
      if (seen[first] || !belongs(first, first)) continue;
      std::vector<std::size_t> open{first};
      seen[first] = true;
      while (!open.empty()) {
        const std::size_t cell = open.back();
        open.pop_back();
        ++sizes[first];
        const auto width = static_cast<std::size_t>(map_.geometry.width);
        for (const std::size_t next : {cell - width, cell - 1, cell + 1, cell + width}) {
          if (next >= seen.size() || seen[next] || !belongs(next, cell)) continue;
          seen[next] = true;
          open.push_back(next);
        }
      }
    }
    return sizes;
  }

  bench::LargeMap building_;
  std::vector<LogOdds> cells_;
  GridView<const LogOdds> map_;
  RoomMap rooms_;
};

TEST_P(RoomLawsTest, ThereAreAboutAsManyAsThereAreKnownRooms) {
  std::size_t known = 0;
  for (std::int32_t y = 0; y < 4; ++y) {
    for (std::int32_t x = 0; x < 4; ++x) known += building_.is_known({x, y}) ? 1U : 0U;
  }
  EXPECT_GE(rooms_.rooms.size(), known);
  EXPECT_LE(rooms_.rooms.size(), 16u);
}

TEST_P(RoomLawsTest, EachIsOnePiece) {
  const auto& labels = rooms_.labels;
  const auto same = [&](std::size_t to, std::size_t from) {
    return labels[to] != kNoRoom && labels[to] == labels[from];
  };
  const std::vector<std::size_t> sizes = pieces(same);
  std::vector<int> pieces_of(rooms_.rooms.size() + 1, 0);
  for (std::size_t i = 0; i < sizes.size(); ++i) pieces_of[labels[i]] += sizes[i] > 0 ? 1 : 0;
  for (const Room& room : rooms_.rooms) EXPECT_EQ(pieces_of[room.label], 1) << room.label;
}

TEST_P(RoomLawsTest, EveryFreeCellIsInOneUnlessItsPieceOfFloorIsTooSmall) {
  const auto least = static_cast<std::size_t>(RoomParams{}.least_area / (0.05 * 0.05));
  const auto is_floor = [&](std::size_t to, std::size_t) {
    return map_.cells[to] <= kFreeLogOdds || rooms_.labels[to] != kNoRoom;
  };
  const std::vector<std::size_t> sizes = pieces(is_floor);
  std::size_t missing = 0;
  std::size_t small = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    missing += map_.cells[i] <= kFreeLogOdds && rooms_.labels[i] == kNoRoom ? 1U : 0U;
    small += sizes[i] < least ? sizes[i] : 0U;
  }
  EXPECT_EQ(missing, small);
}

TEST_P(RoomLawsTest, AreasAndBoundsAreThoseOfTheirCells) {
  std::vector<std::size_t> cells(rooms_.rooms.size() + 1, 0);
  std::vector<CellRect> bounds(cells.size());
  for (std::int32_t y = 0; y < map_.geometry.height; ++y) {
    for (std::int32_t x = 0; x < map_.geometry.width; ++x) {
      const RoomLabel label = rooms_.view()[{x, y}];
      ASSERT_LE(label, rooms_.rooms.size());
      ++cells[label];
      bounds[label] = bounding(bounds[label], {{x, y}, {x + 1, y + 1}});
    }
  }
  for (std::size_t i = 0; i < rooms_.rooms.size(); ++i) {
    const Room& room = rooms_.rooms[i];
    EXPECT_EQ(room.label, i + 1);
    EXPECT_NEAR(room.area, static_cast<double>(cells[room.label]) * 0.0025, 1e-9);
    EXPECT_GE(room.area, RoomParams{}.least_area);
    EXPECT_EQ(room.bounds, bounds[room.label]);
    EXPECT_LE(room.area, rooms_.rooms[i == 0 ? 0 : i - 1].area);
  }
}

TEST_P(RoomLawsTest, CentersAreOnFreeFloorOfTheirRooms) {
  for (const Room& room : rooms_.rooms) {
    const CellIndex cell = map_.geometry.cell_at(room.center);
    EXPECT_EQ(rooms_.view()[cell], room.label);
    EXPECT_LE(map_[cell], kFreeLogOdds);
  }
}

TEST_P(RoomLawsTest, DoorwaysAreWhereRoomsTouch) {
  std::set<std::pair<RoomLabel, RoomLabel>> touching;
  for (std::int32_t y = 0; y + 1 < map_.geometry.height; ++y) {
    for (std::int32_t x = 0; x + 1 < map_.geometry.width; ++x) {
      const RoomLabel here = rooms_.view()[{x, y}];
      for (const RoomLabel there : {rooms_.view()[{x + 1, y}], rooms_.view()[{x, y + 1}]}) {
        if (here != kNoRoom && there != kNoRoom && here != there) touching.insert(std::minmax(here, there));
      }
    }
  }
  std::set<std::pair<RoomLabel, RoomLabel>> told;
  for (const Doorway& door : rooms_.doorways) {
    told.emplace(door.first, door.second);
    EXPECT_LT(door.first, door.second);
    EXPECT_GT(door.width, 0.0);
    EXPECT_LE(door.width, RoomParams{}.widest_opening);
    const RoomLabel label = rooms_.view()[map_.geometry.cell_at(door.center)];
    EXPECT_TRUE(label == door.first || label == door.second);
  }
  EXPECT_EQ(told, touching);
  EXPECT_EQ(told.size(), rooms_.doorways.size());
}

TEST_P(RoomLawsTest, TheSameMapHasTheSameRooms) {
  EXPECT_EQ(split_into_rooms(map_), rooms_);
}

TEST_P(RoomLawsTest, ATurnedMapHasTheSameRooms) {
  const std::int32_t side = map_.geometry.width;
  std::vector<LogOdds> turned(cells_.size());
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) turned[map_.geometry.index({side - 1 - y, x})] = map_[{x, y}];
  }
  const RoomMap other = split_into_rooms({map_.geometry, turned.data()});
  ASSERT_EQ(other.rooms.size(), rooms_.rooms.size());
  // In a doorway of an odd number of cells, the middle ones may go either way.
  std::size_t moved = 0;
  for (std::int32_t y = 0; y < side; ++y) {
    for (std::int32_t x = 0; x < side; ++x) {
      const RoomLabel here = rooms_.view()[{x, y}];
      const RoomLabel there = other.view()[{side - 1 - y, x}];
      moved += (here == kNoRoom) != (there == kNoRoom) ? 1000U : 0U;
      if (here == kNoRoom || there == kNoRoom) continue;
      const Room& room = rooms_.rooms[here - 1U];
      const CellIndex center = map_.geometry.cell_at(room.center);
      moved += other.view()[{side - 1 - center.y, center.x}] != there ? 1U : 0U;
    }
  }
  EXPECT_LE(moved, 60 * rooms_.doorways.size());
}

INSTANTIATE_TEST_SUITE_P(Seeds, RoomLawsTest, testing::Range(0, 4));

}  // namespace
}  // namespace scrubjay

/// \file
/// The rooms of the worlds that come with scrubjay, and of real plans where they are at hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/mapping/rooms.hpp>
#include <scrubjay/world/score.hpp>
#include <set>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;
constexpr double kBurgerRadius = 0.105;  // of a Burger, which knows the floor below tables

/// What a robot would map that senses everything, and its rooms.
struct MappedWorld {
  GridGeometry geometry;
  std::vector<LogOdds> cells;
  RoomMap rooms;
};

MappedWorld mapped(const World& world, const Pose2& start) {
  const GroundTruth truth = ground_truth(world, start, kBurgerRadius, 0.05);
  MappedWorld map{truth.geometry, {}, {}};
  for (const GroundTruth::Cell& cell : truth.cells) {
    map.cells.push_back(cell.wall ? kMaxLogOdds : cell.reachable ? LogOdds{-kMaxLogOdds} : LogOdds{0});
  }
  map.rooms = split_into_rooms({map.geometry, map.cells.data()});
  return map;
}

/// A world of ours, and places in it, together where a person would call it one room.
struct ExpectedRooms {
  std::string name;
  std::vector<std::vector<Point2>> rooms;
};

class WorldRoomsTest : public testing::TestWithParam<ExpectedRooms> {};

TEST_P(WorldRoomsTest, AreThoseThatAPersonWouldCount) {
  const World world = read_world(fs::path(SCRUBJAY_SOURCE_DIR) / "worlds" / (GetParam().name + ".yaml"));
  const MappedWorld map = mapped(world, *world.start);
  EXPECT_EQ(map.rooms.rooms.size(), GetParam().rooms.size());
  std::set<RoomLabel> seen;
  for (const std::vector<Point2>& places : GetParam().rooms) {
    std::set<RoomLabel> labels;
    for (const Point2& place : places) {
      const CellIndex cell = map.geometry.cell_at(inverse(*world.start) * place);
      ASSERT_TRUE(map.geometry.contains(cell));
      labels.insert(map.rooms.view()[cell]);
    }
    EXPECT_EQ(labels.size(), 1u) << "around " << places[0].transpose();
    EXPECT_TRUE(seen.insert(*labels.begin()).second) << "around " << places[0].transpose();
  }
  EXPECT_EQ(seen.count(kNoRoom), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Worlds, WorldRoomsTest,
    testing::Values(ExpectedRooms{"room", {{{1, 2.7}, {3, 0.5}}}},
                    // The way into the room behind is long, and no wider than the door at its end: it belongs to both.
                    ExpectedRooms{"reactive_trap", {{{1, 1.5}, {2.75, 0.7}, {5, 1.2}}}},
                    ExpectedRooms{"corridor_flat",
                                  {{{5, 3.5}, {0.5, 3.5}, {10.2, 3.5}},
                                   {{2.4, 2}},
                                   {{5.4, 1.5}},
                                   {{9, 1.5}},
                                   {{3, 5}},
                                   {{6, 5}},
                                   {{9, 5.5}}}},
                    ExpectedRooms{"apartment", {{{1, 3.3}, {3.5, 5.5}, {4.2, 1}}, {{6, 4.6}}, {{5.3, 1.5}}}},
                    ExpectedRooms{"cluttered_flat", {{{1.9, 3.7}, {3.6, 1.5}, {0.5, 1.5}}, {{6, 3.8}, {6.3, 1}}}},
                    // The living room is open to the hall, whose south end lies behind a shoe rack.
                    ExpectedRooms{"family_house",
                                  {{{3.5, 2}, {1.2, 4}, {5.7, 4}},
                                   {{5.7, 1}},
                                   {{3.8, 6.5}, {1, 7}},
                                   {{7.2, 2}, {10.5, 2}},
                                   {{9, 4.8}, {7, 4.8}},
                                   {{8.5, 7}}}},
                    // And here it is to the long hall.
                    ExpectedRooms{"large_house",
                                  {{{3, 6}, {15, 6}, {9.5, 8}},
                                   {{1.5, 4}},
                                   {{2.5, 1.2}},
                                   {{6, 4.3}, {8, 2}},
                                   {{10, 3}},
                                   {{13, 4.4}},
                                   {{16, 4.3}, {16, 1}},
                                   {{2, 8}},
                                   {{5.5, 8}},
                                   {{13, 7.4}},
                                   {{12.7, 10.7}},
                                   {{16, 9}}}}),
    [](const auto& test) { return test.param.name; });

/// The number of rooms that a plan was drawn with, open ones and parts beyond doors too narrow among them.
std::size_t rooms_drawn(const fs::path& plan) {
  std::ifstream file(plan);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string name = "\"room_num\":";
  return std::stoul(text.substr(text.find(name) + name.size()));
}

TEST(RealPlanRoomsTest, NoPlanIsCutIntoMoreRoomsThanItWasDrawnWithAndMostIntoManyOfThem) {
  const fs::path folder = fs::path(SCRUBJAY_SHARED_DATA) / "houseexpo";
  if (!fs::exists(folder)) GTEST_SKIP() << "no floor plans here";
  std::size_t drawn = 0;
  std::size_t found = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    const World world = read_world(entry.path());
    const std::size_t rooms = mapped(world, starting_pose(world, kBurgerRadius)).rooms.rooms.size();
    EXPECT_GE(rooms, 1u) << world.name;
    EXPECT_LE(rooms, rooms_drawn(entry.path())) << world.name;
    drawn += rooms_drawn(entry.path());
    found += rooms;
  }
  EXPECT_GT(2 * found, drawn) << found << " of " << drawn;
}

}  // namespace
}  // namespace scrubjay

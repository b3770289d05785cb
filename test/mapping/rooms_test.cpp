#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mapping/floor_plan.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/rooms.hpp>

namespace scrubjay {
namespace {

using test::FloorPlan;

RoomMap rooms_of(const FloorPlan& plan, const RoomParams& params = {}) {
  return split_into_rooms(plan.view(), params);
}
std::size_t count(const FloorPlan& plan) {
  return rooms_of(plan).rooms.size();
}
RoomLabel label_at(const RoomMap& rooms, double x, double y) {
  return rooms.view()[rooms.geometry.cell_at({x, y})];
}

/// 4 x 3 m on the left, 3 x 3 m on the right, and a wall of 10 cm between.
FloorPlan two_rooms() {
  return FloorPlan(7.5, 3.4).carve(0.2, 0.2, 4.2, 3.2).carve(4.3, 0.2, 7.3, 3.2);
}
FloorPlan two_rooms_with_gap(double width) {
  return two_rooms().carve(4.2, 1.0, 4.3, 1.0 + width);
}

TEST(RoomsTest, AreNoneWhereNothingIsFree) {
  EXPECT_TRUE(rooms_of(FloorPlan(3.0, 3.0)).rooms.empty());
  const FloorPlan unknown = FloorPlan(3.0, 3.0).forget(0.0, 0.0, 3.0, 3.0);
  EXPECT_EQ(rooms_of(unknown).labels, std::vector<RoomLabel>(60 * 60, kNoRoom));
  EXPECT_TRUE(split_into_rooms({}, {}).labels.empty());
}

TEST(RoomsTest, EndAtADoor) {
  const RoomMap rooms = rooms_of(two_rooms_with_gap(0.85));
  ASSERT_EQ(rooms.rooms.size(), 2u);
  EXPECT_EQ(label_at(rooms, 0.3, 0.3), 1);
  EXPECT_EQ(label_at(rooms, 4.1, 3.1), 1);
  EXPECT_EQ(label_at(rooms, 4.4, 0.3), 2);
  EXPECT_EQ(label_at(rooms, 7.2, 3.1), 2);
  EXPECT_EQ(label_at(rooms, 0.1, 0.1), kNoRoom);
  EXPECT_NEAR(rooms.rooms[0].area, 12.0, 0.1);
  EXPECT_NEAR(rooms.rooms[1].area, 9.0, 0.1);
  EXPECT_NEAR(rooms.rooms[0].area + rooms.rooms[1].area, 21.085, 1e-9);
}

TEST(RoomsTest, TellTheDoorwayBetweenThem) {
  const RoomMap rooms = rooms_of(two_rooms_with_gap(0.85));
  ASSERT_EQ(rooms.doorways.size(), 1u);
  const Doorway& door = rooms.doorways[0];
  EXPECT_EQ(door.first, 1);
  EXPECT_EQ(door.second, 2);
  EXPECT_NEAR(door.width, 0.85, 0.05);
  EXPECT_NEAR(door.center.x(), 4.25, 0.05);
  EXPECT_NEAR(door.center.y(), 1.425, 0.05);
}

TEST(RoomsTest, EndAtDoorsOfAllWidths) {
  for (const double width : {0.3, 0.5, 0.7, 0.8, 0.9, 1.0, 1.1})
    EXPECT_EQ(count(two_rooms_with_gap(width)), 2u) << width;
  EXPECT_EQ(rooms_of(two_rooms()).doorways.size(), 0u);
}

TEST(RoomsTest, EndAtAnOpeningUnlessItIsHardlyNarrowerThanThey) {
  EXPECT_EQ(count(two_rooms_with_gap(1.5)), 2u);
  EXPECT_EQ(count(two_rooms_with_gap(1.95)), 1u);
  EXPECT_EQ(count(FloorPlan(10.0, 6.0).carve(0.2, 0.2, 9.8, 5.8).block(5.0, 0.2, 5.1, 2.0)), 1u) << "an open plan";
}

TEST(RoomsTest, KeepTheirNichesAndBends) {
  EXPECT_EQ(count(FloorPlan(6.0, 6.0).carve(0.2, 0.2, 5.8, 2.2).carve(0.2, 0.2, 2.7, 5.8)), 1u) << "an L";
  EXPECT_EQ(count(FloorPlan(6.0, 6.0).carve(0.2, 0.2, 5.8, 1.4).carve(2.4, 0.2, 3.6, 5.8)), 1u) << "a T";
  EXPECT_EQ(count(FloorPlan(6.0, 6.0).carve(0.2, 0.2, 5.8, 4.2).carve(3.0, 4.2, 4.0, 5.0)), 1u) << "a niche";
}

TEST(RoomsTest, ACorridorIsOneAndSoIsEachRoomBesideIt) {
  FloorPlan plan(9.8, 7.2);
  plan.carve(0.2, 3.0, 9.6, 4.2);
  for (const double left : {0.2, 3.4, 6.6}) {
    plan.carve(left, 0.2, left + 3.0, 2.9).carve(left + 1.0, 2.9, left + 1.85, 3.0);
    plan.carve(left, 4.3, left + 3.0, 7.0).carve(left + 1.2, 4.2, left + 2.1, 4.3);
  }
  const RoomMap rooms = rooms_of(plan);
  ASSERT_EQ(rooms.rooms.size(), 7u);
  EXPECT_EQ(rooms.doorways.size(), 6u);
  EXPECT_EQ(label_at(rooms, 0.3, 3.6), label_at(rooms, 9.5, 3.6));
  EXPECT_EQ(label_at(rooms, 0.3, 3.6), 1);
}

TEST(RoomsTest, ACorridorThatIsNarrowerInTheMiddleIsOne) {
  const FloorPlan plan = FloorPlan(9.0, 1.8).carve(0.2, 0.2, 8.8, 1.6).block(3.0, 1.25, 6.0, 1.6);
  EXPECT_EQ(count(plan), 1u);
}

TEST(RoomsTest, AreNotCutByABed) {
  // Both ways around it are as narrow as a door, and longer than a wall is thick.
  FloorPlan plan = FloorPlan(5.0, 4.0).carve(0.2, 0.2, 4.8, 3.8).block(1.6, 0.9, 3.5, 3.8);
  EXPECT_EQ(count(plan), 1u);
  plan.block(0.2, 3.0, 0.7, 3.8).block(4.3, 0.2, 4.8, 0.6);
  EXPECT_EQ(count(plan), 1u);
}

TEST(RoomsTest, AreNotCutByWhatStandsFree) {
  // Gaps of 0.9 m on both sides of an armchair, which a lidar saw all around.
  const FloorPlan plan =
      FloorPlan(5.2, 3.2).carve(0.2, 0.2, 5.0, 3.0).block(2.2, 1.1, 3.2, 2.1).forget(2.3, 1.2, 3.1, 2.0);
  const RoomMap rooms = rooms_of(plan);
  ASSERT_EQ(rooms.rooms.size(), 1u);
  EXPECT_EQ(label_at(rooms, 2.7, 1.6), 1) << "it is part of the room";
  EXPECT_NEAR(rooms.rooms[0].area, 4.8 * 2.8, 1e-9);
}

TEST(RoomsTest, AreNotCutByChairsAndTables) {
  FloorPlan plan = FloorPlan(5.0, 4.0).carve(0.2, 0.2, 4.8, 3.8);
  for (const double x : {1.5, 1.9, 2.3, 2.7}) {
    for (const double y : {0.5, 0.9, 1.4, 1.8, 2.4, 2.8, 3.3}) plan.block(x, y, x + 0.05, y + 0.05);
  }
  EXPECT_EQ(count(plan), 1u);
}

TEST(RoomsTest, AWallWithHolesIsAWall) {
  FloorPlan plan = two_rooms_with_gap(0.8);
  for (const double y : {0.4, 0.6, 1.9, 2.1, 2.3, 2.5, 2.9}) plan.carve(4.2, y, 4.3, y + 0.1);
  EXPECT_EQ(count(plan), 2u);
}

TEST(RoomsTest, DontSufferFromSpecks) {
  FloorPlan plan = two_rooms_with_gap(0.85);
  Random random(3);
  for (std::size_t i = 0; i < plan.view().geometry.size(); ++i) {
    LogOdds& cell = plan.view().cells[i];
    const double draw = random.uniform();
    if (cell == FloorPlan::kFloor && draw < 0.005) cell = draw < 0.003 ? LogOdds{0} : FloorPlan::kSolid;
  }
  EXPECT_EQ(rooms_of(plan).rooms.size(), 2u);
}

TEST(RoomsTest, TakeInSliversAndLeaveOutSpots) {
  // Seen through a crack, a fan of floor outside; and a spot that nothing leads to.
  FloorPlan plan = FloorPlan(8.0, 5.0).carve(0.2, 0.2, 4.2, 3.2).carve(4.2, 1.0, 4.4, 1.2).carve(4.4, 0.6, 5.6, 1.6);
  plan.carve(6.5, 3.0, 7.5, 4.5);
  const RoomMap rooms = rooms_of(plan);
  ASSERT_EQ(rooms.rooms.size(), 1u);
  EXPECT_EQ(label_at(rooms, 5.0, 1.1), 1);
  EXPECT_EQ(label_at(rooms, 7.0, 4.0), kNoRoom);
  EXPECT_NEAR(rooms.rooms[0].area, 12.0 + 0.04 + 1.2, 1e-9);
}

TEST(RoomsTest, AreNoneInTwoClosetsThatAreTooSmallTogether) {
  EXPECT_EQ(count(FloorPlan(3.0, 1.3).carve(0.2, 0.2, 1.1, 1.1).carve(1.2, 0.2, 2.1, 1.1).carve(1.1, 0.4, 1.2, 0.8)),
            0u);
}

TEST(RoomsTest, MayBeAsSmallAsAThing) {
  RoomParams params;
  params.least_area = 0.5;
  const RoomMap rooms = rooms_of(FloorPlan(1.0, 1.0).carve(0.0, 0.0, 1.0, 1.0), params);
  ASSERT_EQ(rooms.rooms.size(), 1u);
  EXPECT_NEAR(rooms.rooms[0].area, 1.0, 1e-9);
}

TEST(RoomsTest, EndWhereTheMapDoes) {
  // The room behind the door was only seen through it.
  FloorPlan plan = two_rooms_with_gap(0.85).forget(5.5, 0.0, 7.5, 3.4).forget(4.3, 2.4, 7.5, 3.4);
  EXPECT_EQ(count(plan), 2u);
  // Floor up to the border of the map is as much of a room.
  EXPECT_EQ(count(FloorPlan(3.0, 2.0).carve(0.0, 0.0, 3.0, 2.0)), 1u);
}

TEST(RoomsTest, HaveTheirCenterInTheirMiddle) {
  const RoomMap box = rooms_of(FloorPlan(7.5, 3.4).carve(0.2, 0.2, 4.2, 3.2));
  EXPECT_LT((box.rooms.at(0).center - Point2(2.2, 1.7)).norm(), 0.05);
  EXPECT_EQ(box.rooms[0].bounds, (CellRect{{4, 4}, {84, 64}}));
  // Between the arms of a U there is none of its floor.
  const RoomMap bent = rooms_of(FloorPlan(6.0, 6.0).carve(0.2, 0.2, 5.8, 5.8).block(2.0, 1.8, 4.0, 5.8));
  EXPECT_EQ(label_at(bent, bent.rooms.at(0).center.x(), bent.rooms[0].center.y()), 1);
  EXPECT_NE(label_at(bent, 3.0, 3.0), 1);
}

TEST(RoomsTest, AreTheSameInAMapThatGrew) {
  const FloorPlan plan = two_rooms_with_gap(0.85);
  const RoomMap before = rooms_of(plan);
  FloorPlan larger(12.0, 9.0);
  larger.forget(0.0, 0.0, 12.0, 9.0);
  const CellIndex shift{37, 21};
  for (std::int32_t y = 0; y < plan.view().geometry.height; ++y) {
    for (std::int32_t x = 0; x < plan.view().geometry.width; ++x) {
      larger.view()[{x + shift.x, y + shift.y}] = plan.view()[{x, y}];
    }
  }
  const RoomMap after = rooms_of(larger);
  ASSERT_EQ(after.rooms.size(), before.rooms.size());
  for (std::int32_t y = 0; y < plan.view().geometry.height; ++y) {
    for (std::int32_t x = 0; x < plan.view().geometry.width; ++x) {
      ASSERT_EQ((after.view()[{x + shift.x, y + shift.y}]), (before.view()[{x, y}]));
    }
  }
}

TEST(RoomsTest, HangOnMetresAndNotOnCells) {
  for (const double resolution : {0.01, 0.025, 0.1}) {
    FloorPlan plan(7.5, 3.4, resolution);
    plan.carve(0.2, 0.2, 4.2, 3.2).carve(4.3, 0.2, 7.3, 3.2).carve(4.2, 1.0, 4.3, 1.8);
    EXPECT_EQ(count(plan), 2u) << resolution;
  }
}

TEST(RoomsTest, AreRefusedWhereThereAreMoreThanLabels) {
  FloorPlan plan(25.65, 25.65);
  for (std::int32_t y = 0; y < 256; ++y) {
    for (std::int32_t x = 0; x < 256; ++x) plan.view()[{2 * x + 1, 2 * y + 1}] = FloorPlan::kFloor;
  }
  RoomParams params;
  params.least_area = 0.0;
  params.largest_thing = 0.0;
  EXPECT_THROW(rooms_of(plan, params), Error);
  plan.view()[{1, 1}] = FloorPlan::kSolid;
  EXPECT_EQ(rooms_of(plan, params).rooms.size(), 65535u);
}

}  // namespace
}  // namespace scrubjay

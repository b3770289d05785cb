#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mapping/floor_plan.hpp>
#include <scrubjay/messages/room_markers.hpp>

namespace scrubjay::ros {
namespace {

using testing::SizeIs;

const Header kRoomsHeader{{12, 34}, "map"};

/// A room of 4 x 3 m with a corner cut off, a door, and one of 3 x 3 m.
RoomMap two_rooms() {
  test::FloorPlan plan(7.5, 3.4);
  plan.carve(0.2, 0.2, 4.2, 3.2).carve(4.3, 0.2, 7.3, 3.2).carve(4.2, 1.0, 4.3, 1.8).block(0.2, 2.2, 1.2, 3.2);
  return split_into_rooms(plan.view());
}

/// Of triangles that run counter-clockwise; negative for others.
double area_of(const std::vector<Point>& corners) {
  double area = 0.0;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Point& a = corners[i];
    const Point& b = corners[i + 1];
    const Point& c = corners[i + 2];
    area += 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
  }
  return area;
}

TEST(RoomMarkersTest, TakeAwayWhatWasShownBefore) {
  const MarkerArray none = room_markers(kRoomsHeader, RoomMap{});
  ASSERT_THAT(none.markers, SizeIs(1));
  EXPECT_EQ(none.markers[0].action, Marker::kDeleteAll);
  EXPECT_EQ(room_markers(kRoomsHeader, two_rooms()).markers.at(0), none.markers[0]);
}

TEST(RoomMarkersTest, ShowTheFloorOfEachRoom) {
  const RoomMap rooms = two_rooms();
  const MarkerArray message = room_markers(kRoomsHeader, rooms);
  ASSERT_THAT(message.markers, SizeIs(5));
  for (const Room& room : rooms.rooms) {
    const Marker& floor = message.markers[room.label];
    EXPECT_EQ(floor.header, kRoomsHeader);
    EXPECT_EQ(floor.ns, "rooms");
    EXPECT_EQ(floor.id, room.label);
    EXPECT_EQ(floor.type, Marker::kTriangleList);
    EXPECT_EQ(floor.scale, (Vector3{1.0, 1.0, 1.0}));
    EXPECT_NEAR(area_of(floor.points), room.area, 1e-9);
    for (const Point& corner : floor.points) {
      EXPECT_GE(corner.x, rooms.geometry.origin.x() + room.bounds.low.x * 0.05 - 1e-9);
      EXPECT_LE(corner.y, rooms.geometry.origin.y() + room.bounds.high.y * 0.05 + 1e-9);
    }
  }
  EXPECT_NE(message.markers[1].color, message.markers[2].color);
}

TEST(RoomMarkersTest, AreOfFewTriangles) {
  const MarkerArray message = room_markers(kRoomsHeader, two_rooms());
  // Rectangles: below and beside the corner that is cut off, and what belongs to the doorway.
  EXPECT_LE(message.markers[1].points.size() + message.markers[2].points.size(), 8u * 6u);
}

TEST(RoomMarkersTest, NameEachRoomAtItsCenter) {
  const RoomMap rooms = two_rooms();
  const MarkerArray message = room_markers(kRoomsHeader, rooms);
  const Marker& label = message.markers.at(3);
  EXPECT_EQ(label.ns, "room_labels");
  EXPECT_EQ(label.id, 1);
  EXPECT_EQ(label.type, Marker::kTextViewFacing);
  EXPECT_EQ(label.text, "1: 11.0 m2");
  EXPECT_EQ(label.pose.position.x, rooms.rooms[0].center.x());
  EXPECT_EQ(label.pose.position.y, rooms.rooms[0].center.y());
  EXPECT_GT(label.scale.z, 0.0);
}

}  // namespace
}  // namespace scrubjay::ros

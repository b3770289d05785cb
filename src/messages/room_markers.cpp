#include <array>
#include <charconv>
#include <scrubjay/messages/room_markers.hpp>
#include <string>
#include <string_view>

namespace scrubjay::ros {
namespace {

constexpr double kFloorHeight = 0.01;  // so that it doesn't flicker where the map is [m]
constexpr double kLabelHeight = 0.1;   // above the floor [m]
constexpr double kLetterHeight = 0.3;  // [m]
constexpr float kOpacity = 0.4F;

constexpr std::array<ColorRGBA, 12> kColors{{{0.90F, 0.10F, 0.29F, 1.0F},
                                             {0.24F, 0.71F, 0.29F, 1.0F},
                                             {0.00F, 0.51F, 0.78F, 1.0F},
                                             {1.00F, 0.88F, 0.10F, 1.0F},
                                             {0.57F, 0.12F, 0.71F, 1.0F},
                                             {0.96F, 0.51F, 0.19F, 1.0F},
                                             {0.27F, 0.94F, 0.94F, 1.0F},
                                             {0.94F, 0.20F, 0.90F, 1.0F},
                                             {0.67F, 0.43F, 0.16F, 1.0F},
                                             {0.00F, 0.50F, 0.50F, 1.0F},
                                             {0.82F, 0.96F, 0.24F, 1.0F},
                                             {0.50F, 0.00F, 0.00F, 1.0F}}};

/// A rectangle of one room's cells.
struct Tile {
  RoomLabel label = kNoRoom;
  CellRect cells{};
};

/// All cells of rooms as few tiles: runs of rows, those on top of each other together where they begin and end alike.
std::vector<Tile> tiles_of(const RoomMap& rooms) {
  const std::int32_t width = rooms.geometry.width;
  std::vector<Tile> tiles;
  std::vector<std::size_t> below(static_cast<std::size_t>(width));  // by where it begins: tile of the row below
  for (std::int32_t y = 0; y < rooms.geometry.height; ++y) {
    const RoomLabel* row = rooms.labels.data() + rooms.geometry.index({0, y});
    for (std::int32_t begin = 0; begin < width;) {
      std::int32_t end = begin + 1;
      while (end < width && row[end] == row[begin]) ++end;
      if (row[begin] != kNoRoom) {
        std::size_t& at = below[static_cast<std::size_t>(begin)];
        const bool goes_on = at < tiles.size() && tiles[at].label == row[begin] && tiles[at].cells.low.x == begin &&
                             tiles[at].cells.high == CellIndex{end, y};
        if (goes_on) {
          tiles[at].cells.high.y = y + 1;
        } else {
          at = tiles.size();
          tiles.push_back({row[begin], {{begin, y}, {end, y + 1}}});
        }
      }
      begin = end;
    }
  }
  return tiles;
}

Marker marker(const Header& header, std::string_view name, const Room& room, std::int32_t type) {
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.id = room.label;
  marker.type = type;
  marker.action = Marker::kAdd;
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker floor_marker(const Header& header, const Room& room) {
  Marker floor = marker(header, "rooms", room, Marker::kTriangleList);
  floor.pose.position.z = kFloorHeight;
  floor.scale = {1.0, 1.0, 1.0};
  floor.color = room_color(room.label);
  floor.color.a = kOpacity;
  return floor;
}

Marker label_marker(const Header& header, const Room& room) {
  Marker label = marker(header, "room_labels", room, Marker::kTextViewFacing);
  label.pose.position = {room.center.x(), room.center.y(), kLabelHeight};
  label.scale = {0.0, 0.0, kLetterHeight};
  label.color = {1.0F, 1.0F, 1.0F, 1.0F};
  std::array<char, 32> area{};
  const char* const end = std::to_chars(area.begin(), area.end(), room.area, std::chars_format::fixed, 1).ptr;
  label.text = std::to_string(room.label).append(": ").append(std::string_view(area.data(), end)).append(" m2");
  return label;
}

/// Two triangles, counter-clockwise from above.
void add_tile(Marker& floor, const GridGeometry& grid, const CellRect& cells) {
  const Point2 low = grid.origin + grid.resolution * Point2(cells.low.x, cells.low.y);
  const Point2 high = grid.origin + grid.resolution * Point2(cells.high.x, cells.high.y);
  const std::array<Point, 4> corners{
      {{low.x(), low.y(), 0.0}, {high.x(), low.y(), 0.0}, {high.x(), high.y(), 0.0}, {low.x(), high.y(), 0.0}}};
  for (const std::size_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) floor.points.push_back(corners[corner]);
}

}  // namespace

ColorRGBA room_color(RoomLabel label) {
  return kColors[(label - 1U) % kColors.size()];
}

MarkerArray room_markers(const Header& header, const RoomMap& rooms) {
  MarkerArray message;
  Marker clear;
  clear.header = header;
  clear.action = Marker::kDeleteAll;
  clear.pose.orientation.w = 1.0;
  message.markers.push_back(clear);
  for (const Room& room : rooms.rooms) message.markers.push_back(floor_marker(header, room));
  for (const Tile& tile : tiles_of(rooms)) add_tile(message.markers[tile.label], rooms.geometry, tile.cells);
  for (const Room& room : rooms.rooms) message.markers.push_back(label_marker(header, room));
  return message;
}

}  // namespace scrubjay::ros

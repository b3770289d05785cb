/// \file
/// `scrubjay rooms MAP`: the rooms of a map, as a table and a picture.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/map_picture.hpp>
#include <scrubjay/mapping/rooms.hpp>
#include <scrubjay/world/score.hpp>

#include "commands.hpp"

namespace scrubjay::apps {
namespace {

struct RoomsFlags {
  std::string map;
  std::optional<std::string> out;
  bool json = false;
};

/// Evidence for what each cell is taken for, as in `trinary`.
std::vector<LogOdds> evidence_of(const OccupancyGrid& map) {
  std::vector<LogOdds> cells;
  cells.reserve(map.cells.size());
  for (const Occupancy cell : map.cells) {
    const bool free = cell >= kFree && cell <= kFreeUpTo;
    cells.push_back(free ? LogOdds{-kMaxLogOdds} : cell >= kOccupiedFrom ? kMaxLogOdds : LogOdds{0});
  }
  return cells;
}

/// The rooms that one gets to from a room, by their labels.
std::vector<RoomLabel> beside(const RoomMap& rooms, RoomLabel label) {
  std::vector<RoomLabel> others;
  for (const Doorway& door : rooms.doorways) {
    if (door.first == label) others.push_back(door.second);
    if (door.second == label) others.push_back(door.first);
  }
  return others;
}

void print_json(const RoomMap& rooms) {
  auto list = nlohmann::ordered_json::array();
  for (const Room& room : rooms.rooms) {
    list.push_back(
        {{"room", room.label}, {"area", room.area}, {"center", {{"x", room.center.x()}, {"y", room.center.y()}}}});
  }
  auto doors = nlohmann::ordered_json::array();
  for (const Doorway& door : rooms.doorways) {
    doors.push_back({{"rooms", {door.first, door.second}},
                     {"center", {{"x", door.center.x()}, {"y", door.center.y()}}},
                     {"width", door.width}});
  }
  fmt::print("{}\n", nlohmann::ordered_json{{"rooms", list}, {"doorways", doors}}.dump(2));
}

void print_table(const RoomMap& rooms) {
  double area = 0.0;
  for (const Room& room : rooms.rooms) {
    const std::vector<RoomLabel> others = beside(rooms, room.label);
    fmt::print("room {:<4}{:7.1f} m2  around ({:.2f}, {:.2f}){}{}\n", room.label, room.area, room.center.x(),
               room.center.y(), others.empty() ? "" : ", leads to ", fmt::join(others, ", "));
    area += room.area;
  }
  fmt::print("{:<9}{:7.1f} m2\n", "in all", area);
}

void list_rooms(const RoomsFlags& flags) {
  std::vector<std::string> warnings;
  const OccupancyGrid map = read_map(flags.map, &warnings);
  for (const std::string& warning : warnings) fmt::print(stderr, "scrubjay: {}\n", warning);
  const std::vector<LogOdds> cells = evidence_of(map);
  MapPicture picture;
  picture.rooms = split_into_rooms({map.geometry, cells.data()});
  if (flags.out) {
    picture.map = map.view();
    picture.title = std::filesystem::path(flags.map).stem().string();
    const std::vector<std::uint8_t> png = encode_png(draw_map(picture));
    write_file_atomically(*flags.out, std::as_bytes(std::span(png)));
  }
  if (flags.json) return print_json(picture.rooms);
  print_table(picture.rooms);
  if (flags.out) fmt::print("picture: {}\n", *flags.out);
}

}  // namespace

void add_rooms(CLI::App& app) {
  CLI::App* command = app.add_subcommand("rooms", "Split a map into rooms");
  const auto flags = std::make_shared<RoomsFlags>();
  command->add_option("MAP", flags->map, "map YAML")->required();
  command->add_option("--out", flags->out, "PNG to write: each room in a colour of its own");
  command->add_flag("--json", flags->json, "print rooms and doorways as JSON");
  command->callback([flags] { list_rooms(*flags); });
}

}  // namespace scrubjay::apps

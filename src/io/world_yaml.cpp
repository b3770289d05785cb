#include <scrubjay/io/world_reader.hpp>

#include "world_formats.hpp"

namespace scrubjay {
namespace {

constexpr NumberRange kCoordinate{-kWorldExtent, kWorldExtent, false, "a number of metres within +-1000"};
constexpr NumberRange kLength{0.0, kWorldExtent, true, "a positive length in metres"};
constexpr NumberRange kTurn{-100.0, 100.0, false, "an angle in radians"};
constexpr NumberRange kShare{0.0, 1.0, false, "a share from 0 to 1"};
constexpr NumberRange kLevel{1.0, 255.0, false, "a level from 1 to 255"};

double optional_yaw(const YamlField& field) {
  return field.has("yaw") ? WorldShapes::angle(field.at("yaw")) : 0.0;
}

Point2 size_of(const YamlField& field) {
  const std::vector<double> size = field.numbers(2, kLength, "two lengths in metres, [along, across]");
  return {size[0], size[1]};
}

Polygon read_box(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"center", "size", "yaw"});
  return box(shapes.point(field.at("center")), size_of(field.at("size")), optional_yaw(field));
}

Polygon read_disc(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"center", "radius"});
  return disc(shapes.point(field.at("center")), WorldShapes::length(field.at("radius")));
}

/// Four round legs, their centres at the corners of a rectangle.
std::vector<Polygon> read_legs(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"center", "size", "yaw", "radius"});
  const double radius = WorldShapes::length(field.at("radius"));
  std::vector<Polygon> legs;
  for (const Point2& corner : box(shapes.point(field.at("center")), size_of(field.at("size")), optional_yaw(field))) {
    legs.push_back(disc(corner, radius, 8));
  }
  return legs;
}

std::vector<Polygon> read_parts(const YamlField& field, std::string_view shape, WorldShapes& shapes) {
  if (shape == "box") return {read_box(field, shapes)};
  if (shape == "disc") return {read_disc(field, shapes)};
  if (shape == "legs") return read_legs(field, shapes);
  return {shapes.points(field, 3)};
}

Furniture read_furniture(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"name", "box", "disc", "polygon", "legs"});
  Furniture furniture;
  furniture.name = field.has("name") ? field.at("name").text() : "furniture";
  int shape_count = 0;
  for (const std::string_view shape : {"box", "disc", "polygon", "legs"}) {
    if (!field.has(shape)) continue;
    ++shape_count;
    furniture.parts = read_parts(field.at(shape), shape, shapes);
  }
  if (shape_count != 1) field.fail("exactly one of box, disc, polygon and legs");
  return furniture;
}

double read_wall_thickness(const YamlField& root) {
  if (!root.has("wall_thickness")) return 0.0;
  return root.at("wall_thickness").number({0.0, 1.0, false, "a thickness from 0 to 1 m"});
}

Wall read_wall(const YamlField& field, double thickness, WorldShapes& shapes) {
  const std::vector<Point2> line = shapes.points(field, 2);
  const bool closed = line.front() == line.back();
  return thickness > 0.0 && !closed ? thick_wall(line, thickness) : Wall{line};
}

Door read_door(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"from", "to", "open"});
  return {{shapes.point(field.at("from")), shapes.point(field.at("to"))},
          !field.has("open") || field.at("open").boolean()};
}

Polygon read_cliff(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"polygon"});
  return shapes.points(field.at("polygon"), 3);
}

Carpet read_carpet(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"polygon", "slip"});
  return {shapes.points(field.at("polygon"), 3), field.at("slip").number(kShare)};
}

DirtSpot read_dirt(const YamlField& field, WorldShapes& shapes) {
  field.expect_keys({"center", "radius", "level"});
  DirtSpot spot;
  spot.center = shapes.point(field.at("center"));
  spot.radius = WorldShapes::length(field.at("radius"));
  if (field.has("level")) spot.level = static_cast<std::uint8_t>(field.at("level").number(kLevel));
  return spot;
}

VirtualWall read_virtual_wall(const YamlField& field) {
  field.expect_keys({"pose", "range", "half_angle"});
  VirtualWall wall;
  wall.pose = WorldShapes::pose(field.at("pose"));
  if (field.has("range")) wall.range = WorldShapes::length(field.at("range"));
  if (field.has("half_angle")) wall.half_angle = WorldShapes::angle(field.at("half_angle"));
  return wall;
}

}  // namespace

Point2 WorldShapes::point(const YamlField& field) {
  if (++count_ > kMaxWorldPoints) field.fail("no more than a million points in a world");
  const std::vector<double> xy = field.numbers(2, kCoordinate, "a point, [x, y] in metres");
  return {xy[0], xy[1]};
}

std::vector<Point2> WorldShapes::points(const YamlField& field, std::size_t least) {
  std::vector<Point2> points;
  for (const YamlField& item : field.items()) points.push_back(point(item));
  if (points.size() < least) field.fail("at least " + std::to_string(least) + " points");
  return points;
}

Pose2 WorldShapes::pose(const YamlField& field) {
  const std::vector<double> values = field.numbers(3, kCoordinate, "a pose, [x, y, yaw] in metres and radians");
  return {values[0], values[1], wrap_angle(values[2])};
}

double WorldShapes::length(const YamlField& field) {
  return field.number(kLength);
}
double WorldShapes::angle(const YamlField& field) {
  return field.number(kTurn);
}

World world_from_yaml(const YamlField& root) {
  root.expect_keys({"name", "wall_thickness", "walls", "furniture", "doors", "cliffs", "carpets", "dirt",
                    "virtual_walls", "dock", "start"});
  WorldShapes shapes;
  World world;
  if (root.has("name")) world.name = root.at("name").text();
  const double thickness = read_wall_thickness(root);
  for (const YamlField& field : root.items_of("walls")) world.walls.push_back(read_wall(field, thickness, shapes));
  for (const YamlField& field : root.items_of("furniture")) world.furniture.push_back(read_furniture(field, shapes));
  for (const YamlField& field : root.items_of("doors")) world.doors.push_back(read_door(field, shapes));
  for (const YamlField& field : root.items_of("cliffs")) world.cliffs.push_back(read_cliff(field, shapes));
  for (const YamlField& field : root.items_of("carpets")) world.carpets.push_back(read_carpet(field, shapes));
  for (const YamlField& field : root.items_of("dirt")) world.dirt.push_back(read_dirt(field, shapes));
  for (const YamlField& field : root.items_of("virtual_walls")) world.virtual_walls.push_back(read_virtual_wall(field));
  if (root.has("dock")) {
    const YamlField dock = root.at("dock");
    dock.expect_keys({"pose"});
    world.dock = Dock{WorldShapes::pose(dock.at("pose"))};
  }
  if (root.has("start")) world.start = WorldShapes::pose(root.at("start"));
  return world;
}

}  // namespace scrubjay

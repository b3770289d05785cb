/// \file
/// `scrubjay render FILE`: a picture of a map or a world.
#include <fmt/format.h>

#include <memory>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/file_kind.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/map_picture.hpp>
#include <scrubjay/io/run_files.hpp>
#include <scrubjay/io/trajectory_file.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "commands.hpp"
#include "run_options.hpp"

namespace scrubjay::apps {
namespace {

struct RenderFlags {
  std::string file;
  std::optional<std::string> trajectory;
  std::optional<std::string> world;
  std::string start = "0,0,0";
  std::string out = "map.png";
};

void render(const RenderFlags& flags) {
  MapPicture picture;
  OccupancyGrid map;
  map.geometry.width = map.geometry.height = 1;
  map.cells = {kUnknown};
  std::optional<World> world;
  const Pose2 start = parse_pose(flags.start, "--start");
  if (file_kind(flags.file) == FileKind::MapYaml) {
    std::vector<std::string> warnings;
    map = read_map(flags.file, &warnings);
    for (const std::string& warning : warnings) fmt::print(stderr, "scrubjay: {}\n", warning);
  } else {
    world = read_world(flags.file);
  }
  if (flags.world) world = read_world(*flags.world);
  if (world) {
    picture.true_walls = walls_in_map(*world, start);
    if (world->dock) picture.dock = inverse(start) * world->dock->pose;
    if (world->start) picture.start = inverse(start) * *world->start;
  }
  picture.map = map.view();
  if (flags.trajectory) {
    for (const StampedPose& point : read_trajectory(*flags.trajectory)) picture.trajectory.push_back(point.pose);
    if (!picture.trajectory.empty()) {
      picture.start = picture.trajectory.front();
      picture.robot = picture.trajectory.back();
    }
  }
  picture.title = std::filesystem::path(flags.file).stem().string();
  const std::vector<std::uint8_t> png = encode_png(draw_map(picture));
  write_file_atomically(flags.out, std::as_bytes(std::span(png)));
  fmt::print("picture: {}\n", flags.out);
}

}  // namespace

void add_render(CLI::App& app) {
  CLI::App* command = app.add_subcommand("render", "Draw a map or a world as PNG");
  const auto flags = std::make_shared<RenderFlags>();
  command->add_option("FILE", flags->file, "map YAML, world, HouseExpo plan")->required();
  command->add_option("--trajectory", flags->trajectory, "TUM trajectory to draw into it");
  command->add_option("--world", flags->world, "true walls to draw behind a map");
  command->add_option("--start", flags->start, "x,y,theta of the map's origin in the world (0,0,0)");
  command->add_option("--out", flags->out, "PNG to write (map.png)");
  command->callback([flags] { render(*flags); });
}

}  // namespace scrubjay::apps

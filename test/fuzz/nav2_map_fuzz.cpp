/// \file
/// Any YAML beside a small picture is a map that makes a world, or is refused with an Error of one line.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <scrubjay/error.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/world_reader.hpp>

namespace {

/// A folder with a picture in it, as long as the process runs.
class MapFolder {
 public:
  MapFolder() : path_(std::filesystem::temp_directory_path() / ("nav2_map_fuzz." + std::to_string(getpid()))) {
    std::filesystem::create_directory(path_);
    std::ofstream(path_ / "map.pgm", std::ios::binary) << "P2 3 2 255\n254 0 205\n254 254 254\n";
  }
  ~MapFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  static const MapFolder folder;
  const std::filesystem::path yaml = folder / "map.yaml";
  std::ofstream(yaml, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    const OccupancyGrid map = read_map(yaml);
    if (map.geometry.width != 3 || map.geometry.height != 2 || map.cells.size() != 6) std::abort();
    for (const Wall& wall : world_from_map(map).walls) {
      if (wall.points.front() != wall.points.back()) std::abort();
    }
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>

#include "file_content.hpp"
#include "map_cells.hpp"

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kModeNames{"trinary", "scale", "raw"};

/// A map's YAML file, field by field.
class MapYaml {
 public:
  explicit MapYaml(const fs::path& path) : path_(path) {
    const std::vector<std::uint8_t> text = read_file(path);
    try {
      root_ = YAML::Load(std::string(text.begin(), text.end()));
    } catch (const YAML::Exception& e) {
      throw Error(fmt::format("{}:{}: broken YAML: {}", path_.string(), e.mark.line + 1, e.msg));
    }
    if (!root_.IsMap()) throw Error(fmt::format("{}:1: not a map file: want fields such as image", path_.string()));
  }

  fs::path image() const {
    const std::string name = required("image").as<std::string>("");
    if (name.empty()) fail("image", "is empty; want the name of a PGM or PNG file");
    const char* home = std::getenv("HOME");
    if (name.starts_with("~/") && home != nullptr) return fs::path(home) / name.substr(2);
    return path_.parent_path() / name;
  }

  double resolution() const {
    const double value = number(required("resolution"), "resolution");
    if (value <= 0.0) fail("resolution", fmt::format("is {}; want a positive length in metres", value));
    return value;
  }

  Point2 origin() const {
    const YAML::Node node = required("origin");
    if (!node.IsSequence() || node.size() != 3) fail("origin", "is not three numbers; want [x, y, yaw]");
    const double yaw = number(node[2], "origin");
    if (yaw != 0.0) {
      fail("origin", fmt::format("has a yaw of {}; turned maps can't be read, want 0: turn the image instead", yaw));
    }
    return {number(node[0], "origin"), number(node[1], "origin")};
  }

  MapPixels pixels() const {
    return {mode(), negate(), number(required("free_thresh"), "free_thresh"),
            number(required("occupied_thresh"), "occupied_thresh")};
  }

  std::string place(const std::string& field) const {
    const YAML::Node node = root_[field];
    return fmt::format("{}:{}: field {}", path_.string(), node ? node.Mark().line + 1 : 1, field);
  }

 private:
  [[noreturn]] void fail(const std::string& field, const std::string& what) const {
    throw Error(fmt::format("{} {}", place(field), what));
  }

  YAML::Node required(const std::string& field) const {
    const YAML::Node node = root_[field];
    if (!node) throw Error(fmt::format("{}:1: field {} is missing", path_.string(), field));
    return node;
  }

  double number(const YAML::Node& node, const std::string& field) const {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
      fail(field, fmt::format("is {}; want a number", node.IsScalar() ? node.Scalar() : "not a number"));
    }
    return value;
  }

  MapMode mode() const {
    if (!root_["mode"]) return MapMode::Trinary;
    const std::string name = root_["mode"].as<std::string>("");
    const auto* found = std::find(kModeNames.begin(), kModeNames.end(), name);
    if (found == kModeNames.end()) fail("mode", fmt::format("is '{}'; want trinary, scale or raw", name));
    return static_cast<MapMode>(found - kModeNames.begin());
  }

  bool negate() const {
    const YAML::Node node = required("negate");
    int count = 0;
    if (YAML::convert<int>::decode(node, count)) return count != 0;
    bool flag = false;
    if (!YAML::convert<bool>::decode(node, flag))
      fail("negate", "is neither a whole number nor a boolean; want 0 or 1");
    return flag;
  }

  fs::path path_;
  YAML::Node root_;
};

/// Says where the file likely means something else than its author believes.
void add_warnings(const MapYaml& yaml, const MapPixels& pixels, const Image& image,
                  std::vector<std::string>& warnings) {
  if (pixels.mode == MapMode::Raw) return;
  constexpr std::uint8_t kUnknownGrey = 205;
  const Image grey = to_grey(image);
  bool has_unknown_grey = false;
  for (std::size_t i = 0; i < grey.pixels.size(); i += static_cast<std::size_t>(grey.channels)) {
    has_unknown_grey = has_unknown_grey || grey.pixels[i] == kUnknownGrey;
  }
  if (has_unknown_grey && darkness(kUnknownGrey, pixels.negate) <= pixels.free_thresh) {
    warnings.push_back(
        fmt::format("{} is {}: grey 205, which map savers write for unknown, is read as free; want 0.196",
                    yaml.place("free_thresh"), pixels.free_thresh));
  }
  if (pixels.free_thresh > pixels.occupied_thresh) {
    warnings.push_back(
        fmt::format("{} is {}, above occupied_thresh: what is both free and occupied is read as occupied",
                    yaml.place("free_thresh"), pixels.free_thresh));
  }
}

/// As many decimals as it takes to read back the same number, three or more.
std::string decimal(double value) {
  for (int decimals = 3; decimals <= 17; ++decimals) {
    std::string text = fmt::format("{:.{}f}", value + 0.0, decimals);  // + 0.0 makes -0 a plain 0
    if (std::strtod(text.c_str(), nullptr) == value) return text;
  }
  return fmt::format("{}", value);
}

/// A file name as a YAML scalar, quoted where it has to be.
std::string yaml_scalar(const std::string& name) {
  const auto plain = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.'; };
  if (std::all_of(name.begin(), name.end(), plain)) return name;
  std::string quoted = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string yaml_text(const std::string& image, const GridGeometry& geometry, MapMode mode) {
  // Scale spans all greys, so that every value reads back as it was.
  const bool scale = mode == MapMode::Scale;
  return fmt::format(
      "image: {}\nmode: {}\nresolution: {}\norigin: [{}, {}, 0]\nnegate: 0\noccupied_thresh: {}\nfree_thresh: {}\n",
      yaml_scalar(image), kModeNames[static_cast<std::size_t>(mode)], decimal(geometry.resolution),
      decimal(geometry.origin.x()), decimal(geometry.origin.y()), scale ? "1.0" : "0.65", scale ? "0.0" : "0.196");
}

}  // namespace

OccupancyGrid read_map(const fs::path& path, std::vector<std::string>* warnings) {
  const MapYaml yaml(path);
  const MapPixels pixels = yaml.pixels();
  const double resolution = yaml.resolution();
  const Point2 origin = yaml.origin();
  const Image image = read_image(yaml.image());
  if (warnings != nullptr) add_warnings(yaml, pixels, image, *warnings);
  return {{resolution, origin, image.width, image.height}, cells_from_image(image, pixels)};
}

void add_map(AtomicFiles& files, const fs::path& stem, GridView<const Occupancy> map, MapMode mode) {
  const auto with = [&](const char* extension) { return fs::path(stem.string() + extension); };
  const fs::path image_path = with(mode == MapMode::Scale ? ".png" : ".pgm");
  if (map.geometry.width <= 0 || map.geometry.height <= 0) {
    throw Error(fmt::format("{}: a map without cells can't be written", image_path.string()), Error::Kind::Failure);
  }
  const Image image = image_from_cells(map, mode);
  const std::vector<std::uint8_t> bytes = mode == MapMode::Scale ? encode_png(image) : encode_pgm(image);
  files.add(image_path, std::as_bytes(std::span(bytes)));
  files.add(with(".yaml"), yaml_text(image_path.filename().string(), map.geometry, mode));
}

void write_map(const fs::path& stem, GridView<const Occupancy> map, MapMode mode) {
  AtomicFiles files;
  add_map(files, stem, map, mode);
  files.commit();
}

}  // namespace scrubjay

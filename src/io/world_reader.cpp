#include <scrubjay/error.hpp>
#include <scrubjay/io/map_file.hpp>
#include <scrubjay/io/world_reader.hpp>

#include "file_content.hpp"
#include "world_formats.hpp"

namespace scrubjay {
namespace {

bool is_picture(std::string_view text) {
  return text.starts_with("P2") || text.starts_with("P5") || text.starts_with("\x89PNG");
}

YamlField parse_document(std::string_view text, const std::string& file) {
  if (is_picture(text)) throw Error(file + ": is a picture; want the YAML file of its map");
  if (text.size() > kMaxWorldText) {
    throw Error(file + ": holds " + std::to_string(text.size()) + " bytes; want a world of at most 16 MiB");
  }
  YamlField root = YamlField::parse(std::string(text), file);
  if (!root.is_map()) root.fail("a world: fields such as walls, furniture and start");
  return root;
}

World world_from_document(const YamlField& root) {
  return root.has("verts") ? world_from_houseexpo(root) : world_from_yaml(root);
}

}  // namespace

World parse_world(std::string_view text, const std::string& file) {
  return world_from_document(parse_document(text, file));
}

World read_world(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> content = read_file(path);
  const std::string text(content.begin(), content.end());
  const YamlField root = parse_document(text, path.string());
  World world = root.has("image") ? world_from_map(read_map(path)) : world_from_document(root);
  if (world.name.empty()) world.name = path.stem().string();
  return world;
}

}  // namespace scrubjay

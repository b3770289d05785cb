#include <scrubjay/error.hpp>
#include <scrubjay/io/relations_file.hpp>

#include "file_content.hpp"
#include "gzip.hpp"
#include "text_lines.hpp"

namespace scrubjay {

std::vector<Relation> parse_relations(std::span<const std::uint8_t> file, const std::string& name) {
  const std::string text = unpacked(file, name);
  TextLines lines(text, name);
  std::vector<Relation> relations;
  while (auto line = lines.next()) {
    Relation relation;
    relation.from = line->number("t1");
    relation.to = line->number("t2");
    relation.motion.x = line->number("x");
    relation.motion.y = line->number("y");
    for (const char* dropped : {"z", "roll", "pitch"}) line->number(dropped);
    relation.motion.yaw = wrap_angle(line->number("yaw"));
    if (!line->word().empty()) line->fail("more than eight numbers; want t1 t2 x y z roll pitch yaw");
    relations.push_back(relation);
  }
  if (relations.empty()) throw Error(name + ": no relations; want lines of t1 t2 x y z roll pitch yaw");
  return relations;
}

std::vector<Relation> read_relations(const std::filesystem::path& path) {
  return parse_relations(read_file(path), path.string());
}

}  // namespace scrubjay

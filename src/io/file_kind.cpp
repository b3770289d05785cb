#include <algorithm>
#include <array>
#include <fstream>
#include <scrubjay/io/file_kind.hpp>
#include <string>

#include "file_content.hpp"
#include "gzip.hpp"

namespace scrubjay {
namespace {

bool has_key(std::string_view text, std::string_view key) {
  for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    const bool begins_line = at == 0 || text[at - 1] == '\n';
    if (begins_line && at + key.size() < text.size() && text[at + key.size()] == ':') return true;
  }
  return false;
}

/// A line that begins with this word.
bool has_record(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const bool begins_line = at == 0 || text[at - 1] == '\n';
    if (begins_line && at + word.size() < text.size() && text[at + word.size()] == ' ') return true;
  }
  return false;
}

/// Bags are large: only their first bytes are looked at.
bool is_bag(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return true;
  std::array<char, 16> begin{};
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), begin.size());
  const std::string_view text(begin.data(), begin.size());
  return text.starts_with("\x89MCAP0\r\n") || text.starts_with("SQLite format 3");
}

bool is_trajectory(std::string_view text) {
  while (text.starts_with('#')) text.remove_prefix(std::min(text.size(), text.find('\n') + 1));
  const std::string_view line = text.substr(0, text.find('\n'));
  return std::count(line.begin(), line.end(), ' ') == 7 && line.find_first_not_of("0123456789.eE+- ") == line.npos;
}

}  // namespace

std::string_view to_string(FileKind kind) {
  switch (kind) {
    case FileKind::Recording:
      return "recording";
    case FileKind::World:
      return "world";
    case FileKind::HouseExpoPlan:
      return "HouseExpo plan";
    case FileKind::MapYaml:
      return "map";
    case FileKind::Scenario:
      return "scenario";
    case FileKind::Image:
      return "image";
    case FileKind::Urdf:
      return "URDF robot";
    case FileKind::Trajectory:
      return "trajectory";
    case FileKind::CarmenLog:
      return "CARMEN log";
    case FileKind::Octomap:
      return "OctoMap tree";
    case FileKind::Calibration:
      return "calibration";
    case FileKind::Bag:
      return "bag";
    case FileKind::Unknown:
      return "unknown";
  }
  return "";
}

FileKind file_kind(const std::filesystem::path& path) {
  if (is_bag(path)) return FileKind::Bag;
  const std::vector<std::uint8_t> file = read_file(path);
  std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  std::string content;
  if (text.starts_with("\x1f\x8b")) text = content = unpacked(file, path.string());
  if (text.starts_with("\x89OILOG")) return FileKind::Recording;
  if (text.starts_with("\x89PNG") || text.starts_with("P5") || text.starts_with("P2")) return FileKind::Image;
  if (text.starts_with("# Octomap OcTree binary file")) return FileKind::Octomap;
  if (has_record(text, "FLASER")) return FileKind::CarmenLog;
  if (text.find("<robot") != text.npos) return FileKind::Urdf;
  if (text.find("\"verts\"") != text.npos) return FileKind::HouseExpoPlan;
  if (has_key(text, "image")) return FileKind::MapYaml;
  if (has_key(text, "walls")) return FileKind::World;
  if (has_key(text, "axle") && has_key(text, "left") && has_key(text, "right")) return FileKind::Calibration;
  if (has_key(text, "strategy") || has_key(text, "world")) return FileKind::Scenario;
  if (is_trajectory(text)) return FileKind::Trajectory;
  return FileKind::Unknown;
}

}  // namespace scrubjay

#include "architecture/include_checker.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include "architecture/rooms.hpp"

namespace scrubjay::architecture {
namespace {

constexpr std::string_view kPublicRoot = "include/scrubjay/";

/// The part of `path` before its first slash; empty if there is none.
std::string first_folder(std::string_view path) {
  const std::size_t slash = path.find('/');
  return std::string(slash == std::string_view::npos ? "" : path.substr(0, slash));
}

/// The room whose header an include names; empty for one of the root, of third parties or of the standard library.
std::string included_room(const std::string& header) {
  constexpr std::string_view ours = "scrubjay/";
  if (header.starts_with(ours)) return first_folder(std::string_view(header).substr(ours.size()));
  const std::string folder = first_folder(header);
  return house().contains(folder) ? folder : "";
}

const ThirdParty* find_third_party(const std::string& header) {
  const auto found = std::find_if(third_parties().begin(), third_parties().end(),
                                  [&](const ThirdParty& party) { return header.starts_with(party.prefix); });
  return found == third_parties().end() ? nullptr : &*found;
}

bool is_standard(const std::string& header) {
  return header.find_first_of("./") == std::string::npos;
}

/// A header of the including file's own folder; in apps, of a folder below it.
bool is_own(const std::string& room, const std::string& header, bool quoted) {
  return quoted && header.ends_with(".hpp") && (room == "apps" || header.find('/') == std::string::npos);
}

/// Where an include stands.
struct Site {
  std::string room;
  bool is_public = false;
  bool is_c = false;

  bool core() const { return house().contains(room) && is_core(house().at(room)); }
};

std::string check_third_party(const Site& site, const std::string& header, const ThirdParty& party) {
  if (party.public_too) return "";
  if (site.is_public) return "<" + header + "> in a public header; want it in a source file";
  const bool allowed = party.rooms.empty() ? !site.core() : party.rooms.contains(site.room);
  return allowed ? "" : "<" + header + "> may not be included in " + site.room;
}

std::string check_arrow(const Site& site, const std::string& header, const std::string& target) {
  if (!house().contains(target)) return "<" + header + "> names no room that there is";
  if (target == site.room) return "";
  const auto room = house().find(site.room);
  if (room != house().end() && room->second.may_use.contains(target)) return "";
  return (site.room.empty() ? "the root" : site.room) + " may not use " + target + " (<" + header + ">)";
}

std::string check_standard(const Site& site, const std::string& header) {
  if (!site.core() || core_standard_headers().contains(header)) return "";
  return "<" + header + "> is not for the core, which has no heap, clock, file or thread";
}

/// What is wrong with including `header`; empty if nothing is.
std::string check_include(const Site& site, const std::string& header, bool quoted) {
  if (header.find("..") != std::string::npos) return "\"" + header + "\" climbs out of its folder; want its full path";
  if (site.is_c) return c_headers().contains(header) ? "" : "<" + header + "> is not for C firmware";
  if (header == kCHeader) return site.room == kCHeaderRoom ? "" : "<" + header + "> is for firmware in C";
  if (root_headers().contains(header)) return site.core() ? "the core may not use the hosted <" + header + ">" : "";
  if (const std::string target = included_room(header); !target.empty()) return check_arrow(site, header, target);
  if (const ThirdParty* party = find_third_party(header)) return check_third_party(site, header, *party);
  if (is_standard(header)) return check_standard(site, header);
  if (system_headers().contains(header)) {
    return site.core() || site.is_public ? "<" + header + "> belongs into source files above the core" : "";
  }
  if (is_own(site.room, header, quoted)) return "";
  return "<" + header + "> is of nobody that test/architecture/rooms.hpp knows";
}

bool has_line(std::string_view text, std::string_view wanted) {
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (line == wanted) return true;
  }
  return false;
}

}  // namespace

std::string room_of(std::string_view path) {
  if (path.starts_with(kPublicRoot)) return first_folder(path.substr(kPublicRoot.size()));
  if (path.starts_with("src/")) return first_folder(path.substr(4));
  return path.starts_with("apps/") ? "apps" : "";
}

Violations check_source(std::string_view path, std::string_view text) {
  Violations violations;
  const Site site{room_of(path), path.starts_with(kPublicRoot), path.ends_with(".h")};
  if (!site.room.empty() && !house().contains(site.room)) {
    violations.push_back(std::string(path) + ": " + site.room + " is no room that there is");
  }
  if (path.ends_with(".hpp") || path.ends_with(".h")) {
    if (!has_line(text, "#pragma once")) violations.push_back(std::string(path) + ": no `#pragma once`");
    if (!has_line(text, "/// \\file")) violations.push_back(std::string(path) + ": no `/// \\file` that says its idea");
  }

  static const std::regex include(R"re(^\s*#\s*include\s*(<([^>]+)>|"([^"]+)"|.*).*)re");
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::smatch match;
    if (!std::regex_match(line, match, include)) continue;
    const std::string header = match[2].str() + match[3].str();
    const std::string wrong =
        header.empty() ? "an include that names no header" : check_include(site, header, match[3].matched);
    if (wrong.empty()) continue;
    violations.push_back(std::string(path) + ":" + std::to_string(number) + ": " + wrong);
  }
  return violations;
}

Violations check_cmake(std::string_view path, std::string_view text) {
  const std::string where(path);
  const std::string room = room_of(path);
  if (!house().contains(room)) return {where + ": " + room + " is no room that there is"};

  const std::string uncommented = std::regex_replace(std::string(text), std::regex("#[^\n]*"), "");
  static const std::regex call(R"re(scrubjay_library\s*\(([^)]*)\))re");
  std::smatch match;
  if (!std::regex_search(uncommented, match, call)) return {where + ": no scrubjay_library(" + room + " ...)"};

  Violations violations;
  std::istringstream words(match[1].str());
  std::string word;
  words >> word;
  if (word != room) violations.push_back(where + ": makes " + word + "; want " + room);
  bool core = false;
  std::string section;
  while (words >> word) {
    if (word == "CORE") {
      core = true;
    } else if (word == "SOURCES" || word == "USES" || word == "LINKS") {
      section = word;
    } else if (section == "USES" && !house().at(room).may_use.contains(word)) {
      violations.push_back(where + ": " + room + " may not use " + word);
    }
  }
  if (core != is_core(house().at(room))) {
    violations.push_back(where + (core ? ": CORE, above the core" : ": a room of the core without CORE"));
  }
  return violations;
}

}  // namespace scrubjay::architecture

/// \file
/// The house as docs/architecture.md draws it, restated by hand: who stands on which floor and may use whom.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace scrubjay::architecture {

using Rooms = std::set<std::string>;

struct Room {
  int floor = 0;  ///< arrows never point to a higher one
  Rooms may_use;  ///< the room itself aside
};

inline bool is_core(const Room& room) {
  return room.floor == 0;
}

/// Room by folder name.
inline const std::map<std::string, Room>& house() {
  static const Rooms core{"geometry", "oi", "odometry", "grid", "robot", "behavior"};
  const auto with_core = [](Rooms rooms) {
    rooms.insert(core.begin(), core.end());
    return rooms;
  };
  static const Rooms below_mission =
      with_core({"mapping", "planning", "localization", "exploration", "coverage", "world"});
  const auto with_mission = [](Rooms rooms) {
    rooms.insert(below_mission.begin(), below_mission.end());
    rooms.insert("mission");
    return rooms;
  };
  static const std::map<std::string, Room> rooms{
      {"geometry", {0, {}}},
      {"oi", {0, {}}},
      {"odometry", {0, {"geometry"}}},
      {"grid", {0, {"geometry", "robot"}}},
      {"robot", {0, {"oi", "odometry", "geometry"}}},
      {"behavior", {0, {"robot", "grid", "geometry", "odometry"}}},
      {"embedded", {0, {"behavior", "grid", "robot", "odometry", "oi", "geometry"}}},
      {"mapping", {1, core}},
      {"planning", {1, core}},
      {"localization", {1, with_core({"mapping"})}},
      {"exploration", {2, with_core({"mapping", "planning"})}},
      {"coverage", {2, with_core({"mapping", "planning"})}},
      {"world", {2, core}},
      {"simulation", {3, with_core({"world"})}},
      {"mission", {3, below_mission}},
      {"messages", {4, with_mission({})}},
      {"io", {5, with_mission({"messages", "simulation"})}},
      {"ros2", {5, with_mission({"messages"})}},
      {"apps", {6, with_mission({"messages", "simulation", "io", "ros2"})}},
  };
  return rooms;
}

/// Headers in no room; every room above the core may use them, and they use no room.
inline const std::set<std::string>& root_headers() {
  static const std::set<std::string> headers{"scrubjay/error.hpp", "scrubjay/finding.hpp", "scrubjay/nearest_word.hpp"};
  return headers;
}

/// The core's face for C, a root header too: one room makes it, and nobody else needs it.
inline constexpr const char* kCHeader = "scrubjay/scrubjay_c.h";
inline constexpr const char* kCHeaderRoom = "embedded";

/// Headers of C that it may include.
inline const std::set<std::string>& c_headers() {
  static const std::set<std::string> headers{"stddef.h", "stdint.h"};
  return headers;
}

/// Where a third party's headers may be included; never in a public header, unless `public_too`.
struct ThirdParty {
  std::string prefix;       ///< of the header's path as included
  Rooms rooms;              ///< empty: every room above the core
  bool public_too = false;  ///< in every room, the core's and public headers too
};

inline const std::vector<ThirdParty>& third_parties() {
  static const std::vector<ThirdParty> parties{
      {"Eigen/", {}, true},       {"fmt/", {}},           {"box2d/", {"simulation"}},
      {"urdf_", {"io"}},          {"urdf/", {"io"}},      {"console_bridge/", {"io"}},
      {"yaml-cpp/", {"io"}},      {"png.h", {"io"}},      {"zlib.h", {"io"}},
      {"octomap/", {"io"}},       {"sqlite3.h", {"io"}},  {"nlohmann/", {"io", "apps"}},
      {"zstd.h", {"io"}},         {"lz4frame.h", {"io"}}, {"CLI/", {"apps"}},
      {"fastcdr/", {"messages"}}, {"fastdds/", {"ros2"}}, {"fastrtps/", {"ros2"}},
  };
  return parties;
}

/// Standard headers that hold in the core: nothing that allocates, throws, or reaches a clock, a file or a thread.
inline const std::set<std::string>& core_standard_headers() {
  static const std::set<std::string> headers{
      "algorithm",   "array",   "bit",      "cassert",     "cfloat",   "charconv", "climits",
      "cmath",       "compare", "concepts", "cstddef",     "cstdint",  "cstring",  "initializer_list",
      "iterator",    "limits",  "numbers",  "numeric",     "optional", "ranges",   "span",
      "string_view", "tuple",   "utility",  "type_traits", "variant",  "version",
  };
  return headers;
}

/// Headers of the operating system: in sources above the core, where they touch files, ports and signals.
inline const std::set<std::string>& system_headers() {
  static const std::set<std::string> headers{
      "asm/termbits.h", "dirent.h",       "fcntl.h",     "grp.h",       "poll.h",       "pty.h",
      "pwd.h",          "sched.h",        "signal.h",    "spawn.h",     "termios.h",    "time.h",
      "unistd.h",       "linux/serial.h", "sys/file.h",  "sys/ioctl.h", "sys/mman.h",   "sys/resource.h",
      "sys/stat.h",     "sys/statvfs.h",  "sys/types.h", "sys/wait.h",  "netinet/in.h", "sys/socket.h",
  };
  return headers;
}

}  // namespace scrubjay::architecture

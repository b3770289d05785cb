/// \file
/// Checks one file of the tree, given as text, against the house.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::architecture {

/// One line each: `path:line: what is wrong`.
using Violations = std::vector<std::string>;

/// The room that a file belongs to by its path in the tree (`include/scrubjay/<room>/…`, `src/<room>/…`, `apps/…`);
/// empty for what lives in no room, such as `include/scrubjay/error.hpp`.
std::string room_of(std::string_view path);

/// Arrows, third parties, standard headers of the core, and the form of headers. `path` is relative to the tree.
Violations check_source(std::string_view path, std::string_view text);

/// The room's name, CORE and USES of `src/<room>/CMakeLists.txt`.
Violations check_cmake(std::string_view path, std::string_view text);

}  // namespace scrubjay::architecture

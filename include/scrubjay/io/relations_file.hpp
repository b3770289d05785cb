/// \file
/// Relative poses for judging trajectories, as the SLAM benchmark of Freiburg's university keeps them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <scrubjay/world/relation_error.hpp>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// Reads `t1 t2 x y z roll pitch yaw`, a relation a line, plain or packed with gzip; height and tilt are dropped.
/// Throws Error with file, line and field; also if there is none.
std::vector<Relation> read_relations(const std::filesystem::path& path);
/// The same from memory; `name` stands in the errors.
std::vector<Relation> parse_relations(std::span<const std::uint8_t> file, const std::string& name);

}  // namespace scrubjay

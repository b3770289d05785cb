/// \file
/// What an MCAP file consists of, found by stepping from record to record.
///
/// A summary isn't relied on for what the records themselves say: it may be missing, and a wrong one leads nowhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mcap_piece.hpp"
#include "mcap_source.hpp"
#include "mcap_topics.hpp"

namespace scrubjay::mcap {

struct Layout {
  std::vector<Piece> pieces;              ///< in the order of the file
  std::string library;                    ///< that wrote it
  std::optional<std::uint64_t> messages;  ///< as many as the summary says
  bool ended = false;                     ///< by a footer, with nothing behind it
  bool has_summary = false;               ///< whose checksum is right, if it has one
  bool damaged = false;                   ///< a checksum is wrong
  bool channels_known = false;            ///< the topics are complete, before any piece was read
};

/// Steps through the file, and takes the schemas and channels that aren't in chunks. Throws Error, with `name`, if it
/// is no MCAP file, or packed in a way that we don't know.
Layout scan(const Source& source, const std::string& name, Topics& topics);

}  // namespace scrubjay::mcap

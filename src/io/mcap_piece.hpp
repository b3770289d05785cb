/// \file
/// The data of an MCAP file, piece by piece.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mcap_format.hpp"
#include "mcap_packing.hpp"
#include "mcap_source.hpp"
#include "mcap_topics.hpp"

namespace scrubjay::mcap {

/// Where records are that are read in one go: a chunk's, or some that stand one behind the other without a chunk.
struct Piece {
  std::uint64_t position = 0;  ///< of the first byte of the records, packed
  std::uint64_t packed = 0;    ///< bytes in the file
  std::uint64_t unpacked = 0;  ///< bytes, as many as in the file where they aren't packed
  std::string compression;
  std::uint32_t checksum = 0;  ///< of the unpacked bytes; 0 if there is none
  std::uint64_t first = 0;     ///< earliest log time, by its own account [ns]
};

/// The records of a piece; none if they are damaged, or larger than `limit`.
std::optional<Unpacked> load(const Source& source, const Piece& piece, std::size_t limit);

struct ReadMessage {
  std::uint64_t time = 0;  ///< logged at [ns]
  std::size_t topic = 0;
  std::span<const std::byte> data;
};

/// The messages of a piece, in the order of their log times.
class Messages {
 public:
  /// Takes the messages, and schemas and channels. What stands behind a record that makes no sense is left out.
  Messages(Unpacked records, Topics& topics);

  /// All that there are, those of topics left out as well.
  std::size_t count() const { return count_; }
  /// Whether anything made no sense.
  bool damaged() const { return damaged_; }
  bool done() const { return next_ == entries_.size(); }
  std::uint64_t next_time() const { return entries_[next_].time; }
  /// The next one; valid as long as this is.
  const ReadMessage& take() { return entries_[next_++]; }
  std::size_t size() const { return records_.bytes().size(); }

 private:
  bool add(const Record& record, Topics& topics);

  Unpacked records_;
  std::vector<ReadMessage> entries_;
  std::size_t count_ = 0;
  std::size_t next_ = 0;
  bool damaged_ = false;
};

}  // namespace scrubjay::mcap

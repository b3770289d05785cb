/// \file
/// The end of an MCAP file: what is in it, and where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <scrubjay/io/bag_metadata.hpp>

#include "mcap_format.hpp"

namespace scrubjay::mcap {

/// Our channels' numbers: from 1, in the order of the topics.
inline std::uint16_t channel_id(std::size_t topic) {
  return static_cast<std::uint16_t>(topic + 1);
}

/// Where summary and summary offsets begin in the file; 0 if there are none.
struct Footer {
  std::uint64_t summary = 0;
  std::uint64_t offsets = 0;
};

/// Without a checksum: each chunk has one of its own.
void put_data_end(Bytes& file);
/// Footer and the magic behind it; the end of `file`, from `summary_at` on, is what the checksum is taken of.
void put_footer(Bytes& file, const Footer& footer, std::size_t summary_at = 0);

/// Collects what the summary says.
class Summary {
 public:
  /// Both go to the `file`, too.
  void add(const Schema& schema, Bytes& file);
  void add(const Channel& channel, Bytes& file);
  /// A metadata record at `position` in the file, of `length` bytes.
  void add_metadata(std::uint64_t position, std::uint64_t length);
  /// Where the next chunk's Chunk Index record is put.
  Bytes& next_chunk_index() {
    ++chunk_count_;
    return chunk_indexes_;
  }

  /// Writes summary, summary offsets and footer to the end of `file`, whose first byte stands at `position` in the real
  /// file.
  void finish(const BagMetadata& counts, Bytes& file, std::uint64_t position) const;

 private:
  Bytes statistics(const BagMetadata& counts) const;

  Bytes schemas_;
  Bytes channels_;
  Bytes chunk_indexes_;
  Bytes metadata_indexes_;
  std::uint16_t schema_count_ = 0;
  std::uint32_t chunk_count_ = 0;
  std::uint32_t metadata_count_ = 0;
};

}  // namespace scrubjay::mcap

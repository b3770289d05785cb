/// \file
/// The chunk of an MCAP file that is being filled.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mcap_format.hpp"
#include "mcap_packing.hpp"

namespace scrubjay::mcap {

struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;  ///< logged and published at [ns]
  std::span<const std::byte> data;
};

/// Messages with the channels that they need, and where they are by channel.
class ChunkBuilder {
 public:
  void add(const Message& message);
  /// Where other records are put: schemas and channels, before their first message.
  Bytes& records() { return records_; }
  bool empty() const { return records_.empty(); }
  /// Of its records, unpacked.
  std::size_t bytes() const { return records_.size(); }

  /// Writes Chunk and Message Index records to the end of `file`, whose first byte stands at `position` in the real
  /// file, and their Chunk Index record to `chunk_indexes`. Packs with `packer` if there is one. Empty afterwards.
  void finish(Packer* packer, Bytes& file, std::uint64_t position, Bytes& chunk_indexes);

 private:
  struct Entry {
    std::uint64_t time = 0;
    std::uint64_t offset = 0;  ///< in the unpacked records
  };
  using Offsets = std::vector<std::pair<std::uint16_t, std::uint64_t>>;  ///< of Message Index records, by channel
  Offsets put_message_indexes(Writer& out, const Bytes& file, std::uint64_t position) const;

  Bytes records_;
  std::vector<std::vector<Entry>> entries_;  ///< by channel number
  std::size_t messages_ = 0;
  std::uint64_t first_ = 0;  ///< earliest message; 0 if there is none [ns]
  std::uint64_t last_ = 0;   ///< latest message [ns]
};

}  // namespace scrubjay::mcap

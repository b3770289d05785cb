/// \file
/// Replies to Query and QueryList: bare data, without ids, length or checksum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <span>

namespace scrubjay::oi {

/// Awaits one reply at a time, and knows to the byte how long it is.
///
/// Nothing in the reply says where it begins: send the query on a silent line (no stream), and after a time out call
/// `reset`, drain the line and ask again. Time is the caller's.
class QueryReader {
 public:
  explicit QueryReader(Model model) : model_(model) {}

  /// Awaits the reply to this query from now on. False, and nothing is awaited, if the model lacks a packet.
  [[nodiscard]] bool expect(const Query& query);
  [[nodiscard]] bool expect(const QueryList& query);
  /// Awaits nothing.
  void reset();

  /// Takes bytes of the reply off the front of `bytes`, and says how many. With the last one, and not before, the
  /// values go to `sensors`; those out of range leave the earlier ones in place.
  std::size_t feed(std::span<const std::uint8_t> bytes, Sensors& sensors);

  /// Bytes still to come; 0: the reply is whole, or none was expected.
  std::size_t awaited() const { return awaited_; }
  /// Values of the reply that were out of range.
  std::uint16_t rejected() const { return rejected_; }

 private:
  using Ids = decltype(QueryList::ids);

  void await(const Ids& ids);

  Model model_;
  Ids ids_;
  std::size_t next_ = 0;                 ///< index into the ids
  std::array<std::uint8_t, 80> part_{};  ///< data of that id; group 100 is the longest
  std::size_t part_size_ = 0;
  std::size_t awaited_ = 0;
  std::uint16_t rejected_ = 0;
  Sensors reply_;
};

}  // namespace scrubjay::oi

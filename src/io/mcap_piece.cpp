#include "mcap_piece.hpp"

#include <algorithm>
#include <utility>

namespace scrubjay::mcap {

std::optional<Unpacked> load(const Source& source, const Piece& piece, std::size_t limit) {
  if (piece.unpacked > limit || !plausible(piece.compression, piece.packed, piece.unpacked)) return std::nullopt;
  Unpacked packed(static_cast<std::size_t>(piece.packed));
  if (!source.read(piece.position, packed.bytes())) return std::nullopt;
  Unpacked records;
  if (piece.compression.empty()) {
    records = std::move(packed);
  } else {
    records = Unpacked(static_cast<std::size_t>(piece.unpacked));
    if (!unpack(piece.compression, packed.bytes(), records.bytes())) return std::nullopt;
  }
  if (piece.checksum != 0 && checksum(records.bytes()) != piece.checksum) return std::nullopt;
  return records;
}

Messages::Messages(Unpacked records, Topics& topics) : records_(std::move(records)) {
  std::span<const std::byte> rest = std::as_const(records_).bytes();
  while (!rest.empty() && !damaged_) {
    const std::optional<Record> record = take_record(rest);
    damaged_ = !record || !add(*record, topics);
  }
  const auto earlier = [](const ReadMessage& a, const ReadMessage& b) { return a.time < b.time; };
  if (!std::is_sorted(entries_.begin(), entries_.end(), earlier)) {
    std::stable_sort(entries_.begin(), entries_.end(), earlier);
  }
}

bool Messages::add(const Record& record, Topics& topics) {
  if (record.opcode == Opcode{}) return false;  // reserved as such
  if (record.opcode != Opcode::Message) return topics.take(record);
  Fields fields(record.content);
  const auto channel = fields.number<std::uint16_t>();
  fields.number<std::uint32_t>();  // sequence
  const auto time = fields.number<std::uint64_t>();
  fields.number<std::uint64_t>();  // published at
  if (fields.failed() || !topics.knows(channel)) return false;
  ++count_;
  if (const auto topic = topics.topic_of(channel)) entries_.push_back({time, *topic, fields.rest()});
  return true;
}

}  // namespace scrubjay::mcap

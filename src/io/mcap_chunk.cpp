#include "mcap_chunk.hpp"

#include <algorithm>

namespace scrubjay::mcap {

void ChunkBuilder::add(const Message& message) {
  first_ = messages_ == 0 ? message.time : std::min(first_, message.time);
  last_ = messages_ == 0 ? message.time : std::max(last_, message.time);
  ++messages_;
  if (entries_.size() <= message.channel) entries_.resize(message.channel + std::size_t{1});
  entries_[message.channel].push_back({message.time, records_.size()});
  Writer(records_).record(Opcode::Message, [&message](Writer& fields) {
    fields.number(message.channel).number(message.sequence).number(message.time).number(message.time);
    fields.bytes(message.data);
  });
}

void ChunkBuilder::finish(Packer* packer, Bytes& file, std::uint64_t position, Bytes& chunk_indexes) {
  const auto packed = packer != nullptr ? packer->pack(records_) : std::nullopt;
  const std::string_view compression = packed ? kZstd : std::string_view();
  const std::span<const std::byte> content = packed ? *packed : records_;
  Writer out(file);
  const std::size_t begin = file.size();
  out.record(Opcode::Chunk, [&](Writer& fields) {
    fields.number(first_).number(last_).number(std::uint64_t{records_.size()}).number(checksum(records_));
    fields.text(compression).number(std::uint64_t{content.size()}).bytes(content);
  });
  const std::size_t end = file.size();
  const Offsets offsets = put_message_indexes(out, file, position);
  Writer(chunk_indexes).record(Opcode::ChunkIndex, [&](Writer& fields) {
    fields.number(first_).number(last_).number(position + begin).number(std::uint64_t{end - begin});
    fields.sized<std::uint32_t>([&offsets](Writer& map) {
      for (const auto& [channel, offset] : offsets) map.number(channel).number(offset);
    });
    fields.number(std::uint64_t{file.size() - end}).text(compression);
    fields.number(std::uint64_t{content.size()}).number(std::uint64_t{records_.size()});
  });
  records_.clear();
  messages_ = 0;
  first_ = last_ = 0;
  for (std::vector<Entry>& entries : entries_) entries.clear();
}

ChunkBuilder::Offsets ChunkBuilder::put_message_indexes(Writer& out, const Bytes& file, std::uint64_t position) const {
  Offsets offsets;
  for (std::size_t channel = 0; channel < entries_.size(); ++channel) {
    if (entries_[channel].empty()) continue;
    const auto number = static_cast<std::uint16_t>(channel);
    offsets.emplace_back(number, position + file.size());
    out.record(Opcode::MessageIndex, [&](Writer& fields) {
      fields.number(number).sized<std::uint32_t>([&](Writer& list) {
        for (const Entry& entry : entries_[channel]) list.number(entry.time).number(entry.offset);
      });
    });
  }
  return offsets;
}

}  // namespace scrubjay::mcap

#include "mcap_summary.hpp"

#include <utility>

namespace scrubjay::mcap {

void put_data_end(Bytes& file) {
  Writer(file).record(Opcode::DataEnd, [](Writer& fields) { fields.number(std::uint32_t{0}); });
}

void put_footer(Bytes& file, const Footer& footer, std::size_t summary_at) {
  Writer out(file);
  out.number(static_cast<std::uint8_t>(Opcode::Footer)).number(std::uint64_t{kFooterSize});
  out.number(footer.summary).number(footer.offsets);
  const std::uint32_t sum = checksum(std::span(file).subspan(summary_at));
  out.number(footer.summary > 0 ? sum : std::uint32_t{0}).bytes(kMagic);
}

void Summary::add(const Schema& schema, Bytes& file) {
  ++schema_count_;
  for (Bytes* bytes : {&schemas_, &file}) {
    Writer out(*bytes);
    put(out, schema);
  }
}

void Summary::add(const Channel& channel, Bytes& file) {
  for (Bytes* bytes : {&channels_, &file}) {
    Writer out(*bytes);
    put(out, channel);
  }
}

void Summary::add_metadata(std::uint64_t position, std::uint64_t length) {
  ++metadata_count_;
  Writer(metadata_indexes_).record(Opcode::MetadataIndex, [&](Writer& fields) {
    fields.number(position).number(length).text(kMetadataName);
  });
}

Bytes Summary::statistics(const BagMetadata& counts) const {
  const bool any = counts.total > 0;
  Bytes bytes;
  Writer(bytes).record(Opcode::Statistics, [&](Writer& fields) {
    fields.number(std::uint64_t{counts.total}).number(schema_count_);
    fields.number(static_cast<std::uint32_t>(counts.topics.size())).number(std::uint32_t{0});  // no attachments
    fields.number(metadata_count_).number(chunk_count_);
    fields.number(static_cast<std::uint64_t>(any ? counts.first : 0));
    fields.number(static_cast<std::uint64_t>(any ? counts.last : 0));
    fields.sized<std::uint32_t>([&counts](Writer& map) {
      for (std::size_t i = 0; i < counts.messages.size(); ++i) {
        map.number(channel_id(i)).number(std::uint64_t{counts.messages[i]});
      }
    });
  });
  return bytes;
}

void Summary::finish(const BagMetadata& counts, Bytes& file, std::uint64_t position) const {
  const std::size_t begin = file.size();
  Writer out(file);
  Bytes offsets;
  const auto put_group = [&](Opcode opcode, const Bytes& records) {
    if (records.empty()) return;
    Writer(offsets).record(Opcode::SummaryOffset, [&](Writer& fields) {
      fields.number(static_cast<std::uint8_t>(opcode)).number(position + file.size());
      fields.number(std::uint64_t{records.size()});
    });
    out.bytes(records);
  };
  put_group(Opcode::Schema, schemas_);
  put_group(Opcode::Channel, channels_);
  put_group(Opcode::Statistics, statistics(counts));
  put_group(Opcode::ChunkIndex, chunk_indexes_);
  put_group(Opcode::MetadataIndex, metadata_indexes_);
  const Footer footer{position + begin, position + file.size()};
  out.bytes(offsets);
  put_footer(file, footer, begin);
}

}  // namespace scrubjay::mcap

#include "mcap_format.hpp"

#include <zlib.h>

namespace scrubjay::mcap {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text));
}

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Writer& Writer::bytes(std::span<const std::byte> bytes) {
  out_.insert(out_.end(), bytes.begin(), bytes.end());
  return *this;
}

Writer& Writer::text(std::string_view text) {
  return number(static_cast<std::uint32_t>(text.size())).bytes(bytes_of(text));
}

Writer& Writer::map(const TextMap& map) {
  return sized<std::uint32_t>([&map](Writer& out) {
    for (const auto& [key, value] : map) out.text(key).text(value);
  });
}

std::span<const std::byte> Fields::take(std::uint64_t size) {
  if (size > rest_.size()) {
    failed_ = true;
    rest_ = {};
    return {};
  }
  const auto taken = rest_.first(size);
  rest_ = rest_.subspan(size);
  return taken;
}

std::string Fields::text() {
  return text_of(take(number<std::uint32_t>()));
}

TextMap Fields::map() {
  TextMap map;
  Fields entries(take(number<std::uint32_t>()));
  while (!entries.rest().empty()) {
    std::string key = entries.text();
    map.emplace_back(std::move(key), entries.text());
  }
  failed_ = failed_ || entries.failed();
  return map;
}

std::optional<Record> take_record(std::span<const std::byte>& bytes) {
  Fields fields(bytes);
  const auto opcode = static_cast<Opcode>(fields.number<std::uint8_t>());
  const auto content = fields.take(fields.number<std::uint64_t>());
  if (fields.failed()) return std::nullopt;
  bytes = fields.rest();
  return Record{opcode, content};
}

void put(Writer& out, const Schema& schema) {
  out.record(Opcode::Schema, [&schema](Writer& fields) {
    fields.number(schema.id).text(schema.name).text(schema.encoding).text(schema.data);
  });
}

void put(Writer& out, const Channel& channel) {
  out.record(Opcode::Channel, [&channel](Writer& fields) {
    fields.number(channel.id).number(channel.schema).text(channel.topic).text(channel.encoding).map(channel.metadata);
  });
}

std::optional<Schema> parse_schema(std::span<const std::byte> content) {
  Fields fields(content);
  Schema schema;
  schema.id = fields.number<std::uint16_t>();
  schema.name = fields.text();
  schema.encoding = fields.text();
  schema.data = fields.text();
  if (fields.failed()) return std::nullopt;
  return schema;
}

std::optional<Channel> parse_channel(std::span<const std::byte> content) {
  Fields fields(content);
  Channel channel;
  channel.id = fields.number<std::uint16_t>();
  channel.schema = fields.number<std::uint16_t>();
  channel.topic = fields.text();
  channel.encoding = fields.text();
  channel.metadata = fields.map();
  if (fields.failed()) return std::nullopt;
  return channel;
}

std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t previous) {
  return static_cast<std::uint32_t>(crc32_z(previous, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace scrubjay::mcap

/// \file
/// MCAP files by hand, as other writers make them or nobody should.
#pragma once

#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay::mcap_by_hand {

inline const std::string kMagic("\x89MCAP0\r\n");

template <class T>
std::string number(T value) {
  std::string bytes;
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(value >> (8 * i) & 0xff);
  return bytes;
}

inline std::string text(std::string_view text) {
  return number(static_cast<std::uint32_t>(text.size())) + std::string(text);
}

inline std::string record(int opcode, std::string_view content) {
  return number(static_cast<std::uint8_t>(opcode)) + number(std::uint64_t{content.size()}) + std::string(content);
}

inline std::string header(std::string_view library = "by hand") {
  return record(1, text("ros2") + text(library));
}

inline std::string schema(std::uint16_t id, std::string_view name, std::string_view definition) {
  return record(3, number(id) + text(name) + text("ros2msg") + text(definition));
}

inline std::string channel(std::uint16_t id, std::uint16_t schema, std::string_view topic,
                           std::string_view encoding = "cdr", std::string_view metadata = "") {
  return record(4, number(id) + number(schema) + text(topic) + text(encoding) + text(metadata));
}

inline std::string message(std::uint16_t channel, std::uint64_t time, std::string_view data,
                           std::uint32_t sequence = 0) {
  return record(5, number(channel) + number(sequence) + number(time) + number(time) + std::string(data));
}

inline std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(::crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

inline std::string lz4(std::string_view bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr));
  return packed;
}

inline std::string zstd(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1));
  return packed;
}

struct Chunk {
  std::uint64_t first = 0;  ///< earliest message
  std::string records;
  std::string compression;
  std::string packed;          ///< the records, packed by that
  std::uint32_t checksum = 0;  ///< of the records; 0 is none
  std::uint64_t size = 0;      ///< that it says its records have; 0: that which they have
  std::uint64_t last = 0;      ///< latest message
};

inline std::string chunk(const Chunk& chunk) {
  const std::string& packed = chunk.compression.empty() ? chunk.records : chunk.packed;
  const std::uint64_t size = chunk.size != 0 ? chunk.size : chunk.records.size();
  return record(6, number(chunk.first) + number(chunk.last) + number(size) + number(chunk.checksum) +
                       text(chunk.compression) + number(std::uint64_t{packed.size()}) + packed);
}

/// Of one message.
inline std::string message_index(std::uint16_t channel, std::uint64_t time, std::uint64_t offset) {
  return record(7, number(channel) + text(number(time) + number(offset)));
}

inline std::string metadata(std::string_view name, std::string_view key, std::string_view value) {
  return record(12, text(name) + text(text(key) + text(value)));
}

inline std::string data_end(std::uint32_t checksum = 0) {
  return record(15, number(checksum));
}

inline std::string footer(std::uint64_t summary = 0, std::uint32_t checksum = 0) {
  return record(2, number(summary) + number(std::uint64_t{0}) + number(checksum)) + kMagic;
}

/// A whole file of `data`, without a summary.
inline std::string file(std::string_view data) {
  return kMagic + header() + std::string(data) + data_end() + footer();
}

inline std::vector<std::uint8_t> bytes(std::string_view file) {
  return {file.begin(), file.end()};
}

}  // namespace scrubjay::mcap_by_hand

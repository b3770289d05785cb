/// \file
/// What a recording holds, as tests compare it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <scrubjay/io/recording.hpp>
#include <vector>

namespace scrubjay {

using Bytes = std::vector<std::uint8_t>;

struct Chunk {
  Direction direction = Direction::Received;
  double stamp = 0.0;
  Bytes bytes;

  bool operator==(const Chunk&) const = default;
};

inline std::vector<Chunk> read_all(RecordingReader& reader) {
  std::vector<Chunk> chunks;
  while (const auto next = reader.next()) {
    chunks.push_back({next->direction, next->stamp, {next->bytes.begin(), next->bytes.end()}});
  }
  return chunks;
}

inline void write_all(const std::filesystem::path& path, const std::vector<Chunk>& chunks) {
  RecordingWriter writer(path, "seed: 7\n");
  for (const Chunk& chunk : chunks) writer.record(chunk.direction, chunk.stamp, chunk.bytes);
  writer.close();
}

}  // namespace scrubjay

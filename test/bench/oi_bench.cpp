// What the codec costs. Every benchmark is of group 100, one stream frame of 84 bytes, unless its name says otherwise.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <scrubjay/oi/command_decoder.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <vector>

namespace {

using namespace scrubjay::oi;

constexpr std::array<SensorId, 1> kEverything{100};
using Frame = std::array<std::uint8_t, 84>;

/// Values in range, different for each seed.
Sensors some_sensors(std::uint32_t seed) {
  Sensors sensors;
  for (const PacketInfo& packet : kPackets) {
    seed = seed * 1664525U + 1013904223U;
    const ValueRange range = accepted_range(packet.id, Model::Create2);
    const auto count = static_cast<std::uint32_t>(range.max - range.min + 1);
    sensors.set(packet.id, range.min + static_cast<std::int32_t>((seed >> 8) % count));
  }
  return sensors;
}

Frame some_frame(std::uint32_t seed) {
  Frame frame{};
  if (encode_stream_frame(kEverything, some_sensors(seed), Model::Create2, frame) != frame.size()) std::abort();
  return frame;
}

/// `size` bytes of stream.
std::vector<std::uint8_t> some_stream(std::size_t size) {
  std::vector<std::uint8_t> stream;
  for (std::uint32_t seed = 0; stream.size() < size; ++seed) {
    const Frame frame = some_frame(seed);
    stream.insert(stream.end(), frame.begin(), frame.end());
  }
  return stream;
}

void ParseAndDecodeFrame(benchmark::State& state) {
  const Frame frame = some_frame(1);
  StreamParser parser(Model::Create2, 81);
  Sensors sensors;
  for (auto _ : state) {
    parser.feed(frame, [&](const StreamFrame& f) { benchmark::DoNotOptimize(decode(f, Model::Create2, sensors)); });
    benchmark::DoNotOptimize(sensors);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(ParseAndDecodeFrame);

void ParseAndDecodeFrameInTwoPieces(benchmark::State& state) {
  const Frame frame = some_frame(1);
  StreamParser parser(Model::Create2, 81);
  Sensors sensors;
  const auto on_frame = [&](const StreamFrame& f) { benchmark::DoNotOptimize(decode(f, Model::Create2, sensors)); };
  for (auto _ : state) {
    parser.feed(std::span(frame).first(40), on_frame);
    parser.feed(std::span(frame).subspan(40), on_frame);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(ParseAndDecodeFrameInTwoPieces);

void Checksum(benchmark::State& state) {
  const Frame frame = some_frame(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(byte_sum(frame));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(Checksum);

void DecodeGroup100(benchmark::State& state) {
  const Frame frame = some_frame(1);
  Sensors sensors;
  for (auto _ : state) {
    benchmark::DoNotOptimize(decode(100, std::span(frame).subspan(3, 80), Model::Create2, sensors));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(DecodeGroup100);

void EncodeGroup100(benchmark::State& state) {
  Sensors sensors = some_sensors(1);
  std::array<std::uint8_t, 80> data{};
  for (auto _ : state) {
    benchmark::DoNotOptimize(sensors);
    benchmark::DoNotOptimize(encode(100, sensors, Model::Create2, data));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(EncodeGroup100);

void EncodeStreamFrame(benchmark::State& state) {
  Sensors sensors = some_sensors(1);
  Frame frame{};
  for (auto _ : state) {
    benchmark::DoNotOptimize(sensors);
    benchmark::DoNotOptimize(encode_stream_frame(kEverything, sensors, Model::Create2, frame));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(EncodeStreamFrame);

/// A tick of a simulated run: the firmware writes a frame, the driver reads it.
void EncodeParseDecodeFrame(benchmark::State& state) {
  Sensors sent = some_sensors(1);
  Frame frame{};
  StreamParser parser(Model::Create2, 81);
  Sensors received;
  for (auto _ : state) {
    benchmark::DoNotOptimize(sent);
    benchmark::DoNotOptimize(encode_stream_frame(kEverything, sent, Model::Create2, frame));
    parser.feed(frame, [&](const StreamFrame& f) { benchmark::DoNotOptimize(decode(f, Model::Create2, received)); });
    benchmark::ClobberMemory();
  }
}
BENCHMARK(EncodeParseDecodeFrame);

void ParseStream(benchmark::State& state, std::size_t chunk, bool decoded) {
  const std::vector<std::uint8_t> stream = some_stream(1 << 20);
  Sensors sensors;
  for (auto _ : state) {
    StreamParser parser(Model::Create2, 81);
    for (std::size_t at = 0; at < stream.size(); at += chunk) {
      const auto piece = std::span(stream).subspan(at, std::min(chunk, stream.size() - at));
      parser.feed(piece, [&](const StreamFrame& frame) {
        if (decoded) benchmark::DoNotOptimize(decode(frame, Model::Create2, sensors));
      });
    }
    benchmark::DoNotOptimize(parser.counters().frames);
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(stream.size()));
}
BENCHMARK_CAPTURE(ParseStream, megabyte_at_once, 2 << 20, false);
BENCHMARK_CAPTURE(ParseStream, megabyte_at_once_and_decode, 2 << 20, true);
BENCHMARK_CAPTURE(ParseStream, megabyte_in_pieces_of_61_and_decode, 61, true);

void DecodeDriveDirect(benchmark::State& state) {
  const CommandBytes bytes = encode(DriveDirect{200, -200});
  CommandDecoder decoder(Model::Create2);
  for (auto _ : state) {
    decoder.feed(
        bytes.bytes(), [](const Command& command) { benchmark::DoNotOptimize(&command); }, [](const Rejected&) {});
    benchmark::ClobberMemory();
  }
}
BENCHMARK(DecodeDriveDirect);

}  // namespace

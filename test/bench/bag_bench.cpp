#include <benchmark/benchmark.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <scrubjay/io/mcap.hpp>
#include <vector>

namespace scrubjay {
namespace {

const BagTopic kTopic{"/map", "nav_msgs/msg/OccupancyGrid", "int8[] data\n", "", ros::kLatched};

/// A message like a map: long runs of one value, with some noise between them.
std::vector<std::byte> map_message(std::size_t size) {
  std::mt19937 random(1);
  std::vector<std::byte> bytes;
  while (bytes.size() < size) bytes.insert(bytes.end(), 1 + random() % 50, static_cast<std::byte>(random() % 101));
  bytes.resize(size);
  return bytes;
}

/// So many bytes a message: 700 are an odometry, 4 MB a large map.
void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(700)->Arg(4'000'000);
}

std::filesystem::path bench_file() {
  return std::filesystem::temp_directory_path() / "scrubjay-bag-bench.mcap";
}

/// What a message costs, the system's part and a chunk's checksum included; not the wait for the disc.
void write_mcap(benchmark::State& state, bool zstd) {
  const std::vector<std::byte> bytes = map_message(static_cast<std::size_t>(state.range(0)));
  constexpr std::int64_t kFileSize = 500'000'000;
  std::int64_t count = 0;
  auto writer = std::make_unique<McapWriter>(bench_file(), McapOptions{.zstd = zstd});
  std::size_t topic = writer->add(kTopic);
  for ([[maybe_unused]] const auto& _ : state) {
    writer->write(topic, ++count * 10'000'000, bytes);
    if (count * state.range(0) % kFileSize < state.range(0)) {
      state.PauseTiming();
      writer = std::make_unique<McapWriter>(bench_file(), McapOptions{.zstd = zstd});
      topic = writer->add(kTopic);
      state.ResumeTiming();
    }
  }
  state.SetBytesProcessed(count * state.range(0));
  writer.reset();
  std::filesystem::remove(bench_file());
}
void McapWrite(benchmark::State& state) {
  write_mcap(state, false);
}
BENCHMARK(McapWrite)->Apply(sizes);
void McapWriteZstd(benchmark::State& state) {
  write_mcap(state, true);
}
BENCHMARK(McapWriteZstd)->Apply(sizes);

void read_mcap(benchmark::State& state, bool zstd) {
  const std::vector<std::byte> bytes = map_message(static_cast<std::size_t>(state.range(0)));
  const std::int64_t count = 40'000'000 / state.range(0);
  {
    McapWriter writer(bench_file(), {.zstd = zstd});
    const std::size_t topic = writer.add(kTopic);
    for (std::int64_t i = 0; i < count; ++i) writer.write(topic, i * 10'000'000, bytes);
  }
  for ([[maybe_unused]] const auto& _ : state) {
    McapReader reader(bench_file());
    while (const auto message = reader.next()) benchmark::DoNotOptimize(message->bytes.data());
  }
  state.SetBytesProcessed(state.iterations() * count * state.range(0));
  std::filesystem::remove(bench_file());
}
void McapRead(benchmark::State& state) {
  read_mcap(state, false);
}
BENCHMARK(McapRead)->Apply(sizes);
void McapReadZstd(benchmark::State& state) {
  read_mcap(state, true);
}
BENCHMARK(McapReadZstd)->Apply(sizes);

}  // namespace
}  // namespace scrubjay

#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>
#include <scrubjay/io/recording.hpp>

namespace scrubjay {
namespace {

/// A stream's frame of 84 bytes, of which `changing` differ from tick to tick.
void change(std::array<std::uint8_t, 84>& frame, std::size_t changing, std::uint32_t tick) {
  for (std::size_t i = 0; i < changing; ++i) {
    frame[i * frame.size() / changing] = static_cast<std::uint8_t>(tick * 2654435761u >> 24);
  }
}

/// What recording a frame costs, files included.
void RecordFrame(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "scrubjay-recording-bench.oilog";
  const auto changing = static_cast<std::size_t>(state.range(0));
  std::array<std::uint8_t, 84> frame{};
  std::uint32_t tick = 0;
  {
    RecordingWriter writer(path, "bench: true\n");
    for ([[maybe_unused]] const auto& _ : state) {
      change(frame, changing, ++tick);
      writer.record(Direction::Received, tick * 0.015, frame);
    }
    writer.flush();
  }
  state.counters["bytes/frame"] = static_cast<double>(std::filesystem::file_size(path)) / tick;
  std::filesystem::remove(path);
}
BENCHMARK(RecordFrame)->Arg(1)->Arg(10)->Arg(28)->Arg(84);

void ReadFrame(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "scrubjay-recording-bench.oilog";
  constexpr std::uint32_t kFrames = 20000;
  {
    RecordingWriter writer(path, "bench: true\n");
    std::array<std::uint8_t, 84> frame{};
    for (std::uint32_t tick = 0; tick < kFrames; ++tick) {
      change(frame, 10, tick);
      writer.record(Direction::Received, tick * 0.015, frame);
    }
  }
  for ([[maybe_unused]] const auto& _ : state) {
    RecordingReader reader(path);
    while (reader.next()) {
    }
  }
  state.SetItemsProcessed(state.iterations() * kFrames);
  std::filesystem::remove(path);
}
BENCHMARK(ReadFrame);

}  // namespace
}  // namespace scrubjay

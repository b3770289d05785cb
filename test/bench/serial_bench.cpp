// What a serial port costs, between a write at the other end of a pseudo-terminal and the parsed frame at ours.
#include <benchmark/benchmark.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <scrubjay/io/serial_port.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace scrubjay {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kFrameSize = 84;  // of group 100

std::array<std::uint8_t, kFrameSize> some_frame() {
  std::array<std::uint8_t, kFrameSize> frame{};
  const std::array<oi::SensorId, 1> everything{100};
  if (oi::encode_stream_frame(everything, oi::Sensors(), oi::Model::Create2, frame) != kFrameSize) std::abort();
  return frame;
}

/// A robot's wire, of which we have both ends.
struct Wire {
  std::filesystem::path link =
      std::filesystem::temp_directory_path() / ("scrubjay-serial-bench." + std::to_string(::getpid()));
  PseudoTerminal robot{link};
  SerialPort port{{.path = link}};
  oi::StreamParser parser{oi::Model::Create2, 81};
  std::uint64_t calls = 0;  ///< to the system, for reading

  /// Reads once and parses what came.
  template <typename OnFrame>
  void read(OnFrame&& on_frame) {
    std::array<std::uint8_t, 4096> buffer;
    const ByteRead got = port.read(buffer);
    calls += got.count > 0 ? 2 : 1;  // poll, and read where there is something
    parser.feed(std::span(buffer).first(got.count), on_frame);
  }

  /// Waits for room, unlike the pseudo-terminal itself.
  void push(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(robot.descriptor(), bytes.data(), bytes.size());
      if (written > 0) {
        bytes = bytes.subspan(static_cast<std::size_t>(written));
      } else {
        pollfd room{.fd = robot.descriptor(), .events = POLLOUT, .revents = 0};
        ::poll(&room, 1, 1);
      }
    }
  }

  double calls_per_frame() const { return static_cast<double>(calls) / static_cast<double>(parser.counters().frames); }
};

/// Frames as fast as they go, of which the argument says how many are written at once.
void SerialStreamFlatOut(benchmark::State& state) {
  Wire wire;
  std::vector<std::uint8_t> burst;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const auto frame = some_frame();
    burst.insert(burst.end(), frame.begin(), frame.end());
  }
  std::jthread robot([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) wire.push(burst);
  });
  oi::Sensors sensors;
  std::int64_t frames = 0;
  for ([[maybe_unused]] const auto& _ : state) {
    wire.read([&](const oi::StreamFrame& frame) {
      benchmark::DoNotOptimize(oi::decode(frame, oi::Model::Create2, sensors));
      ++frames;
    });
  }
  state.SetItemsProcessed(frames);
  state.counters["calls/frame"] = wire.calls_per_frame();
  robot.request_stop();
  std::uint64_t last = 0;  // the robot may be waiting for room
  do {
    last = wire.parser.counters().frames;
    wire.read([](const oi::StreamFrame&) {});
  } while (wire.parser.counters().frames != last || wire.parser.pending() > 0);
}
BENCHMARK(SerialStreamFlatOut)->Arg(1)->Arg(40)->UseRealTime();

/// From the write at the robot's end to the parsed frame in another thread. The arguments are the pause between two
/// frames [us], and the pieces in which a frame comes, one a millisecond, as from an FTDI adapter told to be quick; the
/// last one counts. The time an iteration takes has no meaning but in the counters, p50 and p99 [us].
void SerialLatency(benchmark::State& state) {
  Wire wire;
  const auto frame = some_frame();
  const auto piece =
      (kFrameSize + static_cast<std::size_t>(state.range(1)) - 1) / static_cast<std::size_t>(state.range(1));
  std::atomic<std::int64_t> arrived = 0;  // when, by the clock's ticks
  std::jthread reader([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      wire.read([&](const oi::StreamFrame&) {
        arrived = Clock::now().time_since_epoch().count();
        arrived.notify_one();
      });
    }
  });
  std::vector<double> latencies;
  for ([[maybe_unused]] const auto& _ : state) {
    std::this_thread::sleep_for(std::chrono::microseconds(state.range(0)));
    const std::int64_t before = arrived;
    std::span<const std::uint8_t> rest(frame);
    for (; rest.size() > piece; rest = rest.subspan(piece)) {
      wire.push(rest.first(piece));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const Clock::time_point sent = Clock::now();
    wire.push(rest);
    arrived.wait(before);
    const Clock::duration latency = Clock::duration(arrived) - sent.time_since_epoch();
    latencies.push_back(std::chrono::duration<double>(latency).count());
    state.SetIterationTime(latencies.back());
  }
  reader.request_stop();
  reader.join();
  std::sort(latencies.begin(), latencies.end());
  state.counters["p50"] = 1e6 * latencies[latencies.size() / 2];
  state.counters["p99"] = 1e6 * latencies[latencies.size() * 99 / 100];
  state.counters["calls/frame"] = wire.calls_per_frame();
}
BENCHMARK(SerialLatency)->Args({0, 1})->Iterations(20000)->UseManualTime();
BENCHMARK(SerialLatency)->Args({15000, 1})->Iterations(300)->UseManualTime();
BENCHMARK(SerialLatency)->Args({7000, 8})->Iterations(300)->UseManualTime();

}  // namespace
}  // namespace scrubjay

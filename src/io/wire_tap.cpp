#include <poll.h>

#include <array>
#include <scrubjay/io/wire_tap.hpp>
#include <scrubjay/oi/command.hpp>

namespace scrubjay {
namespace {

constexpr int kWait = 50;  // for bytes, before it is looked whether somebody asks to stop [ms]

}  // namespace

TapReport tap_wire(SerialPort& port, PseudoTerminal& terminal, RecordingWriter& recording, double max_time,
                   const std::stop_token& stop) {
  TapReport report;
  std::array<std::uint8_t, 4096> buffer;
  const double begin = port.now();
  while (!stop.stop_requested() && !report.robot_gone && port.now() - begin < max_time) {
    std::array<pollfd, 2> ends{{{port.descriptor(), POLLIN, 0}, {terminal.descriptor(), POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), kWait) <= 0) continue;
    if (ends[0].revents != 0) {
      const ByteRead got = port.read(buffer);
      const auto bytes = std::span<const std::uint8_t>(buffer).first(got.count);
      recording.record(Direction::Received, got.stamp - begin, bytes);
      report.from_robot += bytes.size();
      report.robot_gone = !got.open;
      if (!bytes.empty()) terminal.write(bytes);
    }
    if (ends[1].revents != 0) {
      const auto bytes = std::span<const std::uint8_t>(buffer).first(terminal.read(buffer).count);
      if (bytes.empty()) continue;
      recording.record(Direction::Sent, port.now() - begin, bytes);
      report.to_robot += bytes.size();
      report.robot_gone = !port.write(bytes) || report.robot_gone;
    }
  }
  report.time = port.now() - begin;
  report.unread = terminal.dropped();
  if (report.to_robot > 0 && !report.robot_gone) {
    // Twice: the client's last command may lack bytes, and take these for its own.
    for (int i = 0; i < 2; ++i) {
      port.write(encode(oi::Drive{oi::Velocity(0), oi::Radius::straight()}));
      port.write(encode(oi::Start{}));
    }
  }
  return report;
}

}  // namespace scrubjay

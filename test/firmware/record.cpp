/// \file
/// firmware_recorder <file>: a simulated Roomba driven by the core, and all bytes that it sent, for the replay.
#include <array>
#include <cstdint>
#include <exception>
#include <iostream>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/io/world_reader.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <string>
#include <vector>

#include "replay.h"

namespace scrubjay {
namespace {

constexpr double kLongest = 120.0;  // of the recording [s]

/// The recording as recording.S has it.
class Recording {
 public:
  void add(double stamp, std::span<const std::uint8_t> bytes) {
    put(static_cast<std::uint32_t>(stamp * 1000.0 + 0.5), 4);
    put(static_cast<std::uint32_t>(bytes.size()), 2);
    content_.append(bytes.begin(), bytes.end());
  }
  const std::string& content() const { return content_; }

 private:
  void put(std::uint32_t value, int count) {
    for (; count > 0; --count, value >>= 8) content_.push_back(static_cast<char>(value & 0xff));
  }

  std::string content_;
};

int send_to(void* roomba, const std::uint8_t* bytes, std::size_t count) {
  return static_cast<sim::SimulatedRoomba*>(roomba)->write({bytes, count}) ? 1 : 0;
}

void record(const std::string& file) {
  const std::string tree = SCRUBJAY_SOURCE_DIR;
  const World world = read_world(tree + "/worlds/room.yaml");
  const SegmentIndex index(solid_segments(world));
  const sim::RobotSpec spec = read_robot(tree + "/urdf/roomba_600.urdf");
  const sim::NoiseProfile noise = read_noise(tree + "/urdf/noise.yaml", "hard-floor");
  sim::SimulatedRoomba roomba(world, index, spec, noise, Random(1), world.start.value());

  scrubjay_config config = replay_config();
  config.send = send_to;
  config.user = &roomba;
  std::vector<std::max_align_t> memory(
      SCRUBJAY_MEMORY_SIZE(config.map_width, config.map_height) / static_cast<int>(sizeof(std::max_align_t)) + 1);
  scrubjay_mission* mission = nullptr;
  if (scrubjay_create(memory.data(), memory.size() * sizeof(std::max_align_t), &config, &mission) != SCRUBJAY_OK) {
    throw Error("the replay's configuration makes no mission");
  }
  Recording recording;
  std::array<std::uint8_t, 512> buffer;
  while (scrubjay_is_done(mission) == 0 && roomba.now() < kLongest) {
    const ByteRead read = roomba.read(buffer);
    recording.add(read.stamp, {buffer.data(), read.count});
    scrubjay_feed(mission, buffer.data(), read.count, read.stamp);
  }
  write_file_atomically(file, recording.content());
}

}  // namespace
}  // namespace scrubjay

int main(int count, char** words) {
  try {
    if (count != 2) throw scrubjay::Error("firmware_recorder wants one file to write to");
    scrubjay::record(words[1]);
  } catch (const std::exception& error) {
    std::cerr << "firmware_recorder: " << error.what() << '\n';
    return 1;
  }
  return 0;
}

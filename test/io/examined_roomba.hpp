/// \file
/// A simulated Roomba to examine, and wires that do something to what it says.
#pragma once

#include <functional>
#include <scrubjay/io/examination.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace scrubjay::test {

/// In the middle of an empty room of 4 m x 4 m.
class ExaminedRoomba {
 public:
  explicit ExaminedRoomba(oi::Model model = oi::Model::Create2, const sim::FirmwareOptions& options = {})
      : world_(room()),
        index_(solid_segments(world_)),
        roomba(world_, index_, spec_of(model), {}, Random(1), {2.0, 2.0, 0.0}, options) {}

  Examination::Clock clock() const {
    return [this] { return roomba.now(); };
  }

 private:
  static World room() {
    World world;
    world.walls = {{{{0.0, 0.0}, {4.0, 0.0}, {4.0, 4.0}, {0.0, 4.0}, {0.0, 0.0}}}};
    return world;
  }
  static sim::RobotSpec spec_of(oi::Model model) {
    sim::RobotSpec spec;
    spec.model.protocol = model;
    return spec;
  }

  World world_;
  SegmentIndex index_;

 public:
  sim::SimulatedRoomba roomba;
};

/// A wire whose bytes pass through the test's hands.
class TouchedChannel final : public ByteChannel {
 public:
  explicit TouchedChannel(ByteChannel& channel) : channel_(channel) {}

  ByteRead read(std::span<std::uint8_t> buffer) override {
    ByteRead read = channel_.read(buffer);
    if (!from_robot) return read;
    std::vector<std::uint8_t> bytes(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(read.count));
    from_robot(bytes);
    read.count = std::min(bytes.size(), buffer.size());
    std::copy_n(bytes.begin(), read.count, buffer.begin());
    return read;
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    return channel_.write(bytes);
  }

  std::function<void(std::vector<std::uint8_t>&)> from_robot;  ///< may change what was read, as it likes
  std::vector<std::uint8_t> sent;

 private:
  ByteChannel& channel_;
};

/// Nobody on the other end, or somebody who only talks: a tick passes with every read.
class TalkingChannel final : public ByteChannel {
 public:
  explicit TalkingChannel(std::string_view words = {}) : words_(words) {}

  ByteRead read(std::span<std::uint8_t> buffer) override {
    now_ += 0.015;
    std::copy(words_.begin(), words_.end(), buffer.begin());
    return {words_.size(), now_, true};
  }
  bool write(std::span<const std::uint8_t>) override { return true; }
  Examination::Clock clock() const {
    return [this] { return now_; };
  }

 private:
  std::string_view words_;
  double now_ = 0.0;
};

}  // namespace scrubjay::test

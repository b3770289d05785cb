#include <algorithm>
#include <scrubjay/simulation/simulated_roomba.hpp>

namespace scrubjay::sim {

SimulatedRoomba::SimulatedRoomba(const World& world, const SegmentIndex& index, const RobotSpec& spec,
                                 const NoiseProfile& noise, const Random& random, const Pose2& start,
                                 const FirmwareOptions& options, const RobotFaults& faults)
    : body_(world, index, spec, noise, random, start, faults), firmware_(spec, options) {}

ByteRead SimulatedRoomba::read(std::span<std::uint8_t> buffer) {
  if (read_ == wire_.size()) {
    wire_.clear();
    read_ = 0;
    firmware_.tick(body_.tick(firmware_.wanted()), wire_);
  }
  const std::size_t count = std::min(buffer.size(), wire_.size() - read_);
  std::copy_n(wire_.begin() + static_cast<std::ptrdiff_t>(read_), count, buffer.begin());
  read_ += count;
  return {count, now(), true};
}

bool SimulatedRoomba::write(std::span<const std::uint8_t> bytes) {
  firmware_.receive(bytes);
  return true;
}

}  // namespace scrubjay::sim

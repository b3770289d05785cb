#include "emulation.hpp"

#include <scrubjay/world/start.hpp>

namespace scrubjay::apps {

Emulation::Emulation(const Stage& stage, std::size_t count, const EmulatedFaults& faults, std::uint64_t seed,
                     const std::filesystem::path& link)
    : radius_(stage.robot.model.radius) {
  const std::vector<Pose2> starts = starting_poses(stage.world, stage.index, stage.start, radius_, count);
  for (std::size_t i = 0; i < count; ++i) {
    std::filesystem::path own_link = link;
    if (count > 1) own_link += std::to_string(i);
    robots_.emplace_back(stage, starts[i], i, faults, Random(seed), own_link);
  }
}

void Emulation::tick() {
  for (EmulatedRobot& robot : robots_) {
    if (robots_.size() > 1) {
      others_.clear();
      for (const EmulatedRobot& other : robots_) {
        if (&other != &robot) others_.push_back({other.truth().pose.position(), radius_});
      }
      robot.place_others(others_);
    }
    robot.tick();
  }
}

}  // namespace scrubjay::apps

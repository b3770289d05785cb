#include <scrubjay/grid/traversal.hpp>
#include <scrubjay/world/score.hpp>

namespace scrubjay {

std::vector<std::uint16_t> followed_boundaries(const GroundTruth& truth, std::span<const StampedPose> trajectory,
                                               double robot_radius) {
  constexpr double kBeside = 0.1;    // shell to wall, while following [m]
  constexpr double kFollowed = 0.5;  // share of a boundary's walls that the robot must have been beside
  std::vector<bool> beside(truth.cells.size());
  for (const StampedPose& at : trajectory) {
    visit_disc(truth.geometry, at.pose.position(), robot_radius + kBeside,
               [&](CellIndex cell) { beside[truth.geometry.index(cell)] = true; });
  }
  std::vector<double> walls(truth.boundary_count + 1u);
  std::vector<double> passed(truth.boundary_count + 1u);
  for (std::size_t i = 0; i < truth.cells.size(); ++i) {
    walls[truth.cells[i].boundary] += 1.0;
    passed[truth.cells[i].boundary] += beside[i] ? 1.0 : 0.0;
  }
  std::vector<std::uint16_t> followed;
  for (std::uint16_t boundary = 1; boundary <= truth.boundary_count; ++boundary) {
    if (passed[boundary] >= kFollowed * walls[boundary]) followed.push_back(boundary);
  }
  return followed;
}

}  // namespace scrubjay

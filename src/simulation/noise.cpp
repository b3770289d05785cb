#include <scrubjay/simulation/noise.hpp>

namespace scrubjay::sim {
namespace {

double either_way(const Range& range, Random& random) {
  const double size = random.uniform(range.low, range.high);
  return random.below(2) == 0 ? size : -size;
}

}  // namespace

SystematicErrors draw_errors(const NoiseProfile& profile, std::size_t pieces, const Random& random) {
  Random drive = random.fork(0);
  Random light = random.fork(1);
  SystematicErrors errors;
  const double mismatch = either_way(profile.wheel_mismatch, drive);
  const double scale =
      (1.0 + either_way({0.0, profile.distance_error}, drive)) * drive.uniform(profile.grip.low, profile.grip.high);
  errors.left_scale = scale * (1.0 - 0.5 * mismatch);
  errors.right_scale = scale * (1.0 + 0.5 * mismatch);
  errors.separation_scale = 1.0 + either_way(profile.separation_error, drive);
  for (double& mount : errors.mount) mount = either_way({0.0, profile.mount_error}, light);
  errors.albedo.resize(pieces);
  for (double& albedo : errors.albedo) albedo = light.uniform(profile.albedo.low, profile.albedo.high);
  return errors;
}

}  // namespace scrubjay::sim

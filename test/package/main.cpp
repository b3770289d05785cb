// What a user of the core writes first: turns on the spot, drives a metre, and is where one would think.
#include <cmath>
#include <scrubjay/geometry/pose2.hpp>

int main() {
  const scrubjay::Pose2 turn{0.0, 0.0, scrubjay::radians(90.0)};
  const scrubjay::Pose2 metre{1.0, 0.0, 0.0};
  const scrubjay::Pose2 end = turn * metre;
  return std::abs(end.x) < 1e-12 && std::abs(end.y - 1.0) < 1e-12 ? 0 : 1;
}

/// \file
/// The one random generator: a counter, hashed. Same key, same numbers, on every machine.
#pragma once

#include <cstdint>

namespace scrubjay {

/// A stream of random numbers (SplitMix64: Steele, Lea, Flood, *Fast Splittable Pseudorandom Number Generators*, 2014).
///
/// Seeded once at the top and passed down: `fork` gives each robot, sensor or strategy a stream of its own, which
/// doesn't change when another one draws more or fewer numbers.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(mix(seed)) {}

  /// An independent stream, the same for the same `stream` whatever was drawn from this one.
  Random fork(std::uint64_t stream) const { return Random(key_ ^ mix(stream + kGolden)); }

  std::uint64_t next() {
    state_ += kGolden;
    return mix(state_);
  }
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform in 0 ... count - 1; count > 0.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>(((next() >> 32) * static_cast<std::uint64_t>(count)) >> 32);
  }
  /// Standard normal, by inversion: P. J. Acklam's rational approximation, relative error below 1.2e-9.
  double normal();

 private:
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15ull;

  static constexpr std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
  std::uint64_t key_ = state_;
};

}  // namespace scrubjay

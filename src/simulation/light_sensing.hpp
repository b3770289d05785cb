/// \file
/// The six light sensors of the bumper.
#pragma once

#include <array>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/simulation/body_senses.hpp>
#include <scrubjay/simulation/noise.hpp>
#include <scrubjay/simulation/robot_spec.hpp>

#include "surroundings.hpp"

namespace scrubjay::sim {

/// Signal over distance, beam width, surface colour, incidence and noise. Each beam is three rays: the middle, with
/// half of the weight, and two halfway to its edges.
class LightSensing {
 public:
  LightSensing(const RobotSpec& spec, const NoiseProfile& noise, const SystematicErrors& errors, const Random& random);

  /// Beyond this distance from the robot's middle nothing gives a signal [m].
  double reach() const { return reach_; }
  /// Fills light_signal and light_flags. `turn` is the sine and cosine of the robot's heading.
  void sense(const Point2& position, const SinCos& turn, const Surroundings& surroundings, BodySenses& senses);

 private:
  static constexpr int kRays = 3;
  static constexpr double kFlagOn = 100.0;  ///< counts at which a flag rises; own guess
  static constexpr double kFlagOff = 70.0;  ///< ... and falls

  /// A sensor's rays in the robot's frame.
  struct Beam {
    Point2 origin{0.0, 0.0};
    std::array<Point2, kRays> rays;
  };

  double signal(const Beam& beam, const Point2& position, const SinCos& turn, const Surroundings& surroundings) const;

  LightSensorModel model_;
  double relative_noise_;
  double floor_noise_;
  double reach_;
  std::array<Beam, kLightSensorCount> beams_;
  Random random_;
};

}  // namespace scrubjay::sim

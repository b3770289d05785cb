#include "light_sensing.hpp"

#include <cmath>

namespace scrubjay::sim {
namespace {

constexpr double kLightRange = 0.3;  // farther, even a white wall adds less than 2 counts [m]

Point2 turned(const Point2& p, const SinCos& turn) {
  return {turn.cos * p.x() - turn.sin * p.y(), turn.sin * p.x() + turn.cos * p.y()};
}

}  // namespace

LightSensing::LightSensing(const RobotSpec& spec, const NoiseProfile& noise, const SystematicErrors& errors,
                           const Random& random)
    : model_(spec.model.light),
      relative_noise_(noise.light_noise),
      floor_noise_(noise.light_floor_noise),
      reach_(spec.model.radius + kLightRange),
      random_(random) {
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const Pose2& mount = model_.mount[i];
    beams_[i].origin = mount.position();
    for (int ray = 0; ray < kRays; ++ray) {
      const double aside = (ray - 1) * 0.5 * model_.beam_half_angle;
      beams_[i].rays[static_cast<std::size_t>(ray)] = direction(mount.yaw + errors.mount[i] + aside);
    }
  }
}

void LightSensing::sense(const Point2& position, const SinCos& turn, const Surroundings& surroundings,
                         BodySenses& senses) {
  const bool something_near = surroundings.clearance() < reach_;
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    double counts = model_.ambient;
    if (something_near) counts += signal(beams_[i], position, turn, surroundings);
    if (floor_noise_ > 0.0) {
      const double relative = relative_noise_ * counts;
      counts += std::sqrt(floor_noise_ * floor_noise_ + relative * relative) * random_.normal();
    }
    senses.light_signal[i] = counts;
    const auto bit = static_cast<std::uint8_t>(1u << i);
    if (counts >= kFlagOn) senses.light_flags |= bit;
    if (counts < kFlagOff) senses.light_flags &= static_cast<std::uint8_t>(~bit);
  }
}

double LightSensing::signal(const Beam& beam, const Point2& position, const SinCos& turn,
                            const Surroundings& surroundings) const {
  constexpr std::array<double, kRays> kWeights{0.25, 0.5, 0.25};
  const Point2 origin = position + turned(beam.origin, turn);
  double sum = 0.0;
  for (int ray = 0; ray < kRays; ++ray) {
    const Point2 along = turned(beam.rays[static_cast<std::size_t>(ray)], turn);
    double range = kLightRange;
    const NearSegment* hit = nullptr;
    for (const NearSegment& near : surroundings.segments()) {
      if (near.distance > reach_) continue;
      const double distance = ray_hit(near.segment, origin, along);
      if (distance >= range) continue;
      range = distance;
      hit = &near;
    }
    if (hit == nullptr) continue;
    const double incidence = std::fabs(along.dot(hit->normal));
    sum += kWeights[static_cast<std::size_t>(ray)] * hit->albedo * incidence * exp(-model_.attenuation * range);
  }
  return model_.gain * sum;
}

}  // namespace scrubjay::sim

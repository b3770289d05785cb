/// \file
/// The behavior of a robot that somebody else drove.
#pragma once

#include <scrubjay/behavior/behavior.hpp>

namespace scrubjay::apps {

/// Decides nothing: the robot of a log goes where it went.
class Passenger final : public Behavior {
 public:
  Decision decide(const Situation&) override { return {}; }
};

}  // namespace scrubjay::apps

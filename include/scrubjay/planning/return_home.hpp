/// \file
/// Does what another behavior does, and drives back to where it began.
#pragma once

#include <memory>
#include <optional>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/planning/cost_map.hpp>
#include <scrubjay/planning/navigator.hpp>
#include <vector>

namespace scrubjay {

struct ReturnHomeParams {
  CostMapParams costs;  ///< the radius is the robot's, whatever it says here
  NavigatorParams navigator;
  double back_off_speed = 0.1;  ///< after a bump [m/s]
  double back_off_time = 0.7;   ///< [s]
};

/// Home is the pose of the first decision.
///
///     Out --the other one is done--> Homing --home, no way, or stalled--> Done
///                                    Homing --bump--> Backing --for a while--> Homing
class ReturnHome final : public Behavior {
 public:
  ReturnHome(const RobotModel& robot, std::unique_ptr<Behavior> inner, const ReturnHomeParams& params = {});

  Decision decide(const Situation& situation) override;
  /// The other one's; and home, if it couldn't be reached.
  std::span<const Leftover> leftovers() const override;

 private:
  enum class State : std::uint8_t { Out, Homing, Backing, Done };

  Decision homing(const Situation& situation, const CellRect& costs_changed);
  Decision arrive(Travel travel);

  std::unique_ptr<Behavior> inner_;
  ReturnHomeParams params_;
  CostMap costs_;
  Navigator navigator_;
  std::optional<Pose2> home_;
  std::vector<Leftover> leftovers_;
  State state_ = State::Out;
  double backing_until_ = 0.0;  // [s]
};

}  // namespace scrubjay

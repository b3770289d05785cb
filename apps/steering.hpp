/// \file
/// Who steers a run in place of its scenario's strategy.
#pragma once

#include <memory>
#include <scrubjay/behavior/behavior.hpp>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/robot/robot.hpp>

namespace scrubjay::apps {

class Steering {
 public:
  virtual ~Steering() = default;
  virtual std::unique_ptr<Behavior> behavior(const RobotModel& robot) = 0;
  /// What stands between the mission and its robot, which outlives it.
  virtual std::unique_ptr<Robot> between(Robot& robot) = 0;
  /// May put something before the localizer.
  virtual void correct(Estimation& estimation, const RobotModel& robot) = 0;
};

}  // namespace scrubjay::apps

/// \file
/// Where a robot is calibrated: what carries it to its start, and what measures where it ends.
#pragma once

#include <memory>
#include <scrubjay/io/serial_port.hpp>
#include <scrubjay/mission/calibration_session.hpp>
#include <scrubjay/mission/scenario.hpp>
#include <scrubjay/robot/robot.hpp>
#include <stop_token>
#include <string>
#include <vector>

#include "calibration_prompt.hpp"
#include "interrupt.hpp"

namespace scrubjay::apps {

/// A robot, a floor and a ruler.
class CalibrationSite {
 public:
  virtual ~CalibrationSite() = default;

  virtual const RobotModel& model() const = 0;
  /// Puts the robot on its start, or has that done, for a drive that is to end with `plan`.
  virtual void prepare(CalibrationFigure figure, const EndOfDrive& plan) = 0;
  /// Lets the session drive the figure from the start.
  virtual void drive(CalibrationSession& session, CalibrationFigure figure, const std::stop_token& stop) = 0;
  /// Where it ended.
  virtual EndOfDrive measure(CalibrationFigure figure, const EndOfDrive& plan) = 0;
  /// Whether somebody is there to drive again what was blocked, and to measure again where no wheels can have ended.
  virtual bool mistakes_are_human() const { return false; }
  /// What goes on, should the program end during a drive.
  virtual Interrupt::Stake stake() const { return Interrupt::Stake::Nothing; }
};

/// A simulated robot, whose true pose is the ruler. What the scenario says of strategy and map has no meaning here.
std::unique_ptr<CalibrationSite> simulated_site(const Scenario& scenario);

/// A robot on a wire, and an owner with a tape measure who talks with `prompt`. Throws Error if the robot can't be
/// reached, or isn't a `model`; it is reached anew for every drive, and left in between in a mode that charges.
std::unique_ptr<CalibrationSite> owned_site(const SerialAddress& address, const std::string& model,
                                            CalibrationPrompt prompt);

}  // namespace scrubjay::apps

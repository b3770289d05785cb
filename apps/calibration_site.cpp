#include "calibration_site.hpp"

#include <fmt/format.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/serial_robot.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>

#include "data_folder.hpp"
#include "random_streams.hpp"
#include "simulated_run.hpp"

namespace scrubjay::apps {
namespace {

class SimulatedSite final : public CalibrationSite {
 public:
  explicit SimulatedSite(const Scenario& scenario)
      : stage_(set_stage(scenario)),
        roomba_(stage_.world, stage_.index, stage_.robot, stage_.noise, Random(scenario.seed).fork(kRobotStream),
                stage_.start) {}

  const RobotModel& model() const override { return stage_.robot.model; }

  void prepare(CalibrationFigure, const EndOfDrive&) override { roomba_.place(stage_.start); }

  void drive(CalibrationSession& session, CalibrationFigure figure, const std::stop_token& stop) override {
    OiRobot robot(roomba_, model());
    session.drive(robot, figure, stop);
  }

  EndOfDrive measure(CalibrationFigure, const EndOfDrive& plan) override {
    const Pose2 end = inverse(stage_.start) * roomba_.truth().pose;
    if (plan.turn) return {{}, {}, *plan.turn + angle_difference(end.yaw, *plan.turn)};
    if (plan.distance) return {{}, end.position().norm(), {}};
    return {end.position(), {}, {}};
  }

 private:
  Stage stage_;
  sim::SimulatedRoomba roomba_;
};

class OwnedSite final : public CalibrationSite {
 public:
  OwnedSite(const SerialAddress& address, const std::string& model, CalibrationPrompt prompt)
      : address_(address), name_(model), model_(find_robot(model).model), prompt_(std::move(prompt)) {
    // What is wrong with the connection shows before the owner kneels down.
    const Interrupt interrupt(Interrupt::Stake::RobotOnAWire);
    const auto robot = reach(interrupt.token());
    for (const std::string& remark : robot->remarks()) fmt::print(stderr, "scrubjay: {}\n", remark);
  }

  const RobotModel& model() const override { return model_; }
  void prepare(CalibrationFigure figure, const EndOfDrive& plan) override { prompt_.prepare(figure, plan); }
  void drive(CalibrationSession& session, CalibrationFigure figure, const std::stop_token& stop) override {
    session.drive(*reach(stop), figure, stop);
  }
  EndOfDrive measure(CalibrationFigure figure, const EndOfDrive& plan) override {
    return prompt_.ask(figure, plan, model_);
  }
  bool mistakes_are_human() const override { return prompt_.interactive(); }
  Interrupt::Stake stake() const override { return Interrupt::Stake::RobotOnAWire; }

 private:
  std::unique_ptr<SerialRobot> reach(const std::stop_token& stop) const {
    auto robot = std::make_unique<SerialRobot>(address_, model_, stop);
    if (robot->model().protocol == model_.protocol) return robot;
    throw Error(
        fmt::format("{}: the robot doesn't speak as a {} does; want its --model", address_.path.string(), name_));
  }

  SerialAddress address_;
  std::string name_;
  RobotModel model_;
  CalibrationPrompt prompt_;
};

}  // namespace

std::unique_ptr<CalibrationSite> owned_site(const SerialAddress& address, const std::string& model,
                                            CalibrationPrompt prompt) {
  return std::make_unique<OwnedSite>(address, model, std::move(prompt));
}

std::unique_ptr<CalibrationSite> simulated_site(const Scenario& scenario) {
  return std::make_unique<SimulatedSite>(scenario);
}

}  // namespace scrubjay::apps

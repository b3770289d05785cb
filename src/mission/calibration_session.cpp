#include <algorithm>
#include <array>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/localization/localizer.hpp>
#include <scrubjay/mapping/contact_mapper.hpp>
#include <scrubjay/mission/calibration_session.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/nearest_word.hpp>
#include <scrubjay/robot/calibrated_robot.hpp>

namespace scrubjay {
namespace {

constexpr std::array<std::string_view, 4> kNames{"spin", "straight", "square-left", "square-right"};
constexpr double kMaxTime = 900.0;  // of a drive [s]

/// Keeps what the encoders told, from the first motion on: wheels may have turned while somebody carried the robot.
class TravelLog final : public Observer {
 public:
  explicit TravelLog(const Calibration& calibration) : calibration_(calibration) {}

  void notify(const Snapshot& now) override {
    if (travel.empty() && now.decision.motion == Motion{}) return;
    travel.push_back(uncalibrated({now.frame.left_travel, now.frame.right_travel}, calibration_));
  }

  std::vector<WheelTravel> travel;

 private:
  Calibration calibration_;
};

[[noreturn]] void fail(CalibrationFigure figure, const std::string& why) {
  throw Error(std::string(to_string(figure)) + ": " + why, Error::Kind::Failure);
}

}  // namespace

std::string_view to_string(CalibrationFigure figure) {
  return kNames[static_cast<std::size_t>(figure)];
}

CalibrationFigure figure_of(std::string_view name) {
  const auto found = std::ranges::find(kNames, name);
  if (found != kNames.end()) return static_cast<CalibrationFigure>(found - kNames.begin());
  throw Error("there is no drive '" + std::string(name) + "'; did you mean '" +
              std::string(nearest_word(name, {kNames.begin(), kNames.end()})) +
              "'? (known: spin, straight, square-left, square-right)");
}

CalibrationSession::CalibrationSession(const RobotModel& robot, const CalibrationFigures& figures)
    : robot_(robot), figures_(figures), fit_(*fit_calibration({}, robot.drive)) {}

EndOfDrive CalibrationSession::plan(CalibrationFigure figure) const {
  switch (figure) {
    case CalibrationFigure::Spin: {
      // Half a turn is more than three standard deviations off.
      const double known = 1.0 / (6.0 * fit_.deviation.axle);
      const double turns = std::clamp(std::floor(known), 1.0, static_cast<double>(figures_.turns));
      return {{}, {}, 2.0 * kPi * turns};
    }
    case CalibrationFigure::Straight:
      return {{}, figures_.straight, {}};
    case CalibrationFigure::SquareLeft:
    case CalibrationFigure::SquareRight:
      return {Point2(0.0, 0.0), {}, {}};
  }
  return {};
}

std::vector<Leg> CalibrationSession::legs(CalibrationFigure figure) const {
  switch (figure) {
    case CalibrationFigure::Spin:
      return {{0.0, *plan(figure).turn}};
    case CalibrationFigure::Straight:
      return {{figures_.straight, 0.0}};
    case CalibrationFigure::SquareLeft:
      return std::vector<Leg>(4, {figures_.side, 0.5 * kPi});
    case CalibrationFigure::SquareRight:
      return std::vector<Leg>(4, {figures_.side, -0.5 * kPi});
  }
  return {};
}

void CalibrationSession::drive(Robot& robot, CalibrationFigure figure, const std::stop_token& stop) {
  CalibratedRobot calibrated(robot, fit_.calibration, robot_.drive);
  DeadReckoning localizer(robot_.drive);
  ContactMapper mapper(robot_, 0.05);
  LegDrive behavior(legs(figure));
  Mission mission(calibrated, localizer, mapper, behavior, {kMaxTime});
  TravelLog log(fit_.calibration);
  mission.watch(log);
  const Report report = mission.run(stop);
  if (behavior.failed()) fail(figure, "something is in the way; want free and level floor for the whole figure");
  if (report.ended == Ended::Stopped) fail(figure, "stopped before it was done");
  if (report.ended == Ended::RobotGone) fail(figure, "the robot fell silent");
  if (report.ended != Ended::Done) fail(figure, "the robot doesn't get on; want it on its wheels, on free floor");
  logged_.push_back({figure, std::move(log.travel), {}});
}

void CalibrationSession::measure(const EndOfDrive& end) {
  logged_.back().measured = end;
  std::vector<MeasuredDrive> measured;
  for (const Logged& drive : logged_) measured.push_back({drive.travel, drive.measured});
  const auto fit = fit_calibration(measured, robot_.drive, {}, fit_.calibration);
  if (!fit) {
    throw Error(std::string(to_string(logged_.back().figure)) +
                ": no wheels can have ended there; want what was measured in millimetres and degrees");
  }
  fit_ = *fit;
}

std::vector<CalibrationDrive> CalibrationSession::drives() const {
  std::vector<CalibrationDrive> drives;
  for (const auto& [figure, travel, measured] : logged_) {
    const EndOfDrive told = end_of(travel, robot_.drive, fit_.calibration);
    CalibrationDrive& drive = drives.emplace_back(CalibrationDrive{figure});
    const auto add = [&](double by_ruler, double by_wheels) {
      drive.measured.push_back(by_ruler);
      drive.residual.push_back(by_ruler - by_wheels);
    };
    if (measured.offset) {
      add(measured.offset->x(), told.offset->x());
      add(measured.offset->y(), told.offset->y());
    }
    if (measured.distance) add(*measured.distance, *told.distance);
    if (measured.turn) add(*measured.turn, *told.turn);
  }
  return drives;
}

}  // namespace scrubjay

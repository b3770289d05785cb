#include "calibration_prompt.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <scrubjay/error.hpp>

namespace scrubjay::apps {
namespace {

constexpr const char* kSpin = R"(
                  tape
             .-----|-----.       Put a strip of tape on the floor that points
           /       |       \     away from the robot, and a mark on the robot's
          |        o        |    edge where the tape begins. The robot turns to
           \               /     the left, on the spot, {} time{}.
             '-----------'
)";

constexpr const char* kStraight = R"(
           .---. | tape                        .---.
          (  o> )|  ----------------------->  (  o> )
           '---' |                             '---'
                 |<--------- measure --------------->|

     Put a strip of tape on the floor, across, where the robot's front is.
     The robot drives {:.1f} m straight ahead.
)";

constexpr const char* kSquare = R"(
            | ----------- tape     The robot looks up in this picture. Put two strips
            |    .-^-.             of tape on the floor: one across, where its front
       tape |  /       \           is, and one along, where its left side is.
            | |    o    |          The robot drives a square to the {} and comes back
            |  \       /           to where it is now, or nearly so.
            |    '---'
)";

constexpr const char* kAskSpin =
    "Degrees from the tape to the mark; to the left is positive, to the right\n"
    "negative ({:.1f} mm at the edge are one degree): ";
constexpr const char* kAskStraight = "Millimetres from the tape to the robot's front: ";
constexpr const char* kAskSquare =
    "Millimetres by which the robot's front is beyond the tape across, and its left\n"
    "side beyond the tape along; negative where it is short of it. As in 12,-5: ";

/// Numbers between commas or blanks.
std::optional<std::vector<double>> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* at = text.data();
  const char* end = at + text.size();
  const auto gap = [](char c) { return c == ' ' || c == ',' || c == '\t' || c == '\r'; };
  while (true) {
    while (at != end && gap(*at)) ++at;
    if (at == end) return numbers;
    if (*at == '+') ++at;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value) || (stop != end && !gap(*stop))) return std::nullopt;
    numbers.push_back(value);
    at = stop;
  }
}

}  // namespace

std::string preparation(CalibrationFigure figure, const EndOfDrive& plan) {
  switch (figure) {
    case CalibrationFigure::Spin: {
      const double turns = *plan.turn / (2.0 * kPi);
      return fmt::format(kSpin, std::lround(turns), turns > 1.5 ? "s" : "");
    }
    case CalibrationFigure::Straight:
      return fmt::format(kStraight, *plan.distance);
    case CalibrationFigure::SquareLeft:
      return fmt::format(kSquare, "left");
    case CalibrationFigure::SquareRight:
      return fmt::format(kSquare, "right");
  }
  return "";
}

std::string question(CalibrationFigure figure, const RobotModel& robot) {
  if (figure == CalibrationFigure::Spin) return fmt::format(kAskSpin, 1000.0 * radians(1.0) * robot.radius);
  return figure == CalibrationFigure::Straight ? kAskStraight : kAskSquare;
}

std::optional<EndOfDrive> answer(const std::string& text, CalibrationFigure figure, const EndOfDrive& plan) {
  const auto numbers = numbers_in(text);
  if (!numbers || numbers->size() != number_count(figure)) return std::nullopt;
  const std::vector<double>& n = *numbers;
  if (plan.turn) return EndOfDrive{{}, {}, *plan.turn + radians(n[0])};
  if (plan.distance) return EndOfDrive{{}, 1e-3 * n[0], {}};
  return EndOfDrive{1e-3 * Point2(n[0], n[1]), {}, {}};
}

CalibrationPrompt::CalibrationPrompt(std::istream& input, std::vector<std::string> measured)
    : input_(input), measured_(std::move(measured)) {}

std::string CalibrationPrompt::line() {
  std::string text;
  if (std::getline(input_, text)) return text;
  fmt::print(stderr, "\n");  // the question ends without one
  throw Error("nobody answers; want somebody at a terminal, or all that was measured as --measured");
}

void CalibrationPrompt::prepare(CalibrationFigure figure, const EndOfDrive& plan) {
  if (!interactive()) return;
  fmt::print(stderr, "\n{}:\n{}\nPress Enter to start: ", to_string(figure), preparation(figure, plan));
  line();
}

EndOfDrive CalibrationPrompt::ask(CalibrationFigure figure, const EndOfDrive& plan, const RobotModel& robot) {
  if (!interactive()) {
    const std::string text = taken_ < measured_.size() ? measured_[taken_++] : "";
    if (const auto end = answer(text, figure, plan)) return *end;
    throw Error(fmt::format("--measured for {} is '{}'; want {}", to_string(figure), text,
                            number_count(figure) == 2           ? "x,y in millimetres"
                            : figure == CalibrationFigure::Spin ? "degrees beyond the turn"
                                                                : "a distance in millimetres"));
  }
  while (true) {
    fmt::print(stderr, "\n{}", question(figure, robot));
    if (const auto end = answer(line(), figure, plan)) return *end;
    fmt::print(stderr, "That is none; want {}.\n", number_count(figure) == 2 ? "two numbers" : "one number");
  }
}

}  // namespace scrubjay::apps

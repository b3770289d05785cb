/// \file
/// What an owner is told before a calibration drive, and asked after it.
#pragma once

#include <istream>
#include <optional>
#include <scrubjay/mission/calibration_session.hpp>
#include <string>
#include <vector>

namespace scrubjay::apps {

/// How to set the robot up for a figure, with a drawing. Lines of 80 columns at most.
std::string preparation(CalibrationFigure figure, const EndOfDrive& plan);
/// What to measure after it, and how to type it in.
std::string question(CalibrationFigure figure, const RobotModel& robot);
/// What somebody typed in: millimetres, or degrees beyond the planned turn. None if it is anything else.
std::optional<EndOfDrive> answer(const std::string& text, CalibrationFigure figure, const EndOfDrive& plan);

/// Talks with an owner; or, for scripts, takes what was measured from a list, in the drives' order, and says nothing.
class CalibrationPrompt {
 public:
  /// `input` must outlive it. An empty list: there is somebody to ask.
  CalibrationPrompt(std::istream& input, std::vector<std::string> measured);

  /// Explains, and waits for Enter.
  void prepare(CalibrationFigure figure, const EndOfDrive& plan);
  /// Asks until the answer is one. Throws Error if nobody answers any more, or for a list that is wrong.
  EndOfDrive ask(CalibrationFigure figure, const EndOfDrive& plan, const RobotModel& robot);
  /// Whether there is somebody who can measure again.
  bool interactive() const { return measured_.empty(); }

 private:
  std::string line();

  std::istream& input_;
  std::vector<std::string> measured_;
  std::size_t taken_ = 0;
};

}  // namespace scrubjay::apps

#include "doctor_hands.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <optional>
#include <scrubjay/io/keyboard.hpp>

#include "live_text.hpp"
#include "sensor_table.hpp"

namespace scrubjay::apps {
namespace {

/// Where the user reads what to do.
class Prompt {
 public:
  explicit Prompt(bool terminal, bool keys) : keys_(keys) {
    if (terminal) live_.emplace(STDERR_FILENO);
  }

  void show(const HandCheck& check, const oi::Sensors& sensors, oi::Model model) {
    const bool another = !shown_ || *shown_ != check.step();
    shown_ = check.step();
    const std::string task =
        fmt::format("{} of {}: {}", static_cast<int>(check.step()) + 1, kHandSteps, instruction(check.step()));
    if (!live_) {
      if (another) fmt::print(stderr, "{}\n", task);
      return;
    }
    std::vector<std::string> lines = sensor_table(sensors, model);
    lines.emplace_back();
    lines.push_back(task + (keys_ ? "  (Enter: pass over)" : ""));
    live_->show(lines, another);
  }

 private:
  bool keys_;
  std::optional<LiveText> live_;
  std::optional<HandStep> shown_;
};

bool asks_to_skip(const Key& key) {
  return key.kind == Key::Kind::Character && (key.character == '\r' || key.character == '\n');
}

}  // namespace

HandCheck check_by_hand(Examination& examination, const std::stop_token& stop) {
  const oi::Model model = examination.report().model;
  HandCheck check(model);
  std::optional<Keyboard> keyboard;
  if (::isatty(STDIN_FILENO) != 0) keyboard.emplace(STDIN_FILENO);
  Prompt prompt(::isatty(STDERR_FILENO) != 0, keyboard.has_value());
  constexpr double kLongest = 300.0;  // more than all steps' patience together [s]
  examination.watch(kLongest, [&](const oi::Sensors& sensors, double stamp) {
    check.update(sensors, stamp);
    if (keyboard) {
      const auto keys = keyboard->read();
      if (!keys) return false;
      for (const Key& key : *keys) {
        if (asks_to_skip(key)) check.skip();
      }
    }
    if (check.done() || stop.stop_requested()) return false;
    prompt.show(check, sensors, model);
    return true;
  });
  return check;
}

}  // namespace scrubjay::apps

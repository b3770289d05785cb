#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/io/diagnosis.hpp>
#include <scrubjay/oi/sensor_views.hpp>
#include <string_view>

namespace scrubjay {
namespace {

using oi::PacketId;
using Findings = std::vector<Finding>;

void problem(Findings& findings, std::string what, std::string advice) {
  findings.push_back({Finding::Kind::Problem, std::move(what), std::move(advice)});
}

void remark(Findings& findings, std::string what, std::string advice = {}) {
  findings.push_back({Finding::Kind::Remark, std::move(what), std::move(advice)});
}

/// Names between commas.
std::string listed(const std::vector<std::string_view>& names) {
  return fmt::format("{}", fmt::join(names, ", "));
}

void judge_contact(const DoctorReport& report, Findings& findings) {
  if (report.contact == Contact::Silent) {
    problem(findings, "Nobody answers",
            "wake the robot (press CLEAN, or put it on its dock), see that the plug sits all the way in, and that the "
            "adapter's TX goes to the robot's RXD");
  } else if (report.contact == Contact::Foreign) {
    problem(findings, "Somebody answers, but not as the Open Interface does",
            "see that this is the robot's port; take the battery out for ten seconds, which brings the rate of the "
            "line back to the robot's own");
  }
}

void judge_link(const DoctorReport& report, const HealthLimits& limits, Findings& findings) {
  if (report.link_lost) {
    problem(findings, "The port went away in the middle of the examination", "look after plug and cable");
    return;
  }
  const FrameCount& frames = report.frames;
  if (frames.frames == 0) {
    problem(findings, "The robot answers questions, but sends no frames",
            "take the battery out for ten seconds; if that doesn't help, its firmware may be too old to stream");
    return;
  }
  const double missing = static_cast<double>(frames.missing) / static_cast<double>(frames.missing + frames.frames);
  if (missing > limits.missing_frames) {
    problem(findings, fmt::format("{:.1f} % of the frames are missing", 100.0 * missing),
            frames.damaged > 0 ? "a bad contact or a long cable: try another one, away from the motors"
                               : "the computer or the adapter comes too late: try another USB port, without a hub");
  } else if (frames.longest_gap > limits.frame_gap) {
    problem(findings, fmt::format("The robot was silent for {:.0f} ms", 1000.0 * frames.longest_gap),
            "a loose contact, or a computer with too much else to do");
  }
  if (frames.bad_values > 0) {
    problem(findings, fmt::format("{} values were out of range, in frames that were whole", frames.bad_values),
            "the robot is of another kind than it seems: tell us its model and what doctor --json says");
  }
}

void judge_replies(const ReplyTimes& replies, const HealthLimits& limits, Findings& findings) {
  if (replies.asked == 0) return;
  if (replies.answered < limits.answered * replies.asked) {
    problem(findings, fmt::format("{} of {} questions got no answer", replies.asked - replies.answered, replies.asked),
            "a bad contact or a long cable: try another one");
  }
  if (replies.answered > 0 && replies.p95 > limits.reply_p95) {
    problem(findings, fmt::format("Answers take {:.0f} ms", 1000.0 * replies.p95),
            "an FTDI adapter may hold bytes back for 16 ms: run `setserial PORT low_latency`, or use another adapter");
  }
}

void judge_battery(const DoctorReport& report, const HealthLimits& limits, Findings& findings) {
  const oi::Sensors& s = report.sensors;
  if (!s.has(PacketId::BatteryCapacity)) return;
  const oi::ChargingState state = oi::charging_state(s);
  const double charge = s[PacketId::BatteryCharge];
  const double capacity = s[PacketId::BatteryCapacity];
  if (state == oi::ChargingState::Fault) {
    problem(findings, "The battery doesn't take the charge", "clean the contacts of robot and dock, with a dry cloth");
  }
  if (capacity < 1000.0 * limits.worn_capacity) {
    problem(findings, fmt::format("The battery holds {:.1f} Ah only", 1e-3 * capacity),
            "charge it fully twice; if that doesn't help, it is worn");
  } else if (charge < limits.low_charge * capacity && !oi::is_charging(state)) {
    problem(findings, fmt::format("The battery is nearly empty, {:.0f} %", 100.0 * charge / capacity),
            "put the robot on its dock");
  }
  if (s[PacketId::Voltage] < 1000.0 * limits.low_voltage) {
    problem(findings, fmt::format("The battery gives {:.1f} V only", 1e-3 * s[PacketId::Voltage]),
            "charge it; if it is charged, a cell is dead");
  }
  if (s[PacketId::Temperature] > limits.hot) {
    problem(findings, fmt::format("The battery is hot, {} degrees", s[PacketId::Temperature]),
            "let it cool down, off the dock");
  }
}

void judge_floor(const DoctorReport& report, const HealthLimits& limits, Findings& findings) {
  constexpr std::array<std::string_view, 4> kNames{"left", "front left", "front right", "right"};
  std::vector<std::string_view> open;
  std::vector<std::string_view> dark;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    const std::size_t flag = number(PacketId::CliffLeft) + i;
    const std::size_t signal = number(PacketId::CliffLeftSignal) + i;
    const bool has_signal = (report.sensors.known >> signal & 1) != 0;
    if (report.history[flag].always != 0) {
      open.push_back(kNames[i]);
    } else if (has_signal && report.history[signal].most < limits.dark_cliff) {
      dark.push_back(kNames[i]);
    }
  }
  if (!open.empty()) {
    problem(findings, fmt::format("No floor under: {}", listed(open)),
            "put the robot on a floor that isn't black; wipe the windows under the bumper");
  }
  if (!dark.empty()) {
    problem(findings, fmt::format("Cliff sensors that see nothing: {}", listed(dark)),
            "wipe the windows under the bumper; if that doesn't help, the sensor is dead");
  }
}

void judge_shell(const DoctorReport& report, Findings& findings) {
  const std::int32_t shell = report.history[number(PacketId::BumpsAndWheelDrops)].always;
  if ((shell & 0b00011) != 0) {
    problem(findings,
            fmt::format("The bumper is pressed all the time, {}", (shell & 3) == 3   ? "on both sides"
                                                                  : (shell & 2) != 0 ? "on the left"
                                                                                     : "on the right"),
            "move the robot away from what it touches; tap the bumper to free it from grit");
  }
  if ((shell & 0b11100) != 0) {
    problem(findings, "A wheel hangs down", "put the robot on the floor; see that the wheels move up freely");
  }
  if (report.history[number(PacketId::Buttons)].always != 0) {
    problem(findings, "A button is pressed all the time", "free it from what holds it down");
  }
}

void judge_drive(const DoctorReport& report, Findings& findings) {
  // Create 1 has its low side drivers in the first three bits; they say nothing of wheels.
  const std::int32_t overcurrents = report.history[number(PacketId::WheelOvercurrents)].ever;
  std::vector<std::string_view> motors;
  if ((overcurrents & 16) != 0) motors.push_back("left wheel");
  if ((overcurrents & 8) != 0) motors.push_back("right wheel");
  if (report.model != oi::Model::Create1 && (overcurrents & 4) != 0) motors.push_back("main brush");
  if (report.model != oi::Model::Create1 && (overcurrents & 1) != 0) motors.push_back("side brush");
  if (!motors.empty()) {
    problem(findings, fmt::format("Too much current: {}", listed(motors)), "take out the hair that is wound around it");
  }
  if (report.model == oi::Model::Create2 && oi::stasis(report.sensors).disabled) {
    remark(findings, "The caster's sensor is too dirty to tell whether the robot moves",
           "pull the front caster out and wipe it");
  }
}

void judge_hands(const HandCheck* hands, Findings& findings) {
  if (hands == nullptr) return;
  constexpr std::array<std::string_view, kHandSteps> kParts{"left bumper", "right bumper", "wheels hanging down",
                                                            "left wheel turned", "right wheel turned"};
  for (std::size_t i = 0; i < kHandSteps; ++i) {
    const HandResult result = hands->result(static_cast<HandStep>(i));
    if (result == HandResult::NotFelt) {
      problem(findings, fmt::format("Not felt: {}", kParts[i]),
              i < 2    ? "tap the bumper to free it from grit, and check again"
              : i == 2 ? "see that both wheels move down freely, and check again"
                       : "see that the wheel turns freely; its encoder may be dirty");
    } else if (result == HandResult::OtherSide) {
      problem(findings, fmt::format("The other side answered: {}", kParts[i]),
              "check again; if it was the right side, left and right are swapped in the robot");
    }
  }
}

void add_remarks(const DoctorReport& report, Findings& findings) {
  if (report.quirks.mode_one_too_high) remark(findings, "It reports its mode one too high, as some Wi-Fi robots do");
  if (report.quirks.distance_wrong) {
    remark(findings, "This release tells wrong distances and angles; scrubjay counts the wheels instead");
  } else if (report.quirks.angle_divisor != 1.0) {
    remark(findings, "This release tells wrong angles; scrubjay counts the wheels instead");
  }
}

}  // namespace

std::vector<Finding> diagnose(const DoctorReport& report, const HandCheck* hands, const HealthLimits& limits) {
  Findings findings;
  judge_contact(report, findings);
  if (report.contact != Contact::Robot) return findings;
  judge_link(report, limits, findings);
  if (report.frames.frames > 0) {
    judge_replies(report.replies, limits, findings);
    judge_battery(report, limits, findings);
    judge_floor(report, limits, findings);
    judge_shell(report, findings);
    judge_drive(report, findings);
    judge_hands(hands, findings);
  }
  add_remarks(report, findings);
  worst_first(findings);
  return findings;
}

}  // namespace scrubjay

#include "doctor_report.hpp"

#include <fmt/format.h>

#include <array>
#include <scrubjay/oi/packet.hpp>
#include <string_view>

#include "report_rows.hpp"
#include "sensor_table.hpp"

namespace scrubjay::apps {
namespace {

constexpr std::array<std::string_view, kHandSteps> kStepNames{"bumper_left", "bumper_right", "wheels_hang",
                                                              "wheel_left", "wheel_right"};
constexpr std::array<std::string_view, 4> kResultNames{"not asked", "felt", "not felt", "other side"};

std::string_view model_name(oi::Model model) {
  constexpr std::array<std::string_view, oi::kModelCount> kNames{"Roomba 500 or newer, or Create 2", "Create (2006)",
                                                                 "Roomba 400 or older"};
  return kNames[static_cast<std::size_t>(model)];
}

std::string release_text(const oi::Release& release) {
  return fmt::format("{}.{}.{}", release.major_number, release.minor_number, release.patch);
}

std::string port_row(const PortReport& port) {
  std::string text = fmt::format("{}, {} baud", port.address.path.string(), port.address.baud);
  if (!port.driver.name.empty()) text += ", driver " + port.driver.name;
  if (port.driver.latency_ms) text += fmt::format(", gathers bytes for {} ms", *port.driver.latency_ms);
  if (!port.low_latency) text += ", no low-latency mode";
  return row("port", text);
}

std::string figures(const DoctorReport& report) {
  std::string text = row("robot", std::string(model_name(report.model)));
  text += row("firmware", report.release ? "release " + release_text(*report.release) : "it doesn't tell");
  text += row("mode", report.mode ? std::string(mode_name(*report.mode)) : "it doesn't tell");
  text += row("battery", battery_line(report.sensors));
  const FrameCount& frames = report.frames;
  text += row("frames", fmt::format("{:.1f} a second ({} in {:.1f} s), longest gap {:.0f} ms", frames.per_second(),
                                    frames.frames, frames.seconds, 1000.0 * frames.longest_gap));
  text += row("lost", fmt::format("{} frames missing, {} of them damaged; {} stray bytes, {} bad values",
                                  frames.missing, frames.damaged, frames.stray_bytes, frames.bad_values));
  const ReplyTimes& replies = report.replies;
  return text +
         row("latency", fmt::format("{:.1f} ms (95 of 100 within {:.1f} ms), {} of {} questions answered",
                                    1000.0 * replies.median, 1000.0 * replies.p95, replies.answered, replies.asked));
}

std::string hands_row(const HandCheck* hands) {
  if (hands == nullptr) return row("by hand", "bumpers and wheels weren't checked; doctor --check asks you to");
  std::string text;
  for (std::size_t i = 0; i < kHandSteps; ++i) {
    std::string name(kStepNames[i]);
    name[name.find('_')] = ' ';
    const HandResult result = hands->result(static_cast<HandStep>(i));
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, kResultNames[static_cast<std::size_t>(result)]);
  }
  return row("by hand", text);
}

nlohmann::json sensors_json(const DoctorReport& report) {
  nlohmann::json sensors = nlohmann::json::object();
  for (const oi::PacketInfo& packet : oi::kPackets) {
    if (!report.sensors.has(packet.id) || packet.units.empty()) continue;
    const PacketHistory& history = report.history[number(packet.id)];
    sensors[std::string(packet.name)] = {
        {"value", report.sensors[packet.id]}, {"least", history.least}, {"most", history.most}};
  }
  return sensors;
}

nlohmann::json hands_json(const HandCheck& hands) {
  nlohmann::json results;
  for (std::size_t i = 0; i < kHandSteps; ++i) {
    const HandResult result = hands.result(static_cast<HandStep>(i));
    results[std::string(kStepNames[i])] = kResultNames[static_cast<std::size_t>(result)];
  }
  return results;
}

nlohmann::json robot_json(const DoctorReport& report) {
  constexpr std::array<std::string_view, oi::kModelCount> kModels{"create-2", "create-1", "roomba-400"};
  nlohmann::json robot{{"model", kModels[static_cast<std::size_t>(report.model)]},
                       {"release", nullptr},
                       {"mode", nullptr},
                       {"mode_one_too_high", report.quirks.mode_one_too_high},
                       {"banner", report.banner}};
  if (report.release) robot["release"] = release_text(*report.release);
  if (report.mode) robot["mode"] = mode_name(*report.mode);
  return robot;
}

}  // namespace

std::string report_text(const PortReport& port, const DoctorReport& report, const HandCheck* hands,
                        const std::vector<Finding>& findings) {
  std::string text = port_row(port);
  if (report.contact == Contact::Robot) {
    text += figures(report) + '\n';
    for (const std::string& line : sensor_table(report.sensors, report.model)) {
      text += line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
    }
    text += hands_row(hands);
  }
  return text + '\n' + findings_text(findings);
}

std::string report_json(const PortReport& port, const DoctorReport& report, const HandCheck* hands,
                        const std::vector<Finding>& findings) {
  nlohmann::json json;
  json["healthy"] = healthy(findings);
  json["port"] = {{"path", port.address.path.string()},
                  {"baud", port.address.baud},
                  {"driver", port.driver.name},
                  {"low_latency", port.low_latency}};
  if (port.driver.latency_ms) json["port"]["latency_ms"] = *port.driver.latency_ms;
  constexpr std::array<std::string_view, 3> kContacts{"silent", "foreign", "robot"};
  json["contact"] = kContacts[static_cast<std::size_t>(report.contact)];
  if (report.contact == Contact::Robot) {
    const FrameCount& frames = report.frames;
    json["robot"] = robot_json(report);
    json["sensors"] = sensors_json(report);
    json["frames"] = {
        {"count", frames.frames},          {"seconds", frames.seconds},          {"per_second", frames.per_second()},
        {"missing", frames.missing},       {"damaged", frames.damaged},          {"stray_bytes", frames.stray_bytes},
        {"bad_values", frames.bad_values}, {"longest_gap_s", frames.longest_gap}};
    json["replies"] = {{"asked", report.replies.asked},
                       {"answered", report.replies.answered},
                       {"median_s", report.replies.median},
                       {"p95_s", report.replies.p95}};
  }
  if (hands != nullptr) json["by_hand"] = hands_json(*hands);
  json["findings"] = findings_json(findings);
  return json.dump(2) + '\n';
}

}  // namespace scrubjay::apps

#include "fault_flags.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <scrubjay/error.hpp>
#include <string_view>

#include "run_options.hpp"

namespace scrubjay::apps {
namespace {

/// Up to `most` finite numbers between commas; empty if the text is anything else.
std::vector<double> parse_numbers(std::string_view text, std::size_t most) {
  std::vector<double> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (values.size() < most) {
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return {};
    values.push_back(value);
    if (stop == end) return values;
    if (*stop != ',') return {};
    at = stop + 1;
  }
  return {};
}

double share(double value, std::string_view flag, std::string_view what) {
  if (value >= 0.0 && value <= 1.0) return value;
  throw Error(fmt::format("{} is {}; want {}, from 0 to 1", flag, value, what));
}

/// FROM[,UNTIL]; none if the text is anything else.
std::optional<sim::TimeSpan> parse_span(std::string_view text) {
  const std::vector<double> values = parse_numbers(text, 2);
  if (values.empty() || values[0] < 0.0) return std::nullopt;
  sim::TimeSpan span;
  span.from = values[0];
  if (values.size() == 2) span.until = values[1];
  return span.until > span.from ? std::optional(span) : std::nullopt;
}

void add_silences(const std::string& text, sim::WireFaults& wire) {
  const std::vector<double> values = parse_numbers(text, 2);
  if (values.size() != 2 || !(values[0] > 0.0) || !(values[1] > 0.0)) {
    throw Error(fmt::format("--silence is '{}'; want EVERY,FOR in seconds, as 30,2", text));
  }
  wire.silences = 1.0 / values[0];
  wire.silence = values[1];
}

void add_sticky_wheel(const std::string& text, sim::RobotFaults& body) {
  const std::size_t comma = text.find(',');
  const std::string_view side = std::string_view(text).substr(0, comma);
  const auto span = comma == std::string::npos ? std::nullopt : parse_span(std::string_view(text).substr(comma + 1));
  if (!span || (side != "left" && side != "right")) {
    throw Error(
        fmt::format("--sticky-wheel is '{}'; want left or right, and FROM[,UNTIL] in seconds, as left,10,15", text));
  }
  body.stuck_wheel[side == "left" ? 0 : 1] = *span;
}

}  // namespace

void add_fault_flags(CLI::App& command, FaultFlags& flags) {
  command.add_option("--drop", flags.drop, "probability that a byte gets lost (0)")->check(number);
  command.add_option("--flip", flags.flip, "probability that a byte has a bit changed (0)")->check(number);
  command.add_option("--delay", flags.delay, "longest that bytes come late [ms] (0)")->check(number);
  command.add_option("--silence", flags.silence,
                     "EVERY,FOR: the wire falls silent about every so many\nseconds, for so many at most");
  command.add_flag("--mode-off-by-one", flags.mode_off_by_one, "packet 35 reports modes one too high, as some do");
  command.add_option("--encoder-start", flags.encoder_start, "first reading of both encoders, 0 to 65535 (0)");
  command.add_flag("--asleep", flags.asleep, "asleep at first: silent until its BRC pin is pulsed");
  command.add_option("--low-battery", flags.battery, "charge at the start, as a share of the full one (1)")
      ->check(number);
  command.add_option("--lifted", flags.lifted, "FROM[,UNTIL]: in somebody's hands [s]");
  command.add_option("--sticky-wheel", flags.sticky_wheels,
                     "SIDE,FROM[,UNTIL]: its left or right wheel\ndoesn't turn [s]; may be given for both");
}

EmulatedFaults make_faults(const FaultFlags& flags) {
  EmulatedFaults faults;
  faults.wire.drop = share(flags.drop, "--drop", "a probability");
  faults.wire.flip = share(flags.flip, "--flip", "a probability");
  if (!(flags.delay >= 0.0 && flags.delay <= 60'000.0)) {
    throw Error(fmt::format("--delay is {}; want milliseconds, 0 to 60000", flags.delay));
  }
  faults.wire.delay = flags.delay / 1000.0;
  if (flags.silence) add_silences(*flags.silence, faults.wire);
  faults.firmware.quirks.mode_one_too_high = flags.mode_off_by_one;
  if (flags.encoder_start < 0 || flags.encoder_start > 65'535) {
    throw Error(fmt::format("--encoder-start is {}; want counts, 0 to 65535", flags.encoder_start));
  }
  faults.firmware.encoder_start = static_cast<std::uint16_t>(flags.encoder_start);
  faults.firmware.asleep = flags.asleep;
  faults.body.battery = share(flags.battery, "--low-battery", "a share of the full charge");
  if (flags.lifted) {
    const auto span = parse_span(*flags.lifted);
    if (!span) throw Error(fmt::format("--lifted is '{}'; want FROM[,UNTIL] in seconds, as 10,15", *flags.lifted));
    faults.body.lifted = *span;
  }
  for (const std::string& wheel : flags.sticky_wheels) add_sticky_wheel(wheel, faults.body);
  return faults;
}

}  // namespace scrubjay::apps

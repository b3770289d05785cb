#include <charconv>
#include <scrubjay/oi/quirks.hpp>

namespace scrubjay::oi {
namespace {

/// A number up to 9999 off the front of `text`.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number < 0 || number > 9999) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

bool take_dot(std::string_view& text) {
  if (!text.starts_with('.')) return false;
  text.remove_prefix(1);
  return true;
}

/// "3.5.2" at the front of `text`.
std::optional<Release> release_at(std::string_view text) {
  const auto first = take_number(text);
  if (!first || !take_dot(text)) return {};
  const auto second = take_number(text);
  if (!second || !take_dot(text)) return {};
  const auto third = take_number(text);
  if (!third) return {};
  return Release{*first, *second, *third};
}

}  // namespace

std::optional<Release> parse_release(std::string_view banner) {
  constexpr std::string_view kMark = "release-";
  for (std::size_t at = banner.find(kMark); at != std::string_view::npos; at = banner.find(kMark, at)) {
    at += kMark.size();
    // The numbers follow the mark, or the name of a processor and a dash.
    std::string_view word = banner.substr(at, banner.substr(at).find_first_of(" :\r\n"));
    while (true) {
      if (const auto release = release_at(word)) return release;
      const std::size_t dash = word.find('-');
      if (dash == std::string_view::npos) break;
      word.remove_prefix(dash + 1);
    }
  }
  return {};
}

bool heeds_cliffs(int right_velocity, int left_velocity) {
  constexpr int kRobotDiameter = 347;    // [mm]
  constexpr int kWheelSeparation = 235;  // [mm]
  const int sum = right_velocity + left_velocity;
  if (sum >= 0) return sum > 0;
  const int difference =
      right_velocity > left_velocity ? right_velocity - left_velocity : left_velocity - right_velocity;
  // The radius of the arc is separation / 2 * sum / difference.
  return kWheelSeparation * -sum < kRobotDiameter * difference;
}

OiMode mode_after_safety(OiMode mode, const SafetyInputs& inputs) {
  if (mode != OiMode::Safe) return mode;
  const bool cliff = inputs.cliff && heeds_cliffs(inputs.right_velocity, inputs.left_velocity);
  return inputs.wheel_drop || inputs.charger || cliff ? OiMode::Passive : OiMode::Safe;
}

}  // namespace scrubjay::oi

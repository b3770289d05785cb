#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/trajectory_file.hpp>
#include <string_view>

#include "file_content.hpp"

namespace scrubjay {
namespace {

constexpr std::string_view kSeparators = " \t\r";

/// Eight finite numbers between blanks, and nothing else.
std::optional<std::array<double, 8>> eight_numbers(std::string_view line) {
  std::array<double, 8> numbers{};
  for (double& number : numbers) {
    line.remove_prefix(std::min(line.find_first_not_of(kSeparators), line.size()));
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    if (!line.empty() && kSeparators.find(line.front()) == std::string_view::npos) return std::nullopt;
  }
  if (line.find_first_not_of(kSeparators) != std::string_view::npos) return std::nullopt;
  return numbers;
}

/// Heading of a quaternion that may also be tilted (z-y-x Euler angles).
double yaw_of(double qx, double qy, double qz, double qw) {
  return atan2(2.0 * (qw * qz + qx * qy), qw * qw + qx * qx - qy * qy - qz * qz);
}

}  // namespace

std::string trajectory_text(std::span<const StampedPose> trajectory) {
  std::string text;
  for (const StampedPose& at : trajectory) {
    const SinCos half = sin_cos(at.pose.yaw / 2.0);
    fmt::format_to(std::back_inserter(text), "{:.9f} {:.6f} {:.6f} 0 0 0 {:.9f} {:.9f}\n", at.stamp, at.pose.x,
                   at.pose.y, half.sin, half.cos);
  }
  return text;
}

void write_trajectory(const std::filesystem::path& path, std::span<const StampedPose> trajectory) {
  write_file_atomically(path, trajectory_text(trajectory));
}

std::vector<StampedPose> read_trajectory(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> content = read_file(path);
  std::string_view rest(reinterpret_cast<const char*>(content.data()), content.size());
  std::vector<StampedPose> trajectory;
  for (int line_number = 1; !rest.empty(); ++line_number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    const std::size_t first = line.find_first_not_of(kSeparators);
    if (first == std::string_view::npos || line[first] == '#') continue;
    const auto numbers = eight_numbers(line);
    if (!numbers) {
      throw Error(fmt::format("{}:{}: want eight numbers, stamp x y z qx qy qz qw", path.string(), line_number));
    }
    const auto& [stamp, x, y, z, qx, qy, qz, qw] = *numbers;
    trajectory.push_back({stamp, {x, y, yaw_of(qx, qy, qz, qw)}});
  }
  return trajectory;
}

}  // namespace scrubjay

#include <fmt/format.h>

#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/io/robot_file.hpp>

#include "dialect_names.hpp"
#include "file_content.hpp"
#include "urdf_body.hpp"
#include "yaml_field.hpp"

namespace scrubjay {
namespace {

const NumberRange kPositive{0.0, 1e6, true, "a positive number"};
const NumberRange kNotNegative{0.0, 1e6, false, "a number of 0 or more"};
const NumberRange kCount{1.0, 100'000.0, false, "a whole number, 1 to 100000"};
const NumberRange kAngle{-kPi, kPi, false, "an angle in radians, -pi to pi"};

/// A number of the file, and where it goes.
struct Setting {
  std::string_view key;
  double* value;
  const NumberRange* range;
};

template <std::size_t N>
void read_settings(const YamlField& field, const std::array<Setting, N>& settings,
                   std::vector<std::string_view> more = {}) {
  for (const Setting& setting : settings) more.push_back(setting.key);
  field.expect_keys(more);
  for (const Setting& setting : settings) {
    if (field.has(setting.key)) *setting.value = field.at(setting.key).number(*setting.range);
  }
}

void read_protocol(const YamlField& field, RobotModel& model) {
  const std::string name = field.text();
  model.open_interface = name != "none";
  if (!model.open_interface) return;
  for (const auto& [known, dialect] : kDialectNames) {
    if (name != known) continue;
    model.protocol = dialect;
    return;
  }
  field.fail("create-2, create-1 or roomba-400, or none for a robot without an Open Interface");
}

void read_lidar(const YamlField& field, LidarModel& lidar) {
  double beams = lidar.beams;
  lidar.angle_increment = lidar.clear_range = 0.0;
  read_settings(field, std::array<Setting, 9>{{{"beams", &beams, &kCount},
                                               {"angle_min", &lidar.angle_min, &kAngle},
                                               {"angle_increment", &lidar.angle_increment, &kPositive},
                                               {"scan_time", &lidar.scan_time, &kPositive},
                                               {"min_range", &lidar.min_range, &kNotNegative},
                                               {"max_range", &lidar.max_range, &kPositive},
                                               {"clear_range", &lidar.clear_range, &kNotNegative},
                                               {"near_accuracy", &lidar.near_accuracy, &kNotNegative},
                                               {"accuracy", &lidar.accuracy, &kNotNegative}}});
  lidar.beams = static_cast<int>(beams);
  if (lidar.beams != beams) field.at("beams").fail(kCount.want);
  if (lidar.min_range >= lidar.max_range) field.fail("a min_range below its max_range");
  // Not said: all around, and clear as far as it can see.
  if (!field.has("angle_increment")) lidar.angle_increment = 2.0 * kPi / beams;
  if (!field.has("clear_range")) lidar.clear_range = lidar.max_range;
  if ((beams - 1.0) * lidar.angle_increment > 2.0 * kPi) {
    field.at("angle_increment").fail("beams that don't go around more than once");
  }
  if (lidar.clear_range > lidar.max_range) field.at("clear_range").fail("max_range or less");
}

void read_details(const YamlField& root, sim::RobotSpec& spec) {
  RobotModel& model = spec.model;
  read_settings(root,
                std::array<Setting, 6>{{{"counts_per_turn", &model.drive.counts_per_turn, &kPositive},
                                        {"max_wheel_speed", &model.max_wheel_speed, &kPositive},
                                        {"max_linear_speed", &model.max_linear_speed, &kPositive},
                                        {"max_angular_speed", &model.max_angular_speed, &kPositive},
                                        {"acceleration", &spec.acceleration, &kPositive},
                                        {"braking", &spec.braking, &kPositive}}},
                {"protocol", "light", "bumper", "wall", "infrared", "battery", "lidar"});
  if (root.has("protocol")) read_protocol(root.at("protocol"), model);
  if (root.has("light")) {
    LightSensorModel& light = model.light;
    read_settings(root.at("light"),
                  std::array<Setting, 5>{{{"gain", &light.gain, &kPositive},
                                          {"attenuation", &light.attenuation, &kPositive},
                                          {"ambient", &light.ambient, &kNotNegative},
                                          {"max_range", &light.max_range, &kPositive},
                                          {"beam_half_angle", &light.beam_half_angle, &kNotNegative}}});
  }
  if (root.has("bumper")) {
    read_settings(root.at("bumper"), std::array<Setting, 2>{{{"half_from", &model.bumper.half_from, &kAngle},
                                                             {"half_to", &model.bumper.half_to, &kAngle}}});
  }
  if (root.has("wall")) {
    read_settings(root.at("wall"), std::array<Setting, 3>{{{"min_range", &spec.wall.min_range, &kNotNegative},
                                                           {"max_range", &spec.wall.max_range, &kPositive},
                                                           {"max_signal", &spec.wall.max_signal, &kPositive}}});
  }
  if (root.has("infrared")) {
    sim::InfraredSpec& infrared = spec.infrared;
    read_settings(root.at("infrared"), std::array<Setting, 4>{{{"buoy_bearing", &infrared.buoy_bearing, &kAngle},
                                                               {"buoy_half_angle", &infrared.buoy_half_angle, &kAngle},
                                                               {"buoy_range", &infrared.buoy_range, &kNotNegative},
                                                               {"force_field", &infrared.force_field, &kNotNegative}}});
  }
  if (root.has("battery")) {
    sim::BatterySpec& battery = spec.battery;
    read_settings(root.at("battery"),
                  std::array<Setting, 6>{{{"capacity", &battery.capacity, &kPositive},
                                          {"full_voltage", &battery.full_voltage, &kPositive},
                                          {"empty_voltage", &battery.empty_voltage, &kPositive},
                                          {"idle_current", &battery.idle_current, &kNotNegative},
                                          {"drive_current", &battery.drive_current, &kNotNegative},
                                          {"charge_current", &battery.charge_current, &kNotNegative}}});
  }
  if (root.has("lidar")) {
    if (!model.lidar) root.at("lidar").fail("a link 'base_scan' in the URDF, where the lidar is");
    read_lidar(root.at("lidar"), *model.lidar);
  }
}

YamlField read_yaml(const std::filesystem::path& path) {
  const std::vector<std::uint8_t> file = read_file(path);
  return YamlField::parse(std::string(file.begin(), file.end()), path.string());
}

void read_range(const YamlField& field, std::string_view key, sim::Range& range) {
  if (!field.has(key)) return;
  const std::vector<double> ends = field.at(key).numbers(2, kNotNegative, "[low, high]");
  if (ends[0] > ends[1]) field.at(key).fail("[low, high], the lower one first");
  range = {ends[0], ends[1]};
}

}  // namespace

sim::RobotSpec read_robot(const std::filesystem::path& urdf) {
  sim::RobotSpec spec;
  read_urdf_body(urdf, spec);
  RobotModel& model = spec.model;
  model.max_linear_speed = model.max_angular_speed = 0.0;  // not said
  std::filesystem::path details = urdf;
  details.replace_extension(".yaml");
  if (std::filesystem::exists(details)) read_details(read_yaml(details), spec);
  if (model.max_linear_speed == 0.0) model.max_linear_speed = model.max_wheel_speed;
  if (model.max_angular_speed == 0.0) {
    model.max_angular_speed = 2.0 * model.max_wheel_speed / model.drive.wheel_separation;
  }
  return spec;
}

sim::NoiseProfile read_noise(const std::filesystem::path& path, std::string_view profile) {
  const YamlField field = read_yaml(path).choice(profile, "noise profile");
  sim::NoiseProfile noise;
  noise.name = profile;
  read_settings(field,
                std::array<Setting, 14>{{{"distance_error", &noise.distance_error, &kNotNegative},
                                         {"mount_error", &noise.mount_error, &kNotNegative},
                                         {"travel_noise", &noise.travel_noise, &kNotNegative},
                                         {"turn_noise", &noise.turn_noise, &kNotNegative},
                                         {"bump_kick", &noise.bump_kick, &kNotNegative},
                                         {"light_noise", &noise.light_noise, &kNotNegative},
                                         {"light_floor_noise", &noise.light_floor_noise, &kNotNegative},
                                         {"lidar_noise_share", &noise.lidar_noise_share, &kNotNegative},
                                         {"lidar_noise", &noise.lidar_noise, &kNotNegative},
                                         {"carpet_slip", &noise.carpet_slip, &kNotNegative},
                                         {"push_slip", &noise.push_slip, &kNotNegative},
                                         {"wall_friction", &noise.wall_friction, &kNotNegative},
                                         {"speed_step", &noise.speed_step, &kNotNegative},
                                         {"speed_deadband", &noise.speed_deadband, &kNotNegative}}},
                {"wheel_mismatch", "separation_error", "grip", "albedo"});
  read_range(field, "wheel_mismatch", noise.wheel_mismatch);
  read_range(field, "separation_error", noise.separation_error);
  read_range(field, "grip", noise.grip);
  read_range(field, "albedo", noise.albedo);
  return noise;
}

}  // namespace scrubjay

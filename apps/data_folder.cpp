#include "data_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/nearest_word.hpp>

namespace scrubjay::apps {
namespace {

struct KnownRobot {
  std::string_view name;
  std::string_view urdf;
};

// A Create 2 is a Roomba 600 without its vacuum: same body, same interface.
constexpr std::array<KnownRobot, 5> kRobots{{{"roomba-600", "roomba_600.urdf"},
                                             {"create-2", "roomba_600.urdf"},
                                             {"create-1", "create_1.urdf"},
                                             {"roomba-400", "roomba_400.urdf"},
                                             {"turtlebot3-burger", "turtlebot3_burger.urdf"}}};

std::string known_robots() {
  std::string names;
  for (const KnownRobot& robot : kRobots) names.append(names.empty() ? "" : ", ").append(robot.name);
  return names;
}

}  // namespace

std::filesystem::path data_folder() {
  if (const char* named = std::getenv("SCRUBJAY_DATA_DIR")) return named;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  for (std::filesystem::path folder = program.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    for (const std::filesystem::path& candidate : {folder / "share" / "scrubjay", folder}) {
      if (std::filesystem::exists(candidate / "urdf" / "noise.yaml")) return candidate;
    }
  }
  if (std::filesystem::exists(SCRUBJAY_SOURCE_DIR "/urdf/noise.yaml")) return SCRUBJAY_SOURCE_DIR;
  throw Error(
      "the robots that come with scrubjay can't be found; set SCRUBJAY_DATA_DIR to the folder that holds urdf/");
}

std::filesystem::path robot_file(const std::string& model) {
  for (const KnownRobot& robot : kRobots) {
    if (robot.name == model) return data_folder() / "urdf" / robot.urdf;
  }
  if (std::filesystem::path(model).extension() == ".urdf") return model;
  std::vector<std::string_view> names;
  for (const KnownRobot& robot : kRobots) names.push_back(robot.name);
  throw Error("there is no model '" + model + "'; did you mean '" + std::string(nearest_word(model, names)) +
              "'? (known: " + known_robots() + ", or a file.urdf)");
}

sim::RobotSpec find_robot(const std::string& model) {
  return read_robot(robot_file(model));
}

sim::RobotSpec find_oi_robot(const std::string& model) {
  sim::RobotSpec robot = find_robot(model);
  if (robot.model.open_interface) return robot;
  throw Error("--model is " + model +
              ", which doesn't speak the Open Interface; want roomba-600, create-2, create-1 or roomba-400");
}

sim::NoiseProfile find_noise(const std::string& profile) {
  return read_noise(data_folder() / "urdf" / "noise.yaml", profile);
}

}  // namespace scrubjay::apps

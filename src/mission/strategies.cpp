#include <algorithm>
#include <array>
#include <scrubjay/behavior/edge_follow.hpp>
#include <scrubjay/behavior/random_walk.hpp>
#include <scrubjay/behavior/reactive.hpp>
#include <scrubjay/behavior/wander.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/exploration/contact_frontier.hpp>
#include <scrubjay/exploration/frontier_explorer.hpp>
#include <scrubjay/exploration/tile_explorer.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/nearest_word.hpp>
#include <scrubjay/planning/return_home.hpp>
#include <string>

namespace scrubjay {
namespace {

/// What a robot must feel the world with.
enum class Wants : std::uint8_t { Anything, Bumper, Lidar };

using Make = std::unique_ptr<Behavior> (*)(const StrategySetting&);

template <typename Strategy>
std::unique_ptr<Behavior> make(const StrategySetting& setting) {
  return std::make_unique<Strategy>(setting.robot, setting.random);
}

/// Those that plan know of bounds.
template <typename Strategy, typename Params>
std::unique_ptr<Behavior> make_within(const StrategySetting& setting) {
  Params params;
  params.within = setting.within;
  if constexpr (std::is_constructible_v<Strategy, RobotModel, Random, Params>) {
    return std::make_unique<Strategy>(setting.robot, setting.random, params);
  } else {
    return std::make_unique<Strategy>(setting.robot, params);
  }
}

/// What else it can be told.
enum class Heeds : std::uint8_t {
  Nothing,       ///< it goes on for ever
  ReturnHome,    ///< it ends, and can drive home then
  BoundsAsWell,  ///< it plans, and keeps to bounds
};

struct Row {
  std::string_view name;
  Wants wants;
  Heeds heeds;
  Make make;
};

constexpr std::array<Row, 10> kStrategies{{
    {"random-2", Wants::Bumper, Heeds::Nothing, make<Random2>},
    {"random-3", Wants::Bumper, Heeds::Nothing, make<Random3>},
    {"random-look", Wants::Bumper, Heeds::Nothing, make<RandomLook>},
    {"random-aware", Wants::Bumper, Heeds::Nothing, make<RandomAware>},
    {"reactive", Wants::Bumper, Heeds::Nothing,
     [](const StrategySetting& setting) -> std::unique_ptr<Behavior> {
       return std::make_unique<Reactive>(setting.robot);
     }},
    {"wander", Wants::Anything, Heeds::Nothing, make<Wander>},
    {"edge-follow", Wants::Bumper, Heeds::ReturnHome, make<EdgeFollow>},
    {"contact-frontier", Wants::Bumper, Heeds::BoundsAsWell, make_within<ContactFrontier, ContactFrontierParams>},
    {"tiles", Wants::Lidar, Heeds::BoundsAsWell, make_within<TileExplorer, TileExplorerParams>},
    {"frontiers", Wants::Lidar, Heeds::BoundsAsWell, make_within<FrontierExplorer, FrontierExplorerParams>},
}};

bool suits(const Row& row, const RobotModel& robot) {
  switch (row.wants) {
    case Wants::Anything:
      return true;
    case Wants::Bumper:
      return robot.open_interface;
    case Wants::Lidar:
      return robot.lidar.has_value();
  }
  return false;
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

/// Throws Error for what the strategy would leave undone.
void expect_heed(const Row& row, const StrategySetting& setting) {
  const auto refuse = [&](Heeds least, const char* what) {
    if (row.heeds >= least) return;
    std::vector<std::string_view> able;
    for (const Row& other : kStrategies) {
      if (other.heeds >= least && suits(other, setting.robot)) able.push_back(other.name);
    }
    throw Error("strategy '" + std::string(row.name) + "' " + what + " (those that can: " + listed(able) + ")");
  };
  if (setting.within) refuse(Heeds::BoundsAsWell, "plans nothing, and can't stay within bounds");
  if (setting.return_home) refuse(Heeds::ReturnHome, "never ends, and can't return home");
}

}  // namespace

std::vector<std::string_view> strategy_names() {
  std::vector<std::string_view> names;
  for (const Row& row : kStrategies) names.push_back(row.name);
  return names;
}

std::vector<std::string_view> strategy_names(const RobotModel& robot) {
  std::vector<std::string_view> names;
  for (const Row& row : kStrategies) {
    if (suits(row, robot)) names.push_back(row.name);
  }
  return names;
}

std::string_view default_strategy(const RobotModel& robot) {
  return robot.lidar ? "frontiers" : "contact-frontier";
}

std::unique_ptr<Behavior> make_strategy(std::string_view name, const StrategySetting& setting) {
  const auto row = std::ranges::find(kStrategies, name, &Row::name);
  if (row == kStrategies.end()) {
    throw Error("there is no strategy '" + std::string(name) + "'; did you mean '" +
                std::string(nearest_word(name, strategy_names())) + "'? (known: " + listed(strategy_names()) + ")");
  }
  if (!suits(*row, setting.robot)) {
    throw Error("strategy '" + std::string(name) + "' wants " + (row->wants == Wants::Lidar ? "a lidar" : "a bumper") +
                ", which this robot hasn't (it can do: " + listed(strategy_names(setting.robot)) + ")");
  }
  expect_heed(*row, setting);
  std::unique_ptr<Behavior> strategy = row->make(setting);
  if (!setting.return_home) return strategy;
  return std::make_unique<ReturnHome>(setting.robot, std::move(strategy));
}

}  // namespace scrubjay

#include <array>
#include <scrubjay/behavior/edge_follow.hpp>
#include <scrubjay/behavior/random_walk.hpp>
#include <scrubjay/behavior/reactive.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <scrubjay/nearest_word.hpp>
#include <string>

namespace scrubjay {
namespace {

using Make = std::unique_ptr<Behavior> (*)(const RobotModel&, const Random&);

template <typename Strategy>
std::unique_ptr<Behavior> make(const RobotModel& robot, const Random& random) {
  return std::make_unique<Strategy>(robot, random);
}

struct Row {
  std::string_view name;
  Make make;
};

constexpr std::array<Row, 6> kStrategies{{
    {"random-2", make<Random2>},
    {"random-3", make<Random3>},
    {"random-look", make<RandomLook>},
    {"random-aware", make<RandomAware>},
    {"reactive",
     [](const RobotModel& robot, const Random&) -> std::unique_ptr<Behavior> {
       return std::make_unique<Reactive>(robot);
     }},
    {"edge-follow", make<EdgeFollow>},
}};

}  // namespace

std::vector<std::string_view> strategy_names() {
  std::vector<std::string_view> names;
  names.reserve(kStrategies.size());
  for (const Row& row : kStrategies) names.push_back(row.name);
  return names;
}

std::unique_ptr<Behavior> make_strategy(std::string_view name, const RobotModel& robot, const Random& random) {
  for (const Row& row : kStrategies) {
    if (row.name == name) return row.make(robot, random);
  }
  std::string known;
  for (const Row& row : kStrategies) known.append(known.empty() ? "" : ", ").append(row.name);
  throw Error("there is no strategy '" + std::string(name) + "'; did you mean '" +
              std::string(nearest_word(name, strategy_names())) + "'? (known: " + known + ")");
}

}  // namespace scrubjay

#include <gmock/gmock.h>

#include <algorithm>
#include <scrubjay/error.hpp>
#include <scrubjay/exploration/tile_explorer.hpp>
#include <scrubjay/mapping/lidar_mapper.hpp>
#include <string>
#include <vector>

#include "behavior/lidar_world.hpp"
#include "behavior/situations.hpp"

namespace scrubjay::test {
namespace {

using ::testing::IsEmpty;
using ::testing::Not;

void add(std::vector<Segment2>& walls, const std::vector<Segment2>& more) {
  walls.insert(walls.end(), more.begin(), more.end());
}

/// Three rooms in a row, their doorways at opposite ends.
std::vector<Segment2> three_rooms() {
  std::vector<Segment2> walls = box_segments({0.0, 0.0}, {7.5, 3.0});
  add(walls, {{{2.5, 0.0}, {2.5, 2.1}}, {{5.0, 0.9}, {5.0, 3.0}}});
  return walls;
}

/// An exploration of a small world, with exact poses.
struct Exploration {
  explicit Exploration(std::vector<Segment2> walls, const Pose2& start, const TileExplorerParams& params = {})
      : world(std::move(walls), start, 1), mapper(world.robot(), 0.05), explorer(world.robot(), params) {}

  /// Runs until it is done, or for so many seconds.
  void run(double seconds) {
    const int ticks = static_cast<int>(std::lround(seconds / LidarWorld::kTick));
    for (int i = 0; i < ticks && !done; ++i) {
      const Frame& frame = world.sense();
      mapper.update(frame, world.estimate());
      const Decision decision = explorer.decide({frame, world.estimate(), mapper.map(), mapper.changed()});
      done = decision.done;
      if (log.empty() || log.back() != decision.doing) log.emplace_back(decision.doing);
      world.move(decision.motion);
      least = std::min(least, world.clearance());
    }
  }
  /// The share of points in a rectangle that are known as free.
  double known(const Point2& low, const Point2& high) const {
    int all = 0;
    int free = 0;
    for (double x = low.x(); x < high.x(); x += 0.05) {
      for (double y = low.y(); y < high.y(); y += 0.05) {
        const GridView<const LogOdds> map = mapper.map();
        const CellIndex cell = map.geometry.cell_at({x, y});
        ++all;
        free += map.contains(cell) && trinary(map[cell]) == kFree;
      }
    }
    return static_cast<double>(free) / all;
  }
  std::vector<std::string> reasons() const {
    std::vector<std::string> why;
    for (const Leftover& left : explorer.leftovers()) why.emplace_back(left.why);
    return why;
  }

  LidarWorld world;
  LidarMapper mapper;
  TileExplorer explorer;
  bool done = false;
  std::vector<std::string> log;
  double least = 1.0;
};

TEST(TileExplorerTest, ExploresARoomAndSaysSo) {
  Exploration exploration(box_segments({0.0, 0.0}, {4.0, 3.0}), {0.5, 0.5, 0.0});
  exploration.run(300.0);
  EXPECT_TRUE(exploration.done);
  EXPECT_GT(exploration.known({0.1, 0.1}, {3.9, 2.9}), 0.97);
  EXPECT_GT(exploration.least, 0.0);
  EXPECT_TRUE(exploration.explorer
                  .decide({exploration.world.sense(), exploration.world.estimate(), exploration.mapper.map(),
                           exploration.mapper.changed()})
                  .done)
      << "and stays so";
}

TEST(TileExplorerTest, ExploresRoomAfterRoom) {
  for (const bool extended : {true, false}) {
    TileExplorerParams params;
    params.extended_common_visibility = extended;
    Exploration exploration(three_rooms(), {0.6, 0.6, 0.0}, params);
    exploration.run(900.0);
    EXPECT_TRUE(exploration.done);
    EXPECT_GT(exploration.known({0.1, 0.1}, {2.4, 2.9}), 0.95);
    EXPECT_GT(exploration.known({2.6, 0.1}, {4.9, 2.9}), 0.95);
    EXPECT_GT(exploration.known({5.1, 0.1}, {7.4, 2.9}), 0.95);
    EXPECT_GT(exploration.least, 0.0);
    EXPECT_THAT(exploration.log, ::testing::Contains("to a way point")) << "behind a corner there is always one";
  }
}

TEST(TileExplorerTest, WantsALidar) {
  EXPECT_THAT([] { TileExplorer{RobotModel{}}; },
              ::testing::ThrowsMessage<Error>(::testing::HasSubstr("the robot has no lidar")));
}

TEST(TileExplorerTest, WaitsForAMap) {
  TileExplorer explorer(burger());
  for (int i = 0; i < 500; ++i) {
    const Decision decision = decide(explorer, quiet_frame(0.02 * i));
    EXPECT_EQ(decision.motion, Motion{});
    EXPECT_FALSE(decision.done);
  }
}

TEST(TileExplorerTest, LeavesWhatIsOutOfBounds) {
  TileExplorerParams params;
  params.within = Bounds2{{0.0, 0.0}, {2.5, 3.0}};
  Exploration exploration(three_rooms(), {0.6, 0.6, 0.0}, params);
  exploration.run(900.0);
  EXPECT_TRUE(exploration.done);
  EXPECT_LT(exploration.world.pose().x, 2.6);
  EXPECT_LT(exploration.known({5.1, 0.1}, {7.4, 2.9}), 0.5);
  EXPECT_THAT(exploration.reasons(), ::testing::Contains("out of bounds"));
}

TEST(TileExplorerTest, SaysWhatIsTooNarrow) {
  // A passage leads out of the room: the lidar sees into it, and this disc with its margins stays out.
  const std::vector<Segment2> walls{{{0.0, 0.0}, {3.0, 0.0}},  {{3.0, 0.0}, {3.0, 0.7}},   {{3.0, 0.7}, {9.0, 0.7}},
                                    {{9.0, 0.7}, {9.0, 1.05}}, {{9.0, 1.05}, {3.0, 1.05}}, {{3.0, 1.05}, {3.0, 2.0}},
                                    {{3.0, 2.0}, {0.0, 2.0}},  {{0.0, 2.0}, {0.0, 0.0}}};
  TileExplorerParams params;
  params.costs.margin = 0.12;
  Exploration exploration(walls, {1.0, 1.0, 0.0}, params);
  exploration.run(600.0);
  EXPECT_TRUE(exploration.done);
  EXPECT_LT(exploration.world.pose().x, 3.0);
  EXPECT_THAT(exploration.reasons(), ::testing::Contains("too narrow for the robot"));

  params.costs.margin = 0.03;
  Exploration slim(walls, {1.0, 1.0, 0.0}, params);
  slim.run(600.0);
  EXPECT_TRUE(slim.done);
  EXPECT_GT(slim.known({3.0, 0.75}, {8.9, 1.0}), 0.95) << "with less of a margin it goes in";
  EXPECT_GT(slim.least, 0.0);
}

TEST(TileExplorerTest, LeftoversAreKnownWhenItIsStoppedEarly) {
  Exploration exploration(three_rooms(), {0.6, 0.6, 0.0});
  exploration.run(3.0);
  EXPECT_FALSE(exploration.done);
  ASSERT_THAT(exploration.explorer.leftovers(), Not(IsEmpty()));
  EXPECT_THAT(exploration.reasons(), ::testing::Contains("not reached yet"));
  EXPECT_DOUBLE_EQ(exploration.explorer.leftovers()[0].size, 0.25);
}

TEST(TileExplorerTest, TheSameWorldIsExploredTheSameWay) {
  Exploration one(three_rooms(), {0.6, 0.6, 0.0});
  Exploration same(three_rooms(), {0.6, 0.6, 0.0});
  one.run(100.0);
  same.run(100.0);
  EXPECT_EQ(one.world.pose(), same.world.pose());
  EXPECT_EQ(one.log, same.log);
}

}  // namespace
}  // namespace scrubjay::test

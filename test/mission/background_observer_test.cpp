#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <future>
#include <scrubjay/error.hpp>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <scrubjay/mission/background_observer.hpp>

#include "fakes.hpp"

namespace scrubjay {
namespace {

using testing::ElementsAreArray;
using testing::SizeIs;

struct Seen {
  double stamp, left_travel, x;
  std::vector<float> ranges;
  GridGeometry geometry;
  std::vector<LogOdds> cells;
  std::string doing;
  CellRect changed;
  std::vector<Point2> plan;
  std::vector<double> leftovers;

  bool operator==(const Seen&) const = default;
};

/// Keeps all that it sees; waits in notify() until it may.
class Witness final : public Observer {
 public:
  void notify(const Snapshot& now) override {
    ++entered;
    gate.wait();
    if (seen.size() == fails_after) throw Error("the disc is full", Error::Kind::Failure);
    Seen one{now.frame.stamp, now.frame.left_travel, now.estimate.pose.x, {}, now.map.geometry, {}, "", {}, {}, {}};
    if (now.frame.scan) one.ranges.assign(now.frame.scan->ranges.begin(), now.frame.scan->ranges.end());
    one.cells.assign(now.map.cells, now.map.cells + now.map.geometry.size());
    one.doing = now.decision.doing;
    one.changed = now.changed;
    one.plan.assign(now.plan.begin(), now.plan.end());
    for (const Leftover& left : now.leftovers) one.leftovers.push_back(left.size);
    seen.push_back(std::move(one));
  }
  void open() { open_.set_value(); }

  std::vector<Seen> seen;
  std::size_t fails_after = ~std::size_t{0};
  std::atomic<int> entered = 0;

 private:
  std::promise<void> open_;

 public:
  std::shared_future<void> gate = open_.get_future().share();
};

/// A mission of which each tick changes something: the map grows, and scans overwrite one another.
class BackgroundObserverTest : public testing::Test {
 protected:
  void tick(std::initializer_list<Observer*> observers) {
    ranges_.assign(10, static_cast<float>(random_.uniform()));
    frame_.stamp += test::kTick;
    frame_.left_travel = 1.0 / 64;
    frame_.scan.reset();
    if (random_.below(2) == 0) frame_.scan = LaserScan{.ranges = ranges_};
    estimate_.pose.x += 0.01;
    const Point2 somewhere(random_.uniform() * reach_, -random_.uniform() * reach_);
    reach_ *= 1.02;
    map_.cover(somewhere, 0.3);
    const CellRect changed = cells_around(map_.view().geometry, somewhere, 0.2);
    for (std::int32_t y = changed.low.y; y < changed.high.y; ++y) {
      for (std::int32_t x = changed.low.x; x < changed.high.x; ++x) {
        map_.view()[{x, y}] = static_cast<LogOdds>(random_.below(100));
      }
    }
    plan_.assign(random_.below(4), somewhere);
    leftovers_.assign(random_.below(3), Leftover{.size = random_.uniform()});
    const Decision decision{{}, "looking", false};
    for (Observer* observer : observers) {
      observer->notify({frame_, estimate_, std::as_const(map_).view(), decision, changed, plan_, leftovers_});
    }
    // Nothing of a snapshot is there any more when the next one is made.
    std::fill(ranges_.begin(), ranges_.end(), -1.0f);
    std::fill(plan_.begin(), plan_.end(), Point2(99.0, 99.0));
  }

  Random random_{1};
  Frame frame_;
  PoseEstimate estimate_;
  GrowingMap map_{0.05};
  double reach_ = 0.5;
  std::vector<float> ranges_;
  std::vector<Point2> plan_;
  std::vector<Leftover> leftovers_;
  Witness behind_;
};

TEST_F(BackgroundObserverTest, ShowsWhatTheMissionShowedInTheSameOrder) {
  Witness before;
  before.open();
  behind_.open();
  BackgroundObserver background(behind_);
  for (int i = 0; i < 200; ++i) tick({&before, &background});
  background.finish();
  EXPECT_EQ(behind_.seen, before.seen);
  EXPECT_GT(before.seen.back().geometry.size(), 10 * before.seen.front().geometry.size());
  EXPECT_EQ(background.left_out(), 0U);
}

TEST_F(BackgroundObserverTest, NeverWaitsForTheOther) {
  BackgroundObserver background(behind_);
  for (int i = 0; i < 100; ++i) tick({&background});  // or this would never come back
  EXPECT_LE(behind_.entered, 1);
  behind_.open();
  background.finish();
  EXPECT_THAT(behind_.seen, SizeIs(100));
}

TEST_F(BackgroundObserverTest, WhatIsLeftOutComesWithTheNextTick) {
  Witness before;
  before.open();
  BackgroundObserver background(behind_, BackgroundObserver::WhenFull::LeaveOut, 10);
  tick({&before, &background});
  while (behind_.entered == 0) std::this_thread::yield();
  // The first one is being looked at, ten wait.
  for (int i = 0; i < 30; ++i) tick({&before, &background});
  EXPECT_EQ(background.left_out(), 20U);
  behind_.open();
  background.finish();
  tick({&before, &background});
  background.finish();

  ASSERT_THAT(behind_.seen, SizeIs(12));
  const Seen& last = behind_.seen.back();
  EXPECT_EQ(last.cells, before.seen.back().cells);
  EXPECT_EQ(last.geometry, before.seen.back().geometry);
  EXPECT_EQ(last.left_travel, 21.0 / 64);
  CellRect all;
  for (std::size_t i = 11; i < before.seen.size(); ++i) {
    all = bounding(all, moved(before.seen[i].changed, shift_between(before.seen[i].geometry, last.geometry)));
  }
  EXPECT_EQ(last.changed, all);
}

TEST_F(BackgroundObserverTest, LeavesNothingOutWhereTheMissionMayWait) {
  Witness before;
  before.open();
  behind_.open();
  BackgroundObserver background(behind_, BackgroundObserver::WhenFull::Wait, 1);
  for (int i = 0; i < 100; ++i) tick({&before, &background});
  background.finish();
  EXPECT_EQ(behind_.seen, before.seen);
  EXPECT_EQ(background.left_out(), 0U);
}

TEST_F(BackgroundObserverTest, ThrowsWhatTheOtherThrew) {
  behind_.open();
  behind_.fails_after = 3;
  BackgroundObserver background(behind_);
  EXPECT_THROW(
      {
        for (int i = 0; i < 5; ++i) tick({&background});
        background.finish();
      },
      Error);
  EXPECT_THAT(behind_.seen, SizeIs(3));
}

TEST_F(BackgroundObserverTest, EndsThoughNotAllWasSeen) {
  {
    BackgroundObserver background(behind_);
    for (int i = 0; i < 50; ++i) tick({&background});
    behind_.open();
  }
  EXPECT_LE(behind_.seen.size(), 50U);
}

}  // namespace
}  // namespace scrubjay

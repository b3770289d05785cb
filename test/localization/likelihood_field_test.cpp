#include <gtest/gtest.h>

#include <algorithm>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/localization/likelihood_field.hpp>

namespace scrubjay {
namespace {

/// A map of which cells change at random.
struct ChangingMap {
  explicit ChangingMap(std::int32_t width, std::int32_t height)
      : geometry{0.05, {0.0, 0.0}, width, height}, cells(geometry.size()) {}
  GridView<LogOdds> view() { return {geometry, cells.data()}; }

  CellRect change(Random& random, int count) {
    CellRect changed;
    for (int i = 0; i < count; ++i) {
      const CellIndex c{static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(geometry.width))),
                        static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(geometry.height)))};
      view()[c] = static_cast<LogOdds>(random.uniform() < 0.4 ? 60 : -40);
      changed = bounding(changed, {c, {c.x + 1, c.y + 1}});
    }
    return changed;
  }

  GridGeometry geometry;
  std::vector<LogOdds> cells;
};

/// By definition: 255 * (1 - d^2 / 9) for the nearest occupied cell within two cells along either axis.
int expected_fit(ChangingMap& map, CellIndex c) {
  int best = 0;
  for (std::int32_t y = c.y - 2; y <= c.y + 2; ++y) {
    for (std::int32_t x = c.x - 2; x <= c.x + 2; ++x) {
      if (!map.geometry.contains({x, y}) || map.view()[{x, y}] < kOccupiedLogOdds) continue;
      const int squared = (x - c.x) * (x - c.x) + (y - c.y) * (y - c.y);
      best = std::max(best, (255 * (9 - squared) + 4) / 9);
    }
  }
  return best;
}

void expect_follows(const LikelihoodField& field, ChangingMap& map) {
  for (std::int32_t y = -1; y <= map.geometry.height; ++y) {
    for (std::int32_t x = -1; x <= map.geometry.width; ++x) {
      const int expected = map.geometry.contains({x, y}) ? expected_fit(map, {x, y}) : 0;
      ASSERT_EQ(field.at({x, y}), expected) << x << ", " << y;
    }
  }
}

TEST(LikelihoodFieldTest, FollowsCellsThatComeAndGo) {
  Random random(1);
  ChangingMap map(83, 31);
  LikelihoodField field;
  field.follow(map.view(), {});
  for (int i = 0; i < 60; ++i) {
    field.follow(map.view(), map.change(random, 40));
    expect_follows(field, map);
  }
}

TEST(LikelihoodFieldTest, StartsAnewWhenTheMapGrew) {
  Random random(2);
  ChangingMap small(10, 10);
  ChangingMap large(50, 40);
  large.change(random, 300);
  LikelihoodField field;
  field.follow(small.view(), {});
  field.follow(large.view(), {{3, 3}, {4, 4}});
  expect_follows(field, large);
}

TEST(LikelihoodFieldTest, BoundsEveryBlockOfOffsets) {
  Random random(3);
  ChangingMap map(41, 22);
  LikelihoodField field;
  for (int i = 0; i < 20; ++i) {
    field.follow(map.view(), map.change(random, 25));
    for (std::int32_t y = -6; y < 28; ++y) {
      for (std::int32_t x = -6; x < 47; ++x) {
        for (std::int32_t v = 0; v < LikelihoodField::kBlock; ++v) {
          for (std::int32_t u = 0; u < LikelihoodField::kBlock; ++u) {
            ASSERT_GE(field.bound({x, y}), field.at({x + u, y + v})) << x << ", " << y;
          }
        }
      }
    }
  }
}

TEST(LikelihoodFieldTest, TellsFarFromNear) {
  ChangingMap map(60, 60);
  map.view()[{30, 30}] = 60;
  LikelihoodField field;
  field.follow(map.view(), {});
  EXPECT_EQ(field.bound({10, 10}), 0);  // a bound that is always high would bound, too
  EXPECT_EQ(field.at({30, 30}), LikelihoodField::kBest);
  EXPECT_EQ(field.at({33, 30}), 0);
}

}  // namespace
}  // namespace scrubjay

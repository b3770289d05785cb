#include <gtest/gtest.h>

#include <scrubjay/exploration/felt_costs.hpp>
#include <scrubjay/mapping/growing_map.hpp>

namespace scrubjay {
namespace {

class FeltCostsTest : public testing::Test {
 protected:
  FeltCostsTest() {
    map.cover({0.0, 0.0}, 1.0);
    params.radius = 0.1735;
    params.margin = 0.0;
    params.through_unknown = true;
  }
  void update(FeltCosts& costs) { costs.update(map.view(), cells_of(map.view().geometry)); }
  bool passable(const FeltCosts& costs, const Point2& p) const {
    return costs.passable(map.view().geometry.cell_at(p));
  }

  GrowingMap map{0.05};
  CostMapParams params;
};

TEST_F(FeltCostsTest, IsTheCostMapAsLongAsNothingIsFelt) {
  map.view()[map.view().geometry.cell_at({0.5, 0.5})] = kMaxLogOdds;
  FeltCosts costs(params);
  update(costs);
  CostMap plain(params);
  plain.update(map.view(), cells_of(map.view().geometry));
  for (std::size_t i = 0; i < map.view().geometry.size(); ++i) {
    ASSERT_EQ(costs.view().cells[i], plain.view().cells[i]);
  }
}

TEST_F(FeltCostsTest, WhereItFeltSomethingItCantGoUntilThatIsForgiven) {
  FeltCosts costs(params);
  update(costs);
  EXPECT_FALSE(costs.any_blocked());
  costs.block({0.3, 0.0});
  EXPECT_TRUE(costs.any_blocked());
  EXPECT_FALSE(passable(costs, {0.3, 0.0}));
  EXPECT_TRUE(passable(costs, {0.4, 0.0}));
  update(costs);
  EXPECT_FALSE(passable(costs, {0.3, 0.0})) << "whatever the map says";
  costs.unblock({0.3, 0.0});
  EXPECT_TRUE(passable(costs, {0.3, 0.0}));
  EXPECT_FALSE(costs.any_blocked());
}

TEST_F(FeltCostsTest, ForgivesAllButWhatIsForGood) {
  FeltCosts costs(params);
  update(costs);
  costs.block({0.3, 0.0});
  costs.block({-0.3, 0.0});
  costs.block({0.0, 0.3}, true);
  costs.unblock_all();
  EXPECT_FALSE(costs.any_blocked());
  EXPECT_TRUE(passable(costs, {0.3, 0.0}));
  EXPECT_TRUE(passable(costs, {-0.3, 0.0}));
  costs.unblock({0.0, 0.3});
  EXPECT_FALSE(passable(costs, {0.0, 0.3}));
}

TEST_F(FeltCostsTest, StaysWhereItIsWhenTheMapGrows) {
  FeltCosts costs(params);
  update(costs);
  costs.block({0.32, 0.12});
  map.cover({-4.0, -3.0}, 0.5);
  costs.update(map.view(), {});
  EXPECT_FALSE(passable(costs, {0.32, 0.12}));
  EXPECT_TRUE(passable(costs, {-4.0, -3.0}));
}

TEST_F(FeltCostsTest, NeverLeavesItsBounds) {
  FeltCosts costs(params, Bounds2{{-0.5, -0.5}, {0.5, 0.5}});
  update(costs);
  EXPECT_TRUE(passable(costs, {0.4, 0.4}));
  EXPECT_FALSE(passable(costs, {0.6, 0.0}));
  map.cover({2.0, 0.0}, 0.5);
  costs.update(map.view(), {});
  EXPECT_FALSE(passable(costs, {2.0, 0.0}));
}

}  // namespace
}  // namespace scrubjay

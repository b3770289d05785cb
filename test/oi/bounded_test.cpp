#include <gtest/gtest.h>

#include <scrubjay/oi/bounded.hpp>
#include <scrubjay/oi/command_values.hpp>
#include <type_traits>
#include <vector>

namespace scrubjay::oi {
namespace {

template <typename T, int Value>
concept BuildsFrom = requires {
  typename std::bool_constant<(T(Value), true)>;
};

TEST(BoundedTest, LiteralsOutOfRangeDontCompile) {
  static_assert(BuildsFrom<Velocity, -500> && BuildsFrom<Velocity, 500>);
  static_assert(!BuildsFrom<Velocity, -501> && !BuildsFrom<Velocity, 501>);
  static_assert(BuildsFrom<Radius, 2000> && !BuildsFrom<Radius, 2001>);
  static_assert(!BuildsFrom<Minute, 60> && !BuildsFrom<Minute, -1> && !BuildsFrom<Minute, 65536>);
}

TEST(BoundedTest, OfTakesTheRangeAndNoMore) {
  EXPECT_EQ(Velocity::of(-500)->value(), -500);
  EXPECT_EQ(Velocity::of(500)->value(), 500);
  EXPECT_FALSE(Velocity::of(501));
  EXPECT_FALSE(Velocity::of(-501));
  EXPECT_FALSE(Velocity::of(65536 + 1));
}

TEST(BoundedTest, ClampedGoesToTheNearestEnd) {
  EXPECT_EQ(Velocity::clamped(10000).value(), 500);
  EXPECT_EQ(Velocity::clamped(-10000).value(), -500);
  EXPECT_EQ(Velocity::clamped(17).value(), 17);
}

TEST(BoundedTest, DefaultIsTheValueNearestToZero) {
  EXPECT_EQ(Velocity().value(), 0);
  EXPECT_EQ(Ascii().value(), 32);
  EXPECT_EQ((Bounded<-9, -3>().value()), -3);
}

TEST(BoundedTest, SizeOnTheWireFollowsFromTheRange) {
  static_assert(std::is_same_v<Bounded<0, 255>::Wire, std::uint8_t>);
  static_assert(std::is_same_v<Bounded<-1, 127>::Wire, std::int8_t>);
  static_assert(std::is_same_v<Bounded<-1, 128>::Wire, std::int16_t>);
  static_assert(std::is_same_v<Bounded<0, 256>::Wire, std::int16_t>);
}

TEST(FixedListTest, TakesAsManyAsItMay) {
  using List = FixedList<int, 1, 3>;
  EXPECT_FALSE(List::of({}));
  EXPECT_EQ(List::of(std::vector{1, 2, 3})->size(), 3U);
  EXPECT_FALSE(List::of(std::vector{1, 2, 3, 4}));
  EXPECT_EQ(List().size(), 1U);
}

TEST(FixedListTest, EqualityIsThatOfTheItemsInUse) {
  using List = FixedList<int, 0, 3>;
  const auto list = [](const std::vector<int>& items) { return *List::of(items); };
  List shrunk = list({1, 2, 3});
  shrunk = list({1});
  EXPECT_EQ(shrunk, list({1}));
  EXPECT_NE(shrunk, list({1, 2}));
  EXPECT_NE(shrunk, list({2}));
}

TEST(FixedListTest, IsBuiltFromLiterals) {
  static constexpr FixedList<int, 0, 3> kLiterals = {4, 5};
  EXPECT_EQ(kLiterals.size(), 2U);
  EXPECT_EQ(kLiterals[1], 5);
}

TEST(RadiusTest, StraightHasTwoNumbers) {
  EXPECT_EQ(Radius::of(-32768), Radius::straight());
  EXPECT_EQ(Radius::of(32767), Radius::straight());
  EXPECT_TRUE(Radius().is_straight());
  EXPECT_EQ(Radius::straight().value(), -32768);
}

TEST(RadiusTest, SpinsAreOneMillimetre) {
  EXPECT_EQ(Radius::spin_clockwise().value(), -1);
  EXPECT_EQ(Radius::spin_counter_clockwise().value(), 1);
  EXPECT_EQ(Radius::of(-1), Radius::spin_clockwise());
}

TEST(RadiusTest, RefusesWhatIsNoRadius) {
  EXPECT_FALSE(Radius::of(2001));
  EXPECT_FALSE(Radius::of(-2001));
  EXPECT_FALSE(Radius::of(32766));
  EXPECT_FALSE(Radius::of(-32767));
}

}  // namespace
}  // namespace scrubjay::oi

#include <gtest/gtest.h>

#include <limits>
#include <scrubjay/messages/std_msgs.hpp>

namespace scrubjay::ros {
namespace {

TEST(TimeTest, IsSecondsAndWhatIsOver) {
  EXPECT_EQ(time_from_nanoseconds(12'345'678'901), (Time{12, 345'678'901}));
  EXPECT_EQ(time_from_nanoseconds(0), (Time{0, 0}));
  EXPECT_EQ(time_from_nanoseconds(999'999'999), (Time{0, 999'999'999}));
}

TEST(TimeTest, RoundsSecondsDownBeforeTheEpoch) {
  EXPECT_EQ(time_from_nanoseconds(-1), (Time{-1, 999'999'999}));
  EXPECT_EQ(time_from_nanoseconds(-1'000'000'000), (Time{-1, 0}));
  EXPECT_EQ(time_from_nanoseconds(-1'000'000'001), (Time{-2, 999'999'999}));
}

TEST(TimeTest, ComesBackAsItWas) {
  for (const std::int64_t t : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{1'700'000'000'123'456'789},
                               std::int64_t{-2'000'000'000'999'999'999}}) {
    EXPECT_EQ(to_nanoseconds(time_from_nanoseconds(t)), t);
  }
}

TEST(TimeTest, StaysWithinWhatTheSecondsHold) {
  EXPECT_EQ(time_from_nanoseconds(std::numeric_limits<std::int64_t>::max()),
            (Time{std::numeric_limits<std::int32_t>::max(), 999'999'999}));
  EXPECT_EQ(time_from_nanoseconds(std::numeric_limits<std::int64_t>::min()),
            (Time{std::numeric_limits<std::int32_t>::min(), 0}));
}

}  // namespace
}  // namespace scrubjay::ros

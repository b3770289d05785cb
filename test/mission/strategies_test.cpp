#include <gmock/gmock.h>

#include <scrubjay/error.hpp>
#include <scrubjay/mission/strategies.hpp>
#include <string>

namespace scrubjay::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string error_of(std::string_view name) {
  try {
    make_strategy(name, {}, Random(1));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Input);
    return error.what();
  }
  return {};
}

TEST(StrategiesTest, AreTheSixPhases) {
  EXPECT_THAT(strategy_names(),
              ElementsAre("random-2", "random-3", "random-look", "random-aware", "reactive", "edge-follow"));
}

TEST(StrategiesTest, EachCanBeMadeAndDecides) {
  for (const std::string_view name : strategy_names()) {
    const std::unique_ptr<Behavior> behavior = make_strategy(name, {}, Random(1));
    ASSERT_NE(behavior, nullptr) << name;
    const Decision decision = behavior->decide({Frame{}, PoseEstimate{}, {}});
    EXPECT_FALSE(decision.done) << name;
    EXPECT_NE(std::string_view(decision.doing), "") << name;
    EXPECT_TRUE(decision.motion.linear != 0.0 || decision.motion.angular != 0.0) << name;
  }
}

TEST(StrategiesTest, AnUnknownNameGetsTheKnownOnesAndTheNearest) {
  EXPECT_THAT(error_of("edge-folow"), AllOf(HasSubstr("'edge-folow'"), HasSubstr("did you mean 'edge-follow'?"),
                                            HasSubstr("random-2, random-3, random-look, random-aware, reactive")));
  EXPECT_THAT(error_of("random"), HasSubstr("did you mean 'random-2'?"));
  EXPECT_EQ(error_of("radnom-aware").find('\n'), std::string::npos);
  EXPECT_THAT(error_of("").c_str(), HasSubstr("there is no strategy ''"));
}

}  // namespace
}  // namespace scrubjay::test

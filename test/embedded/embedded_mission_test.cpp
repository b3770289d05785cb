#include <gmock/gmock.h>

#include <robot/scripted_channel.hpp>
#include <scrubjay/embedded/embedded_mission.hpp>
#include <vector>

namespace scrubjay {
namespace {

/// Drives as it is told, and keeps what it saw.
class PlainBehavior final : public Behavior {
 public:
  Decision decide(const Situation& now) override {
    stamps.push_back(now.frame.stamp);
    changed.push_back(now.changed);
    return decision;
  }

  Decision decision{{0.2, 0.0}, "", false};
  std::vector<double> stamps;
  std::vector<CellRect> changed;
};

class EmbeddedMissionTest : public testing::Test {
 protected:
  int step(double stamp, const Bytes& bytes) {
    channel.give(stamp, bytes);
    return mission.step();
  }

  ScriptedChannel channel;
  PlainBehavior behavior;
  std::vector<LogOdds> cells = std::vector<LogOdds>(40 * 40);
  EmbeddedMission mission{channel, {}, {{0.05, {-1.0, -1.0}, 40, 40}, cells.data()}, behavior};
};

const Bytes kFrame = stream_frame(at_rest());
const Bytes kBegin(kFrame.begin(), kFrame.begin() + 40);
const Bytes kRest(kFrame.begin() + 40, kFrame.end());

TEST_F(EmbeddedMissionTest, DecidesOncePerFrameWhateverTheChunks) {
  channel.give(0.0, kFrame + kBegin);
  channel.give(0.015, kRest + kFrame + kFrame);
  EXPECT_EQ(mission.step(), 4);
  EXPECT_THAT(behavior.stamps, testing::ElementsAre(0.0, 0.015, 0.015, 0.015));
}

TEST_F(EmbeddedMissionTest, EndsAStepWithTheReadThatCompletesNothing) {
  channel.give(0.0, kBegin);
  channel.give(0.015, kRest);
  EXPECT_EQ(mission.step(), 0);
  EXPECT_EQ(mission.step(), 1);
}

TEST_F(EmbeddedMissionTest, SendsTheMotionAndRemembersIt) {
  channel.take_written();
  step(0.0, kFrame);
  EXPECT_THAT(channel.written.at(0), testing::ElementsAre(145, 0, 200, 0, 200));
  // The script's end is the link's: then it stands.
  EXPECT_EQ(mission.link(), LinkState::Closed);
  EXPECT_EQ(mission.motion(), Motion{});
}

TEST_F(EmbeddedMissionTest, TellsWhichCellsMayHaveChanged) {
  channel.give(0.0, kFrame);
  channel.give(0.015, kFrame);
  mission.step();
  ASSERT_EQ(behavior.changed.size(), 2u);
  EXPECT_FALSE(behavior.changed[0].empty());
  EXPECT_TRUE(behavior.changed[1].empty());  // it stands where it stood
  EXPECT_NE(cells[20 * 40 + 20], 0);
}

TEST_F(EmbeddedMissionTest, StopsWhenTheBehaviorIsDoneAndDecidesNoMore) {
  behavior.decision.done = true;
  channel.give(0.0, kFrame);
  channel.give(0.015, kFrame);
  EXPECT_EQ(mission.step(), 2);
  EXPECT_TRUE(mission.done());
  EXPECT_EQ(behavior.stamps.size(), 1u);
  EXPECT_EQ(mission.motion(), Motion{});
  EXPECT_THAT(channel.written.back(), testing::ElementsAre(128));
}

TEST_F(EmbeddedMissionTest, GoesOnTellingThePoseAfterTheStop) {
  step(0.0, stream_frame(counted(0, 0)));
  mission.stop();
  const std::vector<LogOdds> before = cells;
  step(0.015, stream_frame(counted(10, 10)));
  EXPECT_GT(mission.estimate().pose.x, 0.004);
  EXPECT_EQ(cells, before);
}

}  // namespace
}  // namespace scrubjay

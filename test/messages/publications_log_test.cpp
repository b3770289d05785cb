/// \file
/// /rosout and /diagnostics.
#include <gmock/gmock.h>

#include "messages/publications_fixture.hpp"

namespace scrubjay::ros {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Key;
using testing::Not;

TEST_F(PublicationsTest, HasAStatusEachForRobotBatteryAndWhoeverCarriesMessages) {
  class FaringSink final : public MessageSink {
   public:
    void publish(const TopicInfo&, std::int64_t, const std::shared_ptr<const Bytes>&) override {}
    std::optional<DiagnosticStatus> status() override {
      DiagnosticStatus status;
      status.name = "messages";
      return status;
    }
  };
  const auto listed = [&] {
    std::vector<std::string> names;
    const DiagnosticArray told = kept_.of(kDiagnosticsTopic).at(0);
    for (const DiagnosticStatus& status : told.status) names.push_back(status.name);
    return names;
  };
  FaringSink faring;
  PublicationParams params;
  params.node = "/robot1/jay";
  publications_.emplace(RobotModel{}, params, std::vector<MessageSink*>{&kept_, &faring});
  tick();
  EXPECT_THAT(listed(), ElementsAre("robot1/jay: robot", "robot1/jay: battery", "robot1/jay: messages"));
  kept_.forget();
  RobotModel robot;
  robot.open_interface = false;
  begin(robot);
  tick();
  EXPECT_THAT(listed(), ElementsAre("scrubjay: robot"));
}

TEST_F(PublicationsTest, LogsWhatTheRobotDoesWhenThatChanges) {
  begin();
  ticks(3);
  doing_ = "driving";
  ticks(3);
  const std::vector<Log> lines = kept_.of(kRosoutTopic);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], (Log{{0, 15'000'000}, Log::kInfo, "scrubjay", "looking", "", "", 0}));
  EXPECT_EQ(lines[1], (Log{{0, 60'000'000}, Log::kInfo, "scrubjay", "driving", "", "", 0}));
}

TEST_F(PublicationsTest, LogsWhatItIsToldByAnybodyWithTheNextFrameOrAtTheEnd) {
  LogQueue others;
  PublicationParams params;
  params.node = "/fleet/robot1/jay";
  params.log = &others;
  begin({}, params);
  others.add(Log::kWarn, "before it began");
  publications_->log(Log::kInfo, "begins");
  EXPECT_THAT(kept_.stamps(), Not(Contains(Key("/rosout"))));
  tick();
  publications_->log(Log::kError, "ends");
  publications_->finish(std::as_const(map_).view());
  const std::vector<Log> lines = kept_.of(kRosoutTopic);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].msg, "before it began");
  EXPECT_EQ(lines[0].level, Log::kWarn);
  EXPECT_EQ(lines[0].name, "fleet.robot1.jay");
  EXPECT_EQ(lines[1].msg, "begins");
  EXPECT_EQ(lines[2].msg, "looking");
  EXPECT_EQ(lines[3].msg, "ends");
  EXPECT_EQ(lines[3].level, Log::kError);
}

TEST_F(PublicationsTest, LogsThatTheRobotWasSilent) {
  begin();
  tick();
  frame_.stamp += 0.9;
  tick();
  EXPECT_EQ(kept_.of(kRosoutTopic).size(), 1u);
  frame_.stamp += 3.0;
  tick();
  const std::vector<Log> lines = kept_.of(kRosoutTopic);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].msg, "the robot was silent for 3 s");
  EXPECT_EQ(lines[1].level, Log::kWarn);
}

}  // namespace
}  // namespace scrubjay::ros

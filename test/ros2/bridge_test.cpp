#include <gmock/gmock.h>

#include <scrubjay/ros2/bridge.hpp>

#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::ElementsAre;

using BridgeTest = WireTest;

std::shared_ptr<const Bytes> shared(Bytes bytes) {
  return std::make_shared<const Bytes>(std::move(bytes));
}

TEST_F(BridgeTest, HasTheEndpointsThatAreForetoldOfIt) {
  const NodeNames names("jay", "/robot1");
  Commands commands({});
  Bridge bridge(options(names), kTopics);
  bridge.listen(commands);
  EXPECT_EQ(bridge.participant().endpoints(), bridge_endpoints(names, kTopics));
}

TEST_F(BridgeTest, TellsHowManyMessagesItSent) {
  const std::array<TopicInfo, 2> topics{kModeTopic, kIrOmniTopic};
  Bridge bridge(options(), topics);
  bridge.publish(kModeTopic, 0, shared(encode(Mode{})));
  bridge.publish(kIrOmniTopic, 0, shared(encode(UInt16{161})));
  bridge.publish(kOdomTopic, 0, shared(encode(Odometry{})));  // which it wasn't made for
  ASSERT_TRUE(bridge.flush(30.0));
  EXPECT_EQ(bridge.tally(), (WriterTally{2, 0, 0}));
  const std::optional<DiagnosticStatus> status = bridge.status();
  ASSERT_TRUE(status);
  EXPECT_EQ(status->name, "messages");
  EXPECT_EQ(status->level, DiagnosticStatus::kOk);
  EXPECT_THAT(status->values,
              ElementsAre(KeyValue{"published", "2"}, KeyValue{"dropped", "0"}, KeyValue{"refused by DDS", "0"}));
}

TEST_F(BridgeTest, WarnsOnceOfMessagesThatWereLostInBetween) {
  const std::array<TopicInfo, 1> topics{kIrOmniTopic};
  Bridge bridge(options(), topics);
  // More at once than may wait: some are dropped, as sending takes longer than that.
  const auto message = shared(encode(UInt16{161}));
  ASSERT_TRUE(eventually([&] {
    for (int i = 0; i < 1000; ++i) bridge.publish(kIrOmniTopic, 0, message);
    return bridge.tally().dropped > 0;
  }));
  ASSERT_TRUE(bridge.flush(30.0));
  EXPECT_EQ(bridge.status()->level, DiagnosticStatus::kWarn);
  EXPECT_EQ(bridge.status()->level, DiagnosticStatus::kOk) << "no more since then";
}

}  // namespace
}  // namespace scrubjay::ros

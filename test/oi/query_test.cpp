#include <gtest/gtest.h>

#include <algorithm>
#include <scrubjay/oi/query.hpp>
#include <vector>

#include "random_values.hpp"

namespace scrubjay::oi {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(QueryReaderTest, ReadsOnePacket) {
  QueryReader reader(Model::Create2);
  Sensors sensors;
  ASSERT_TRUE(reader.expect(Query{PacketId::Voltage}));
  EXPECT_EQ(reader.awaited(), 2U);
  EXPECT_EQ(reader.feed(Bytes{0x3A}, sensors), 1U);
  EXPECT_FALSE(sensors.has(PacketId::Voltage));
  EXPECT_EQ(reader.feed(Bytes{0x98}, sensors), 1U);
  EXPECT_EQ(reader.awaited(), 0U);
  EXPECT_EQ(sensors[PacketId::Voltage], 15000);
}

TEST(QueryReaderTest, LeavesTheBytesBehindTheReply) {
  QueryReader reader(Model::Create2);
  Sensors sensors;
  ASSERT_TRUE(reader.expect(Query{PacketId::Wall}));
  EXPECT_EQ(reader.feed(Bytes{1, 2, 3}, sensors), 1U);
  EXPECT_EQ(reader.feed(Bytes{2, 3}, sensors), 0U);
}

TEST(QueryReaderTest, ReadsListsInAnyChunks) {
  Random random(5);
  for (int run = 0; run < 500; ++run) {
    const Sensors sent = random_sensors(random, Model::Create2);
    std::vector<SensorId> ids;
    Bytes reply;
    for (int i = random.between(1, 30); i > 0; --i) {
      ids.push_back(random_id(random, Model::Create2));
      Bytes part(ids.back().bytes());
      ASSERT_EQ(encode(ids.back(), sent, Model::Create2, part), part.size());
      reply.insert(reply.end(), part.begin(), part.end());
    }
    QueryReader reader(Model::Create2);
    Sensors received;
    ASSERT_TRUE(reader.expect(QueryList{*decltype(QueryList::ids)::of(ids)}));
    ASSERT_EQ(reader.awaited(), reply.size());
    for (std::size_t at = 0; at < reply.size();) {
      ASSERT_EQ(received, Sensors{});
      const auto count = std::min<std::size_t>(static_cast<std::size_t>(random.between(0, 50)), reply.size() - at);
      ASSERT_EQ(reader.feed(std::span(reply).subspan(at, count), received), count);
      at += count;
    }
    ASSERT_EQ(reader.awaited(), 0U);
    for (const SensorId id : ids) {
      for (std::uint8_t n = id.run().first; n <= id.run().last; ++n)
        ASSERT_EQ(received[PacketId{n}], sent[PacketId{n}]);
    }
  }
}

TEST(QueryReaderTest, AReplyThatNeverEndedLeavesNothing) {
  QueryReader reader(Model::Create2);
  Sensors sensors;
  ASSERT_TRUE(reader.expect(QueryList{{PacketId::Wall, PacketId::Voltage}}));
  EXPECT_EQ(reader.feed(Bytes{1, 0x3A}, sensors), 2U);
  reader.reset();
  EXPECT_EQ(reader.awaited(), 0U);
  EXPECT_EQ(sensors, Sensors{});
  ASSERT_TRUE(reader.expect(Query{PacketId::CliffLeft}));
  EXPECT_EQ(reader.feed(Bytes{1}, sensors), 1U);
  EXPECT_EQ(sensors[PacketId::CliffLeft], 1);
  EXPECT_FALSE(sensors.has(PacketId::Wall));
}

TEST(QueryReaderTest, ValuesOutOfRangeLeaveTheEarlierOnes) {
  QueryReader reader(Model::Create2);
  Sensors sensors;
  sensors.set(PacketId::Wall, 1);
  ASSERT_TRUE(reader.expect(QueryList{{PacketId::Wall, PacketId::CliffLeft}}));
  EXPECT_EQ(reader.feed(Bytes{2, 1}, sensors), 2U);
  EXPECT_EQ(reader.rejected(), 1);
  EXPECT_EQ(sensors[PacketId::Wall], 1);
  EXPECT_EQ(sensors[PacketId::CliffLeft], 1);
}

TEST(QueryReaderTest, AwaitsNothingThatTheModelLacks) {
  QueryReader create1(Model::Create1);
  EXPECT_FALSE(create1.expect(Query{100}));
  EXPECT_FALSE(create1.expect(QueryList{{7, 43}}));
  EXPECT_EQ(create1.awaited(), 0U);
  QueryReader roomba400(Model::Roomba400);
  EXPECT_FALSE(roomba400.expect(QueryList{{7}}));
  EXPECT_TRUE(roomba400.expect(Query{0}));
  EXPECT_EQ(roomba400.awaited(), 26U);
}

}  // namespace
}  // namespace scrubjay::oi

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <robot/scripted_channel.hpp>

#include "scrubjay_c_client.h"

namespace scrubjay {
namespace {

using testing::ElementsAre;

constexpr std::size_t kDefaultSize = SCRUBJAY_MEMORY_SIZE(100, 100);
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Bytes take_sent(ClientWire& wire) {
  Bytes sent(wire.sent, wire.sent + wire.count);
  wire.count = 0;
  return sent;
}

void feed(scrubjay_mission* mission, const Bytes& bytes, double stamp) {
  EXPECT_EQ(scrubjay_feed(mission, bytes.data(), bytes.size(), stamp), SCRUBJAY_OK);
}

scrubjay_status status_of(void (*change)(scrubjay_config&)) {
  scrubjay_config config = scrubjay_default_config();
  change(config);
  return client_try(&config, 0, kDefaultSize);
}

TEST(ScrubjayCTest, WakesTheRobotTakesControlAndStartsTheStream) {
  ClientWire wire{};
  ASSERT_NE(client_create(&wire), nullptr);
  EXPECT_THAT(take_sent(wire), ElementsAre(128, 131, 148, 1, 100));
}

TEST(ScrubjayCTest, DrivesAndMapsFromTheFirstFrameOn) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  take_sent(wire);
  EXPECT_EQ(client_free_cells(mission), 0);
  for (int i = 0; i < 100; ++i) feed(mission, stream_frame(counted(4 * i, 4 * i)), 0.015 * i);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.1);
  EXPECT_EQ(scrubjay_get_motion(mission).angular, 0.0);
  EXPECT_THAT(Bytes(wire.sent, wire.sent + 5), ElementsAre(145, 0, 100, 0, 100));
  const scrubjay_pose pose = scrubjay_get_pose(mission);
  EXPECT_NEAR(pose.x, 396 * 0.4446e-3, 1e-4);
  EXPECT_EQ(pose.y, 0.0);
  EXPECT_EQ(pose.yaw, 0.0);
  EXPECT_GT(client_free_cells(mission), 20);
  EXPECT_EQ(scrubjay_get_counters(mission).frames, 100u);
  EXPECT_EQ(scrubjay_get_link(mission), SCRUBJAY_LINK_ALIVE);
  EXPECT_EQ(scrubjay_is_done(mission), 0);
}

TEST(ScrubjayCTest, TakesAsManyBytesAtOnceAsThereAre) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  Bytes many;
  for (int i = 0; i < 100; ++i) many = many + stream_frame(counted(i, i));
  feed(mission, many, 0.0);
  EXPECT_EQ(scrubjay_get_counters(mission).frames, 100u);
  EXPECT_EQ(scrubjay_get_counters(mission).skipped_bytes, 0u);
}

TEST(ScrubjayCTest, CountsWhatTheLineSpoils) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  Bytes spoilt = stream_frame(at_rest());
  spoilt.back() ^= 1;
  feed(mission, spoilt + stream_frame(at_rest()), 0.0);
  const scrubjay_counters counters = scrubjay_get_counters(mission);
  EXPECT_EQ(counters.frames, 1u);
  EXPECT_EQ(counters.lost_frames, 1u);
  EXPECT_EQ(counters.skipped_bytes, spoilt.size());
}

TEST(ScrubjayCTest, StandsWhileTheRobotIsSilent) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  feed(mission, stream_frame(at_rest()), 0.0);
  ASSERT_EQ(scrubjay_get_motion(mission).linear, 0.1);
  for (int i = 1; i <= 8; ++i) EXPECT_EQ(scrubjay_feed(mission, nullptr, 0, 0.015 * i), SCRUBJAY_OK);
  EXPECT_EQ(scrubjay_get_link(mission), SCRUBJAY_LINK_SILENT);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.0);
  feed(mission, stream_frame(at_rest()), 0.2);
  EXPECT_EQ(scrubjay_get_link(mission), SCRUBJAY_LINK_ALIVE);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.1);
}

/// Times that the session was begun, by what was sent.
int sessions_in(const Bytes& sent) {
  const Bytes begin{128, 131, 148, 1, 100};
  int count = 0;
  for (auto at = sent.begin(); (at = std::search(at, sent.end(), begin.begin(), begin.end())) != sent.end(); ++at) {
    ++count;
  }
  return count;
}

TEST(ScrubjayCTest, StartsASilentRobotAnewAsLongAsItIsSilent) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  feed(mission, stream_frame(counted(100, 100)), 0.0);
  take_sent(wire);
  double now = 0.0;
  const auto sessions_until = [&](double end) {
    int sessions = 0;
    for (; now < end; now += 0.015) {
      feed(mission, {}, now);
      sessions += sessions_in(take_sent(wire));
    }
    return sessions;
  };
  EXPECT_EQ(sessions_until(0.06), 0);
  EXPECT_GE(sessions_until(5.0), 3);
  EXPECT_GE(sessions_until(300.0), 140);  // it never gives up
  EXPECT_LE(sessions_until(400.0), 50);   // nor does it hurry
  feed(mission, stream_frame(counted(0, 0)), now);
  EXPECT_EQ(scrubjay_get_link(mission), SCRUBJAY_LINK_ALIVE);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.1);
  EXPECT_NEAR(scrubjay_get_pose(mission).x, 0.0, 0.001);  // counters began anew, the pose didn't
}

TEST(ScrubjayCTest, LeavesASilentRobotAloneOnceItWasStopped) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  feed(mission, stream_frame(at_rest()), 0.0);
  scrubjay_stop(mission);
  take_sent(wire);
  for (int i = 1; i <= 400; ++i) feed(mission, {}, 0.015 * i);
  EXPECT_EQ(sessions_in(take_sent(wire)), 0);
}

TEST(ScrubjayCTest, TriesAgainOnceItCanSend) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  wire.gone = 1;
  for (int i = 0; i < 100; ++i) feed(mission, {}, 0.015 * i);
  EXPECT_EQ(scrubjay_get_link(mission), SCRUBJAY_LINK_CLOSED);
  take_sent(wire);
  wire.gone = 0;
  for (int i = 100; i < 400; ++i) feed(mission, {}, 0.015 * i);
  EXPECT_GE(sessions_in(take_sent(wire)), 1);
}

TEST(ScrubjayCTest, StandsWhenNothingCanBeSent) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  wire.gone = 1;
  feed(mission, stream_frame(at_rest()), 0.0);
  EXPECT_EQ(scrubjay_get_link(mission), SCRUBJAY_LINK_CLOSED);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.0);
}

TEST(ScrubjayCTest, StopsInAModeThatCharges) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  feed(mission, stream_frame(at_rest()), 0.0);
  take_sent(wire);
  EXPECT_EQ(scrubjay_stop(mission), SCRUBJAY_OK);
  const Bytes sent = take_sent(wire);
  EXPECT_THAT(sent, testing::Contains(137));  // Drive
  EXPECT_EQ(sent.back(), 128);                // Start: Passive
  EXPECT_EQ(scrubjay_is_done(mission), 1);
  feed(mission, stream_frame(at_rest()), 0.015);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.0);
}

TEST(ScrubjayCTest, RunsWithoutAnyoneToSendTo) {
  const scrubjay_config config = scrubjay_default_config();
  alignas(SCRUBJAY_ALIGNMENT) static unsigned char memory[kDefaultSize];
  scrubjay_mission* mission = nullptr;
  ASSERT_EQ(scrubjay_create(memory, sizeof memory, &config, &mission), SCRUBJAY_OK);
  feed(mission, stream_frame(at_rest()), 0.0);
  EXPECT_EQ(scrubjay_get_motion(mission).linear, 0.1);
}

TEST(ScrubjayCTest, KeepsToTheMemoryThatItAskedFor) {
  scrubjay_config config = scrubjay_default_config();
  config.map_width = 30;
  config.map_height = 20;
  std::vector<std::max_align_t> memory(1000);
  auto* bytes = reinterpret_cast<unsigned char*>(memory.data());
  const std::size_t size = SCRUBJAY_MEMORY_SIZE(30, 20);
  std::fill(bytes, bytes + memory.size() * sizeof(std::max_align_t), static_cast<unsigned char>(0x5a));
  scrubjay_mission* mission = nullptr;
  ASSERT_EQ(scrubjay_create(bytes, size, &config, &mission), SCRUBJAY_OK);
  for (int i = 0; i < 1000; ++i) feed(mission, stream_frame(counted(30 * i, 30 * i)), 0.015 * i);
  const auto* cells = reinterpret_cast<const unsigned char*>(scrubjay_get_map(mission).cells);
  EXPECT_GE(cells, bytes);
  EXPECT_LE(cells + 30 * 20, bytes + size);
  EXPECT_TRUE(std::all_of(bytes + size, bytes + memory.size() * sizeof(std::max_align_t),
                          [](unsigned char byte) { return byte == 0x5a; }));
}

TEST(ScrubjayCTest, RefusesMemoryThatWontDo) {
  const scrubjay_config config = scrubjay_default_config();
  EXPECT_EQ(client_try(&config, 0, kDefaultSize), SCRUBJAY_OK);
  EXPECT_EQ(client_try(&config, 0, kDefaultSize - 1), SCRUBJAY_TOO_SMALL);
  EXPECT_EQ(client_try(&config, 1, kDefaultSize), SCRUBJAY_MISALIGNED);
  scrubjay_mission* mission = nullptr;
  EXPECT_EQ(scrubjay_create(nullptr, kDefaultSize, &config, &mission), SCRUBJAY_NULL);
  EXPECT_EQ(client_try(nullptr, 0, kDefaultSize), SCRUBJAY_NULL);
}

TEST(ScrubjayCTest, RefusesMapsAndRobotsThatMakeNoSense) {
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.map_width = 0; }), SCRUBJAY_BAD_MAP);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.map_height = -1; }), SCRUBJAY_BAD_MAP);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.map_width = SCRUBJAY_MAX_SIDE + 1; }), SCRUBJAY_BAD_MAP);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.resolution = 0.0; }), SCRUBJAY_BAD_MAP);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.origin_x = kNan; }), SCRUBJAY_BAD_MAP);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.robot_radius = -0.1; }), SCRUBJAY_BAD_ROBOT);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.wheel_separation = kNan; }), SCRUBJAY_BAD_ROBOT);
  EXPECT_EQ(status_of([](scrubjay_config& c) { c.wheel_radius = 0.0; }), SCRUBJAY_BAD_ROBOT);
}

TEST(ScrubjayCTest, RefusesBytesFromNowhereAndTimeThatGoesBack) {
  ClientWire wire{};
  scrubjay_mission* mission = client_create(&wire);
  EXPECT_EQ(scrubjay_feed(nullptr, nullptr, 0, 0.0), SCRUBJAY_NULL);
  EXPECT_EQ(scrubjay_feed(mission, nullptr, 1, 0.0), SCRUBJAY_NULL);
  EXPECT_EQ(scrubjay_stop(nullptr), SCRUBJAY_NULL);
  EXPECT_EQ(scrubjay_feed(mission, nullptr, 0, kNan), SCRUBJAY_BAD_STAMP);
  feed(mission, {}, 1.0);
  EXPECT_EQ(scrubjay_feed(mission, nullptr, 0, 0.999), SCRUBJAY_BAD_STAMP);
}

TEST(ScrubjayCTest, TellsCellsAsNavigationDoes) {
  EXPECT_EQ(scrubjay_occupancy(0), -1);
  EXPECT_EQ(scrubjay_occupancy(100), 100);
  EXPECT_EQ(scrubjay_occupancy(-100), 0);
}

}  // namespace
}  // namespace scrubjay

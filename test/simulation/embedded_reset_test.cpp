#include <gtest/gtest.h>
#include <scrubjay/scrubjay_c.h>

#include <array>
#include <scrubjay/simulation/simulated_roomba.hpp>

#include "stage.hpp"

namespace scrubjay::test {
namespace {

/// Firmware of ours on a simulated Roomba's port.
class EmbeddedResetTest : public testing::Test {
 protected:
  void SetUp() override {
    scrubjay_config config = scrubjay_default_config();
    config.user = &roomba_;
    config.send = [](void* user, const uint8_t* bytes, size_t count) {
      return static_cast<sim::SimulatedRoomba*>(user)->write({bytes, count}) ? 1 : 0;
    };
    ASSERT_EQ(scrubjay_create(memory_.data(), memory_.size(), &config, &mission_), SCRUBJAY_OK);
  }

  void run(double seconds) {
    std::array<std::uint8_t, 512> bytes{};
    for (const double end = now_ + seconds; now_ < end;) {
      const ByteRead read = roomba_.read(bytes);
      now_ = read.stamp;
      ASSERT_EQ(scrubjay_feed(mission_, bytes.data(), read.count, now_), SCRUBJAY_OK);
    }
  }

  World world_ = room(6.0, 4.0);
  SegmentIndex index_{solid_segments(world_)};
  sim::SimulatedRoomba roomba_{world_, index_, sim::RobotSpec{}, {}, Random(1), {1.0, 2.0, 0.0}};
  alignas(SCRUBJAY_ALIGNMENT) std::array<unsigned char, SCRUBJAY_MEMORY_SIZE(100, 100)> memory_{};
  scrubjay_mission* mission_ = nullptr;
  double now_ = 0.0;
};

TEST_F(EmbeddedResetTest, DrivesOnAfterTheRobotWasStartedAnew) {
  run(3.0);
  ASSERT_GT(scrubjay_get_pose(mission_).x, 0.2);
  roomba_.write(std::array<std::uint8_t, 1>{7});  // Reset, by somebody else on the wire
  run(2.0);
  EXPECT_EQ(scrubjay_get_link(mission_), SCRUBJAY_LINK_SILENT);
  EXPECT_EQ(scrubjay_get_motion(mission_).linear, 0.0);
  const double stood = roomba_.truth().pose.x;
  run(8.0);
  EXPECT_EQ(scrubjay_get_link(mission_), SCRUBJAY_LINK_ALIVE);
  EXPECT_GT(roomba_.truth().pose.x, stood + 0.1);
  EXPECT_NEAR(scrubjay_get_pose(mission_).x, roomba_.truth().pose.x - 1.0, 0.05);
}

}  // namespace
}  // namespace scrubjay::test

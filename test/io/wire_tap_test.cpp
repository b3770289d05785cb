#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <scrubjay/io/recorded_robot.hpp>
#include <scrubjay/io/wire_tap.hpp>
#include <scrubjay/oi/all_packets.hpp>
#include <scrubjay/robot/oi_robot.hpp>
#include <thread>

#include "fake_robot.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

/// A robot, a tap, and a client that opens the tap's end.
class WireTapTest : public testing::Test {
 protected:
  WireTapTest()
      : robot_(folder_ / "robot"),
        port_({folder_ / "robot"}),
        terminal_(folder_ / "tap"),
        writer_(std::make_unique<RecordingWriter>(folder_ / "tap.oilog", "model: roomba-600\n")),
        tap_([this](const std::stop_token& stop) { report_ = tap_wire(port_, terminal_, *writer_, 1e3, stop); }) {}

  void end() {
    tap_.request_stop();
    tap_.join();
    writer_->close();
  }
  std::vector<Frame> replayed() const {
    RecordingReader reader(folder_ / "tap.oilog");
    RecordedRobot again(reader, {});
    std::vector<Frame> frames;
    while (const auto frame = again.next()) frames.push_back(*frame);
    return frames;
  }
  static double way(const std::vector<Frame>& frames) {
    double sum = 0.0;
    for (const Frame& frame : frames) sum += frame.left_travel;
    return sum;
  }

  TemporaryFolder folder_;
  FakeRobot robot_;
  SerialPort port_;
  PseudoTerminal terminal_;
  std::unique_ptr<RecordingWriter> writer_;
  TapReport report_;
  std::jthread tap_;
};

TEST_F(WireTapTest, PassesAStreamOnAndReplaysIt) {
  {
    SerialPort client({folder_ / "tap"});
    OiRobot driver(client, {});
    double rolled = 0.0;
    for (int i = 0; i < 40 || rolled < 0.02;) {
      const auto frame = driver.next();
      if (!frame) continue;
      ++i;
      rolled += frame->left_travel;
      driver.drive({0.2, 0.0});
    }
  }
  end();
  EXPECT_GT(report_.to_robot, 10u);
  EXPECT_TRUE(soon([&] { return robot_.stands(); }));  // the client has left it driving
  EXPECT_EQ(robot_.mode(), oi::OiMode::Passive);
  const std::vector<Frame> frames = replayed();
  EXPECT_GE(frames.size(), 40u);
  EXPECT_GT(way(frames), 0.02);
}

TEST_F(WireTapTest, ReplaysAClientThatAsksForASinglePacketAtATime) {
  {
    SerialPort client({folder_ / "tap"});
    client.write(encode(oi::Start{}));
    client.write(encode(oi::Safe{}));
    client.write(encode(oi::DriveDirect{oi::Velocity(200), oi::Velocity(200)}));
    std::array<std::uint8_t, 64> buffer{};
    for (int i = 0; i < 30; ++i) {
      client.write(encode(oi::Query{oi::SensorId(43)}));
      std::size_t count = 0;
      ASSERT_TRUE(soon([&] {
        count += client.read(buffer).count;
        return count >= 2;
      }));
      client.write(encode(oi::Query{oi::SensorId(7)}));
      ASSERT_TRUE(soon([&] { return client.read(buffer).count > 0; }));
    }
  }
  end();
  const std::vector<Frame> frames = replayed();
  EXPECT_EQ(frames.size(), 60u);
  EXPECT_GT(way(frames), 0.05);
}

TEST_F(WireTapTest, IsNotHeldUpByAClientThatDoesntRead) {
  {
    SerialPort client({folder_ / "tap"});
    client.write(encode(oi::Start{}));
    client.write(encode(oi::stream_of_all(oi::Model::Create2)));
    ASSERT_TRUE(soon([&] { return robot_.frames_sent() * 84 > 2 * PseudoTerminal::kBacklog; }));
  }
  end();
  EXPECT_GT(report_.unread, 0u);
  EXPECT_GE(replayed().size(), PseudoTerminal::kBacklog / 84);
}

TEST_F(WireTapTest, EndsWhenTheRobotsPortGoesAway) {
  robot_.go_away();
  tap_.join();
  EXPECT_TRUE(report_.robot_gone);
}

}  // namespace
}  // namespace scrubjay

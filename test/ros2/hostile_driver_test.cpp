/// \file
/// A peer that sends to a robot, on every topic that it listens to, what nobody should.
#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <scrubjay/mission/estimation.hpp>
#include <scrubjay/mission/mission.hpp>
#include <scrubjay/ros2/bridge.hpp>
#include <scrubjay/ros2/ordered_robot.hpp>
#include <scrubjay/ros2/placed_localizer.hpp>
#include <scrubjay/ros2/remote_drive.hpp>

#include "ros2/commands_fixture.hpp"
#include "ros2/hostile_payloads.hpp"
#include "ros2/wire_fixture.hpp"

namespace scrubjay::ros {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;

constexpr std::uint64_t kMessages = 10'000;  // that arrive, of each type
constexpr std::uint64_t kAtOnce = 10;        // on their way: as many as a reader keeps, so that none of them is lost

/// Stands on its floor, whatever it is told, and notes that.
class NotingRobot final : public Robot {
 public:
  std::optional<Frame> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    Frame frame;
    frame.stamp = 0.015 * static_cast<double>(++frames_);
    frame.mode = oi::OiMode::Safe;
    return frame;
  }
  void drive(const Motion& motion) override {
    if (motion != Motion{}) motions.add(motion);
  }
  bool order(const oi::Command& command) override {
    orders.add(command);
    return true;
  }
  void stop() override {}

  Kept<Motion> motions;  ///< other than to stand
  Kept<oi::Command> orders;

 private:
  std::uint64_t frames_ = 0;
};

/// A robot that others drive, in the midst of its mission.
class HostileDriverTest : public WireTest {
 protected:
  HostileDriverTest() {
    bridge_.listen(commands_);
    estimation_.localizer = std::make_unique<PlacedLocalizer>(std::move(estimation_.localizer), commands_);
    mission_ = std::jthread([this](const std::stop_token& stop) { report_ = run(stop); });
  }

  Report run(const std::stop_token& stop) {
    OrderedRobot ordered(robot_, commands_);
    RemoteDrive drive(model_, commands_);
    Mission mission(ordered, *estimation_.localizer, *estimation_.mapper, drive, {1e9});
    return mission.run(stop);
  }
  Report end() {
    mission_.request_stop();
    mission_.join();
    return report_;
  }

  /// Until so many were refused. `cmd_vel` is heard without guarantee, all else arrives.
  void assail(Writer& writer, const Target& target, Random random) {
    const std::uint64_t before = refused();
    std::uint64_t expected = before;
    while (refused() - before < kMessages) {
      const Bytes message = malformed(target, random);
      if (!message.empty()) ++expected;  // one without any byte is thrown away by DDS
      writer.publish(message);
      ASSERT_LE(refused(), expected);
      if (expected - refused() < kAtOnce) continue;
      if (target.topic == "cmd_vel") {
        ASSERT_NO_FATAL_FAILURE(expect_velocity_taken(writer, target));
        expected = refused();  // what is heard without guarantee may be lost
      } else {
        ASSERT_TRUE(eventually([&] { return expected - refused() < kAtOnce / 2; }));
      }
    }
    ASSERT_TRUE(target.topic == "cmd_vel" || eventually([&] { return refused() == expected; }));
  }

  /// Of what is longer than the bridge takes, nothing arrives.
  void assail_at_length(Writer& writer, const Target& target) {
    const std::uint64_t before = refused();
    const std::size_t most = ParticipantOptions{}.most_read;
    for (const std::size_t size : {2 * most, std::size_t{4'000'000}, most - 1000, std::size_t{1000}}) {
      writer.publish(malformed_and_long(target, size));
    }
    if (target.topic == "cmd_vel") {
      expect_velocity_taken(writer, target);
    } else {
      EXPECT_TRUE(eventually([&] { return refused() - before == 2; }));
    }
  }

  /// One of none; whatever was sent before has arrived then, or never will.
  void expect_velocity_taken(Writer& writer, const Target& target) {
    const Bytes none = target.type.name == Twist::kType ? twist(0.0, 0.0) : twist_stamped(0.0, 0.0);
    const std::uint64_t before = commands_.tally().taken;
    const auto taken = [&] { return commands_.tally().taken > before; };
    // One at a time: one that comes late would be taken for the next.
    for (int attempt = 0; attempt < 10 && !taken(); ++attempt) {
      writer.publish(none);
      ++velocities_of_none_;
      eventually(taken, std::chrono::seconds(3));
    }
    ASSERT_TRUE(taken());
  }

  /// Refused, for whatever reason.
  std::uint64_t refused() const {
    const CommandTally tally = commands_.tally();
    return tally.malformed + tally.out_of_range + tally.other_frame;
  }

  std::uint64_t velocities_of_none_ = 0;  ///< that were told
  RobotModel model_;
  Commands commands_{kLimits};
  Estimation estimation_ = make_estimation({}, model_);
  NotingRobot robot_;
  Bridge bridge_{options(), {}};
  Report report_;
  std::jthread mission_;
};

/// Somebody who can write all that the robot listens to.
class Hostile {
 public:
  Hostile(const ParticipantOptions& options, const std::vector<Target>& targets) : participant_(options) {
    for (const Target& target : targets) {
      writers_.push_back(&participant_.write(target.topic, target.type, Qos{.depth = 200}));
    }
  }
  bool is_heard() const {
    return std::all_of(writers_.begin(), writers_.end(), [](const Writer* writer) { return writer->readers() == 1; });
  }
  Writer& writer(std::size_t target) { return *writers_[target]; }

 private:
  Participant participant_;
  std::vector<Writer*> writers_;
};

TEST_F(HostileDriverTest, TenThousandMalformedMessagesOnEachTopicMoveNothing) {
  const std::vector<Target> all = targets();
  Hostile hostile(options(), all);
  ASSERT_TRUE(eventually([&] { return hostile.is_heard(); }));
  const Random random(2026);
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(std::string(all[i].type.name));
    ASSERT_NO_FATAL_FAILURE(assail(hostile.writer(i), all[i], random.fork(i)));
    ASSERT_NO_FATAL_FAILURE(assail_at_length(hostile.writer(i), all[i]));
    ASSERT_LE(commands_.tally().taken, velocities_of_none_);
  }
  EXPECT_THAT(robot_.motions.all(), IsEmpty());
  EXPECT_THAT(robot_.orders.all(), IsEmpty());

  // And it is as it was.
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t before = robot_.motions.size();
    EXPECT_TRUE(eventually([&] {
      hostile.writer(i).publish(all[i].sound);
      return robot_.motions.size() > before + 10;
    })) << all[i].type.name;
  }
  EXPECT_THAT(robot_.motions.all(), Each(Motion{0.2, 0.3}));
  hostile.writer(all.size() - 2).publish(all[all.size() - 2].sound);
  EXPECT_TRUE(eventually([&] { return robot_.orders.size() == 1; }));
  const Report report = end();
  EXPECT_EQ(report.ended, Ended::Stopped);
  EXPECT_EQ(report.distance, 0.0);
}

}  // namespace
}  // namespace scrubjay::ros

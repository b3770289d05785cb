#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <scrubjay/io/robot_file.hpp>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/simulation/simulated_roomba.hpp>
#include <span>
#include <thread>

#include "stage.hpp"
#include "world/generated.hpp"

namespace scrubjay::test {
namespace {

/// FNV-1a over all that comes.
class Digest {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) value_ = (value_ ^ byte) * 0x100000001B3ull;
  }
  template <typename T>
  void add(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    std::array<std::uint8_t, sizeof(T)> bytes;
    std::memcpy(bytes.data(), &value, sizeof(T));
    add(std::span<const std::uint8_t>(bytes));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ull;
};

class DeterminismTest : public ::testing::Test {
 protected:
  DeterminismTest() {
    Random random(7);
    world_ = random_house(random, 3, 3.0);
    world_.carpets = {{box({4.0, 4.0}, {3.0, 3.0}, 0.3), 0.1}};
    world_.dock = Dock{{0.1, 4.0, 0.0}};
    noise_ = read_noise(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "urdf/noise.yaml", "carpet");
    start_ = start_pose();
  }

  Pose2 start_pose() {
    const SegmentIndex index(solid_segments(world_));
    Pose2 best;
    double most = 0.0;
    for (double x = 0.5; x < 9.0; x += 0.25) {
      const double room = index.distance({x, 4.5}, 2.0);
      if (room > most) best = {x, 4.5, 0.0};
      most = std::max(most, room);
    }
    return best;
  }

  /// Everything that a body senses, and the truth.
  std::uint64_t senses(std::uint64_t seed) const {
    const SegmentIndex index(solid_segments(world_));
    sim::RoombaBody body(world_, index, {}, noise_, Random(seed), start_);
    Random driver(5);
    Digest digest;
    sim::WheelSpeeds speeds;
    for (int i = 0; i < 10'000; ++i) {
      if (i % 50 == 0) speeds = {driver.uniform(-0.1, 0.4), driver.uniform(-0.1, 0.4)};
      const sim::BodySenses& s = body.tick(speeds);
      for (const double signal : s.light_signal) digest.add(signal);
      for (const double value : {s.left_rolled, s.right_rolled, s.wall_signal, s.battery.charge}) digest.add(value);
      for (const bool flag : {s.bump_left, s.bump_right, s.wall, s.docked}) digest.add(flag);
      for (const std::uint8_t value : {s.light_flags, s.cliff_flags, s.infrared_omni}) digest.add(value);
      for (const double value : {body.truth().pose.x, body.truth().pose.y, body.truth().pose.yaw}) digest.add(value);
    }
    EXPECT_GT(body.truth().bumps, 5u) << "too tame to tell";
    return digest.value();
  }

  World world_;
  sim::NoiseProfile noise_;
  Pose2 start_;
};

TEST_F(DeterminismTest, TheSameSeedGivesTheSameSenses) {
  EXPECT_EQ(senses(1), senses(1));
}

TEST_F(DeterminismTest, AnotherSeedGivesOthers) {
  EXPECT_NE(senses(1), senses(2));
}

/// The bytes of some minutes at the wire.
std::uint64_t bytes_of(const World& world, const SegmentIndex& index, const sim::NoiseProfile& noise,
                       const Pose2& start, std::uint64_t seed) {
  sim::SimulatedRoomba roomba(world, index, {}, noise, Random(seed), start);
  roomba.write(encode(oi::Start{}));
  roomba.write(encode(oi::Full{}));
  roomba.write(encode(oi::Stream{{100}}));
  Random driver(seed);
  Digest digest;
  std::array<std::uint8_t, 256> buffer;
  for (int i = 0; i < 10'000; ++i) {
    if (i % 50 == 0) {
      const auto speed = [&] { return oi::Velocity::clamped(static_cast<int>(driver.uniform(-100.0, 400.0))); };
      const oi::Velocity right = speed();
      roomba.write(encode(oi::DriveDirect{right, speed()}));
    }
    const ByteRead read = roomba.read(buffer);
    digest.add(std::span<const std::uint8_t>(buffer.data(), read.count));
  }
  return digest.value();
}

TEST_F(DeterminismTest, RobotsInOneWorldDoNotDisturbEachOther) {
  const SegmentIndex index(solid_segments(world_));
  const std::uint64_t first = bytes_of(world_, index, noise_, start_, 1);
  const std::uint64_t second = bytes_of(world_, index, noise_, start_, 2);
  EXPECT_NE(first, second);
  std::array<std::uint64_t, 2> found{};
  {
    std::jthread one([&] { found[0] = bytes_of(world_, index, noise_, start_, 1); });
    std::jthread two([&] { found[1] = bytes_of(world_, index, noise_, start_, 2); });
  }
  EXPECT_EQ(found[0], first);
  EXPECT_EQ(found[1], second);
}

TEST_F(DeterminismTest, RobotsThatTakeTurnsDoNotDisturbEachOther) {
  const SegmentIndex index(solid_segments(world_));
  const Random seed(9);
  sim::RoombaBody alone(world_, index, {}, noise_, seed.fork(0), start_);
  sim::RoombaBody one(world_, index, {}, noise_, seed.fork(0), start_);
  sim::RoombaBody two(world_, index, {}, noise_, seed.fork(1), start_);
  bool differed = false;
  for (int i = 0; i < 2000; ++i) {
    const sim::BodySenses& expected = alone.tick({0.2, 0.25});
    const sim::BodySenses& other = two.tick({0.2, 0.25});
    differed = differed || expected.light_signal != other.light_signal;
    EXPECT_EQ(one.tick({0.2, 0.25}).light_signal, expected.light_signal);
    ASSERT_EQ(one.truth().pose, alone.truth().pose);
  }
  EXPECT_TRUE(differed);
}

}  // namespace
}  // namespace scrubjay::test

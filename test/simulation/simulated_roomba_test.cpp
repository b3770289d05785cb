#include <gmock/gmock.h>

#include <scrubjay/simulation/simulated_roomba.hpp>

#include "stage.hpp"
#include "wire.hpp"

namespace scrubjay::test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

/// A whole robot in a world of its own.
class Unit {
 public:
  explicit Unit(World scenery, const Pose2& start = {}, oi::Model protocol = oi::Model::Create2)
      : world(std::move(scenery)),
        index(solid_segments(world)),
        roomba(world, index, speaking(protocol), {}, Random(1), start) {}
  Unit(const Unit&) = delete;
  Unit& operator=(const Unit&) = delete;

  void send(const Bytes& bytes) { EXPECT_TRUE(roomba.write(bytes)); }
  Bytes read(std::size_t at_most = 4096) {
    Bytes buffer(at_most);
    const ByteRead read = roomba.read(buffer);
    EXPECT_TRUE(read.open);
    buffer.resize(read.count);
    return buffer;
  }
  void run(double seconds) {
    for (int i = ticks_in(seconds); i > 0; --i) read();
  }

  World world;
  SegmentIndex index;
  sim::SimulatedRoomba roomba;
};

TEST(SimulatedRoombaTest, AdvancesByATickWhenThereIsNothingToRead) {
  Unit unit({});
  EXPECT_THAT(unit.read(), SizeIs(0));
  EXPECT_EQ(unit.roomba.truth().ticks, 1u);
  EXPECT_DOUBLE_EQ(unit.roomba.now(), 0.015);
  unit.send({128, 142, 35});
  EXPECT_THAT(unit.read(), ElementsAre(1));
  EXPECT_EQ(unit.roomba.truth().ticks, 2u);
}

TEST(SimulatedRoombaTest, HandsOutATickInPiecesBeforeTheNextOne) {
  Unit whole({});
  Unit pieces({});
  whole.send({128, 148, 1, 100});
  pieces.send({128, 148, 1, 100});
  for (std::uint64_t tick = 1; tick <= 20; ++tick) {
    Bytes frame;
    for (const std::size_t size : {1u, 30u, 50u, 3u}) {
      const Bytes piece = pieces.read(size);
      EXPECT_EQ(pieces.roomba.truth().ticks, tick);
      frame.insert(frame.end(), piece.begin(), piece.end());
    }
    EXPECT_EQ(frame, whole.read());
  }
}

TEST(SimulatedRoombaTest, TakesCommandsInAnyPieces) {
  Unit unit({});
  for (const std::uint8_t byte : Bytes{128, 132, 145, 0, 100, 0, 100}) unit.send({byte});
  unit.run(2.0);
  EXPECT_NEAR(unit.roomba.truth().pose.x, 0.1 * (2.0 - 0.125), 0.005);
}

TEST(SimulatedRoombaTest, TellsOfABumpThroughTheWire) {
  Unit unit(with_walls({facing({0.0, 0.0}, 0.0, 0.4, 1.0)}));
  unit.send({128, 131, 145, 0, 200, 0, 200});
  unit.run(3.0);
  unit.send({142, 7});
  EXPECT_THAT(unit.read(), ElementsAre(3));
}

TEST(SimulatedRoombaTest, SafeModeStopsAtACliffAndTheWheelsStayOnTheFloor) {
  World world;
  world.cliffs = {box({1.0, 0.0}, {1.0, 2.0}, 0.0)};
  Unit unit(world);
  unit.send({128, 131, 145, 0, 200, 0, 200});
  unit.run(6.0);
  EXPECT_EQ(unit.roomba.firmware().mode(), oi::OiMode::Passive);
  EXPECT_LT(unit.roomba.truth().pose.x, 0.5);
  EXPECT_GT(unit.roomba.truth().pose.x, 0.3);
}

TEST(SimulatedRoombaTest, FullModeDrivesOverACliff) {
  World world;
  world.cliffs = {box({1.0, 0.0}, {1.0, 2.0}, 0.0)};
  Unit unit(world);
  unit.send({128, 132, 145, 0, 200, 0, 200});
  unit.run(6.0);
  EXPECT_GE(unit.roomba.truth().pose.x, 0.5);
  unit.send({142, 7});
  EXPECT_THAT(unit.read(), ElementsAre(0b1100)) << "both wheels hang";
}

TEST(SimulatedRoombaTest, ReplaysItsBytesFromTheSameCommands) {
  const auto bytes = [] {
    Unit unit(room(2.0, 2.0), {1.0, 1.0, 0.3});
    unit.send({128, 132, 148, 1, 100, 137, 0, 200, 1, 44});
    Bytes all;
    for (int i = 0; i < 500; ++i) {
      const Bytes frame = unit.read();
      all.insert(all.end(), frame.begin(), frame.end());
    }
    return all;
  };
  EXPECT_EQ(bytes(), bytes());
}

class GarbageTest : public ::testing::TestWithParam<oi::Model> {};

TEST_P(GarbageTest, SurvivesAnyBytes) {
  Unit unit(room(3.0, 3.0), {1.5, 1.5, 0.0}, GetParam());
  Random random(static_cast<std::uint64_t>(GetParam()) + 1);
  constexpr std::array<std::uint8_t, 12> kLively{128, 131, 132, 137, 142, 145, 146, 148, 149, 140, 141, 0};
  for (int i = 0; i < 100'000; ++i) {
    // Half of the bytes are opcodes that lead somewhere, or zeros.
    const std::uint8_t byte = random.below(2) == 0 ? static_cast<std::uint8_t>(random.next())
                                                   : kLively[random.below(static_cast<std::uint32_t>(kLively.size()))];
    unit.send({byte});
    if (i % 10 == 0) unit.read();
    if (unit.roomba.firmware().asleep()) unit.roomba.pulse_brc();  // Power is among them, too
    const sim::WheelSpeeds wanted = unit.roomba.firmware().wanted();
    ASSERT_LE(std::fabs(wanted.left), 0.5);
    ASSERT_LE(std::fabs(wanted.right), 0.5);
  }
  const Pose2 pose = unit.roomba.truth().pose;
  EXPECT_TRUE(std::isfinite(pose.x + pose.y + pose.yaw));
  EXPECT_GE(unit.index.distance(pose.position(), 5.0), kRadius - 0.0085);
  EXPECT_GT(unit.roomba.firmware().rejected_commands(), 1000u);
}

INSTANTIATE_TEST_SUITE_P(Models, GarbageTest,
                         ::testing::Values(oi::Model::Create2, oi::Model::Create1, oi::Model::Roomba400));

}  // namespace
}  // namespace scrubjay::test

/// \file
/// `scrubjay rooms`: what it prints and draws.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <mapping/floor_plan.hpp>
#include <nlohmann/json.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>

#include "command_line.hpp"

namespace scrubjay {
namespace {

class RoomsCommandTest : public testing::Test {
 protected:
  Outcome call(const Words& words) const { return scrubjay_in(folder_.path(), words); }
  void write(const std::string& stem, const test::FloorPlan& plan) const {
    OccupancyGrid map{plan.view().geometry, {}};
    for (std::size_t i = 0; i < map.geometry.size(); ++i) map.cells.push_back(trinary(plan.view().cells[i]));
    write_map(folder_ / stem, map.view());
  }
  /// A kitchen of 3 x 3 m beside a hall of 4 x 3 m, and a store that nothing leads to.
  void write_flat() const {
    test::FloorPlan plan(7.5, 5.5);
    plan.carve(0.2, 0.2, 4.2, 3.2).carve(4.3, 0.2, 7.3, 3.2).carve(4.2, 1.0, 4.3, 1.9).carve(0.2, 3.4, 2.2, 5.2);
    write("flat", plan);
  }

  TemporaryFolder folder_;
};

TEST_F(RoomsCommandTest, ListsRoomsTheLargestFirstAndWhereTheyLead) {
  write_flat();
  const Outcome outcome = call({"rooms", "flat.yaml"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out,
            "room 1      12.0 m2  around (2.23, 1.68), leads to 2\n"
            "room 2       9.0 m2  around (5.78, 1.68), leads to 1\n"
            "room 3       3.6 m2  around (1.18, 4.28)\n"
            "in all      24.7 m2\n");
}

TEST_F(RoomsCommandTest, TellsProgramsTheSame) {
  write_flat();
  const nlohmann::json json = nlohmann::json::parse(call({"rooms", "flat.yaml", "--json"}).out);
  ASSERT_EQ(json.at("rooms").size(), 3u);
  EXPECT_EQ(json["rooms"][2].at("room"), 3);
  EXPECT_NEAR(json["rooms"][2].at("area").get<double>(), 3.6, 1e-9);
  EXPECT_NEAR(json["rooms"][2].at("center").at("y").get<double>(), 4.3, 0.05);
  ASSERT_EQ(json.at("doorways").size(), 1u);
  EXPECT_EQ(json["doorways"][0].at("rooms"), (std::vector<int>{1, 2}));
  EXPECT_NEAR(json["doorways"][0].at("width").get<double>(), 0.9, 0.05);
}

TEST_F(RoomsCommandTest, DrawsThem) {
  write_flat();
  const Outcome outcome = call({"rooms", "flat.yaml", "--out", "rooms.png"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::EndsWith("picture: rooms.png\n"));
  ASSERT_EQ(call({"render", "flat.yaml", "--out", "map.png"}).code, 0);
  const Image rooms = read_image(folder_ / "rooms.png");
  const Image map = read_image(folder_ / "map.png");
  EXPECT_EQ(rooms.width, map.width);
  EXPECT_EQ(rooms.height, map.height);
  EXPECT_NE(rooms.pixels, map.pixels);
}

TEST_F(RoomsCommandTest, FindsNoneInAMapWithoutFloor) {
  write("solid", test::FloorPlan(2.0, 2.0));
  const Outcome outcome = call({"rooms", "solid.yaml"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "in all       0.0 m2\n");
}

TEST_F(RoomsCommandTest, RefusesWhatIsNoMapAndWhatItCantWrite) {
  write_flat();
  for (const Words& words : {Words{"rooms", "missing.yaml"}, Words{"rooms", "flat.pgm"}, Words{"rooms"}}) {
    const Outcome outcome = call(words);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  }
  const Outcome outcome = call({"rooms", "flat.yaml", "--out", "nowhere/rooms.png"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, testing::HasSubstr("nowhere/rooms.png"));
}

}  // namespace
}  // namespace scrubjay

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/io/world_reader.hpp>

namespace scrubjay {
namespace {

TEST(WorldYamlTest, ReadsEverythingThatAWorldHas) {
  const World world = parse_world(R"(
name: everything
walls:
  - [[0, 0], [4, 0], [4, 3]]
  - [[1, 1], [2, 1]]
furniture:
  - {name: box, box: {center: [1, 2], size: [0.4, 0.2], yaw: 1.570796326794896619}}
  - {name: disc, disc: {center: [3, 1], radius: 0.5}}
  - {polygon: [[0, 0], [1, 0], [0, 1]]}
  - {name: table, legs: {center: [2, 2], size: [1.0, 0.6], radius: 0.03}}
doors:
  - {from: [4, 0], to: [4, 0.9], open: false}
  - {from: [0, 0], to: [0, 0.9]}
cliffs:
  - {polygon: [[5, 5], [6, 5], [6, 6]]}
carpets:
  - {polygon: [[1, 1], [2, 1], [2, 2]], slip: 0.04}
dirt:
  - {center: [1, 1], radius: 0.3, level: 200}
virtual_walls:
  - {pose: [1, 2, 0.5], range: 1.5, half_angle: 0.2}
dock: {pose: [0.1, 1, 0]}
start: [0.5, 1, 7]
)",
                                  "all.yaml");
  EXPECT_EQ(world.name, "everything");
  ASSERT_EQ(world.walls.size(), 2u);
  EXPECT_EQ(world.walls[0].points, (std::vector<Point2>{{0, 0}, {4, 0}, {4, 3}}));
  ASSERT_EQ(world.furniture.size(), 4u);
  EXPECT_NEAR((world.furniture[0].parts[0][0] - Point2(1.1, 1.8)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((world.furniture[1].parts[0][0] - Point2(3.5, 1)).norm(), 0.0, 1e-12);
  EXPECT_EQ(world.furniture[2].name, "furniture");
  ASSERT_EQ(world.furniture[3].parts.size(), 4u);
  for (const Point2& corner : world.furniture[3].parts[2]) {
    EXPECT_NEAR((corner - Point2(2.5, 2.3)).norm(), 0.03, 1e-12);
  }
  EXPECT_FALSE(world.doors[0].open);
  EXPECT_TRUE(world.doors[1].open);
  EXPECT_EQ(world.cliffs[0].size(), 3u);
  EXPECT_EQ(world.carpets[0].slip, 0.04);
  EXPECT_EQ(world.dirt[0].level, 200);
  EXPECT_EQ(world.virtual_walls[0].pose, (Pose2{1, 2, 0.5}));
  EXPECT_EQ(world.virtual_walls[0].range, 1.5);
  EXPECT_EQ(world.dock->pose, (Pose2{0.1, 1, 0}));
  EXPECT_NEAR(world.start->yaw, 7 - 2 * kPi, 1e-12) << "wrapped";
}

TEST(WorldYamlTest, TakesEmptyListsForNone) {
  const World world = parse_world("name: bare\nwalls:\nfurniture: []\n", "bare.yaml");
  EXPECT_TRUE(world.walls.empty());
  EXPECT_FALSE(world.dock.has_value());
  EXPECT_FALSE(world.start.has_value());
}

struct BadText {
  std::string_view text;
  std::string_view error;
};

class BadWorldTest : public testing::TestWithParam<BadText> {};

TEST_P(BadWorldTest, IsRefusedInOneLineThatSaysWhereAndWhatWouldBeRight) {
  EXPECT_EQ(message_of([&] { parse_world(GetParam().text, "flat.yaml"); }), GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, BadWorldTest,
    testing::Values(
        BadText{"walls:\nfurniture:\n  - disc: {center: [0, 0],\n           radius: -0.2}\n",
                "flat.yaml:4: furniture[0].disc.radius is -0.2; want a positive length in metres"},
        BadText{"furniture:\n  - {name: a, box: {center: [0, 0], size: [1, 0]}}\n",
                "flat.yaml:2: furniture[0].box.size[1] is 0; want a positive length in metres"},
        BadText{"furniture:\n  - {name: a, box: {center: [0, 0], size: [1, 1], yaw: left}}\n",
                "flat.yaml:2: furniture[0].box.yaw is left; want an angle in radians"},
        BadText{"furniture:\n  - {name: a, disc: {center: [0, 0]}}\n",
                "flat.yaml:2: furniture[0].disc.radius is missing"},
        BadText{"furniture:\n  - {name: a}\n",
                "flat.yaml:2: furniture[0] is a map; want exactly one of box, disc, polygon and legs"},
        BadText{"furniture:\n  - {name: a, dics: {center: [0, 0], radius: 1}}\n",
                "flat.yaml:2: there is no field 'dics' in furniture[0]; did you mean 'disc'?"},
        BadText{"name: a\nwals: []\n", "flat.yaml:2: there is no field 'wals'; did you mean 'walls'?"},
        BadText{"name: a\nname: b\n", "flat.yaml:2: 'name' is given twice; want it once"},
        BadText{"walls:\n  - [[0, 0], [1, 0]]\n  - [[0, 0]]\n",
                "flat.yaml:3: walls[1] is a list of 1; want at least 2 points"},
        BadText{"walls: [[[0, 0], [1]]]\n", "flat.yaml:1: walls[0][1] is a list of 1; want a point, [x, y] in metres"},
        BadText{"walls: [[[0, 0], [1, .nan]]]\n",
                "flat.yaml:1: walls[0][1][1] is .nan; want a number of metres within +-1000"},
        BadText{"walls: [[[0, 0], [1, 1e9]]]\n",
                "flat.yaml:1: walls[0][1][1] is 1e9; want a number of metres within +-1000"},
        BadText{"walls: 3\n", "flat.yaml:1: walls is 3; want a list"},
        BadText{"start: [1, 2]\n", "flat.yaml:1: start is a list of 2; want a pose, [x, y, yaw] in metres and radians"},
        BadText{"\ndock: {pose: here}\n",
                "flat.yaml:2: dock.pose is here; want a pose, [x, y, yaw] in metres and radians"},
        BadText{"dock: 3\n", "flat.yaml:1: dock is 3; want fields such as pose"},
        BadText{"doors:\n  - {from: [0, 0], to: [1, 0], open: ajar}\n",
                "flat.yaml:2: doors[0].open is ajar; want true or false"},
        BadText{"carpets:\n  - {polygon: [[0, 0], [1, 0], [1, 1]], slip: 1.5}\n",
                "flat.yaml:2: carpets[0].slip is 1.5; want a share from 0 to 1"},
        BadText{"dirt:\n  - {center: [0, 0], radius: 1, level: 0}\n",
                "flat.yaml:2: dirt[0].level is 0; want a level from 1 to 255"},
        BadText{"cliffs:\n  - {polygon: [[0, 0], [1, 0]]}\n",
                "flat.yaml:2: cliffs[0].polygon is a list of 2; want at least 3 points"},
        BadText{"", "flat.yaml:1: the document is empty; want a world: fields such as walls, furniture and start"},
        BadText{"just words",
                "flat.yaml:1: the document is just words; want a world: fields such as walls, furniture and start"},
        BadText{"P5\n10 10\n255\n", "flat.yaml: is a picture; want the YAML file of its map"},
        BadText{"name: [a, b]", "flat.yaml:1: name is a list of 2; want text"},
        BadText{R"({"id": "x", "verts": [[0, 0], [1, 0]]})",
                "flat.yaml:1: verts is a list of 2; want at least 3 points"},
        BadText{R"({"id": "x", "verts": [[0, 0], [1, 0], [1, "a"]]})",
                "flat.yaml:1: verts[2][1] is a; want a number of metres within +-1000"}));

TEST(WorldReaderTest, SaysWhereYamlIsBroken) {
  EXPECT_THAT(message_of([] { parse_world("walls:\n  - [[0, 0]\nname: x\n", "flat.yaml"); }),
              testing::MatchesRegex("flat.yaml:[23]: .*; want YAML"));
}

TEST(WorldReaderTest, RefusesMoreThanAMillionPointsThroughAliases) {
  std::string text = "walls:\n  - &a [";
  for (int i = 0; i < 1000; ++i) text += "[0, 0], ";
  text += "]\n";
  for (int i = 0; i < 1100; ++i) text += "  - *a\n";
  EXPECT_THAT(message_of([&] { parse_world(text, "bomb.yaml"); }),
              testing::HasSubstr("want no more than a million points in a world"));
}

TEST(WorldReaderTest, RefusesEndlessNesting) {
  EXPECT_THAT(message_of([] { parse_world("walls: " + std::string(100'000, '['), "deep.yaml"); }),
              testing::StartsWith("deep.yaml:1: "));
}

TEST(WorldReaderTest, RefusesFilesThatAreTooLong) {
  EXPECT_THAT(message_of([] { parse_world(std::string(kMaxWorldText + 1, '#'), "long.yaml"); }),
              testing::HasSubstr("want a world of at most 16 MiB"));
}

TEST(WorldReaderTest, NamesANamelessWorldAfterItsFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_world(folder.write("attic.yaml", "walls: []\n")).name, "attic");
  EXPECT_EQ(read_world(folder.write("attic.yaml", "name: loft\n")).name, "loft");
}

TEST(WorldReaderTest, KnowsAFloorPlanByItsContent) {
  const TemporaryFolder folder;
  const World world = read_world(folder.write("plan.txt", R"({"id": "ab", "room_num": 1,
    "bbox": {"max": [2, 3], "min": [0, 0]}, "verts": [[0, 0], [2, 0], [2, 3], [0, 3]], "room_category": {}})"));
  EXPECT_EQ(world.name, "ab");
  ASSERT_EQ(world.walls.size(), 1u);
  EXPECT_EQ(world.walls[0].points, (std::vector<Point2>{{0, 0}, {2, 0}, {2, 3}, {0, 3}, {0, 0}}));
}

TEST(WorldReaderTest, MakesWallsOfAMap) {
  const TemporaryFolder folder;
  folder.write("room.pgm", "P2\n4 3\n255\n0 0 0 0\n0 254 254 0\n0 0 0 0\n");
  const World world = read_world(folder.write("room.yaml",
                                              "image: room.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\n"
                                              "occupied_thresh: 0.65\nfree_thresh: 0.196\n"));
  EXPECT_EQ(world.name, "room");
  ASSERT_EQ(world.walls.size(), 1u);
  EXPECT_EQ(world.walls[0].points, (std::vector<Point2>{{1.5, 2.5}, {2.5, 2.5}, {2.5, 3}, {1.5, 3}, {1.5, 2.5}}));
}

TEST(WorldReaderTest, SaysThatAFileIsMissing) {
  EXPECT_THAT(message_of([] { read_world("no/such/world.yaml"); }), testing::HasSubstr("no/such/world.yaml"));
}

}  // namespace
}  // namespace scrubjay

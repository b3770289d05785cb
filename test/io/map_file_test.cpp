#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A map's YAML with some of its lines replaced or added.
std::string yaml_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  std::vector<std::pair<std::string, std::string>> fields{{"image", "map.pgm"},        {"resolution", "0.05"},
                                                          {"origin", "[0, 0, 0]"},     {"negate", "0"},
                                                          {"occupied_thresh", "0.65"}, {"free_thresh", "0.196"}};
  for (const auto& change : changes) {
    const auto same = [&](const auto& field) { return field.first == change.first; };
    const auto found = std::find_if(fields.begin(), fields.end(), same);
    if (found == fields.end()) {
      fields.push_back(change);
    } else {
      found->second = change.second;
    }
  }
  std::string text;
  for (const auto& [name, value] : fields) text += value.empty() ? "" : name + ": " + value + "\n";
  return text;
}

/// What a map of these pixels (top row first, `width` a row) reads as.
class MapFileTest : public testing::Test {
 protected:
  std::vector<int> read(const std::vector<std::pair<std::string, std::string>>& changes,
                        std::vector<std::string>* warnings = nullptr) const {
    const OccupancyGrid map = read_map(folder_.write("map.yaml", yaml_with(changes)), warnings);
    EXPECT_EQ(map.cells.size(), map.geometry.size());
    return {map.cells.begin(), map.cells.end()};
  }
  std::string error_of(const std::vector<std::pair<std::string, std::string>>& changes) const {
    return message_of([&] { read(changes); });
  }

  TemporaryFolder folder_;
  std::filesystem::path image_ = folder_.write("map.pgm", "P2 2 1 255 0 254");
};

TEST_F(MapFileTest, ReadsTheGoldenMap) {
  const OccupancyGrid map = read_map(std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "test/data/maps/trinary.yaml");
  EXPECT_EQ(map.geometry, (GridGeometry{0.05, {-1.5, 2.25}, 3, 2}));
  EXPECT_THAT(map.cells, ElementsAre(0, -1, 100, 100, -1, -1)) << "the image's bottom row comes first";
}

TEST_F(MapFileTest, CountsTheThresholdsThemselvesAsOccupiedAndFree) {
  // 153 / 255 is 0.6 exactly, so p is 0.4; 51 / 255 is 0.2, so p is 0.8.
  folder_.write("map.pgm", "P2 4 1 255 51 52 152 153");
  EXPECT_THAT(read({{"occupied_thresh", "0.8"}, {"free_thresh", "0.4"}}), ElementsAre(100, -1, -1, 0));
}

TEST_F(MapFileTest, TestsOccupiedBeforeFree) {
  std::vector<std::string> warnings;
  folder_.write("map.pgm", "P2 3 1 255 100 127 254");
  EXPECT_THAT(read({{"occupied_thresh", "0.3"}, {"free_thresh", "0.9"}}, &warnings), ElementsAre(100, 100, 0));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("map.yaml:6: field free_thresh is 0.9, above occupied_thresh")));
}

TEST_F(MapFileTest, ReadsLightAsOccupiedWhereNegated) {
  folder_.write("map.pgm", "P2 3 1 255 0 128 255");
  for (const std::string yes : {"1", "true", "True", "yes"}) {
    EXPECT_THAT(read({{"negate", yes}}), ElementsAre(0, -1, 100)) << yes;
  }
  for (const std::string no : {"0", "false"}) EXPECT_THAT(read({{"negate", no}}), ElementsAre(100, -1, 0)) << no;
  EXPECT_THAT(error_of({{"negate", "maybe"}}), HasSubstr("map.yaml:4: field negate is neither"));
}

TEST_F(MapFileTest, ScalesBetweenTheThresholds) {
  // p is 0, 0.2, 0.4, 0.6, 0.8, 1; between 0.2 and 0.8 that is 0, 33.3, 66.7, 100 percent.
  folder_.write("map.pgm", "P2 6 1 255 255 204 153 102 51 0");
  EXPECT_THAT(read({{"mode", "scale"}, {"occupied_thresh", "0.8"}, {"free_thresh", "0.2"}}),
              ElementsAre(0, 0, 33, 67, 100, 100));
}

TEST_F(MapFileTest, TakesWhatIsNotOpaqueForUnknownInScaleModeEvenWhereDark) {
  const std::vector<std::uint8_t> png = encode_png({4, 1, 2, {0, 255, 0, 254, 0, 0, 255, 255}});
  write_file_atomically(image_, std::as_bytes(std::span(png)));
  EXPECT_THAT(read({{"mode", "scale"}}), ElementsAre(100, -1, -1, 0));
  EXPECT_THAT(read({{"mode", "trinary"}}), ElementsAre(100, 100, 100, 0)) << "in scale mode only";
}

TEST_F(MapFileTest, ReadsPixelsAsCellsInRawMode) {
  folder_.write("map.pgm", "P2 5 1 255 0 37 100 101 255");
  EXPECT_THAT(read({{"mode", "raw"}}), ElementsAre(0, 37, 100, -1, -1));
  EXPECT_THAT(read({{"mode", "raw"}, {"negate", "1"}}), ElementsAre(0, 37, 100, -1, -1));
}

TEST_F(MapFileTest, IsTrinaryUnlessToldAndKnowsNoFourthMode) {
  folder_.write("map.pgm", "P2 1 1 255 128");
  EXPECT_EQ(read({}), read({{"mode", "trinary"}}));
  EXPECT_THAT(error_of({{"mode", "Trinary"}}),
              HasSubstr("map.yaml:7: field mode is 'Trinary'; want trinary, scale or raw"));
}

TEST_F(MapFileTest, ExpandsIndexedColoursToGreyFirst) {
  const auto images = std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "test/data/images";
  EXPECT_THAT(read({{"image", (images / "indexed8.png").string()}}), ElementsAre(-1, -1, 100, 0));
}

TEST_F(MapFileTest, ReadsImagesOf16Bits) {
  folder_.write("map.pgm", std::string("P5 3 1 65535\n\x00\x00\xcd\xcd\xfe\xfe", 19));
  EXPECT_THAT(read({}), ElementsAre(100, -1, 0));
}

TEST_F(MapFileTest, FindsTheImageBesideTheYamlInTheHomeFolderOrAnywhere) {
  std::filesystem::create_directory(folder_ / "sub folder");
  std::filesystem::rename(image_, folder_ / "sub folder/the map.pgm");
  EXPECT_THAT(read({{"image", "sub folder/the map.pgm"}}), ElementsAre(100, 0)) << "blanks in the name";
  EXPECT_THAT(read({{"image", std::string("\"").append(folder_ / "sub folder/the map.pgm").append("\"")}}),
              ElementsAre(100, 0));
  const char* home = ::getenv("HOME");
  const std::string old_home = home == nullptr ? "" : home;
  ::setenv("HOME", (folder_ / "sub folder").c_str(), 1);
  EXPECT_THAT(read({{"image", "~/the map.pgm"}}), ElementsAre(100, 0));
  ::setenv("HOME", old_home.c_str(), 1);
  EXPECT_THAT(error_of({{"image", "gone.pgm"}}), HasSubstr((folder_ / "gone.pgm").string()));
}

TEST_F(MapFileTest, RefusesATurnedOriginLoudly) {
  EXPECT_THAT(read({{"origin", "[1, 2, 0.0]"}}), ElementsAre(100, 0));
  EXPECT_THAT(error_of({{"origin", "[1, 2, 0.1]"}}), HasSubstr("map.yaml:3: field origin has a yaw of 0.1"));
}

TEST_F(MapFileTest, TellsFileLineAndField) {
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> cases{
      {{"origin", "[1, 2]"}, ":3: field origin is not three numbers"},
      {{"origin", "[1, 2, 0, 0]"}, ":3: field origin is not three numbers"},
      {{"origin", "[1, two, 0]"}, ":3: field origin is two; want a number"},
      {{"origin", "7"}, ":3: field origin is not three numbers"},
      {{"resolution", "-0.05"}, ":2: field resolution is -0.05; want a positive"},
      {{"resolution", "0"}, ":2: field resolution is 0; want a positive"},
      {{"resolution", ".nan"}, ":2: field resolution is .nan; want a number"},
      {{"resolution", ".inf"}, ":2: field resolution is .inf; want a number"},
      {{"resolution", "[1]"}, ":2: field resolution is not a number"},
      {{"occupied_thresh", "high"}, ":5: field occupied_thresh is high; want a number"},
      {{"free_thresh", ""}, ":1: field free_thresh is missing"},
      {{"image", ""}, ":1: field image is missing"},
      {{"image", "''"}, ":1: field image is empty"},
      {{"negate", ""}, ":1: field negate is missing"},
      {{"image", "a: b: c"}, ":1: broken YAML"}};
  for (const auto& [change, complaint] : cases) {
    EXPECT_THAT(error_of({change}), AllOf(HasSubstr(std::string("map.yaml").append(complaint)), Not(HasSubstr("\n"))))
        << change.second;
  }
  EXPECT_THAT(message_of([&] { read_map(folder_.write("list.yaml", "- 1\n")); }),
              HasSubstr("list.yaml:1: not a map file"));
  EXPECT_THAT(message_of([&] { read_map(folder_ / "gone.yaml"); }), HasSubstr("gone.yaml: cannot read"));
}

TEST_F(MapFileTest, WarnsWhereUnknownTurnsIntoFree) {
  std::vector<std::string> warnings;
  folder_.write("map.pgm", "P2 3 1 255 0 205 254");
  EXPECT_THAT(read({}, &warnings), ElementsAre(100, -1, 0));
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_THAT(read({{"free_thresh", "0.25"}}, &warnings), ElementsAre(100, 0, 0));
  EXPECT_THAT(warnings, ElementsAre(AllOf(HasSubstr("map.yaml:6: field free_thresh is 0.25"), HasSubstr("0.196"))));
  warnings.clear();
  folder_.write("map.pgm", "P2 2 1 255 0 254");
  read({{"free_thresh", "0.25"}}, &warnings);
  EXPECT_THAT(warnings, IsEmpty()) << "no grey 205, no trap";
}

/// Three rows of 34 cells: every value there is.
OccupancyGrid every_value() {
  OccupancyGrid map{{0.05, {-1.25, 0.3}, 34, 3}, {}};
  for (int v = -1; v <= 100; ++v) map.cells.push_back(static_cast<Occupancy>(v));
  return map;
}

TEST_F(MapFileTest, WritesTrinaryMapsByTheByte) {
  const OccupancyGrid map{{0.05, {-1.25, 0.0}, 4, 2}, {0, 19, 20, 64, 65, 100, -1, 0}};
  write_map(folder_ / "out", map.view());
  EXPECT_EQ(content_of(folder_ / "out.pgm"), std::string("P5\n4 2\n255\n\x00\x00\xcd\xfe\xfe\xfe\xcd\xcd", 19));
  EXPECT_EQ(content_of(folder_ / "out.yaml"),
            "image: out.pgm\nmode: trinary\nresolution: 0.050\norigin: [-1.250, 0.000, 0]\nnegate: 0\n"
            "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

TEST_F(MapFileTest, ReadsBackTrinaryAsItsThreeClasses) {
  const OccupancyGrid map = every_value();
  write_map(folder_ / "out", map.view());
  std::vector<std::string> warnings;
  const OccupancyGrid again = read_map(folder_ / "out.yaml", &warnings);
  EXPECT_EQ(again.geometry, map.geometry);
  EXPECT_THAT(warnings, IsEmpty());
  for (std::size_t i = 0; i < map.cells.size(); ++i) {
    const int cell = map.cells[i];
    EXPECT_EQ(again.cells[i], cell < 0 ? -1 : cell >= 65 ? 100 : cell <= 19 ? 0 : -1) << cell;
  }
}

TEST_F(MapFileTest, ReadsBackEveryValueInScaleAndRawMode) {
  const OccupancyGrid map = every_value();
  for (const MapMode mode : {MapMode::Scale, MapMode::Raw}) {
    write_map(folder_ / "out", map.view(), mode);
    const OccupancyGrid again = read_map(folder_ / "out.yaml");
    EXPECT_EQ(again.geometry, map.geometry);
    EXPECT_EQ(again.cells, map.cells);
  }
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out.png")) << "scale needs transparency";
}

TEST_F(MapFileTest, KeepsAllDecimalsOfOriginAndResolution) {
  for (const double value : {0.1 + 0.2, 1.0 / 3.0, 1e-7, 1e-25, 123456.789, 0.025, 1.0}) {
    const OccupancyGrid map{{value, {-value, 1e6 * value}, 1, 1}, {0}};
    write_map(folder_ / "out", map.view());
    EXPECT_EQ(read_map(folder_ / "out.yaml").geometry, map.geometry) << value;
  }
}

TEST_F(MapFileTest, QuotesNamesThatYamlWouldMisread) {
  const OccupancyGrid map{{0.05, {0.0, 0.0}, 1, 1}, {100}};
  for (const std::string stem : {"my map", "a: b", "# 1", "it's \"it\"", "back\\slash", "~", "v1.2", "-", "Küche"}) {
    write_map(folder_ / stem, map.view());
    EXPECT_EQ(read_map(folder_ / (stem + ".yaml")).cells, map.cells) << stem;
  }
}

TEST_F(MapFileTest, WritesNoMapWithoutCellsAndTellsAMissingFolder) {
  EXPECT_THAT(message_of([&] { write_map(folder_ / "out", OccupancyGrid{}.view()); }), HasSubstr("without cells"));
  EXPECT_THAT(message_of([&] { write_map(folder_ / "gone/out", every_value().view()); }), HasSubstr("No such file"));
}

}  // namespace
}  // namespace scrubjay

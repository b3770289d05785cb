#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <scrubjay/io/map_picture.hpp>
#include <scrubjay/mapping/occupancy_grid.hpp>
#include <utility>

namespace scrubjay {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// A map from text, top row first: # occupied, . free, blank unknown; cells of 5 cm from the origin.
OccupancyGrid map_of(const std::vector<std::string>& rows) {
  OccupancyGrid map{{0.05, {0.0, 0.0}, static_cast<int>(rows.front().size()), static_cast<int>(rows.size())}, {}};
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) map.cells.push_back(c == '#' ? kOccupied : c == '.' ? kFree : kUnknown);
  }
  return map;
}

Pixel pixel_at(const Image& image, int x, int y) {
  Pixel pixel{};
  std::copy_n(image.pixels.begin() + static_cast<long>(static_cast<std::size_t>(y) * image.row_bytes()) + 4L * x, 4,
              pixel.begin());
  return pixel;
}

std::size_t count(const Image& image, const Pixel& wanted) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    found += std::equal(wanted.begin(), wanted.end(), image.pixels.begin() + static_cast<long>(i)) ? 1 : 0;
  }
  return found;
}

constexpr Pixel kPaper{253, 250, 242, 255}, kInk{38, 46, 59, 255};
constexpr std::size_t kCell = 24 * 24;  // pixels of a cell in a small map

/// A page without scale bar and legend, which have ink of their own: all above the footer.
Image map_part(const Image& page) {
  Image part = page;
  part.height -= 80;
  part.pixels.resize(part.row_bytes() * static_cast<std::size_t>(part.height));
  return part;
}

TEST(MapPictureTest, DrawsEachCellWithItsWholePixels) {
  const OccupancyGrid map = map_of({"####", "#.. ", "#..#"});
  MapPicture picture;
  picture.map = map.view();
  const Image image = map_part(draw_map(picture));
  EXPECT_EQ(count(image, kInk), 7 * kCell);
  EXPECT_EQ(image.channels, 4);
  // The lines at whole metres run through the lower left corner, over some of the paper.
  EXPECT_NEAR(static_cast<double>(count(image, kPaper)), 4.0 * kCell, 60.0);
}

TEST(MapPictureTest, TintsRooms) {
  OccupancyGrid map{{0.05, {0.0, 0.0}, 40, 40}, std::vector<Occupancy>(40 * 40, kFree)};
  MapPicture picture;
  picture.map = map.view();
  const std::size_t paper = count(map_part(draw_map(picture)), kPaper);
  picture.rooms = {map.geometry, std::vector<RoomLabel>(40 * 40, kNoRoom), {{1, 1.0, {0.5, 1.0}, {}}}, {}};
  for (std::size_t i = 0; i < 800; ++i) picture.rooms.labels[i] = 1;  // the lower half
  EXPECT_NEAR(static_cast<double>(count(map_part(draw_map(picture)), kPaper)), 0.5 * static_cast<double>(paper),
              0.01 * static_cast<double>(paper));
}

TEST(MapPictureTest, PutsTheMapsLastRowOnTop) {
  const OccupancyGrid map = map_of({"##", "..", ".."});
  MapPicture picture;
  picture.map = map.view();
  const Image image = map_part(draw_map(picture));
  int first_ink = image.height, first_paper = image.height;
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x) {
      if (pixel_at(image, x, y) == kInk) first_ink = y;
      if (pixel_at(image, x, y) == kPaper) first_paper = y;
    }
  }
  EXPECT_EQ(first_paper, first_ink + 24);
}

TEST(MapPictureTest, CropsToWhatIsKnownDrivenOrTrue) {
  OccupancyGrid map{{0.05, {-50.0, -50.0}, 2000, 2000}, std::vector<Occupancy>(2000 * 2000, kUnknown)};
  for (int y = 1000; y < 1060; ++y) std::fill_n(map.cells.begin() + y * 2000 + 1000, 120, kFree);
  MapPicture picture;
  picture.map = map.view();
  const Image cropped = draw_map(picture);
  EXPECT_NEAR(cropped.width, 1200, 120);
  EXPECT_LT(cropped.height, 800);
  picture.true_walls.push_back({{0.0, 0.0}, {0.0, 6.0}});
  EXPECT_GT(draw_map(picture).height, 1100);
}

TEST(MapPictureTest, HasALongSideOfAbout1200PixelsWhateverTheMap) {
  for (const int cells : {60, 100, 130, 170, 250, 290}) {
    const OccupancyGrid map{{0.05, {0.0, 0.0}, cells, 10}, std::vector<Occupancy>(std::size_t(cells) * 10, kFree)};
    MapPicture picture;
    picture.map = map.view();
    EXPECT_NEAR(draw_map(picture).width, 1272, 170) << cells;
  }
}

TEST(MapPictureTest, ShowsEverythingThatItIsGiven) {
  const OccupancyGrid map = map_of(std::vector<std::string>(60, std::string(80, '.')));
  MapPicture picture;
  picture.map = map.view();
  Image before = draw_map(picture);
  const auto changes = [&] {
    const Image now = draw_map(picture);
    return !(std::exchange(before, now) == now);
  };
  picture.true_walls.push_back({{0.5, 0.5}, {3.0, 0.5}});
  EXPECT_TRUE(changes());
  picture.trajectory = {{0.5, 1.0, 0.0}, {3.0, 1.0, 0.0}};
  EXPECT_TRUE(changes());
  picture.robot = Pose2{3.0, 2.0, 0.0};
  EXPECT_TRUE(changes());
  picture.robot = Pose2{3.0, 2.0, 1.0};
  EXPECT_TRUE(changes()) << "its heading shows";
  picture.start = Pose2{0.5, 1.0, 0.0};
  EXPECT_TRUE(changes());
  picture.dock = Pose2{0.5, 2.0, 0.0};
  EXPECT_TRUE(changes());
  picture.bumps = {{2.0, 0.5}};
  EXPECT_TRUE(changes());
  picture.stuck = {{1.0, 0.7}};
  EXPECT_TRUE(changes());
  picture.title = "living room";
  EXPECT_TRUE(changes());
}

TEST(MapPictureTest, DrawsTrueWallsBeneathTheMapsOwn) {
  const OccupancyGrid map = map_of(std::vector<std::string>(40, std::string(40, '#')));
  MapPicture picture;
  picture.map = map.view();
  const Image without = map_part(draw_map(picture));
  picture.true_walls.push_back({{0.5, 0.5}, {1.5, 1.5}});
  EXPECT_EQ(map_part(draw_map(picture)), without);
}

TEST(MapPictureTest, GivesTheSameBytesAgain) {
  const OccupancyGrid map = map_of({"#####", "#...#", "#####"});
  MapPicture picture;
  picture.map = map.view();
  picture.trajectory = {{0.1, 0.1, 0.0}, {0.15, 0.08, 0.0}};
  picture.robot = picture.trajectory.back();
  EXPECT_EQ(encode_png(draw_map(picture)), encode_png(draw_map(picture)));
}

TEST(MapPictureTest, TakesMapsOfNothingAndPosesOfNonsense) {
  MapPicture picture;
  EXPECT_GT(draw_map(picture).width, 100);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  picture.trajectory = {{kNan, 0.0, 0.0}, {1.0, kNan, 0.0}, {1e300, 0.0, kNan}, {0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}};
  picture.robot = Pose2{kNan, kNan, kNan};
  picture.bumps = {{1e300, 0.0}};
  picture.title = std::string(300, 'x');
  const Image image = draw_map(picture);
  EXPECT_LT(image.width, 2000) << "what is far off doesn't shrink the rest";
}

TEST(MapPictureTest, StaysAPictureForAMapOfKilometres) {
  MapPicture picture;
  picture.trajectory = {{0.0, 0.0, 0.0}, {5000.0, 3000.0, 0.0}};
  const Image image = draw_map(picture);
  EXPECT_LE(image.width, 8200);
}

}  // namespace
}  // namespace scrubjay

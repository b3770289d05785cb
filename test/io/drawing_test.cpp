#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/io/drawing.hpp>

namespace scrubjay {
namespace {

constexpr Color kBlack{0, 0, 0};
constexpr Color kWhite{255, 255, 255};

int grey_at(const Canvas& canvas, int x, int y) {
  return canvas.image()
      .pixels[static_cast<std::size_t>(y) * canvas.image().row_bytes() + 4 * static_cast<std::size_t>(x)];
}

/// How many pixels' worth of ink is on a white canvas.
double ink(const Canvas& canvas) {
  double sum = 0.0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) sum += 1.0 - grey_at(canvas, x, y) / 255.0;
  }
  return sum;
}

TEST(DrawingTest, MixesColoursAndFadesThem) {
  EXPECT_EQ(mix(kBlack, kWhite, 0.0), kBlack);
  EXPECT_EQ(mix(kBlack, kWhite, 1.0), kWhite);
  EXPECT_EQ(mix({0, 100, 200}, {100, 0, 200}, 0.5), (Color{50, 50, 200}));
  EXPECT_EQ(faded(kBlack, 0.2), (Color{0, 0, 0, 51}));
}

TEST(DrawingTest, BlendsByOpacityAndStaysOpaqueItself) {
  Canvas canvas(1, 1, kWhite);
  canvas.blend(0, 0, {0, 100, 255, 51});
  EXPECT_EQ(canvas.image().pixels, (std::vector<std::uint8_t>{204, 224, 255, 255}));
}

TEST(DrawingTest, FillsPolygonsByTheAreaTheyCoverInEachPixel) {
  Canvas canvas(10, 10, kWhite);
  const std::vector<Point2> square{{2.0, 2.0}, {5.5, 2.0}, {5.5, 5.0}, {2.0, 5.0}};
  canvas.fill_polygon(square, kBlack);
  EXPECT_EQ(grey_at(canvas, 1, 3), 255);
  EXPECT_EQ(grey_at(canvas, 2, 2), 0);
  EXPECT_EQ(grey_at(canvas, 4, 4), 0);
  EXPECT_NEAR(grey_at(canvas, 5, 3), 127, 1);
  EXPECT_EQ(grey_at(canvas, 4, 5), 255);
  EXPECT_NEAR(ink(canvas), 3.5 * 3.0, 0.02);
}

TEST(DrawingTest, LeavesHolesByTheEvenOddRule) {
  Canvas canvas(20, 20, kWhite);
  const std::vector<Point2> bow{{1, 1}, {19, 1}, {19, 19}, {1, 19}, {1, 1}, {6, 6}, {6, 14}, {14, 14}, {14, 6}, {6, 6}};
  canvas.fill_polygon(bow, kBlack);
  EXPECT_NEAR(ink(canvas), 18.0 * 18.0 - 8.0 * 8.0, 0.5);
  EXPECT_EQ(grey_at(canvas, 10, 10), 255);
}

TEST(DrawingTest, DiscsRingsAndLinesHaveTheirArea) {
  for (const double shift : {0.0, 0.3, 0.5}) {
    Canvas disc(40, 40, kWhite), ring(40, 40, kWhite), line(40, 40, kWhite);
    disc.fill_disc({20.0 + shift, 20.0}, 10.0, kBlack);
    EXPECT_NEAR(ink(disc), kPi * 100.0, 2.0);
    ring.draw_circle({20.0 + shift, 20.0}, 10.0, 2.0, kBlack);
    EXPECT_NEAR(ink(ring), kPi * (11.0 * 11.0 - 9.0 * 9.0), 2.0);
    line.draw_polyline(std::vector<Point2>{{8.0, 9.0 + shift}, {32.0, 27.0 + shift}}, 3.0, kBlack);
    EXPECT_NEAR(ink(line), 30.0 * 3.0 + kPi * 1.5 * 1.5, 2.0);
  }
}

TEST(DrawingTest, LinesThinnerThanAPixelAreFaint) {
  Canvas canvas(30, 5, kWhite);
  canvas.draw_polyline(std::vector<Point2>{{-10.0, 2.5}, {40.0, 2.5}}, 0.5, kBlack);
  EXPECT_NEAR(ink(canvas), 15.0, 2.0);
}

TEST(DrawingTest, ATranslucentLineIsNoDarkerWhereItCrossesItself) {
  Canvas canvas(20, 20, kWhite);
  canvas.draw_polyline(std::vector<Point2>{{2, 10}, {18, 10}, {18, 18}, {10, 18}, {10, 2}}, 4.0, faded(kBlack, 0.5));
  EXPECT_EQ(grey_at(canvas, 10, 10), grey_at(canvas, 4, 10));
  EXPECT_NEAR(grey_at(canvas, 10, 10), 127, 1);
}

TEST(DrawingTest, CutsOffWhatLiesOutside) {
  Canvas canvas(10, 10, kWhite);
  canvas.fill_rectangle(-5, -5, 7, 7, kBlack);
  EXPECT_NEAR(ink(canvas), 4.0, 1e-9);
  canvas.fill_disc({-100.0, 5.0}, 20.0, kBlack);
  canvas.fill_polygon(std::vector<Point2>{{20, 20}, {30, 20}, {20, 30}}, kBlack);
  canvas.draw_text(50, -50, "far", 3, kBlack);
  canvas.draw_polyline(std::vector<Point2>{{50, 50}, {60, 60}}, 3.0, kBlack);
  EXPECT_NEAR(ink(canvas), 4.0, 1e-9);
}

TEST(DrawingTest, LeavesOutWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  Canvas canvas(10, 10, kWhite);
  for (const Point2& bad : {Point2{kNan, 5.0}, Point2{5.0, kInfinity}, Point2{1e300, -1e300}}) {
    canvas.fill_disc(bad, 3.0, kBlack);
    canvas.draw_circle(bad, 3.0, 1.0, kBlack);
    canvas.draw_polyline(std::vector<Point2>{{1, 1}, bad}, 2.0, kBlack);
    canvas.fill_polygon(std::vector<Point2>{{1, 1}, {8, 1}, bad}, kBlack);
  }
  canvas.draw_polyline({}, 2.0, kBlack);
  canvas.fill_polygon(std::vector<Point2>{{1, 1}, {8, 8}}, kBlack);
  EXPECT_EQ(ink(canvas), 0.0);
}

TEST(DrawingTest, DrawsEveryLetterAndDigitDifferently) {
  const std::string characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:-/_%()+";
  std::vector<Image> seen;
  for (const char c : characters) {
    Canvas canvas(5, 9, kWhite);
    canvas.draw_text(0, 0, std::string(1, c), 1, kBlack);
    EXPECT_GT(ink(canvas), 2.0) << c;
    EXPECT_EQ(std::count(seen.begin(), seen.end(), canvas.image()), 0) << c;
    seen.push_back(canvas.image());
  }
  Canvas blank(40, 9, kWhite);
  blank.draw_text(0, 0, " \xc3\xa4\n~", 1, kBlack);
  EXPECT_EQ(ink(blank), 0.0);
}

TEST(DrawingTest, MeasuresLabels) {
  EXPECT_EQ(text_width("", 2), 0);
  EXPECT_EQ(text_width("a", 2), 10);
  EXPECT_EQ(text_width("ab", 3), 33);
}

TEST(DrawingTest, RefusesCanvasesThatNoImageCanBe) {
  EXPECT_THROW(Canvas(0, 10, kWhite), Error);
  EXPECT_THROW(Canvas(-5, -5, kWhite), Error);
  EXPECT_THROW(Canvas(100000, 100000, kWhite), Error);
}

}  // namespace
}  // namespace scrubjay

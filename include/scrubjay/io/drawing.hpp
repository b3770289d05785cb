/// \file
/// A small canvas: polygons, discs and lines with soft edges, and labels.
#pragma once

#include <cstdint>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/io/image.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace scrubjay {

/// Red, green, blue and opacity, 0 to 255 each.
struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  std::uint8_t alpha = 255;

  bool operator==(const Color&) const = default;
};

/// The same colour, less opaque; 0 <= opacity <= 1.
Color faded(Color color, double opacity);
/// From `a` at share 0 to `b` at share 1.
Color mix(Color a, Color b, double share);

/// Draws over an opaque ground. Coordinates are pixels, x to the right and y down from the top left corner of the first
/// pixel, so that its centre is (0.5, 0.5). What lies outside is cut off; shapes with a coordinate that isn't finite
/// are left out. The same calls give the same bytes.
class Canvas {
 public:
  /// Throws Error for a canvas larger than an image may be.
  Canvas(int width, int height, Color ground);

  int width() const { return image_.width; }
  int height() const { return image_.height; }
  /// RGBA.
  const Image& image() const { return image_; }
  /// Blends over one pixel, which must lie inside.
  void blend(int x, int y, Color color);
  /// Pixels whole: [x, x + width) by [y, y + height).
  void fill_rectangle(int x, int y, int width, int height, Color color);
  /// Inside by the even-odd rule; the last corner joins the first.
  void fill_polygon(std::span<const Point2> corners, Color color);
  void fill_disc(const Point2& center, double radius, Color color);
  /// A ring whose line of `thickness` runs along the circle.
  void draw_circle(const Point2& center, double radius, double thickness, Color color);
  /// A line with round joints and ends, as one shape: where it crosses itself it is no darker.
  void draw_polyline(std::span<const Point2> points, double thickness, Color color);
  /// Capital letters about 7 * scale pixels high; (x, y) is their top left corner. What the font lacks is left blank.
  void draw_text(int x, int y, std::string_view text, int scale, Color color);

 private:
  struct Box;
  template <typename Coverage>
  void fill(const Box& box, Color color, Coverage coverage);

  Image image_;
};

/// Width of a label in pixels.
int text_width(std::string_view text, int scale);

}  // namespace scrubjay

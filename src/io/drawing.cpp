#include <algorithm>
#include <array>
#include <cmath>
#include <scrubjay/geometry/segment2.hpp>
#include <scrubjay/io/drawing.hpp>

#include "font.hpp"
#include "image_formats.hpp"

namespace scrubjay {
namespace {

std::uint8_t blend_channel(int below, int above, int alpha) {
  return static_cast<std::uint8_t>((above * alpha + below * (255 - alpha) + 127) / 255);
}

/// False for what is not finite, and for what lies so far away that squares would lose their sense.
bool drawable(std::span<const Point2> points) {
  constexpr double kFar = 1e7;  // [pixels]
  return std::all_of(points.begin(), points.end(),
                     [](const Point2& p) { return std::abs(p.x()) < kFar && std::abs(p.y()) < kFar; });
}

/// Adds the share of each pixel of a row that lies in [from, to], times `weight`.
void add_span(std::vector<double>& row, double from, double to, double weight) {
  from = std::clamp(from, 0.0, static_cast<double>(row.size()));
  to = std::clamp(to, 0.0, static_cast<double>(row.size()));
  for (double x = from; x < to;) {
    const double next = std::min(std::floor(x) + 1.0, to);
    row[static_cast<std::size_t>(x)] += (next - x) * weight;
    x = next;
  }
}

/// Where the outline crosses the height `y`, ascending.
void find_crossings(std::span<const Point2> corners, double y, std::vector<double>& crossings) {
  crossings.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& a = corners[i];
    const Point2& b = corners[(i + 1) % corners.size()];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(crossings.begin(), crossings.end());
}

}  // namespace

Color faded(Color color, double opacity) {
  color.alpha = static_cast<std::uint8_t>(std::lround(color.alpha * std::clamp(opacity, 0.0, 1.0)));
  return color;
}

Color mix(Color a, Color b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue), channel(a.alpha, b.alpha)};
}

/// Pixels [left, right) by [top, bottom) that lie within the canvas.
struct Canvas::Box {
  int left, top, right, bottom;

  /// All pixels within `margin` of the points.
  static Box around(std::span<const Point2> points, double margin, const Canvas& canvas) {
    Point2 low = points.front(), high = points.front();
    for (const Point2& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const auto clip = [](double value, int size) { return static_cast<int>(std::clamp(value, 0.0, double{1} * size)); };
    return {clip(std::floor(low.x() - margin), canvas.width()), clip(std::floor(low.y() - margin), canvas.height()),
            clip(std::ceil(high.x() + margin), canvas.width()), clip(std::ceil(high.y() + margin), canvas.height())};
  }
};

Canvas::Canvas(int width, int height, Color ground) : image_{width, height, 4, {}} {
  check_image_size(static_cast<std::uint64_t>(std::max(width, 0)), static_cast<std::uint64_t>(std::max(height, 0)),
                   "picture");
  image_.pixels.resize(image_.row_bytes() * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image_.pixels.size(); i += 4) {
    const std::array<std::uint8_t, 4> pixel{ground.red, ground.green, ground.blue, 255};
    std::copy(pixel.begin(), pixel.end(), image_.pixels.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void Canvas::blend(int x, int y, Color color) {
  std::uint8_t* pixel =
      &image_.pixels[static_cast<std::size_t>(y) * image_.row_bytes() + 4 * static_cast<std::size_t>(x)];
  pixel[0] = blend_channel(pixel[0], color.red, color.alpha);
  pixel[1] = blend_channel(pixel[1], color.green, color.alpha);
  pixel[2] = blend_channel(pixel[2], color.blue, color.alpha);
}

/// Blends each pixel of the box by coverage(its centre), the share of it that the shape covers.
template <typename Coverage>
void Canvas::fill(const Box& box, Color color, Coverage coverage) {
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      const double share = coverage(Point2{x + 0.5, y + 0.5});
      if (share > 0.0) blend(x, y, faded(color, share));
    }
  }
}

void Canvas::fill_rectangle(int x, int y, int width, int height, Color color) {
  const std::array<Point2, 2> corners{Point2{1.0 * x, 1.0 * y}, Point2{1.0 * x + width, 1.0 * y + height}};
  fill(Box::around(corners, 0.0, *this), color, [](const Point2&) { return 1.0; });
}

void Canvas::fill_polygon(std::span<const Point2> corners, Color color) {
  if (corners.size() < 3 || !drawable(corners)) return;
  constexpr int kScanlines = 8;  // a pixel; along each, coverage is exact
  const Box box = Box::around(corners, 0.0, *this);
  std::vector<double> row(static_cast<std::size_t>(width()));
  std::vector<double> crossings;
  for (int y = box.top; y < box.bottom; ++y) {
    std::fill(row.begin(), row.end(), 0.0);
    for (int i = 0; i < kScanlines; ++i) {
      find_crossings(corners, y + (i + 0.5) / kScanlines, crossings);
      for (std::size_t c = 0; c + 1 < crossings.size(); c += 2) {
        add_span(row, crossings[c], crossings[c + 1], 1.0 / kScanlines);
      }
    }
    fill({box.left, y, box.right, y + 1}, color,
         [&](const Point2& center) { return row[static_cast<std::size_t>(center.x())]; });
  }
}

void Canvas::fill_disc(const Point2& center, double radius, Color color) {
  if (!drawable({&center, 1})) return;
  fill(Box::around({&center, 1}, radius + 1.0, *this), color,
       [&](const Point2& p) { return std::clamp(radius + 0.5 - (p - center).norm(), 0.0, 1.0); });
}

void Canvas::draw_circle(const Point2& center, double radius, double thickness, Color color) {
  if (!drawable({&center, 1})) return;
  fill(Box::around({&center, 1}, radius + thickness + 1.0, *this), color, [&](const Point2& p) {
    return std::clamp(thickness / 2.0 + 0.5 - std::abs((p - center).norm() - radius), 0.0, std::min(thickness, 1.0));
  });
}

void Canvas::draw_polyline(std::span<const Point2> points, double thickness, Color color) {
  if (points.empty() || !drawable(points)) return;
  const double reach = thickness / 2.0 + 0.5;
  const Box all = Box::around(points, reach, *this);
  if (all.left >= all.right || all.top >= all.bottom) return;
  const auto stride = static_cast<std::size_t>(all.right - all.left);
  const auto place = [&](int x, int y) {
    return static_cast<std::size_t>(y - all.top) * stride + static_cast<std::size_t>(x - all.left);
  };
  // Covered by any segment, not by their sum: so a line is as dark at its joints as between them.
  std::vector<double> covered(stride * static_cast<std::size_t>(all.bottom - all.top), 0.0);
  for (std::size_t i = 0; i < std::max<std::size_t>(points.size() - 1, 1); ++i) {
    const std::array<Point2, 2> ends{points[i], points[std::min(i + 1, points.size() - 1)]};
    const Segment2 segment{ends[0], ends[1]};
    const Box box = Box::around(ends, reach, *this);
    for (int y = box.top; y < box.bottom; ++y) {
      for (int x = box.left; x < box.right; ++x) {
        const double distance = std::sqrt(squared_distance(segment, {x + 0.5, y + 0.5}));
        double& share = covered[place(x, y)];
        share = std::max(share, std::clamp(reach - distance, 0.0, std::min(thickness, 1.0)));
      }
    }
  }
  fill(all, color, [&](const Point2& p) { return covered[place(static_cast<int>(p.x()), static_cast<int>(p.y()))]; });
}

void Canvas::draw_text(int x, int y, std::string_view text, int scale, Color color) {
  for (const char character : text) {
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        if (!glyph_ink(character, column, row)) continue;
        fill_rectangle(x + column * scale, y + row * scale, scale, scale, color);
      }
    }
    x += (kGlyphWidth + 1) * scale;
  }
}

int text_width(std::string_view text, int scale) {
  return text.empty() ? 0 : (static_cast<int>(text.size()) * (kGlyphWidth + 1) - 1) * scale;
}

}  // namespace scrubjay

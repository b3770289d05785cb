#include "picture_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture_style.hpp"
#include "picture_symbols.hpp"

namespace scrubjay {
namespace {

constexpr int kMargin = 36;
constexpr int kLabelScale = 2;
constexpr int kLabelHeight = 7 * kLabelScale;
constexpr int kTitleBand = 48;
constexpr int kFooterRow = 32;
constexpr int kIconWidth = 33;
constexpr int kItemGap = 26;
constexpr int kLeastWidth = 420;

struct LegendItem {
  std::string_view label;
  void (*draw)(Canvas& canvas, const Point2& center);
};

void draw_line_icon(Canvas& canvas, const Point2& center, Color from, Color to, double thickness) {
  constexpr int kPieces = 8;
  for (int i = 0; i < kPieces; ++i) {
    const double left = center.x() - 11.0 + 22.0 * i / kPieces;
    const std::array<Point2, 2> piece{Point2{left, center.y()}, Point2{left + 22.0 / kPieces, center.y()}};
    canvas.draw_polyline(piece, thickness, mix(from, to, i / (kPieces - 1.0)));
  }
}

std::vector<LegendItem> legend_of(const MapPicture& picture) {
  std::vector<LegendItem> items;
  const auto add = [&](bool present, LegendItem item) {
    if (present) items.push_back(item);
  };
  add(!picture.trajectory.empty(), {"path", [](Canvas& canvas, const Point2& at) {
                                      draw_line_icon(canvas, at, style::kPathBegin, style::kPathEnd, 3.0);
                                    }});
  add(!picture.true_walls.empty(), {"true wall", [](Canvas& canvas, const Point2& at) {
                                      const std::array<Point2, 2> line{at - Point2{11.0, 0.0}, at + Point2{11.0, 0.0}};
                                      canvas.draw_polyline(line, 3.0, style::kTrueWall);
                                    }});
  add(!picture.bumps.empty(), {"bump", [](Canvas& canvas, const Point2& at) { draw_bump(canvas, at, 9.0); }});
  add(!picture.left.empty(), {"left", [](Canvas& canvas, const Point2& at) { draw_left(canvas, at, 11.0); }});
  add(!picture.stuck.empty(), {"stuck", [](Canvas& canvas, const Point2& at) { draw_stuck(canvas, at, 18.0); }});
  add(picture.start.has_value(), {"start", [](Canvas& canvas, const Point2& at) {
                                    draw_start(canvas, {at - Point2{3.0, 0.0}, 0.0}, 15.0);
                                  }});
  add(picture.dock.has_value(), {"dock", [](Canvas& canvas, const Point2& at) {
                                   draw_dock(canvas, {at - Point2{0.0, 4.0}, radians(90.0)}, 20.0);
                                 }});
  add(picture.robot.has_value(), {"robot", [](Canvas& canvas, const Point2& at) {
                                    draw_robot(canvas, {at, radians(90.0)}, 10.0);
                                  }});
  return items;
}

/// The longest of 1, 2 or 5 times a power of ten [m] that a bar of at most `limit` pixels can show.
double round_length(double pixels_per_metre, double limit) {
  double best = 0.001;
  for (double decade = 0.001; decade < 1e6; decade *= 10.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step * decade * pixels_per_metre <= limit) best = step * decade;
    }
  }
  return best;
}

std::string length_label(double metres) {
  if (metres >= 0.999) return fmt::format("{:.0f} m", metres);
  return metres >= 0.00999 ? fmt::format("{:.0f} cm", metres * 100.0) : fmt::format("{:.0f} mm", metres * 1000.0);
}

int item_width(const LegendItem& item) {
  return kIconWidth + text_width(item.label, kLabelScale);
}

struct ScaleBar {
  int pixels;
  std::string label;
  int width() const { return pixels + 12 + text_width(label, kLabelScale); }
};

ScaleBar scale_bar(double pixels_per_metre) {
  const double length = round_length(pixels_per_metre, 170.0);
  return {static_cast<int>(std::lround(length * pixels_per_metre)), length_label(length)};
}

/// Where the legend's items begin, row after row to the right of the scale bar.
std::vector<Point2> legend_places(const std::vector<LegendItem>& items, int bar_width, int page_width) {
  std::vector<Point2> places;
  int total = 0;
  for (const LegendItem& item : items) total += item_width(item) + kItemGap;
  const int left = kMargin + bar_width + kItemGap;
  const int room = page_width - kMargin - left;
  int x = std::max(left, page_width - kMargin - (total - kItemGap));  // flush right while it is one row
  int row = 0;
  for (const LegendItem& item : items) {
    if (x > left && x + item_width(item) > left + room) {
      x = left;
      ++row;
    }
    places.emplace_back(x, row);
    x += item_width(item) + kItemGap;
  }
  return places;
}

}  // namespace

PageLayout lay_out_page(const MapPicture& picture, int map_width, int map_height, double pixels_per_metre) {
  PageLayout page{.map_width = map_width, .map_height = map_height};
  page.width = std::max(map_width, kLeastWidth) + 2 * kMargin;
  page.map_left = (page.width - map_width) / 2;
  page.map_top = kMargin + (picture.title.empty() ? 0 : kTitleBand);
  if (text_width(picture.title, page.title_scale) > page.width - 2 * kMargin) page.title_scale = 2;
  page.footer_top = page.map_top + map_height + 24;
  const auto places = legend_places(legend_of(picture), scale_bar(pixels_per_metre).width(), page.width);
  const int rows = places.empty() ? 1 : 1 + static_cast<int>(places.back().y());
  page.height = page.footer_top + rows * kFooterRow + kMargin / 2;
  return page;
}

void draw_frame(Canvas& canvas, const MapPicture& picture, const PageLayout& page, double pixels_per_metre,
                const Point2& size) {
  canvas.draw_text(kMargin, kMargin, picture.title, page.title_scale, style::kInk);
  const std::string extent = fmt::format("{:.1f} x {:.1f} m", size.x(), size.y());
  const int size_left = page.width - kMargin - text_width(extent, kLabelScale);
  if (!picture.title.empty() && kMargin + text_width(picture.title, page.title_scale) + kItemGap < size_left) {
    const int below = 7 * (page.title_scale - kLabelScale);
    canvas.draw_text(size_left, kMargin + below, extent, kLabelScale, style::kFaintInk);
  }

  const ScaleBar bar = scale_bar(pixels_per_metre);
  const int middle = page.footer_top + kFooterRow / 2;
  canvas.fill_rectangle(kMargin, middle - 1, bar.pixels, 3, style::kInk);
  canvas.fill_rectangle(kMargin, middle - 6, 3, 13, style::kInk);
  canvas.fill_rectangle(kMargin + bar.pixels - 3, middle - 6, 3, 13, style::kInk);
  canvas.draw_text(kMargin + bar.pixels + 12, middle - kLabelHeight / 2, bar.label, kLabelScale, style::kInk);

  const std::vector<LegendItem> items = legend_of(picture);
  const std::vector<Point2> places = legend_places(items, bar.width(), page.width);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double y = middle + places[i].y() * kFooterRow;
    items[i].draw(canvas, {places[i].x() + 11.0, y + 0.5});
    canvas.draw_text(static_cast<int>(places[i].x()) + kIconWidth, static_cast<int>(y) - kLabelHeight / 2,
                     items[i].label, kLabelScale, style::kInk);
  }
}

}  // namespace scrubjay

/// \file
/// Maps drawn as rows of text, the top row first: '#' is occupied, '?' unknown, anything else free.
#pragma once

#include <scrubjay/grid/cell_rect.hpp>
#include <scrubjay/grid/log_odds.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace scrubjay::test {

class MapDrawing {
 public:
  /// Each character makes `scale` x `scale` cells.
  explicit MapDrawing(const std::vector<std::string>& rows, double resolution = 0.05, int scale = 1)
      : rows_(rows), scale_(scale) {
    geometry_.resolution = resolution;
    geometry_.width = scale * static_cast<std::int32_t>(rows.front().size());
    geometry_.height = scale * static_cast<std::int32_t>(rows.size());
    cells_.resize(geometry_.size());
    for (std::int32_t y = 0; y < geometry_.height; ++y) {
      for (std::int32_t x = 0; x < geometry_.width; ++x) view()[{x, y}] = value(at({x / scale, y / scale}));
    }
  }

  GridView<LogOdds> view() { return {geometry_, cells_.data()}; }
  GridView<const LogOdds> view() const { return {geometry_, cells_.data()}; }
  CellRect all() const { return cells_of(geometry_); }
  /// The middle cell of what a character made.
  CellIndex cell(char mark) const {
    for (std::int32_t y = 0; y < geometry_.height / scale_; ++y) {
      for (std::int32_t x = 0; x < geometry_.width / scale_; ++x) {
        if (at({x, y}) == mark) return {x * scale_ + scale_ / 2, y * scale_ + scale_ / 2};
      }
    }
    throw std::invalid_argument(std::string("no such mark in the drawing: ") + mark);
  }
  Point2 point(char mark) const { return geometry_.center(cell(mark)); }
  void set(const CellRect& rect, char mark) {
    for (std::int32_t y = rect.low.y; y < rect.high.y; ++y) {
      for (std::int32_t x = rect.low.x; x < rect.high.x; ++x) view()[{x, y}] = value(mark);
    }
  }

 private:
  static LogOdds value(char mark) { return mark == '#' ? LogOdds{60} : mark == '?' ? LogOdds{0} : LogOdds{-60}; }
  char at(CellIndex c) const {
    return rows_.at(rows_.size() - 1 - static_cast<std::size_t>(c.y)).at(static_cast<std::size_t>(c.x));
  }

  std::vector<std::string> rows_;
  int scale_;
  GridGeometry geometry_;
  std::vector<LogOdds> cells_;
};

}  // namespace scrubjay::test

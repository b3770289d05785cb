#include "clearance.hpp"

#include <algorithm>
#include <cstddef>

namespace scrubjay {
namespace {

/// Leaves in each cell the squared distance along its column.
void measure_columns(GridView<const std::uint8_t> floor, std::int32_t reach, std::vector<SquaredClearance>& cells) {
  const auto width = static_cast<std::size_t>(floor.geometry.width);
  const auto height = static_cast<std::size_t>(floor.geometry.height);
  const auto far = static_cast<SquaredClearance>(reach);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = floor.cells[i] != 0 ? far : SquaredClearance{0};
  const auto step = [&](std::size_t from, std::size_t to) {
    const SquaredClearance* before = cells.data() + from * width;
    SquaredClearance* row = cells.data() + to * width;
    for (std::size_t x = 0; x < width; ++x) row[x] = std::min(row[x], static_cast<SquaredClearance>(before[x] + 1));
  };
  for (std::size_t y = 1; y < height; ++y) step(y - 1, y);
  for (std::size_t y = height; y-- > 1;) step(y, y - 1);
  for (SquaredClearance& cell : cells) cell = static_cast<SquaredClearance>(cell * cell);
}

}  // namespace

std::vector<SquaredClearance> squared_clearance(GridView<const std::uint8_t> floor, std::int32_t reach) {
  const auto width = static_cast<std::size_t>(floor.geometry.width);
  std::vector<SquaredClearance> cells(floor.geometry.size());
  measure_columns(floor, reach, cells);
  // A row with as much beside it as the reach is long, all of it far.
  const auto far = static_cast<SquaredClearance>(reach * reach);
  const auto margin = static_cast<std::size_t>(reach);
  std::vector<SquaredClearance> padded(width + 2 * margin, far);
  for (std::size_t begin = 0; begin < cells.size(); begin += width) {
    SquaredClearance* row = cells.data() + begin;
    std::copy_n(row, width, padded.data() + margin);
    for (std::size_t shift = 0; shift < padded.size() - width + 1; ++shift) {
      const SquaredClearance* from = padded.data() + shift;
      const auto dx = static_cast<std::int32_t>(shift) - reach;
      const auto across = static_cast<SquaredClearance>(dx * dx);
      for (std::size_t x = 0; x < width; ++x) {
        row[x] = std::min(row[x], static_cast<SquaredClearance>(from[x] + across));
      }
    }
  }
  return cells;
}

}  // namespace scrubjay

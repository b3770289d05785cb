#include "map_cells.hpp"

#include <array>
#include <cmath>

namespace scrubjay {
namespace {

Occupancy cell_of(std::uint8_t grey, const MapPixels& pixels) {
  if (pixels.mode == MapMode::Raw) return grey <= kOccupied ? static_cast<Occupancy>(grey) : kUnknown;
  const double p = darkness(grey, pixels.negate);
  if (p >= pixels.occupied_thresh) return kOccupied;
  if (p <= pixels.free_thresh) return kFree;
  if (pixels.mode == MapMode::Trinary) return kUnknown;
  const double share = (p - pixels.free_thresh) / (pixels.occupied_thresh - pixels.free_thresh);
  return static_cast<Occupancy>(std::lround(share * 100.0));
}

std::uint8_t trinary_grey(Occupancy cell) {
  constexpr std::uint8_t kOccupiedGrey = 0, kFreeGrey = 254, kUnknownGrey = 205;
  constexpr MapPixels kWritten;
  if (cell < 0) return kUnknownGrey;
  if (cell >= kWritten.occupied_thresh * 100.0) return kOccupiedGrey;
  return cell <= kWritten.free_thresh * 100.0 ? kFreeGrey : kUnknownGrey;
}

std::uint8_t raw_grey(Occupancy cell) {
  return cell < 0 || cell > kOccupied ? 255 : static_cast<std::uint8_t>(cell);
}

std::uint8_t scale_grey(Occupancy cell) {
  return static_cast<std::uint8_t>(std::lround((kOccupied - cell) * 255.0 / kOccupied));
}

}  // namespace

double darkness(std::uint8_t grey, bool negate) {
  const double lightness = grey / 255.0;
  return negate ? lightness : 1.0 - lightness;
}

std::vector<Occupancy> cells_from_image(const Image& image, const MapPixels& pixels) {
  const Image grey = to_grey(image);
  std::array<Occupancy, 256> cell_by_grey{};
  for (std::size_t v = 0; v < cell_by_grey.size(); ++v) cell_by_grey[v] = cell_of(static_cast<std::uint8_t>(v), pixels);

  const auto step = static_cast<std::size_t>(grey.channels);
  const bool masked = grey.has_alpha() && pixels.mode == MapMode::Scale;
  std::vector<Occupancy> cells;
  cells.reserve(grey.pixels.size() / step);
  for (int row = grey.height - 1; row >= 0; --row) {
    const std::uint8_t* pixel = grey.pixels.data() + static_cast<std::size_t>(row) * grey.row_bytes();
    for (int x = 0; x < grey.width; ++x, pixel += step) {
      cells.push_back(masked && pixel[1] < 255 ? kUnknown : cell_by_grey[pixel[0]]);
    }
  }
  return cells;
}

Image image_from_cells(GridView<const Occupancy> map, MapMode mode) {
  Image image{map.geometry.width, map.geometry.height, mode == MapMode::Scale ? 2 : 1, {}};
  image.pixels.reserve(image.row_bytes() * static_cast<std::size_t>(image.height));
  for (std::int32_t y = map.geometry.height - 1; y >= 0; --y) {
    for (std::int32_t x = 0; x < map.geometry.width; ++x) {
      const Occupancy cell = map[{x, y}];
      if (mode == MapMode::Trinary) {
        image.pixels.push_back(trinary_grey(cell));
      } else if (mode == MapMode::Raw) {
        image.pixels.push_back(raw_grey(cell));
      } else {
        const bool known = cell >= 0 && cell <= kOccupied;
        image.pixels.push_back(known ? scale_grey(cell) : 0);
        image.pixels.push_back(known ? 255 : 0);
      }
    }
  }
  return image;
}

}  // namespace scrubjay

/// \file
/// Pixels to cells and back, as nav2 has it.
#pragma once

#include <scrubjay/grid/grid_view.hpp>
#include <scrubjay/io/image.hpp>
#include <scrubjay/io/map_file.hpp>

namespace scrubjay {

/// How the pixels of a map's image are to be understood. Defaults: what nav2's map saver writes.
struct MapPixels {
  MapMode mode = MapMode::Trinary;
  bool negate = false;            ///< light is occupied
  double free_thresh = 0.196;     ///< p at or below is free; 205, the customary grey of unknown, is just above
  double occupied_thresh = 0.65;  ///< p at or above is occupied
};

/// How occupied a grey value looks, 0 to 1.
double darkness(std::uint8_t grey, bool negate);

/// The cells of an image, lowest row first.
std::vector<Occupancy> cells_from_image(const Image& image, const MapPixels& pixels);

/// The image of a map: grey, or grey and alpha for Scale.
Image image_from_cells(GridView<const Occupancy> map, MapMode mode);

}  // namespace scrubjay

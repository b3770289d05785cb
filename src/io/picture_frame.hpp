/// \file
/// What stands around the map in a picture: title above, scale bar and legend below.
#pragma once

#include <scrubjay/io/drawing.hpp>
#include <scrubjay/io/map_picture.hpp>
#include <string>

namespace scrubjay {

/// Where things go on the page [pixels].
struct PageLayout {
  int width = 0;
  int height = 0;
  int map_left = 0;
  int map_top = 0;
  int map_width = 0;
  int map_height = 0;
  int title_scale = 3;
  int footer_top = 0;
};

/// A page for a map of this many pixels.
PageLayout lay_out_page(const MapPicture& picture, int map_width, int map_height, double pixels_per_metre);

/// Title and `size` [m], scale bar, and a legend of what the picture has.
void draw_frame(Canvas& canvas, const MapPicture& picture, const PageLayout& page, double pixels_per_metre,
                const Point2& size);

}  // namespace scrubjay

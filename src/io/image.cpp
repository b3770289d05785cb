#include <fmt/format.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/image.hpp>

#include "file_content.hpp"
#include "image_formats.hpp"

namespace scrubjay {

void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& name) {
  if (width == 0 || height == 0 || width > kMaxImagePixels || height > kMaxImagePixels / width) {
    throw Error(fmt::format("{}: image of {} x {} pixels; want at least one and at most {} in all", name, width, height,
                            kMaxImagePixels));
  }
}

Image decode_image(std::span<const std::uint8_t> file, const std::string& name) {
  if (is_pgm(file)) return decode_pgm(file, name);
  if (is_png(file)) return decode_png(file, name);
  throw Error(fmt::format("{}: neither a PGM nor a PNG image", name));
}

Image read_image(const std::filesystem::path& path) {
  return decode_image(read_file(path), path.string());
}

Image to_grey(const Image& image) {
  if (image.channels <= 2) return image;
  Image grey{image.width, image.height, image.has_alpha() ? 2 : 1, {}};
  const auto step = static_cast<std::size_t>(image.channels);
  grey.pixels.reserve(image.pixels.size() / step * static_cast<std::size_t>(grey.channels));
  for (std::size_t i = 0; i + step <= image.pixels.size(); i += step) {
    const std::uint8_t* pixel = &image.pixels[i];
    const int luma = (299 * pixel[0] + 587 * pixel[1] + 114 * pixel[2] + 500) / 1000;
    grey.pixels.push_back(static_cast<std::uint8_t>(luma));
    if (image.has_alpha()) grey.pixels.push_back(pixel[3]);
  }
  return grey;
}

}  // namespace scrubjay

/// \file
/// Any bytes are an image of a size that fits, or refused with an Error.
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/image.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    const Image image = decode_image({data, size}, "fuzz");
    if (image.width <= 0 || image.height <= 0 || image.channels < 1 || image.channels > 4) std::abort();
    if (image.pixels.size() != image.row_bytes() * static_cast<std::size_t>(image.height)) std::abort();
    const Image grey = to_grey(image);
    if (grey.channels == 1 && grey.pixels.size() < 10000 && decode_image(encode_pgm(grey), "again") != grey)
      std::abort();
  } catch (const Error&) {
  }
  return 0;
}

/// \file
/// The decoders behind decode_image, one a format.
#pragma once

#include <scrubjay/io/image.hpp>

namespace scrubjay {

bool is_pgm(std::span<const std::uint8_t> file);
Image decode_pgm(std::span<const std::uint8_t> file, const std::string& name);

bool is_png(std::span<const std::uint8_t> file);
Image decode_png(std::span<const std::uint8_t> file, const std::string& name);

/// Throws Error unless both sides are positive and the image has at most kMaxImagePixels.
void check_image_size(std::uint64_t width, std::uint64_t height, const std::string& name);

}  // namespace scrubjay

/// \file
/// Pictures in memory, and their files: PGM and PNG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace scrubjay {

/// Pixels of 8 bits a channel, row by row from the top left one.
struct Image {
  int width = 0;     ///< [pixels]
  int height = 0;    ///< [pixels]
  int channels = 1;  ///< 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha (not premultiplied)
  std::vector<std::uint8_t> pixels;

  std::size_t row_bytes() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels); }
  bool has_alpha() const { return channels == 2 || channels == 4; }
  bool operator==(const Image&) const = default;
};

/// Images of more pixels are refused, so that a few forged bytes can't claim all memory.
inline constexpr std::size_t kMaxImagePixels = std::size_t{1} << 26;

/// Reads a PGM (plain or binary, 8 or 16 bits) or a PNG (any kind), told apart by their first bytes, whatever the name.
///
/// 16 bits become 8 by rounding; palettes and bit depths below 8 are expanded; transparent palette entries and colours
/// become alpha. Grey values are taken as they are: gamma and colour profiles are ignored.
/// Throws Error with the file's name and what is wrong.
Image read_image(const std::filesystem::path& path);
/// The same from memory; `name` stands in the errors.
Image decode_image(std::span<const std::uint8_t> file, const std::string& name);

/// Grey by luma (ITU-R BT.601: 0.299 R + 0.587 G + 0.114 B); equal channels stay exactly what they are. Alpha is kept.
Image to_grey(const Image& image);

/// The file's bytes: the same for the same image, always. PGM (binary) takes grey images without alpha only.
std::vector<std::uint8_t> encode_pgm(const Image& image);
std::vector<std::uint8_t> encode_png(const Image& image);

}  // namespace scrubjay

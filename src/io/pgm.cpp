#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <scrubjay/error.hpp>
#include <string_view>

#include "image_formats.hpp"

namespace scrubjay {
namespace {

bool is_space(std::uint8_t c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}
bool is_digit(std::uint8_t c) {
  return c >= '0' && c <= '9';
}

/// Reads the numbers of a PGM, stepping over blanks and comments (from # to the end of the line).
class PgmReader {
 public:
  PgmReader(std::span<const std::uint8_t> file, const std::string& name) : rest_(file.subspan(2)), name_(name) {}

  /// The next number, at most `max`; it must stand apart from what is before it.
  std::uint32_t number(std::string_view what, std::uint32_t max) {
    if (!skip_blanks()) fail(fmt::format("{} does not stand apart from what is before it", what));
    if (rest_.empty()) fail(fmt::format("ends before {}", what));
    if (!is_digit(rest_.front())) fail(fmt::format("{} is not a number", what));
    std::uint64_t value = 0;
    while (!rest_.empty() && is_digit(rest_.front())) {
      value = value * 10 + static_cast<std::uint64_t>(rest_.front() - '0');
      if (value > max) fail(fmt::format("{} is over {}", what, max));
      rest_ = rest_.subspan(1);
    }
    return static_cast<std::uint32_t>(value);
  }

  /// The pixels of a binary PGM, after the one blank that ends its header.
  std::span<const std::uint8_t> bytes(std::size_t count) {
    if (rest_.empty() || !is_space(rest_.front())) fail("no blank after the header");
    if (rest_.size() - 1 < count) fail(fmt::format("has {} bytes of pixels, wants {}", rest_.size() - 1, count));
    return rest_.subspan(1, count);
  }

  std::size_t remaining() const { return rest_.size(); }
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}: broken PGM: {}", name_, what)); }

 private:
  bool skip_blanks() {
    const std::size_t before = rest_.size();
    while (!rest_.empty() && (is_space(rest_.front()) || rest_.front() == '#')) {
      const bool comment = rest_.front() == '#';
      const auto end = comment ? std::find(rest_.begin(), rest_.end(), '\n') : rest_.begin() + 1;
      rest_ = rest_.subspan(static_cast<std::size_t>(end - rest_.begin()));
    }
    return rest_.size() < before;
  }

  std::span<const std::uint8_t> rest_;
  const std::string& name_;
};

std::uint8_t to_8_bits(std::uint32_t value, std::uint32_t max) {
  return static_cast<std::uint8_t>((value * 255 + max / 2) / max);
}

void read_plain(PgmReader& reader, std::uint32_t max, Image& image, std::size_t count) {
  // Each pixel takes a blank and a digit: checked before the memory is claimed.
  if (reader.remaining() / 2 < count) reader.fail(fmt::format("too short for {} pixels", count));
  image.pixels.reserve(count);
  for (std::size_t i = 0; i < count; ++i) image.pixels.push_back(to_8_bits(reader.number("pixel", max), max));
}

void read_binary(PgmReader& reader, std::uint32_t max, Image& image, std::size_t count) {
  const std::size_t width = max > 255 ? 2 : 1;
  const std::span<const std::uint8_t> bytes = reader.bytes(count * width);
  image.pixels.reserve(count);
  for (std::size_t i = 0; i < bytes.size(); i += width) {
    const std::uint32_t value = width == 1 ? bytes[i] : static_cast<std::uint32_t>(bytes[i] << 8 | bytes[i + 1]);
    if (value > max) reader.fail(fmt::format("pixel {} is {}, over the maximum of {}", i / width, value, max));
    image.pixels.push_back(to_8_bits(value, max));
  }
}

}  // namespace

bool is_pgm(std::span<const std::uint8_t> file) {
  return file.size() >= 2 && file[0] == 'P' && (file[1] == '2' || file[1] == '5');
}

Image decode_pgm(std::span<const std::uint8_t> file, const std::string& name) {
  PgmReader reader(file, name);
  const std::uint32_t width = reader.number("width", kMaxImagePixels);
  const std::uint32_t height = reader.number("height", kMaxImagePixels);
  const std::uint32_t max = reader.number("maximum", 65535);
  check_image_size(width, height, name);
  if (max == 0) reader.fail("maximum is 0");

  Image image{static_cast<int>(width), static_cast<int>(height), 1, {}};
  const std::size_t count = std::size_t{width} * height;
  if (file[1] == '2') {
    read_plain(reader, max, image, count);
  } else {
    read_binary(reader, max, image, count);
  }
  return image;
}

std::vector<std::uint8_t> encode_pgm(const Image& image) {
  assert(image.channels == 1);
  const std::string header = fmt::format("P5\n{} {}\n255\n", image.width, image.height);
  std::vector<std::uint8_t> file(header.begin(), header.end());
  file.insert(file.end(), image.pixels.begin(), image.pixels.end());
  return file;
}

}  // namespace scrubjay

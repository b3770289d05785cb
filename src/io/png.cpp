#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <csetjmp>
#include <cstring>
#include <scrubjay/error.hpp>

#include "image_formats.hpp"

// libpng leaves its functions by longjmp on errors. So every object with a destructor lives in the caller of the
// functions that set the jump, and those hold plain values alone.

namespace scrubjay {
namespace {

using Message = std::array<char, 128>;

void keep_message(png_structp png, png_const_charp text) {
  auto& message = *static_cast<Message*>(png_get_error_ptr(png));
  std::strncpy(message.data(), text, message.size() - 1);
  std::longjmp(png_jmpbuf(png), 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void read_bytes(png_structp png, png_bytep out, std::size_t count) {
  auto& rest = *static_cast<std::span<const std::uint8_t>*>(png_get_io_ptr(png));
  if (rest.size() < count) png_error(png, "ends too early");
  std::copy_n(rest.begin(), count, out);
  rest = rest.subspan(count);
}

void write_bytes(png_structp png, png_bytep bytes, std::size_t count) {
  auto& out = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  out.insert(out.end(), bytes, bytes + count);
}

void flush_nothing(png_structp) {}

struct ReadStruct {
  png_structp png;
  png_infop info = nullptr;

  explicit ReadStruct(Message& message)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning)) {
    if (png != nullptr) info = png_create_info_struct(png);
  }
  ReadStruct(const ReadStruct&) = delete;
  ReadStruct& operator=(const ReadStruct&) = delete;
  ~ReadStruct() { png_destroy_read_struct(&png, &info, nullptr); }
};

struct WriteStruct {
  png_structp png;
  png_infop info = nullptr;

  explicit WriteStruct(Message& message)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning)) {
    if (png != nullptr) info = png_create_info_struct(png);
  }
  WriteStruct(const WriteStruct&) = delete;
  WriteStruct& operator=(const WriteStruct&) = delete;
  ~WriteStruct() { png_destroy_write_struct(&png, &info); }
};

/// Reads up to the pixels and asks for 8 bits a channel, expanded; false on an error.
bool read_header(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // check_image_size is the one limit
  png_read_info(png, info);
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

int color_type(int channels) {
  constexpr std::array<int, 4> kTypes{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                      PNG_COLOR_TYPE_RGB_ALPHA};
  return kTypes[static_cast<std::size_t>(channels - 1)];
}

bool write_image(png_structp png, png_infop info, const Image& image, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  // Said, not left to the library's defaults: the same image must give the same bytes.
  png_set_compression_level(png, 6);
  png_set_compression_strategy(png, 0);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               color_type(image.channels), PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, info);
  return true;
}

std::vector<png_bytep> row_pointers(std::uint8_t* pixels, std::size_t row_bytes, int height) {
  std::vector<png_bytep> rows(static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels + y * row_bytes;
  return rows;
}

}  // namespace

bool is_png(std::span<const std::uint8_t> file) {
  return file.size() >= 8 && png_sig_cmp(file.data(), 0, 8) == 0;
}

Image decode_png(std::span<const std::uint8_t> file, const std::string& name) {
  Message message{};
  ReadStruct reader(message);
  const auto fail = [&] { throw Error(fmt::format("{}: broken PNG: {}", name, message.data())); };
  if (reader.info == nullptr) throw Error(fmt::format("{}: not enough memory", name), Error::Kind::Failure);
  png_set_read_fn(reader.png, &file, read_bytes);
  if (!read_header(reader.png, reader.info)) fail();

  const png_uint_32 width = png_get_image_width(reader.png, reader.info);
  const png_uint_32 height = png_get_image_height(reader.png, reader.info);
  check_image_size(width, height, name);
  Image image{static_cast<int>(width), static_cast<int>(height), png_get_channels(reader.png, reader.info), {}};
  image.pixels.resize(image.row_bytes() * height);
  std::vector<png_bytep> rows = row_pointers(image.pixels.data(), image.row_bytes(), image.height);
  if (!read_rows(reader.png, rows.data())) fail();
  return image;
}

std::vector<std::uint8_t> encode_png(const Image& image) {
  assert(image.channels >= 1 && image.channels <= 4);
  Message message{};
  WriteStruct writer(message);
  if (writer.info == nullptr) throw Error("not enough memory to write a PNG", Error::Kind::Failure);
  std::vector<std::uint8_t> file;
  png_set_write_fn(writer.png, &file, write_bytes, flush_nothing);
  // libpng's rows aren't const, but writing doesn't change them.
  std::vector<png_bytep> rows =
      row_pointers(const_cast<std::uint8_t*>(image.pixels.data()), image.row_bytes(), image.height);
  if (!write_image(writer.png, writer.info, image, rows.data())) {
    throw Error(fmt::format("cannot encode a PNG of {} x {} pixels: {}", image.width, image.height, message.data()),
                Error::Kind::Failure);
  }
  return file;
}

}  // namespace scrubjay

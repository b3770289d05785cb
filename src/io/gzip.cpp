#include "gzip.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>

#include "file_content.hpp"

namespace scrubjay {
namespace {

constexpr std::array<std::uint8_t, 2> kMagic{0x1f, 0x8b};

/// zlib's state for gzip members.
class Inflater {
 public:
  Inflater() {
    constexpr int kGzipOnly = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw Error("zlib: out of memory", Error::Kind::Failure);
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  z_stream& stream() { return stream_; }

 private:
  z_stream stream_{};
};

[[noreturn]] void fail_too_long(const std::string& name) {
  throw Error(fmt::format("{}: more than {} MiB of text; want less", name, kLongestText >> 20));
}

}  // namespace

std::string unpacked(std::span<const std::uint8_t> file, const std::string& name) {
  if (file.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), file.begin())) {
    if (file.size() > kLongestText) fail_too_long(name);
    return {file.begin(), file.end()};
  }
  std::string text;
  Inflater inflater;
  z_stream& stream = inflater.stream();
  std::array<std::uint8_t, 1 << 16> piece{};
  while (true) {
    // zlib counts in 32 bits, and its input isn't const for old compilers' sake.
    const std::size_t given = std::min<std::size_t>(file.size(), 1u << 30);
    stream.next_in = const_cast<std::uint8_t*>(file.data());
    stream.avail_in = static_cast<uInt>(given);
    stream.next_out = piece.data();
    stream.avail_out = static_cast<uInt>(piece.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    const std::size_t got = piece.size() - stream.avail_out;
    file = file.subspan(given - stream.avail_in);
    text.append(piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
    if (text.size() > kLongestText) fail_too_long(name);
    if (status == Z_STREAM_END) {
      if (file.empty()) return text;
      inflateReset(&stream);
    } else if (status != Z_OK && status != Z_BUF_ERROR) {
      throw Error(fmt::format("{}: damaged: {}; want a whole gzip file", name,
                              stream.msg != nullptr ? stream.msg : "not what gzip packs"));
    } else if (file.empty() && stream.avail_out != 0) {
      throw Error(fmt::format("{}: cut: the end of what gzip packed is missing; want the whole file", name));
    }
  }
}

std::string read_text(const std::filesystem::path& path) {
  return unpacked(read_file(path), path.string());
}

}  // namespace scrubjay

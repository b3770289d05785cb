#include "file_content.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <scrubjay/error.hpp>

namespace scrubjay {

std::vector<std::uint8_t> read_file(const std::filesystem::path& path) {
  const auto fail = [&](int error) {
    throw Error(fmt::format("{}: cannot read: {}", path.string(), std::strerror(error)));
  };
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Closer> file(std::fopen(path.c_str(), "rbe"));
  if (!file) fail(errno);

  // Read in pieces instead of asking for the size: pipes have none, and a growing file may have another by now.
  std::vector<std::uint8_t> content;
  constexpr std::size_t kPiece = 1 << 16;
  while (true) {
    const std::size_t before = content.size();
    content.resize(before + kPiece);
    const std::size_t count = std::fread(content.data() + before, 1, kPiece, file.get());
    content.resize(before + count);
    if (count == kPiece) continue;
    if (std::ferror(file.get()) != 0) fail(errno);
    return content;
  }
}

}  // namespace scrubjay

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag.hpp>
#include <scrubjay/io/mcap.hpp>
#include <scrubjay/io/rosbag2.hpp>
#include <string_view>

namespace scrubjay {
namespace {

constexpr std::string_view kMcapMagic("\x89MCAP", 5);
constexpr std::string_view kSqliteMagic("SQLite format 3\0", 16);

}  // namespace

std::unique_ptr<BagReader> open_bag(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return std::make_unique<Rosbag2Reader>(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(fmt::format("{}: cannot read: {}", path.string(), std::strerror(errno)));
  std::array<char, kSqliteMagic.size()> begin{};
  file.read(begin.data(), begin.size());
  const std::string_view head(begin.data(), static_cast<std::size_t>(file.gcount()));
  if (head.starts_with(kMcapMagic)) return std::make_unique<McapReader>(path);
  if (head == kSqliteMagic) return std::make_unique<Rosbag2Reader>(path);
  throw Error(fmt::format("{}: is no bag; want MCAP, a folder of rosbag2, or a .db3 out of one", path.string()));
}

std::unique_ptr<BagWriter> make_bag_writer(const std::filesystem::path& path, bool zstd) {
  if (path.extension() == ".mcap") return std::make_unique<McapWriter>(path, McapOptions{.zstd = zstd});
  if (zstd) throw Error(fmt::format("{}: a database can't be packed; want a name that ends in .mcap", path.string()));
  return std::make_unique<Rosbag2Writer>(path);
}

}  // namespace scrubjay

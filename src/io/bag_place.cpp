#include "bag_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>
#include <string>
#include <string_view>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& folder, const std::error_code& error) {
  throw Error(fmt::format("{}: cannot make the bag's folder: {}", folder.string(), error.message()),
              Error::Kind::Failure);
}

/// Files of rosbag2, and what a killed run may have left of them.
bool belongs_to_bag(const fs::directory_entry& entry) {
  if (!entry.is_regular_file()) return false;
  const std::string name = entry.path().filename().string();
  constexpr std::array<std::string_view, 7> kEnds{".db3",  ".db3-wal",  ".db3-shm",  ".db3-journal",
                                                  ".mcap", ".db3.zstd", ".mcap.zstd"};
  return name == "metadata.yaml" || (name.starts_with(".scrubjay-") && name.ends_with(".tmp")) ||
         std::any_of(kEnds.begin(), kEnds.end(), [&name](std::string_view end) { return name.ends_with(end); });
}

/// Refuses a folder that holds more than a bag.
void check_bag(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw Error(fmt::format("{}: is a file; want the name of a new folder, or of a bag", folder.string()));
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (belongs_to_bag(entry)) continue;
    throw Error(fmt::format("{}: holds {}, which is no part of a bag; want the name of a new folder, or of a bag",
                            folder.string(), entry.path().filename().string()));
  }
}

bool is_complete(const fs::path& folder) {
  if (!fs::exists(folder / "metadata.yaml")) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (has_sqlite_log(entry.path())) return false;
  }
  return true;
}

/// Without links, and without a `/` at its end.
fs::path plain(const fs::path& folder) {
  const fs::path path = fs::weakly_canonical(fs::absolute(folder));
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

BagPlace::BagPlace(const fs::path& folder) {
  try {
    folder_ = plain(folder);
    if (fs::exists(folder_)) move_aside();
    fs::create_directories(folder_);
  } catch (const fs::filesystem_error& error) {
    const std::error_code code = error.code();
    give_up();
    fail(folder, code);
  }
}

void BagPlace::move_aside() {
  check_bag(folder_);
  if (fs::is_empty(folder_)) return;
  fs::path aside = folder_;
  aside += "~";
  const bool second = fs::exists(aside);
  if (second) check_bag(aside);
  older_ = aside;
  if (second && is_complete(aside) && !is_complete(folder_)) {
    fs::remove_all(folder_);
  } else {
    fs::remove_all(aside);
    fs::rename(folder_, aside);
  }
}

void BagPlace::keep() {
  std::error_code ignored;
  if (older_) fs::remove_all(*older_, ignored);
  older_.reset();
}

void BagPlace::give_up() {
  std::error_code ignored;
  if (!older_ || !fs::exists(*older_, ignored)) return;
  clear();
  fs::rename(*older_, folder_, ignored);
  older_.reset();
}

void BagPlace::clear() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

bool has_sqlite_log(const fs::path& file) {
  for (const std::string_view end : {"-wal", "-journal"}) {
    fs::path log = file;
    log += end;
    std::error_code error;
    const std::uintmax_t size = fs::file_size(log, error);
    if (!error && size > 0) return true;
  }
  return false;
}

}  // namespace scrubjay

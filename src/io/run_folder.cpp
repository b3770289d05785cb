#include <fmt/format.h>
#include <unistd.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/run_folder.hpp>
#include <utility>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

/// It and those above it that aren't there, the lowest first.
std::vector<fs::path> missing_of(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  fs::path path = fs::absolute(folder, ignored).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  for (; path.has_relative_path() && !fs::exists(path, ignored); path = path.parent_path()) missing.push_back(path);
  return missing;
}

}  // namespace

RunFolder::RunFolder(fs::path folder, std::vector<fs::path> missing)
    : path_(std::move(folder)), made_(std::move(missing)) {}

// By another constructor, so that what was made goes, too, where it throws.
RunFolder::RunFolder(const fs::path& folder) : RunFolder(folder, missing_of(folder)) {
  std::error_code error;
  fs::create_directories(path_, error);
  if (error) {
    throw Error(fmt::format("{}: can't make this folder: {}", path_.string(), error.message()), Error::Kind::Failure);
  }
  if (::access(path_.c_str(), W_OK | X_OK) != 0) {
    throw Error(fmt::format("{}: can't write to this folder; want one of yours", path_.string()), Error::Kind::Failure);
  }
}

RunFolder::~RunFolder() {
  for (const fs::path& folder : made_) ::rmdir(folder.c_str());  // which fails if there is anything in it
}

}  // namespace scrubjay

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <set>
#include <utility>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, std::string_view what, int error) {
  throw Error(fmt::format("{}: {}: {}", path.string(), what, std::strerror(error)), Error::Kind::Failure);
}

/// Makes the renames in a folder survive a power cut.
void sync_folder(const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) return;  // A folder that may be written but not read: the file is in place, and more can't be done.
  const int synced = ::fsync(file);
  const int error = errno;
  ::close(file);
  // Some network file systems can't sync folders, and say so with EINVAL.
  if (synced != 0 && error != EINVAL && error != ENOTSUP) fail(target, "cannot sync its folder", error);
}

}  // namespace

/// A file under a temporary name; removed unless it was renamed.
class AtomicFiles::TemporaryFile {
 public:
  TemporaryFile(const fs::path& target, mode_t permissions) : target_(target), path_(fresh_name(target)) {
    // The permissions given here are those of any new file: narrowed by the user's umask.
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
    if (file_ < 0) fail(target_, "cannot write into its folder", errno);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (file_ >= 0) ::close(file_);
    if (!path_.empty()) ::unlink(path_.c_str());
  }

  void write(std::span<const std::byte> content) {
    while (!content.empty()) {
      const ssize_t written = ::write(file_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail(target_, "cannot write", errno);
      content = content.subspan(static_cast<std::size_t>(written));
    }
  }

  void set_permissions(mode_t permissions) {
    if (::fchmod(file_, permissions) != 0) fail(target_, "cannot keep its permissions", errno);
  }

  /// Only now is it sure that there was room for all of it.
  void finish() {
    if (::fsync(file_) != 0) fail(target_, "cannot write", errno);
    const int closed = ::close(file_);
    file_ = -1;
    if (closed != 0) fail(target_, "cannot write", errno);
  }

  void rename_to_target() {
    if (::rename(path_.c_str(), target_.c_str()) != 0) fail(target_, "cannot replace", errno);
    path_.clear();
  }

  const fs::path& target() const { return target_; }

 private:
  static fs::path fresh_name(const fs::path& target) {
    static std::atomic<unsigned> count{0};
    return target.parent_path() / fmt::format(".scrubjay-{}-{}.tmp", ::getpid(), count++);
  }

  fs::path target_;
  fs::path path_;
  int file_ = -1;
};

AtomicFiles::AtomicFiles() = default;
AtomicFiles::~AtomicFiles() = default;

void AtomicFiles::add(const fs::path& path, std::span<const std::byte> content) {
  std::error_code ignored;
  const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
  struct stat old {};
  const bool replaces = ::stat(target.c_str(), &old) == 0;
  if (target.empty() || (replaces && !S_ISREG(old.st_mode))) {
    throw Error(fmt::format("{}: not a regular file", path.string()), Error::Kind::Failure);
  }

  auto file = std::make_unique<TemporaryFile>(target, 0666);
  if (replaces) file->set_permissions(old.st_mode & 07777);
  file->write(content);
  file->finish();
  files_.push_back(std::move(file));
}

void AtomicFiles::add(const fs::path& path, std::string_view content) {
  add(path, std::as_bytes(std::span(content)));
}

void AtomicFiles::commit() {
  const auto files = std::exchange(files_, {});
  for (const auto& file : files) file->rename_to_target();
  std::set<fs::path> synced;
  for (const auto& file : files) {
    if (synced.insert(file->target().parent_path()).second) sync_folder(file->target());
  }
}

void write_file_atomically(const fs::path& path, std::span<const std::byte> content) {
  AtomicFiles file;
  file.add(path, content);
  file.commit();
}

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, std::as_bytes(std::span(content)));
}

}  // namespace scrubjay

#include "growing_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <scrubjay/error.hpp>
#include <utility>

namespace scrubjay {
namespace {

Error write_error(const std::string& name, const GrowingFile::Kind& kind, int error) {
  return Error(fmt::format("{}: cannot write {}: {}", name, kind.name, std::strerror(error)), Error::Kind::Failure);
}

bool is_regular(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error));
}

/// Renames a file that is there, and gives its new name; none if there is no such file to keep.
std::optional<std::filesystem::path> move_aside(const std::filesystem::path& path, const GrowingFile::Kind& kind) {
  if (!is_regular(path)) return std::nullopt;
  std::filesystem::path aside = path;
  aside += "~";
  if (is_regular(aside) && kind.is_whole(aside) && !kind.is_whole(path)) return aside;
  if (::rename(path.c_str(), aside.c_str()) != 0) throw write_error(path.string(), kind, errno);
  return aside;
}

}  // namespace

GrowingFile::GrowingFile(const std::filesystem::path& path, const Kind& kind, std::span<const std::byte> head,
                         std::span<const std::byte> end)
    : name_(path.string()), kind_(kind), older_(move_aside(path, kind)) {
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) {
    const int error = errno;
    put_back();
    throw write_error(name_, kind_, error);
  }
  const bool seekable = ::lseek(file_, 0, SEEK_CUR) >= 0;
  if (seekable) end_.assign(end.begin(), end.end());
  append(head);
  if (failed_) {
    ::close(file_);
    if (std::filesystem::is_regular_file(path)) ::unlink(path.c_str());  // a part of the head is of no use
    put_back();
    throw write_error(name_, kind_, failure_);
  }
}

GrowingFile::~GrowingFile() {
  if (file_ >= 0) ::close(file_);
}

void GrowingFile::put_back() {
  if (older_) ::rename(older_->c_str(), name_.c_str());
  older_.reset();
}

bool GrowingFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

void GrowingFile::append(std::span<const std::byte> bytes) {
  if (end_.empty()) return hand_over(bytes, bytes.size());
  // In one go: a kill between two would leave a file without an end.
  with_end_.assign(bytes.begin(), bytes.end());
  with_end_.insert(with_end_.end(), end_.begin(), end_.end());
  hand_over(with_end_, bytes.size());
}

/// Writes `bytes` over the end, and counts those that stay.
void GrowingFile::hand_over(std::span<const std::byte> bytes, std::size_t staying) {
  if (!writable()) return;
  const bool in_place = end_.empty() || ::lseek(file_, static_cast<off_t>(size_), SEEK_SET) >= 0;
  if (in_place && write(bytes)) {
    size_ += staying;
    return;
  }
  failed_ = true;
  failure_ = errno;
  if (!end_.empty()) cut_back();
}

/// Takes away what was written in part, so that the file ends as it did before. Where that fails too, readers find the
/// part, and stop there.
void GrowingFile::cut_back() {
  if (::ftruncate(file_, static_cast<off_t>(size_)) != 0) return;
  if (::lseek(file_, static_cast<off_t>(size_), SEEK_SET) >= 0) write(end_);
}

void GrowingFile::complete(std::span<const std::byte> last) {
  if (file_ < 0) return;
  hand_over(last, last.size());
  // What can't be synced (a pipe) needn't be: EINVAL says so.
  const bool synced = failed_ || ::fsync(file_) == 0 || errno == EINVAL;
  const int sync_error = errno;
  const bool closed = ::close(std::exchange(file_, -1)) == 0;
  if (!failed_ && !(synced && closed)) {
    failed_ = true;
    failure_ = synced ? errno : sync_error;
  }
  if (failed_) put_back();
  if (older_) ::unlink(older_->c_str());
  older_.reset();
}

void GrowingFile::throw_failure() {
  if (failure_ != 0) throw write_error(name_, kind_, std::exchange(failure_, 0));
}

}  // namespace scrubjay

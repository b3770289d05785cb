#include "mcap_source.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <scrubjay/error.hpp>
#include <utility>

#include "file_content.hpp"

namespace scrubjay::mcap {
namespace {

class File : public Source {
 public:
  File(int file, std::uint64_t size, std::string name) : file_(file), size_(size), name_(std::move(name)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() override { ::close(file_); }

  std::uint64_t size() const override { return size_; }

  bool read(std::uint64_t position, std::span<std::byte> out) const override {
    while (!out.empty()) {
      const ssize_t count = ::pread(file_, out.data(), out.size(), static_cast<off_t>(position));
      if (count == 0) return false;
      if (count > 0) {
        out = out.subspan(static_cast<std::size_t>(count));
        position += static_cast<std::uint64_t>(count);
      } else if (errno != EINTR) {
        throw Error(fmt::format("{}: cannot read: {}", name_, std::strerror(errno)));
      }
    }
    return true;
  }

 private:
  int file_;
  std::uint64_t size_;
  std::string name_;
};

class Memory : public Source {
 public:
  explicit Memory(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}

  std::uint64_t size() const override { return bytes_.size(); }

  bool read(std::uint64_t position, std::span<std::byte> out) const override {
    const auto from = std::as_bytes(std::span(bytes_)).subspan(position, out.size());
    std::copy(from.begin(), from.end(), out.begin());
    return true;
  }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::unique_ptr<Source> open_source(const std::filesystem::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode)) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file >= 0) return std::make_unique<File>(file, static_cast<std::uint64_t>(status.st_size), path.string());
  }
  return memory_source(read_file(path));
}

std::unique_ptr<Source> memory_source(std::vector<std::uint8_t> bytes) {
  return std::make_unique<Memory>(std::move(bytes));
}

std::span<const std::byte> Cursor::peek(std::size_t count) {
  if (left() < count) return {};
  const bool is_ahead = position_ >= ahead_at_ && position_ + count <= ahead_at_ + ahead_.size();
  if (!is_ahead) {
    ahead_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kAhead, left())));
    ahead_at_ = position_;
    if (!source_.read(position_, ahead_)) {
      ahead_.clear();
      return {};
    }
  }
  return std::span<const std::byte>(ahead_).subspan(static_cast<std::size_t>(position_ - ahead_at_), count);
}

}  // namespace scrubjay::mcap

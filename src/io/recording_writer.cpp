#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recording.hpp>
#include <utility>

#include "recording_format.hpp"

namespace scrubjay {
namespace {

constexpr std::size_t kBufferSize = 1 << 16;
constexpr std::int64_t kBufferTime = 1'000'000'000;  // [ns]

Error write_error(const std::string& name, int error) {
  return Error(fmt::format("{}: cannot write the recording: {}", name, std::strerror(error)), Error::Kind::Failure);
}

bool is_regular(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error));
}

bool is_whole_recording(const std::filesystem::path& path) {
  try {
    RecordingReader reader(path);
    while (reader.next()) {
    }
    return !reader.cut();
  } catch (const Error&) {
    return false;
  }
}

/// Renames a file that is there, and gives its new name; none if there is no such file to keep. A whole recording that
/// an earlier run has put aside, and that was killed before its own one was whole, stays where it is instead.
std::optional<std::filesystem::path> move_aside(const std::filesystem::path& path) {
  if (!is_regular(path)) return std::nullopt;
  std::filesystem::path aside = path;
  aside += "~";
  if (is_regular(aside) && is_whole_recording(aside) && !is_whole_recording(path)) return aside;
  if (::rename(path.c_str(), aside.c_str()) != 0) throw write_error(path.string(), errno);
  return aside;
}

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const std::string& scenario)
    : name_(path.string()), older_(move_aside(path)) {
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) {
    const int error = errno;
    give_up();
    throw write_error(name_, error);
  }
  buffer_.reserve(kBufferSize + 1024);
  buffer_.assign(recording::kFileHead.begin(), recording::kFileHead.end());
  checksum_ = recording::checksum(0, buffer_);
  append(recording::kScenario, 0, {reinterpret_cast<const std::uint8_t*>(scenario.data()), scenario.size()});
  hand_over();
  if (failed_) {
    ::close(file_);
    if (std::filesystem::is_regular_file(path)) ::unlink(path.c_str());  // a part of the head is no recording
    give_up();
    throw write_error(name_, failure_);
  }
}

/// Puts the older file back.
void RecordingWriter::give_up() {
  if (older_) ::rename(older_->c_str(), name_.c_str());
  older_.reset();
}

RecordingWriter::~RecordingWriter() {
  try {
    close();
  } catch (const Error&) {
    // Whoever wants to know calls close().
  }
}

void RecordingWriter::record(Direction direction, double stamp, std::span<const std::uint8_t> bytes) {
  if (failed_ || file_ < 0 || bytes.empty()) return;
  const std::int64_t now = stamp_to_nanoseconds(stamp);
  if (direction == Direction::Sent) {
    append(recording::kSent, now, bytes);
  } else if (bytes.size() > ChunkHistory::kMaxLength) {
    append(recording::kReceived, now, bytes);
  } else {
    const std::span<std::uint8_t> last = history_->of_length(bytes.size());
    recording::DeltaBuffer delta;
    const std::size_t size = recording::make_delta(bytes, last, delta);
    if (size > 0) {
      append(recording::kReceivedDelta, now, std::span(delta).first(size));
    } else {
      append(recording::kReceived, now, bytes);
    }
    std::copy(bytes.begin(), bytes.end(), last.begin());
  }
  const bool late = now - handed_over_at_ >= kBufferTime || now < handed_over_at_;
  if (buffer_.size() < kBufferSize && !late) return;
  handed_over_at_ = now;
  hand_over();
}

void RecordingWriter::record_end(const RecordedEnd& end) {
  if (failed_ || file_ < 0) return;
  std::vector<std::uint8_t> payload(recording::kMaxVarintSize);
  payload.resize(recording::put_varint(payload.data(), end.frames));
  payload.insert(payload.end(), end.why.begin(), end.why.end());
  append(recording::kMissionEnd, last_stamp_, payload);
}

void RecordingWriter::append(std::uint8_t kind, std::int64_t nanoseconds, std::span<const std::uint8_t> payload) {
  const std::size_t begin = buffer_.size();
  std::array<std::uint8_t, 1 + 2 * recording::kMaxVarintSize> head{kind};
  std::size_t size = 1;
  size += recording::put_varint(&head[size], recording::zigzag(nanoseconds - last_stamp_));
  size += recording::put_varint(&head[size], payload.size());
  buffer_.insert(buffer_.end(), head.begin(), head.begin() + static_cast<std::ptrdiff_t>(size));
  buffer_.insert(buffer_.end(), payload.begin(), payload.end());
  checksum_ = recording::checksum(checksum_, std::span(buffer_).subspan(begin));
  for (unsigned shift = 0; shift < 32; shift += 8) buffer_.push_back(static_cast<std::uint8_t>(checksum_ >> shift));
  last_stamp_ = nanoseconds;
}

void RecordingWriter::hand_over() {
  std::span<const std::uint8_t> rest = buffer_;
  while (!rest.empty() && !failed_) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written >= 0) {
      rest = rest.subspan(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      failed_ = true;
      failure_ = errno;
    }
  }
  buffer_.clear();
}

void RecordingWriter::throw_failure() {
  if (failure_ != 0) throw write_error(name_, std::exchange(failure_, 0));
}

void RecordingWriter::flush() {
  if (file_ >= 0) hand_over();
  throw_failure();
}

void RecordingWriter::close() {
  if (file_ >= 0) {
    append(recording::kEnd, last_stamp_, {});
    hand_over();
    // What can't be synced (a pipe) needn't be: EINVAL says so.
    const bool synced = failed_ || ::fsync(file_) == 0 || errno == EINVAL;
    const int sync_error = errno;
    const bool closed = ::close(std::exchange(file_, -1)) == 0;
    if (!failed_ && !(synced && closed)) {
      failed_ = true;
      failure_ = synced ? errno : sync_error;
    }
    if (failed_) give_up();
    if (older_) ::unlink(older_->c_str());
    older_.reset();
  }
  throw_failure();
}

}  // namespace scrubjay

#include <algorithm>
#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recording.hpp>

#include "growing_file.hpp"
#include "recording_format.hpp"

namespace scrubjay {
namespace {

constexpr std::size_t kBufferSize = 1 << 16;
constexpr std::int64_t kBufferTime = 1'000'000'000;  // [ns]

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

constexpr GrowingFile::Kind kRecording{"the recording", &is_whole_recording};

}  // namespace

RecordingWriter::RecordingWriter(const std::filesystem::path& path, const std::string& scenario) {
  buffer_.reserve(kBufferSize + 1024);
  buffer_.assign(recording::kFileHead.begin(), recording::kFileHead.end());
  checksum_ = recording::checksum(0, buffer_);
  append(recording::kScenario, 0, {reinterpret_cast<const std::uint8_t*>(scenario.data()), scenario.size()});
  file_ = std::make_unique<GrowingFile>(path, kRecording, std::as_bytes(std::span(buffer_)));
  buffer_.clear();
}

RecordingWriter::~RecordingWriter() {
  try {
    close();
  } catch (const Error&) {
    // Whoever wants to know calls close().
  }
}

void RecordingWriter::record(Direction direction, double stamp, std::span<const std::uint8_t> bytes) {
  if (!file_->writable() || bytes.empty()) return;
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
  file_->append(std::as_bytes(std::span(buffer_)));
  buffer_.clear();
}

void RecordingWriter::record_end(const RecordedEnd& end) {
  if (!file_->writable()) return;
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

void RecordingWriter::flush() {
  file_->append(std::as_bytes(std::span(buffer_)));
  buffer_.clear();
  file_->throw_failure();
}

void RecordingWriter::close() {
  if (file_->open()) {
    append(recording::kEnd, last_stamp_, {});
    file_->complete(std::as_bytes(std::span(buffer_)));
    buffer_.clear();
  }
  file_->throw_failure();
}

}  // namespace scrubjay

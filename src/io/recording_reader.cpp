#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recording.hpp>
#include <utility>

#include "file_content.hpp"
#include "recording_format.hpp"

namespace scrubjay {
namespace {

constexpr std::size_t kChecksumSize = 4;

std::uint32_t stored_checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < kChecksumSize; ++i) value |= std::uint32_t{bytes[i]} << (8 * i);
  return value;
}

/// `stamp + step`, if a stamp can hold it.
std::optional<std::int64_t> advance(std::int64_t stamp, std::int64_t step) {
  using Limits = std::numeric_limits<std::int64_t>;
  if (step > 0 ? stamp > Limits::max() - step : stamp < Limits::min() - step) return std::nullopt;
  return stamp + step;
}

}  // namespace

RecordingReader::RecordingReader(const std::filesystem::path& path) : RecordingReader(read_file(path), path.string()) {}

RecordingReader::RecordingReader(std::vector<std::uint8_t> file, const std::string& name) : file_(std::move(file)) {
  const std::size_t given = std::min(file_.size(), recording::kFileHead.size());
  const auto differs =
      std::mismatch(file_.begin(), file_.begin() + static_cast<std::ptrdiff_t>(given), recording::kFileHead.begin());
  const auto equal = static_cast<std::size_t>(differs.first - file_.begin());
  if (equal < std::min(given, recording::kMagicSize)) throw Error(fmt::format("{}: not a recording (.oilog)", name));
  if (equal < given) {
    throw Error(fmt::format("{}: recording of version {}; this program reads version {}", name,
                            file_[recording::kMagicSize], recording::kFileHead[recording::kMagicSize]));
  }
  if (given < recording::kFileHead.size()) {
    cut_ = true;
    position_ = file_.size();
    return;
  }
  checksum_ = recording::checksum(0, std::span(file_).first(given));
  position_ = given;
  const std::optional<Record> first = next_record();
  if (first && first->kind == recording::kScenario) {
    scenario_.assign(first->payload.begin(), first->payload.end());
  } else {
    cut_ = true;
  }
}

std::optional<RecordingReader::Record> RecordingReader::next_record() {
  if (cut_ || ended_) return std::nullopt;
  const auto whole = std::span<const std::uint8_t>(file_).subspan(position_);
  cut_ = true;  // until the record is seen to be whole
  if (whole.empty()) return std::nullopt;
  auto rest = whole.subspan(1);
  const auto step = recording::take_varint(rest);
  const auto size = recording::take_varint(rest);
  if (!step || !size || rest.size() < kChecksumSize || *size > rest.size() - kChecksumSize) return std::nullopt;
  const auto payload = rest.first(*size);
  const auto record = whole.first(whole.size() - rest.size() + *size);
  const std::uint32_t checksum = recording::checksum(checksum_, record);
  const auto stamp = advance(last_stamp_, recording::unzigzag(*step));
  if (!stamp || checksum != stored_checksum(rest.subspan(*size))) return std::nullopt;
  checksum_ = checksum;
  last_stamp_ = *stamp;
  position_ += record.size() + kChecksumSize;
  const std::uint8_t kind = whole.front();
  ended_ = kind == recording::kEnd && payload.empty() && position_ == file_.size();
  cut_ = kind == recording::kEnd && !ended_;
  if (kind == recording::kEnd) return std::nullopt;
  return Record{kind, payload};
}

/// The next record that holds bytes which passed, or makes no sense.
std::optional<RecordingReader::Record> RecordingReader::next_chunk() {
  while (true) {
    std::optional<Record> record = next_record();
    if (!record || record->kind != recording::kMissionEnd) return record;
    std::span<const std::uint8_t> payload = record->payload;
    const auto frames = recording::take_varint(payload);
    if (!frames) return record;
    mission_end_ = RecordedEnd{*frames, std::string(payload.begin(), payload.end())};
  }
}

std::optional<RecordedBytes> RecordingReader::next() {
  const std::optional<Record> record = next_chunk();
  if (!record) return std::nullopt;
  const double stamp = stamp_from_nanoseconds(last_stamp_);
  std::span<const std::uint8_t> payload = record->payload;
  if (record->kind == recording::kSent) return RecordedBytes{Direction::Sent, stamp, payload};
  if (record->kind == recording::kReceived) {
    if (!payload.empty() && payload.size() <= ChunkHistory::kMaxLength) {
      std::copy(payload.begin(), payload.end(), history_->of_length(payload.size()).begin());
    }
    return RecordedBytes{Direction::Received, stamp, payload};
  }
  if (record->kind == recording::kReceivedDelta) {
    const auto length = recording::take_varint(payload);
    if (length && *length >= 1 && *length <= ChunkHistory::kMaxLength) {
      const std::span<std::uint8_t> chunk = history_->of_length(*length);
      if (recording::apply_delta(payload, chunk)) return RecordedBytes{Direction::Received, stamp, chunk};
    }
  }
  cut_ = true;
  return std::nullopt;
}

}  // namespace scrubjay

#include <algorithm>
#include <cstring>
#include <scrubjay/oi/stream_parser.hpp>

namespace scrubjay::oi {
namespace {

/// Data bytes behind each id in a stream of that model; 0: the model has no such id.
constexpr auto kDataBytes = [] {
  std::array<std::array<std::uint8_t, 256>, kModelCount> bytes{};
  for (std::uint8_t model = 0; model < kModelCount; ++model) {
    for (int id = 0; id < 256; ++id) {
      const auto known = SensorId::of(id, Model{model});
      if (known) bytes[model][static_cast<std::size_t>(id)] = known->run().bytes;
    }
  }
  return bytes;
}();

}  // namespace

std::uint8_t byte_sum(std::span<const std::uint8_t> bytes) {
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : bytes) sum = static_cast<std::uint8_t>(sum + byte);
  return sum;
}

DecodeStatus decode(const StreamFrame& frame, Model model, Sensors& sensors) {
  DecodeStatus all{.ok = true};
  for (const StreamFrame::Entry& entry : frame) {
    const DecodeStatus one = decode(entry.id, entry.data, model, sensors);
    all.ok = all.ok && one.ok;
    all.rejected = static_cast<std::uint16_t>(all.rejected + one.rejected);
  }
  return all;
}

/// What `bytes` (not empty) begin with, as far as they go. More bytes never change a finding but Incomplete.
StreamParser::Finding StreamParser::judge(std::span<const std::uint8_t> bytes) const {
  const auto& data_bytes = kDataBytes[static_cast<std::size_t>(model_)];
  if (bytes[0] != kStreamHeader) return Finding::NoHeader;
  if (bytes.size() < 3) return Finding::Incomplete;
  const std::size_t payload = bytes[1];
  const std::size_t first = data_bytes[bytes[2]];
  if (first == 0 || 1 + first > payload) return Finding::NoHeader;
  if (expected_ && payload != *expected_) return Finding::OtherLength;

  const std::size_t end = 2 + payload;
  std::size_t at = 3 + first;
  while (at < end && at < bytes.size()) {
    const std::size_t next = data_bytes[bytes[at]];
    if (next == 0) return Finding::Malformed;
    at += 1 + next;
  }
  if (at > end) return Finding::Malformed;
  if (bytes.size() <= end) return Finding::Incomplete;
  return byte_sum(bytes.first(end + 1)) == 0 ? Finding::Frame : Finding::Malformed;
}

/// Adds to the frame that has begun, up to its end. Says how many bytes were taken, which is one at least.
std::size_t StreamParser::refill(std::span<const std::uint8_t> bytes) {
  const std::size_t wanted = pending_size_ < 2 ? 2 : pending_[1] + kStreamOverhead;
  const std::size_t count = std::min(wanted - pending_size_, bytes.size());
  std::memcpy(pending_.data() + pending_size_, bytes.data(), count);
  pending_size_ += count;
  return count;
}

void StreamParser::release(std::size_t count) {
  pending_size_ -= count;
  std::memmove(pending_.data(), pending_.data() + count, pending_size_);
}

void StreamParser::hold(std::span<const std::uint8_t> bytes) {
  std::copy(bytes.begin(), bytes.end(), pending_.begin());
  pending_size_ = bytes.size();
}

void StreamParser::reset() {
  counters_.skipped += pending_size_;
  pending_size_ = 0;
  counted_extent_ = 0;
}

void StreamParser::pass(std::size_t frame_size) {
  ++counters_.frames;
  counters_.frame_bytes += frame_size;
  counted_extent_ = 0;
}

/// Goes on to the next byte that may be a header. Says how many bytes that skips, which is one at least.
std::size_t StreamParser::skip(std::span<const std::uint8_t> bytes, Finding finding) {
  if (finding != Finding::NoHeader && counted_extent_ == 0) {
    ++(finding == Finding::OtherLength ? counters_.other_length : counters_.lost);
    counted_extent_ = bytes[1] + kStreamOverhead;
  }
  const void* next = std::memchr(bytes.data() + 1, kStreamHeader, bytes.size() - 1);
  const std::size_t count =
      next == nullptr ? bytes.size() : static_cast<std::size_t>(static_cast<const std::uint8_t*>(next) - bytes.data());
  counters_.skipped += count;
  counted_extent_ -= std::min(counted_extent_, count);
  return count;
}

std::size_t encode_stream_frame(std::span<const SensorId> ids, const Sensors& sensors, Model model,
                                std::span<std::uint8_t> out) {
  out = out.first(std::min(out.size(), kMaxStreamFrame));
  if (out.size() < kStreamOverhead) return 0;
  std::size_t at = 2;
  for (const SensorId id : ids) {
    // The last byte is kept for the checksum.
    if (at + 1 >= out.size()) return 0;
    out[at] = id.number();
    const std::size_t bytes = encode(id, sensors, model, out.subspan(at + 1, out.size() - at - 2));
    if (bytes == 0) return 0;
    at += 1 + bytes;
  }
  out[0] = kStreamHeader;
  out[1] = static_cast<std::uint8_t>(at - 2);
  out[at] = static_cast<std::uint8_t>(-byte_sum(out.first(at)));
  return at + 1;
}

}  // namespace scrubjay::oi

/// \file
/// The stream of sensor frames: `19, N, {id, data}..., checksum`, parsed from any chunking of bytes, and written.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <scrubjay/oi/model.hpp>
#include <scrubjay/oi/sensor_id.hpp>
#include <scrubjay/oi/sensors.hpp>
#include <span>

namespace scrubjay::oi {

inline constexpr std::uint8_t kStreamHeader = 19;
inline constexpr std::size_t kStreamOverhead = 3;  ///< header, N and checksum
inline constexpr std::size_t kMaxStreamFrame = 255 + kStreamOverhead;

/// Sum of the bytes, modulo 256. It is 0 over a whole stream frame.
std::uint8_t byte_sum(std::span<const std::uint8_t> bytes);

/// The verified inside of a stream frame: known ids, each with all of its data. It refers to the parser's or the
/// caller's bytes, and is good until the callback returns.
class StreamFrame {
 public:
  struct Entry {
    SensorId id;
    std::span<const std::uint8_t> data;
  };

  class Iterator {
   public:
    explicit Iterator(std::span<const std::uint8_t> rest) : rest_(rest) {}
    Entry operator*() const {
      const SensorId id = *SensorId::of(rest_[0]);
      return {id, rest_.subspan(1, id.bytes())};
    }
    Iterator& operator++() {
      rest_ = rest_.subspan(1 + detail::kRuns[rest_[0]].bytes);
      return *this;
    }
    bool operator==(const Iterator& other) const { return rest_.data() == other.rest_.data(); }

   private:
    std::span<const std::uint8_t> rest_;
  };

  Iterator begin() const { return Iterator(payload_); }
  Iterator end() const { return Iterator(payload_.last(0)); }
  /// Ids and data, without header, N and checksum.
  std::span<const std::uint8_t> payload() const { return payload_; }

 private:
  friend class StreamParser;
  explicit StreamFrame(std::span<const std::uint8_t> payload) : payload_(payload) {}
  std::span<const std::uint8_t> payload_;
};

/// Decodes all entries of the frame, in order.
DecodeStatus decode(const StreamFrame& frame, Model model, Sensors& sensors);

/// Finds the frames in a stream of bytes.
///
/// A frame is what begins with 19, whose ids the model has, whose ids and data add up to N exactly, and whose sum is 0.
/// On anything else the search goes on one byte further, so that a stray 19 never costs the frame behind it. Frames
/// that lie whole in the bytes given are read where they lie; others are put together in storage of 258 bytes.
class StreamParser {
 public:
  /// Whatever the chunking: bytes fed = frame_bytes + skipped + pending().
  struct Counters {
    std::uint64_t frames = 0;       ///< handed on
    std::uint64_t frame_bytes = 0;  ///< in them, whole frames
    /// Headers that were plausible (19, N, an id of the model whose data fit into N), of the expected N if there is
    /// one, with inner ids that don't add up or a sum that isn't 0 behind them. Others that begin within the N + 3
    /// bytes of one counted aren't counted again.
    std::uint64_t lost = 0;
    /// Plausible headers of another N than the expected one, counted by the same rule: the robot streams another list.
    std::uint64_t other_length = 0;
    std::uint64_t skipped = 0;  ///< bytes that belong to no frame
    bool operator==(const Counters&) const = default;
  };

  /// `expected_payload`: N of the frames wanted (81 for group 100 alone), where it is known. Frames of another N aren't
  /// handed on then; and noise that looks like the header of a long frame can't hold back the frames behind it.
  explicit StreamParser(Model model, std::optional<std::uint8_t> expected_payload = {})
      : model_(model), expected_(expected_payload) {}

  /// Calls `on_frame(const StreamFrame&)` for each frame that these bytes complete.
  template <typename OnFrame>
  void feed(std::span<const std::uint8_t> bytes, OnFrame&& on_frame) {
    while (pending_size_ > 0) {
      if (bytes.empty()) return;
      bytes = bytes.subspan(refill(bytes));
      release(scan({pending_.data(), pending_size_}, on_frame));
    }
    hold(bytes.subspan(scan(bytes, on_frame)));
  }
  /// Forgets the frame that has only begun; its bytes count as skipped.
  void reset();

  /// Bytes of a frame that has only begun.
  std::size_t pending() const { return pending_size_; }
  const Counters& counters() const { return counters_; }

 private:
  enum class Finding : std::uint8_t { Incomplete, Frame, NoHeader, OtherLength, Malformed };

  /// Takes all frames and noise off the front; what is left begins like a frame. Says how many bytes were taken.
  template <typename OnFrame>
  std::size_t scan(std::span<const std::uint8_t> bytes, OnFrame& on_frame) {
    std::size_t at = 0;
    while (at < bytes.size()) {
      const auto rest = bytes.subspan(at);
      const Finding finding = judge(rest);
      if (finding == Finding::Incomplete) break;
      if (finding == Finding::Frame) {
        const std::size_t size = rest[1] + kStreamOverhead;
        pass(size);
        at += size;
        on_frame(StreamFrame(rest.subspan(2, rest[1])));
      } else {
        at += skip(rest, finding);
      }
    }
    return at;
  }

  Finding judge(std::span<const std::uint8_t> bytes) const;
  std::size_t refill(std::span<const std::uint8_t> bytes);
  void release(std::size_t count);
  void hold(std::span<const std::uint8_t> bytes);
  void pass(std::size_t frame_size);
  std::size_t skip(std::span<const std::uint8_t> bytes, Finding finding);

  Model model_;
  std::optional<std::uint8_t> expected_;
  std::array<std::uint8_t, kMaxStreamFrame> pending_{};
  std::size_t pending_size_ = 0;
  std::size_t counted_extent_ = 0;  ///< bytes ahead that belong to a failure already counted
  Counters counters_;
};

/// Writes a frame with these ids to the front of `out`, and says how many bytes that took; 0 if it doesn't fit, is
/// longer than a frame can be, or names what the model lacks.
[[nodiscard]] std::size_t encode_stream_frame(std::span<const SensorId> ids, const Sensors& sensors, Model model,
                                              std::span<std::uint8_t> out);

}  // namespace scrubjay::oi

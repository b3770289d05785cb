/// \file
/// A bad wire: bytes get lost, change, come late, or not at all for a while.
#pragma once

#include <cstdint>
#include <deque>
#include <scrubjay/geometry/random.hpp>
#include <scrubjay/robot/byte_channel.hpp>
#include <vector>

namespace scrubjay::sim {

/// How bad. All zeros: a perfect wire.
struct WireFaults {
  double drop = 0.0;      ///< probability that a byte gets lost
  double flip = 0.0;      ///< probability that a bit of a byte changes
  double delay = 0.0;     ///< longest that a chunk comes late [s]; evenly drawn, order is kept
  double silences = 0.0;  ///< how often the wire falls silent [1/s], as a Poisson process
  double silence = 0.0;   ///< for how long, at most [s]; evenly drawn. What is sent meanwhile is lost
};

/// What the wire did so far, both ways.
struct WireFaultCounters {
  std::uint64_t dropped = 0;   ///< bytes lost one by one
  std::uint64_t flipped = 0;   ///< bytes with a changed bit
  std::uint64_t delayed = 0;   ///< chunks that came late
  std::uint64_t silences = 0;  ///< that began
  std::uint64_t silenced = 0;  ///< bytes lost in them
  bool operator==(const WireFaultCounters&) const = default;
};

/// A channel over another one, with faults in both directions. The same seed and the same use give the same faults; the
/// two directions draw from streams of their own.
///
/// Time is that of the channel's stamps: a channel that has no clock can neither delay nor fall silent. What is written
/// counts as sent at the stamp of the last read, and what is due late goes out with the reads that follow.
class FaultyChannel final : public ByteChannel {
 public:
  /// `channel` must outlive it.
  FaultyChannel(ByteChannel& channel, const WireFaults& faults, const Random& random);

  ByteRead read(std::span<std::uint8_t> buffer) override;
  bool write(std::span<const std::uint8_t> bytes) override;

  /// Whether what is sent now gets lost, either way.
  bool is_silent() const { return silent_; }
  const WireFaultCounters& counters() const { return counters_; }

 private:
  /// Bytes on their way.
  struct Chunk {
    double due = 0.0;  ///< [s]
    std::vector<std::uint8_t> bytes;
  };
  /// One direction.
  struct Way {
    Random random;
    double last_due = 0.0;  ///< of the chunk that was sent last [s]
    std::deque<Chunk> late;
  };

  void pass_time(double stamp);
  std::size_t spoil(Random& random, std::span<std::uint8_t> bytes);
  void hold_back(Way& way, std::span<const std::uint8_t> bytes);
  void send_due();
  std::size_t take_due(std::span<std::uint8_t> buffer);
  double until_next_silence();

  ByteChannel* channel_;
  WireFaults faults_;
  Random silence_random_;
  Way in_;   // from the channel to the reader
  Way out_;  // from the writer to the channel
  double now_ = 0.0;
  bool clock_started_ = false;
  double silent_from_ = 0.0;
  double silent_until_ = 0.0;  // of the silence that began last
  bool silent_ = false;
  bool ended_ = false;      // no more bytes from the channel
  bool link_gone_ = false;  // a write failed
  WireFaultCounters counters_;
};

}  // namespace scrubjay::sim

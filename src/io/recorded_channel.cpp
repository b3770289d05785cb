#include <algorithm>
#include <scrubjay/io/recording.hpp>

namespace scrubjay {

ByteRead RecordingChannel::read(std::span<std::uint8_t> buffer) {
  ByteRead got = channel_.read(buffer);
  got.stamp = stamp_from_nanoseconds(stamp_to_nanoseconds(got.stamp));
  last_stamp_ = got.stamp;
  writer_.record(Direction::Received, got.stamp, buffer.first(got.count));
  return got;
}

bool RecordingChannel::write(std::span<const std::uint8_t> bytes) {
  writer_.record(Direction::Sent, last_stamp_, bytes);
  return channel_.write(bytes);
}

ByteRead RecordedChannel::read(std::span<std::uint8_t> buffer) {
  while (rest_.empty()) {
    const std::optional<RecordedBytes> next = reader_.next();
    if (!next) return {.count = 0, .stamp = stamp_, .open = false};
    if (next->direction == Direction::Sent) {
      // What came of a read that brought nothing: a reader that lost patience then is to lose it again.
      if (!heard_ || next->stamp <= stamp_) continue;
      stamp_ = next->stamp;
      return {.count = 0, .stamp = stamp_, .open = true};
    }
    heard_ = true;
    rest_ = next->bytes;
    stamp_ = next->stamp;
  }
  const std::size_t count = std::min(buffer.size(), rest_.size());
  std::copy_n(rest_.begin(), count, buffer.begin());
  rest_ = rest_.subspan(count);
  return {.count = count, .stamp = stamp_, .open = true};
}

bool RecordedChannel::write(std::span<const std::uint8_t>) {
  return true;
}

}  // namespace scrubjay

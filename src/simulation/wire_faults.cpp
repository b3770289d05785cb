#include <algorithm>
#include <scrubjay/geometry/elementary.hpp>
#include <scrubjay/simulation/wire_faults.hpp>

namespace scrubjay::sim {
namespace {

enum Stream : std::uint64_t { kReading, kWriting, kSilences };

}  // namespace

FaultyChannel::FaultyChannel(ByteChannel& channel, const WireFaults& faults, const Random& random)
    : channel_(&channel),
      faults_(faults),
      silence_random_(random.fork(kSilences)),
      in_{random.fork(kReading), 0.0, {}},
      out_{random.fork(kWriting), 0.0, {}} {}

ByteRead FaultyChannel::read(std::span<std::uint8_t> buffer) {
  send_due();
  if (const std::size_t count = take_due(buffer)) return {count, now_, true};
  if (ended_) return {0, now_, false};
  const ByteRead read = channel_->read(buffer);
  pass_time(read.stamp);
  ended_ = !read.open;
  std::size_t count = spoil(in_.random, buffer.first(read.count));
  if (faults_.delay > 0.0) {
    hold_back(in_, buffer.first(count));
    count = take_due(buffer);
  }
  return {count, now_, read.open || !in_.late.empty()};
}

bool FaultyChannel::write(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> sent(bytes.begin(), bytes.end());
  sent.resize(spoil(out_.random, sent));
  if (faults_.delay > 0.0) {
    hold_back(out_, sent);
    send_due();
  } else if (!sent.empty()) {
    link_gone_ = !channel_->write(sent);
  }
  return !link_gone_;
}

/// Begins and ends the silences until then.
void FaultyChannel::pass_time(double stamp) {
  now_ = stamp;
  if (faults_.silences <= 0.0) return;
  if (!clock_started_) {
    clock_started_ = true;
    silent_from_ = stamp + until_next_silence();
  }
  silent_ = silent_ && now_ < silent_until_;
  while (!silent_ && silent_from_ <= now_) {
    ++counters_.silences;
    silent_until_ = silent_from_ + faults_.silence * silence_random_.uniform();
    silent_ = now_ < silent_until_;
    silent_from_ = silent_until_ + until_next_silence();
  }
}

double FaultyChannel::until_next_silence() {
  return -log(1.0 - silence_random_.uniform()) / faults_.silences;
}

/// Loses and changes some of the bytes, in place; returns how many are left.
std::size_t FaultyChannel::spoil(Random& random, std::span<std::uint8_t> bytes) {
  if (silent_) {
    counters_.silenced += bytes.size();
    return 0;
  }
  std::size_t left = 0;
  for (std::uint8_t byte : bytes) {
    if (faults_.drop > 0.0 && random.uniform() < faults_.drop) {
      ++counters_.dropped;
      continue;
    }
    if (faults_.flip > 0.0 && random.uniform() < faults_.flip) {
      byte = static_cast<std::uint8_t>(byte ^ (1u << random.below(8)));
      ++counters_.flipped;
    }
    bytes[left++] = byte;
  }
  return left;
}

void FaultyChannel::hold_back(Way& way, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return;
  // Never before what was sent earlier, which isn't later than `delay` from now either.
  way.last_due = std::max(way.last_due, now_ + faults_.delay * way.random.uniform());
  if (way.last_due > now_) ++counters_.delayed;
  way.late.push_back({way.last_due, {bytes.begin(), bytes.end()}});
}

void FaultyChannel::send_due() {
  while (!silent_ && !out_.late.empty() && out_.late.front().due <= now_) {
    link_gone_ = !channel_->write(out_.late.front().bytes);
    out_.late.pop_front();
  }
}

/// Once the channel has ended there is no clock to wait by: all that is left is due.
std::size_t FaultyChannel::take_due(std::span<std::uint8_t> buffer) {
  std::size_t count = 0;
  while (count < buffer.size() && !in_.late.empty() && (ended_ || (!silent_ && in_.late.front().due <= now_))) {
    std::vector<std::uint8_t>& bytes = in_.late.front().bytes;
    const std::size_t taken = std::min(bytes.size(), buffer.size() - count);
    const auto end = bytes.begin() + static_cast<std::ptrdiff_t>(taken);
    std::copy(bytes.begin(), end, buffer.begin() + static_cast<std::ptrdiff_t>(count));
    count += taken;
    bytes.erase(bytes.begin(), end);
    if (bytes.empty()) in_.late.pop_front();
  }
  return count;
}

}  // namespace scrubjay::sim

#include <gmock/gmock.h>

#include <bit>
#include <numeric>
#include <scrubjay/simulation/wire_faults.hpp>

#include "wire.hpp"

namespace scrubjay::test {
namespace {

using sim::FaultyChannel;
using sim::WireFaultCounters;
using sim::WireFaults;

constexpr double kStep = 0.015;

/// A channel that brings a chunk every 15 ms, counts up in its bytes, and keeps what was sent to it.
class CountingChannel final : public ByteChannel {
 public:
  explicit CountingChannel(std::size_t chunk, int chunks = 1'000'000, double stamp = 0.0)
      : chunk_(chunk), chunks_(chunks), stamp_(stamp) {}

  ByteRead read(std::span<std::uint8_t> buffer) override {
    stamp_ += kStep;
    if (chunks_ == 0) return {0, stamp_, false};
    --chunks_;
    const std::span<std::uint8_t> chunk = buffer.first(chunk_);
    std::iota(chunk.begin(), chunk.end(), next_);
    next_ = static_cast<std::uint8_t>(next_ + chunk_);
    return {chunk_, stamp_, true};
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    sent.insert(sent.end(), bytes.begin(), bytes.end());
    sent_at.push_back(stamp_);
    return !gone;
  }

  Bytes sent;
  std::vector<double> sent_at;
  bool gone = false;

 private:
  std::size_t chunk_;
  int chunks_;
  double stamp_;
  std::uint8_t next_ = 0;
};

Bytes counted(std::size_t count) {
  Bytes bytes(count);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}

struct Received {
  Bytes bytes;
  std::vector<double> stamps;  ///< of each byte
};

Received receive(ByteChannel& channel, int reads, std::size_t at_most = 512) {
  Received all;
  Bytes buffer(at_most);
  for (int i = 0; i < reads; ++i) {
    const ByteRead read = channel.read(buffer);
    all.bytes.insert(all.bytes.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(read.count));
    all.stamps.insert(all.stamps.end(), read.count, read.stamp);
    if (!read.open) break;
  }
  return all;
}

/// Whether `some` are among `all`, in order.
bool is_subsequence(const Bytes& some, const Bytes& all) {
  std::size_t found = 0;
  for (const std::uint8_t byte : all) found += found < some.size() && some[found] == byte;
  return found == some.size();
}

TEST(WireFaultsTest, APerfectWireChangesNothing) {
  CountingChannel channel(80);
  FaultyChannel wire(channel, {}, Random(1));
  EXPECT_EQ(receive(wire, 100).bytes, counted(8000));
  EXPECT_TRUE(wire.write(counted(300)));
  EXPECT_EQ(channel.sent, counted(300));
  EXPECT_EQ(wire.counters(), WireFaultCounters{});
}

TEST(WireFaultsTest, LosesAsManyBytesAsItCountsAndKeepsTheOrderOfTheRest) {
  CountingChannel channel(100);
  FaultyChannel wire(channel, {.drop = 0.01}, Random(1));
  const Bytes read = receive(wire, 1000).bytes;
  const std::uint64_t lost_reading = wire.counters().dropped;
  EXPECT_EQ(read.size(), 100'000u - lost_reading);
  EXPECT_NEAR(static_cast<double>(lost_reading), 1000.0, 150.0);
  EXPECT_TRUE(is_subsequence(read, counted(100'000)));
  EXPECT_TRUE(wire.write(counted(50'000)));
  EXPECT_EQ(channel.sent.size(), 50'000u - (wire.counters().dropped - lost_reading));
  EXPECT_NEAR(static_cast<double>(channel.sent.size()), 49'500.0, 110.0);
}

TEST(WireFaultsTest, ChangesOneBitOfAsManyBytesAsItCounts) {
  CountingChannel channel(100);
  FaultyChannel wire(channel, {.flip = 0.02}, Random(1));
  wire.write(counted(20'000));
  Bytes both = channel.sent;
  const Bytes read = receive(wire, 200).bytes;
  both.insert(both.end(), read.begin(), read.end());
  ASSERT_EQ(both.size(), 40'000u);
  std::uint64_t changed = 0;
  for (std::size_t i = 0; i < both.size(); ++i) {
    const int bits = std::popcount(static_cast<unsigned>(both[i] ^ static_cast<std::uint8_t>(i % 20'000)));
    EXPECT_LE(bits, 1);
    changed += bits == 1;
  }
  EXPECT_EQ(changed, wire.counters().flipped);
  EXPECT_NEAR(static_cast<double>(changed), 800.0, 120.0);
}

TEST(WireFaultsTest, DelaysWhatIsReadWithoutLosingOrReorderingIt) {
  CountingChannel channel(50);
  FaultyChannel wire(channel, {.delay = 0.1}, Random(1));
  const Received got = receive(wire, 1000);
  EXPECT_GT(wire.counters().delayed, 900u);
  ASSERT_GT(got.bytes.size(), 49'000u);
  EXPECT_EQ(got.bytes, counted(got.bytes.size()));
  double latest = 0.0;
  for (std::size_t i = 0; i < got.bytes.size(); ++i) {
    const double late = got.stamps[i] - kStep * static_cast<double>(i / 50 + 1);
    EXPECT_GE(late, -1e-9);
    latest = std::max(latest, late);
  }
  EXPECT_GT(latest, 0.06);
  EXPECT_LT(latest, 0.1 + kStep + 1e-9);
}

TEST(WireFaultsTest, DelaysWhatIsWrittenAndKeepsItsOrder) {
  CountingChannel channel(1);
  FaultyChannel wire(channel, {.delay = 0.1}, Random(3));
  const Bytes bytes = counted(200);
  double latest = 0.0;
  std::vector<double> written_at;
  for (int i = 0; i < 200; ++i) {
    wire.write(std::span(bytes).subspan(static_cast<std::size_t>(i), 1));
    written_at.push_back(kStep * i);
    receive(wire, 1);
  }
  receive(wire, 20);
  ASSERT_EQ(channel.sent, bytes);
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_GE(channel.sent_at[i], written_at[i] - 1e-9);
    latest = std::max(latest, channel.sent_at[i] - written_at[i]);
  }
  EXPECT_GT(latest, 0.06);
  EXPECT_LT(latest, 0.1 + 2.0 * kStep);
}

TEST(WireFaultsTest, FallsSilentBothWaysForAWhile) {
  // Whatever the clock says when the wire is first used.
  for (const double begin : {0.0, 1e6}) {
    CountingChannel channel(1, 1'000'000, begin);
    FaultyChannel wire(channel, {.silences = 0.1, .silence = 2.0}, Random(1));
    std::uint64_t quiet_ticks = 0;
    std::uint64_t falls = 0;
    bool was_quiet = false;
    const int ticks = 200'000;  // 3000 s
    for (int i = 0; i < ticks; ++i) {
      const std::size_t sent = channel.sent.size();
      const bool quiet = receive(wire, 1).bytes.empty();
      wire.write(Bytes{1});
      EXPECT_EQ(channel.sent.size() == sent, quiet) << "either way";
      quiet_ticks += quiet;
      falls += quiet && !was_quiet;
      was_quiet = quiet;
    }
    const WireFaultCounters& counters = wire.counters();
    EXPECT_EQ(counters.silenced, 2 * quiet_ticks);
    // One in 10 s of sound, each 1 s in the mean.
    EXPECT_NEAR(static_cast<double>(counters.silences), 3000.0 / 11.0, 50.0);
    EXPECT_NEAR(static_cast<double>(quiet_ticks) * kStep, 3000.0 / 11.0, 60.0);
    EXPECT_LE(falls, counters.silences);
    EXPECT_GE(static_cast<double>(falls), 0.9 * static_cast<double>(counters.silences));
  }
}

TEST(WireFaultsTest, LetsNothingThatIsLateThroughASilence) {
  CountingChannel channel(1);
  FaultyChannel wire(channel, {.delay = 0.2, .silences = 0.5, .silence = 1.0}, Random(1));
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t before = wire.counters().silenced;
    const bool something = !receive(wire, 1).bytes.empty();
    const bool silent = wire.counters().silenced > before;
    EXPECT_FALSE(something && silent);
  }
}

TEST(WireFaultsTest, TheSameSeedGivesTheSameFaults) {
  const WireFaults faults{0.01, 0.01, 0.05, 0.2, 0.5};
  const auto run = [&](std::uint64_t seed, bool talkative) {
    CountingChannel channel(60);
    FaultyChannel wire(channel, faults, Random(seed));
    Received all;
    for (int i = 0; i < 500; ++i) {
      if (talkative) wire.write(counted(10));
      const Received some = receive(wire, 1);
      all.bytes.insert(all.bytes.end(), some.bytes.begin(), some.bytes.end());
    }
    return std::pair(all.bytes, channel.sent);
  };
  EXPECT_EQ(run(1, true), run(1, true));
  EXPECT_NE(run(1, true).first, run(2, true).first);
  EXPECT_NE(run(1, true).second, run(2, true).second);
  EXPECT_EQ(run(1, true).first, run(1, false).first) << "what is written doesn't change what is read";
}

TEST(WireFaultsTest, HandsOutInPiecesWhatABufferHasNoRoomFor) {
  CountingChannel channel(10);
  FaultyChannel wire(channel, {.delay = 0.1}, Random(1));
  Bytes all;
  for (int i = 0; i < 200; ++i) {
    const Bytes some = receive(wire, 1, 10).bytes;
    all.insert(all.end(), some.begin(), some.end());
  }
  EXPECT_GT(all.size(), 1000u);
  EXPECT_EQ(all, counted(all.size()));
}

TEST(WireFaultsTest, DeliversWhatIsLateBeforeItEnds) {
  CountingChannel channel(10, 5);
  FaultyChannel wire(channel, {.delay = 60.0}, Random(1));
  const Received got = receive(wire, 100);
  EXPECT_EQ(got.bytes, counted(50));
  Bytes buffer(10);
  EXPECT_FALSE(wire.read(buffer).open);
}

TEST(WireFaultsTest, TellsWhenTheLinkIsGone) {
  CountingChannel channel(10);
  channel.gone = true;
  FaultyChannel wire(channel, {.drop = 0.001}, Random(1));
  EXPECT_FALSE(wire.write(counted(10)));
}

}  // namespace
}  // namespace scrubjay::test

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <scrubjay/oi/all_packets.hpp>
#include <scrubjay/oi/stream_parser.hpp>
#include <vector>

#include "random_values.hpp"

namespace scrubjay::oi {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Bytes frame_of(const std::vector<SensorId>& ids, const Sensors& sensors, Model model = Model::Create2) {
  Bytes out(kMaxStreamFrame);
  out.resize(encode_stream_frame(ids, sensors, model, out));
  return out;
}

/// A frame of group 100 with values in range.
Bytes random_frame(Random& random) {
  return frame_of({100}, random_sensors(random, Model::Create2));
}

/// A parser and the payloads that it handed on.
struct Listener {
  explicit Listener(std::optional<std::uint8_t> expected = {}, Model model = Model::Create2)
      : parser(model, expected) {}
  void feed(std::span<const std::uint8_t> bytes) {
    fed += bytes.size();
    parser.feed(bytes, [this](const StreamFrame& frame) {
      payloads.emplace_back(frame.payload().begin(), frame.payload().end());
    });
    const auto& counters = parser.counters();
    EXPECT_EQ(counters.frame_bytes + counters.skipped + parser.pending(), fed);
    EXPECT_EQ(counters.frames, payloads.size());
  }

  StreamParser parser;
  std::vector<Bytes> payloads;
  std::size_t fed = 0;
};

Bytes payload_of(const Bytes& frame) {
  return {frame.begin() + 2, frame.end() - 1};
}

TEST(StreamParserTest, ReadsTheExampleOfTheSpecification) {
  // Cliff front left signal 537 and virtual wall 0.
  Listener listener;
  listener.feed(Bytes{19, 5, 29, 2, 25, 13, 0, 163});
  EXPECT_THAT(listener.payloads, ElementsAre(Bytes{29, 2, 25, 13, 0}));
  Sensors sensors;
  StreamParser parser(Model::Create2);
  parser.feed(Bytes{19, 5, 29, 2, 25, 13, 0, 163}, [&](const StreamFrame& frame) {
    EXPECT_EQ(decode(frame, Model::Create2, sensors), (DecodeStatus{.ok = true}));
    std::vector<int> ids;
    for (const auto& entry : frame) ids.push_back(entry.id.number());
    EXPECT_THAT(ids, ElementsAre(29, 13));
  });
  EXPECT_EQ(sensors[PacketId::CliffFrontLeftSignal], 537);
  EXPECT_TRUE(sensors.has(PacketId::VirtualWall));
}

TEST(StreamParserTest, DecodesWhatWasEncodedForAnyListOfIds) {
  Random random(6);
  for (const Model model : {Model::Create2, Model::Create1}) {
    for (int run = 0; run < 2000; ++run) {
      const Sensors sent = random_sensors(random, model);
      std::vector<SensorId> ids;
      std::size_t payload = 0;
      for (int i = random.between(1, 60); i > 0; --i) {
        const SensorId id = random_id(random, model);
        if (payload + 1 + id.bytes() > 255) break;
        payload += 1 + id.bytes();
        ids.push_back(id);
      }
      const Bytes frame = frame_of(ids, sent, model);
      ASSERT_EQ(frame.size(), payload + 3);
      ASSERT_EQ(std::accumulate(frame.begin(), frame.end(), 0) % 256, 0);
      Sensors received;
      StreamParser parser(model);
      parser.feed(frame,
                  [&](const StreamFrame& f) { ASSERT_EQ(decode(f, model, received), (DecodeStatus{.ok = true})); });
      ASSERT_EQ(parser.counters().frames, 1U);
      for (const SensorId id : ids) {
        for (std::uint8_t n = id.run().first; n <= id.run().last; ++n) {
          ASSERT_TRUE(received.has(PacketId{n}));
          ASSERT_EQ(received[PacketId{n}], sent[PacketId{n}]);
        }
      }
    }
  }
}

TEST(StreamParserTest, FramesWholeInTheInputAreNotCopied) {
  Random random(7);
  const Bytes bytes = Bytes{1, 2} + random_frame(random);
  StreamParser parser(Model::Create2);
  parser.feed(bytes, [&](const StreamFrame& frame) { EXPECT_EQ(frame.payload().data(), bytes.data() + 4); });
  EXPECT_EQ(parser.counters().frames, 1U);
}

/// Frames, noise, headers in noise, cut frames: whatever a line may carry.
Bytes random_line(Random& random) {
  Bytes line;
  for (int i = random.between(1, 8); i > 0; --i) {
    Bytes part = random.between(0, 1) == 0 ? random_frame(random)
                                           : frame_of({random_id(random, Model::Create2), PacketId::Distance},
                                                      random_sensors(random, Model::Create2));
    const auto place = [&] { return static_cast<std::size_t>(random.between(0, static_cast<int>(part.size()) - 1)); };
    switch (random.between(0, 5)) {
      case 0:
        part.resize(place());
        break;
      case 1:
        part[place()] = static_cast<std::uint8_t>(random.next());
        break;
      case 2:
        part.insert(part.begin(), kStreamHeader);
        break;
      case 3:
        part.insert(part.begin(), {kStreamHeader, static_cast<std::uint8_t>(random.next()), 7});
        break;
      default:
        break;
    }
    line = line + part;
  }
  return line;
}

TEST(StreamParserTest, ChunksDontMatter) {
  Random random(8);
  for (int run = 0; run < 3000; ++run) {
    const Bytes line = random_line(random);
    const std::optional<std::uint8_t> expected =
        run % 2 == 0 ? std::optional<std::uint8_t>(81) : std::optional<std::uint8_t>();
    Listener whole(expected);
    whole.feed(line);
    Listener pieces(expected);
    const int longest = random.between(1, 100);
    for (std::size_t at = 0; at < line.size();) {
      const auto count = std::min<std::size_t>(static_cast<std::size_t>(random.between(0, longest)), line.size() - at);
      pieces.feed(std::span(line).subspan(at, count));
      at += count;
    }
    ASSERT_EQ(pieces.payloads, whole.payloads);
    ASSERT_EQ(pieces.parser.counters(), whole.parser.counters());
    ASSERT_EQ(pieces.parser.pending(), whole.parser.pending());
  }
}

TEST(StreamParserTest, OneWrongByteCostsOneFrameAtMost) {
  Random random(9);
  const Bytes a = random_frame(random), b = random_frame(random), c = random_frame(random);
  const std::vector<Bytes> payloads{payload_of(a), payload_of(b), payload_of(c)};
  for (std::size_t at = 0; at < 3 * 84; ++at) {
    for (int flip = 1; flip < 256; ++flip) {
      Bytes line = a + b + c;
      line[at] = static_cast<std::uint8_t>(line[at] ^ flip);
      Listener listener(81);
      listener.feed(line);
      std::vector<Bytes> others = payloads;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(at / 84));
      ASSERT_EQ(listener.payloads, others) << at << " " << flip;
      ASSERT_LE(listener.parser.counters().lost + listener.parser.counters().other_length, 1U);
      if (at % 84 > 2) {  // behind 19, N and id
        ASSERT_EQ(listener.parser.counters().lost, 1U) << at << " " << flip;
      }
    }
  }
}

TEST(StreamParserTest, OneWrongByteCostsOneFrameWhenAnyLengthIsTaken) {
  Random random(10);
  const Bytes a = random_frame(random), b = random_frame(random), c = random_frame(random);
  const Bytes later = random_frame(random) + random_frame(random) + random_frame(random) + random_frame(random);
  for (std::size_t at = 0; at < 3 * 84; ++at) {
    for (int flip = 1; flip < 256; ++flip) {
      Bytes line = a + b + c;
      line[at] = static_cast<std::uint8_t>(line[at] ^ flip);
      Listener listener;
      // A wrong N may hold frames back for as long as the longest frame.
      listener.feed(line + later);
      ASSERT_EQ(listener.payloads.size(), 6U) << at << " " << flip;
    }
  }
}

TEST(StreamParserTest, ADroppedByteCostsOneFrame) {
  Random random(11);
  const Bytes a = random_frame(random), b = random_frame(random), c = random_frame(random);
  for (std::size_t at = 0; at < 84; ++at) {
    Bytes cut = b;
    cut.erase(cut.begin() + static_cast<std::ptrdiff_t>(at));
    Listener listener(81);
    listener.feed(a + cut + c);
    EXPECT_THAT(listener.payloads, ElementsAre(payload_of(a), payload_of(c))) << at;
  }
}

TEST(StreamParserTest, AStrayHeaderDoesntCostTheFrameBehindIt) {
  Random random(12);
  const Bytes frame = random_frame(random);
  for (const Bytes& stray :
       {Bytes{19}, Bytes{19, 19}, Bytes{19, 81}, Bytes{19, 81, 19}, Bytes{19, 0}, Bytes{19, 3, 7}}) {
    Listener strict(81);
    strict.feed(stray + frame);
    EXPECT_THAT(strict.payloads, ElementsAre(payload_of(frame))) << stray.size();
    EXPECT_EQ(strict.parser.counters().skipped, stray.size());
    Listener any;
    any.feed(stray + frame);
    EXPECT_THAT(any.payloads, ElementsAre(payload_of(frame))) << stray.size();
  }
}

TEST(StreamParserTest, AStrayWholeHeaderDoesntCostTheFrameBehindIt) {
  Random random(13);
  const Bytes frame = random_frame(random);
  Listener listener(81);
  listener.feed(Bytes{19, 81, 100} + frame + frame);
  EXPECT_THAT(listener.payloads, ElementsAre(payload_of(frame), payload_of(frame)));
  EXPECT_EQ(listener.parser.counters().lost, 1U);
}

TEST(StreamParserTest, FramesOfAnotherLengthAreToldApart) {
  Random random(14);
  const Bytes wanted = random_frame(random);
  const Bytes other = frame_of({PacketId::Wall, PacketId::Angle}, random_sensors(random, Model::Create2));
  Listener listener(81);
  listener.feed(other + wanted + other + other + wanted);
  EXPECT_THAT(listener.payloads, ElementsAre(payload_of(wanted), payload_of(wanted)));
  EXPECT_EQ(listener.parser.counters().other_length, 3U);
  EXPECT_EQ(listener.parser.counters().lost, 0U);
  EXPECT_EQ(listener.parser.counters().skipped, 3 * other.size());
}

TEST(StreamParserTest, NoiseDelaysNoFrameOfTheExpectedLength) {
  Random random(15);
  const Bytes frame = random_frame(random);
  Listener listener(81);
  listener.feed(Bytes{19, 255, 100} + frame);
  EXPECT_THAT(listener.payloads, ElementsAre(payload_of(frame)));
}

TEST(StreamParserTest, AChecksumOfZeroIsAChecksum) {
  // 19 + 2 + 15 + 220 = 256
  Listener listener;
  listener.feed(Bytes{19, 2, 15, 220, 0});
  EXPECT_THAT(listener.payloads, ElementsAre(Bytes{15, 220}));
  EXPECT_EQ(frame_of({PacketId::DirtDetect},
                     [] {
                       Sensors sensors;
                       sensors.set(PacketId::DirtDetect, 220);
                       return sensors;
                     }()),
            (Bytes{19, 2, 15, 220, 0}));
}

TEST(StreamParserTest, LengthsInsideAreNeverTrusted) {
  const auto closed = [](Bytes bytes) {
    bytes.push_back(static_cast<std::uint8_t>(-std::accumulate(bytes.begin(), bytes.end(), 0)));
    return bytes;
  };
  // Packet 43 has two bytes, N has room for one; an id that isn't; a second packet beyond the end; nothing inside.
  for (const Bytes& bytes : {closed({19, 2, 43, 0}), closed({19, 2, 59, 0}), closed({19, 4, 8, 0, 43, 0}),
                             closed({19, 3, 8, 0, 8}), closed({19, 0}), closed({19, 1, 8})}) {
    Listener listener;
    listener.feed(bytes + Bytes(300, 0));
    EXPECT_THAT(listener.payloads, IsEmpty()) << bytes.size();
    EXPECT_EQ(listener.parser.pending(), 0U);
  }
}

TEST(StreamParserTest, IdsOfOtherModelsAreNoFrames) {
  Random random(16);
  const Bytes frame = random_frame(random);
  Listener create1({}, Model::Create1);
  create1.feed(frame);
  EXPECT_THAT(create1.payloads, IsEmpty());
}

TEST(StreamParserTest, ValuesOutOfRangeAreNotStored) {
  Sensors sent;
  sent.set(PacketId::Wall, 9);
  sent.set(PacketId::Angle, 12);
  Sensors received;
  received.set(PacketId::Wall, 1);
  StreamParser parser(Model::Create2);
  parser.feed(frame_of({PacketId::Wall, PacketId::Angle}, sent), [&](const StreamFrame& frame) {
    EXPECT_EQ(decode(frame, Model::Create2, received), (DecodeStatus{true, 1}));
  });
  EXPECT_EQ(received[PacketId::Wall], 1);
  EXPECT_EQ(received[PacketId::Angle], 12);
}

TEST(StreamParserTest, ResetForgetsTheFrameThatHasBegun) {
  Random random(17);
  const Bytes frame = random_frame(random);
  Listener listener(81);
  listener.feed(std::span(frame).first(50));
  EXPECT_EQ(listener.parser.pending(), 50U);
  listener.parser.reset();
  listener.feed(frame);
  EXPECT_THAT(listener.payloads, ElementsAre(payload_of(frame)));
  EXPECT_EQ(listener.parser.counters().skipped, 50U);
}

TEST(StreamEncoderTest, OfAllPacketsHasThePayloadThatIsExpectedOfIt) {
  for (const Model model : {Model::Create2, Model::Create1}) {
    const Stream all = stream_of_all(model);
    Sensors empty;
    const Bytes frame = frame_of({all.ids.begin(), all.ids.end()}, empty, model);
    EXPECT_EQ(payload_of(frame).size(), payload_of_all(model));
    EXPECT_GT(payload_of_all(model), 50);
    Listener listener(payload_of_all(model), model);
    listener.feed(frame);
    EXPECT_THAT(listener.payloads, ElementsAre(payload_of(frame)));
  }
}

TEST(StreamEncoderTest, RefusesWhatIsNoFrame) {
  Bytes out(kMaxStreamFrame);
  const Sensors sensors;
  EXPECT_EQ(encode_stream_frame(std::vector<SensorId>{100}, sensors, Model::Create2, std::span(out).first(83)), 0U);
  EXPECT_EQ(encode_stream_frame(std::vector<SensorId>{100}, sensors, Model::Create2, std::span(out).first(84)), 84U);
  EXPECT_EQ(encode_stream_frame(std::vector<SensorId>{100}, sensors, Model::Create1, out), 0U);
  EXPECT_EQ(encode_stream_frame(std::vector<SensorId>{100}, sensors, Model::Create2, {}), 0U);
}

TEST(StreamEncoderTest, TheLongestFrameHas255BytesInside) {
  Bytes out(1000);
  // 3 * 81 + 4 * 3 = 255
  std::vector<SensorId> ids{100, 100, 100, 43, 43, 43, 43};
  EXPECT_EQ(encode_stream_frame(ids, Sensors{}, Model::Create2, out), kMaxStreamFrame);
  ids.push_back(PacketId::Wall);
  EXPECT_EQ(encode_stream_frame(ids, Sensors{}, Model::Create2, out), 0U);
}

}  // namespace
}  // namespace scrubjay::oi

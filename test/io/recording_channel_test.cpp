#include <gtest/gtest.h>

#include <deque>
#include <io/temporary_folder.hpp>
#include <scrubjay/io/recording.hpp>

#include "recorded_chunks.hpp"

namespace scrubjay {
namespace {

/// A channel that gives prepared reads, then is closed, and keeps what was written.
class ScriptedChannel : public ByteChannel {
 public:
  explicit ScriptedChannel(const std::vector<Chunk>& reads) : reads_(reads.begin(), reads.end()) {}
  ByteRead read(std::span<std::uint8_t> buffer) override {
    if (reads_.empty()) return {.count = 0, .stamp = 0.0, .open = false};
    const Chunk chunk = reads_.front();
    reads_.pop_front();
    std::copy(chunk.bytes.begin(), chunk.bytes.end(), buffer.begin());
    return {.count = chunk.bytes.size(), .stamp = chunk.stamp, .open = true};
  }
  bool write(std::span<const std::uint8_t> bytes) override {
    written.insert(written.end(), bytes.begin(), bytes.end());
    return link_is_up;
  }

  Bytes written;
  bool link_is_up = true;

 private:
  std::deque<Chunk> reads_;
};

std::vector<Chunk> drain(ByteChannel& channel, std::size_t buffer_size) {
  std::vector<Chunk> chunks;
  while (true) {
    Bytes buffer(buffer_size);
    const ByteRead got = channel.read(buffer);
    if (!got.open) return chunks;
    buffer.resize(got.count);
    if (got.count > 0) chunks.push_back({Direction::Received, got.stamp, buffer});
  }
}

TEST(RecordingChannelTest, ReplaysWhatTheLiveReaderSawToTheBit) {
  const TemporaryFolder folder;
  std::vector<Chunk> live_script;
  for (int i = 0; i < 500; ++i)
    live_script.push_back({Direction::Received, i * (1.0 / 66.7), Bytes(std::size_t(i % 3), 9)});
  ScriptedChannel robot(live_script);
  RecordingWriter writer(folder / "run.oilog", "");
  RecordingChannel recorded(robot, writer);
  const std::vector<Chunk> live = drain(recorded, 256);
  writer.close();
  ASSERT_GT(live.size(), 300u);
  EXPECT_NEAR(live.back().stamp, live_script.back().stamp, 1e-9);

  RecordingReader reader(folder / "run.oilog");
  RecordedChannel replay(reader);
  EXPECT_EQ(drain(replay, 256), live);
}

TEST(RecordingChannelTest, KeepsWhatIsSentWithTheStampOfTheLastRead) {
  const TemporaryFolder folder;
  ScriptedChannel robot({{Direction::Received, 0.5, {1}}});
  RecordingWriter writer(folder / "run.oilog", "");
  RecordingChannel channel(robot, writer);
  Bytes buffer(10);
  EXPECT_TRUE(channel.write(Bytes{128}));
  channel.read(buffer);
  robot.link_is_up = false;
  EXPECT_FALSE(channel.write(Bytes{131, 132}));
  writer.flush();
  EXPECT_EQ(robot.written, (Bytes{128, 131, 132}));
  RecordingReader reader(folder / "run.oilog");
  EXPECT_EQ(read_all(reader),
            (std::vector<Chunk>{
                {Direction::Sent, 0.0, {128}}, {Direction::Received, 0.5, {1}}, {Direction::Sent, 0.5, {131, 132}}}));
}

TEST(RecordedChannelTest, BringsNothingWhereSomethingWasSentForWantOfBytes) {
  const TemporaryFolder folder;
  write_all(folder / "run.oilog", {{Direction::Sent, 0.5, {128}},
                                   {Direction::Received, 1.0, {1}},
                                   {Direction::Sent, 1.0, {142, 100}},
                                   {Direction::Sent, 1.06, {142, 100}},
                                   {Direction::Sent, 1.06, {142, 100}},
                                   {Direction::Received, 1.07, {2}}});
  RecordingReader reader(folder / "run.oilog");
  RecordedChannel channel(reader);
  Bytes buffer(4);
  const auto read = [&] {
    const ByteRead got = channel.read(buffer);
    EXPECT_TRUE(got.open);
    return std::pair(got.stamp, got.count);
  };
  EXPECT_EQ(read(), std::pair(1.0, std::size_t{1}));
  EXPECT_EQ(read(), std::pair(1.06, std::size_t{0}));
  EXPECT_EQ(read(), std::pair(1.07, std::size_t{1}));
  EXPECT_FALSE(channel.read(buffer).open);
}

TEST(RecordedChannelTest, HandsOutALongChunkInPiecesAndIgnoresCommands) {
  const TemporaryFolder folder;
  write_all(
      folder / "run.oilog",
      {{Direction::Sent, 0.0, {7, 7}}, {Direction::Received, 1.0, {1, 2, 3, 4, 5}}, {Direction::Received, 2.0, {6}}});
  RecordingReader reader(folder / "run.oilog");
  RecordedChannel channel(reader);
  EXPECT_TRUE(channel.write(Bytes{1}));
  EXPECT_EQ(drain(channel, 2), (std::vector<Chunk>{{Direction::Received, 1.0, {1, 2}},
                                                   {Direction::Received, 1.0, {3, 4}},
                                                   {Direction::Received, 1.0, {5}},
                                                   {Direction::Received, 2.0, {6}}}));
  Bytes buffer(4);
  EXPECT_FALSE(channel.read(buffer).open) << "and stays closed";
}

}  // namespace
}  // namespace scrubjay

#include <gmock/gmock.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/mcap.hpp>

#include "bag_content.hpp"
#include "mcap_file.hpp"

namespace scrubjay::mcap_by_hand {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kDeclared =
    schema(1, "std_msgs/msg/String", "string data\n") + channel(1, 1, "/a") + channel(2, 1, "/b");

/// Topic, time and bytes of each message.
std::vector<std::string> messages_of(McapReader& reader) {
  std::vector<std::string> messages;
  while (const auto message = reader.next()) {
    const std::string bytes(reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size());
    messages.push_back(reader.topics()[message->topic].name + " " + std::to_string(message->nanoseconds) + " " + bytes);
  }
  return messages;
}

McapReader reader_of(std::string_view file) {
  return {bytes(file), "run.mcap"};
}

TEST(McapReaderTest, ReadsMessagesWithoutChunks) {
  McapReader reader = reader_of(file(kDeclared + message(1, 5, "x") + message(2, 6, "y") + message(1, 7, "z")));
  ASSERT_EQ(reader.topics().size(), 2u);
  EXPECT_EQ(reader.topics()[0], (BagTopic{"/a", "std_msgs/msg/String", "string data\n", "", {}}));
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 5 x", "/b 6 y", "/a 7 z"));
  EXPECT_FALSE(reader.cut()) << "nobody needs a summary";
}

TEST(McapReaderTest, ReadsChunksOfEveryCompression) {
  const std::string records = kDeclared + message(1, 5, std::string(1000, 'x')) + message(2, 6, "y");
  for (const Chunk& of : {Chunk{5, records, "", "", checksum(records)}, Chunk{5, records, "lz4", lz4(records)},
                          Chunk{5, records, "zstd", zstd(records), checksum(records)}}) {
    McapReader reader = reader_of(file(chunk(of) + chunk({7, message(1, 7, "z"), "", ""})));
    EXPECT_EQ(reader.topics().size(), 2u) << "known before anything is read, wherever they are declared";
    EXPECT_THAT(messages_of(reader), ElementsAre("/a 5 " + std::string(1000, 'x'), "/b 6 y", "/a 7 z"));
    EXPECT_FALSE(reader.cut()) << of.compression;
  }
}

TEST(McapReaderTest, GivesMessagesByTheirTimesAcrossChunks) {
  McapReader reader =
      reader_of(file(kDeclared + chunk({3, message(1, 9, "c") + message(1, 3, "a"), "", ""}) + message(2, 4, "alone") +
                     chunk({2, message(2, 2, "b") + message(2, 9, "d"), "", ""}) +
                     chunk({20, message(1, 20, "e"), "", ""}) + chunk({1, message(1, 1, "f"), "", ""})));
  EXPECT_THAT(messages_of(reader),
              ElementsAre("/a 1 f", "/b 2 b", "/a 3 a", "/b 4 alone", "/a 9 c", "/b 9 d", "/a 20 e"));
  EXPECT_FALSE(reader.cut());
}

TEST(McapReaderTest, KeepsTheOrderOfTheFileAmongEqualTimes) {
  McapReader reader = reader_of(file(kDeclared + chunk({5, message(1, 5, "1") + message(2, 5, "2"), "", ""}) +
                                     chunk({5, message(1, 5, "3") + message(2, 5, "4"), "", ""})));
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 5 1", "/b 5 2", "/a 5 3", "/b 5 4"));
  McapReader later = reader_of(file(kDeclared + chunk({5, message(1, 5, "2"), "", ""}) +
                                    chunk({4, message(1, 4, "1") + message(2, 5, "3"), "", ""})));
  EXPECT_THAT(messages_of(later), ElementsAre("/a 4 1", "/a 5 2", "/b 5 3"));
}

TEST(McapReaderTest, GivesMessagesWithoutChunksByTheirTimes) {
  McapReader reader = reader_of(file(kDeclared + message(1, 9, "d") + message(1, 3, "b") + message(2, 1, "a") +
                                     chunk({5, message(2, 5, "c"), "", ""})));
  EXPECT_THAT(messages_of(reader), ElementsAre("/b 1 a", "/a 3 b", "/b 5 c", "/a 9 d"));
}

TEST(McapReaderTest, TakesSeveralWritersOfATopicTogether) {
  McapReader reader = reader_of(file(kDeclared + channel(7, 1, "/a") + message(1, 1, "x") + message(7, 2, "y")));
  EXPECT_EQ(reader.topics().size(), 2u);
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 1 x", "/a 2 y"));
}

TEST(McapReaderTest, LeavesOutWhatIsNotRos2s) {
  McapReader reader =
      reader_of(file(kDeclared + channel(7, 0, "/j", "json") + message(7, 1, "{}") + message(1, 2, "x")));
  EXPECT_EQ(reader.topics().size(), 2u);
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 2 x"));
  EXPECT_EQ(message_of([] { reader_of(file(channel(7, 0, "/j", "json") + channel(8, 0, "/p", "protobuf"))); }),
            "run.mcap: its messages are json, protobuf; want ROS 2's encoding, cdr");
}

TEST(McapReaderTest, StepsOverRecordsThatItDoesNotKnow) {
  McapReader reader = reader_of(file(kDeclared + record(0x80, "ours") + record(9, "an attachment") +
                                     chunk({1, record(0x90, "?") + message(1, 1, "x"), "", ""})));
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 1 x"));
  EXPECT_FALSE(reader.cut());
}

TEST(McapReaderTest, RefusesOtherFilesAndOtherVersions) {
  const auto open = [](const std::string& content) { return message_of([&] { reader_of(content); }); };
  EXPECT_EQ(open("P5 2 2 255\n1234"), "run.mcap: not an MCAP file; want one that begins with \\x89MCAP0\\r\\n");
  EXPECT_THAT(open("\x89MCAP0\n0123456789"), HasSubstr("not an MCAP file")) << "a transfer as text broke it";
  EXPECT_THAT(open("\x89MCAP"), HasSubstr("not an MCAP file"));
  EXPECT_THAT(open(""), HasSubstr("not an MCAP file"));
  EXPECT_EQ(open("\x89MCAP1\r\n"), "run.mcap: MCAP file of version 1; this program reads version 0");
  EXPECT_EQ(open(file(chunk({1, "", "brotli", "?"}))), "run.mcap: packed with brotli; want zstd, lz4 or nothing");
  EXPECT_EQ(message_of([] { McapReader("no/such.mcap"); }), "no/such.mcap: cannot read: No such file or directory");
}

TEST(McapReaderTest, YieldsAllWholeChunksWhereverItIsCut) {
  const TemporaryFolder folder;
  {
    McapWriter writer(folder / "run.mcap", {.chunk_size = 100});
    writer.add(kMapTopic);
    for (int i = 0; i < 10; ++i) writer.write(0, i, bytes_of(std::string(60, static_cast<char>('0' + i))));
  }
  const std::string whole = content_of(folder / "run.mcap");
  std::size_t before = 0;
  for (std::size_t size = kMagic.size(); size <= whole.size(); ++size) {
    McapReader reader = reader_of(whole.substr(0, size));
    const std::size_t count = messages_of(reader).size();
    EXPECT_GE(count, before) << "more bytes, no fewer messages";
    before = count;
    EXPECT_EQ(reader.cut(), size < whole.size()) << size;
  }
  EXPECT_EQ(before, 10u);
}

TEST(McapReaderTest, NeverGivesADamagedMessage) {
  const TemporaryFolder folder;
  std::vector<std::string> written;
  {
    McapWriter writer(folder / "run.mcap", {.chunk_size = 200});
    writer.add(kMapTopic);
    for (int i = 0; i < 10; ++i) {
      const std::string bytes(60, static_cast<char>('0' + i));
      writer.write(0, i, bytes_of(bytes));
      written.push_back("/map " + std::to_string(i) + " " + bytes);
    }
  }
  const std::string whole = content_of(folder / "run.mcap");
  for (std::size_t place = kMagic.size(); place < whole.size(); ++place) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x10);
    McapReader reader = reader_of(damaged);
    std::vector<std::string> read = messages_of(reader);
    // A chunk whose own times are wrong may be read too early or too late.
    std::sort(read.begin(), read.end());
    EXPECT_TRUE(std::includes(written.begin(), written.end(), read.begin(), read.end())) << place;
    EXPECT_TRUE(read.size() == written.size() || reader.cut()) << place << ": lost, and nothing said";
  }
}

TEST(McapReaderTest, StopsAtTheFirstDamagedChunk) {
  McapReader reader =
      reader_of(file(kDeclared + chunk({1, message(1, 1, "x"), "", ""}) +
                     chunk({2, message(1, 2, "y"), "", "", 12345}) + chunk({3, message(1, 3, "z"), "", ""})));
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 1 x"));
  EXPECT_TRUE(reader.cut());
}

TEST(McapReaderTest, StopsAtAMessageOfAChannelThatWasNeverDeclared) {
  McapReader reader = reader_of(file(kDeclared + message(1, 1, "x") + message(9, 2, "y") + message(1, 3, "z")));
  EXPECT_THAT(messages_of(reader), ElementsAre("/a 1 x"));
  EXPECT_TRUE(reader.cut());
}

TEST(McapReaderTest, ChecksTheDatasOwnChecksumWhereMessagesHaveNoOther) {
  const std::string data = kMagic + header() + kDeclared + message(1, 1, "x");
  const auto cut = [&data](std::uint32_t checksum) {
    McapReader reader = reader_of(data + data_end(checksum) + footer());
    EXPECT_THAT(messages_of(reader), ElementsAre("/a 1 x"));
    return reader.cut();
  };
  EXPECT_FALSE(cut(checksum(data)));
  EXPECT_TRUE(cut(checksum(data) + 1));
}

TEST(McapReaderTest, ChecksTheSummarysChecksum) {
  const std::string data = kMagic + header() + kDeclared + message(1, 1, "x") + data_end();
  const std::string summary = kDeclared;
  const auto cut = [&](bool right) {
    const std::string summed = summary + footer(data.size()).substr(0, 9 + 16);
    McapReader reader = reader_of(data + summary + footer(data.size(), checksum(summed) + (right ? 0 : 1)));
    EXPECT_THAT(messages_of(reader), ElementsAre("/a 1 x"));
    return reader.cut();
  };
  EXPECT_FALSE(cut(true));
  EXPECT_TRUE(cut(false));
}

/// A chunk that lies about its size takes no memory for that, and ends the reading.
TEST(McapReaderTest, BelievesNoSizeThatCannotBe) {
  const std::string records = message(1, 1, "x");
  constexpr std::uint64_t kGib = std::uint64_t{1} << 30;
  for (const std::uint64_t size : {std::uint64_t{1}, kGib, kGib * kGib}) {
    for (const Chunk& of : {Chunk{1, records, "", "", 0, size}, Chunk{1, records, "lz4", lz4(records), 0, size},
                            Chunk{1, records, "zstd", zstd(records), 0, size}}) {
      McapReader reader = reader_of(file(kDeclared + chunk(of)));
      EXPECT_THAT(messages_of(reader), IsEmpty());
      EXPECT_TRUE(reader.cut()) << of.compression << size;
    }
  }
}

TEST(McapReaderTest, UnpacksNoMoreThanAChunkMayTake) {
  // A bomb: 2 GiB of zeros, in a few dozen kilobytes.
  const std::string records = message(1, 1, "x");
  const std::string zeros = zstd(std::string(std::size_t{1} << 21, '\0'));
  std::string bomb = zstd(records);
  for (int i = 0; i < 1024; ++i) bomb += zeros;
  const std::uint64_t size = records.size() + (std::uint64_t{1} << 31);
  ASSERT_LT(bomb.size(), 1'000'000u);
  McapReader reader = reader_of(file(kDeclared + chunk({1, "", "zstd", bomb, 0, size})));
  EXPECT_THAT(messages_of(reader), IsEmpty());
  EXPECT_TRUE(reader.cut());
}

TEST(McapReaderTest, ReadsFilesAsWellAsMemory) {
  const TemporaryFolder folder;
  McapReader reader(
      folder.write("run.mcap", file(kDeclared + message(1, 1, std::string(3'000'000, 'x')) + message(2, 2, "y"))));
  const std::vector<std::string> messages = messages_of(reader);
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0].size(), 3'000'005u);
  EXPECT_EQ(messages[1], "/b 2 y");
}

}  // namespace
}  // namespace scrubjay::mcap_by_hand

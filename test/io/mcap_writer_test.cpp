#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <io/temporary_folder.hpp>
#include <random>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>
#include <scrubjay/io/mcap.hpp>

#include "bag_content.hpp"
#include "mcap_file.hpp"

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::int64_t kSecond = 1'000'000'000;

BagContent content_of_mcap(const std::filesystem::path& path) {
  McapReader reader(path);
  BagContent content;
  while (const auto message = reader.next()) {
    const std::string bytes(reinterpret_cast<const char*>(message->bytes.data()), message->bytes.size());
    content.messages.push_back(reader.topics()[message->topic].name + " " + std::to_string(message->nanoseconds) + " " +
                               bytes);
  }
  content.topics = reader.topics();
  content.cut = reader.cut();
  return content;
}

/// rosbag2's record.
std::string metadata_of(const BagMetadata& metadata) {
  return mcap_by_hand::metadata("rosbag2", "serialized_metadata", bag_metadata_text(metadata));
}

class McapWriterTest : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const std::filesystem::path path_ = folder_ / "run.mcap";
};

TEST_F(McapWriterTest, GivesBackWhatWasWritten) {
  for (const bool zstd : {false, true}) {
    McapWriter writer(path_, {.zstd = zstd});
    EXPECT_EQ(writer.add(kMapTopic), 0u);
    EXPECT_EQ(writer.add(kScanTopic), 1u);
    writer.write(0, 5, bytes_of("map"));
    writer.write(1, 7 * kSecond, bytes_of("scan"));
    writer.write(1, 7 * kSecond, bytes_of("scan at the same time"));
    writer.write(1, 8 * kSecond, {});
    writer.close();
    const BagContent content = content_of_mcap(path_);
    EXPECT_THAT(content.topics, ElementsAre(kMapTopic, kScanTopic));
    EXPECT_THAT(content.messages, ElementsAre("/map 5 map", "/scan 7000000000 scan",
                                              "/scan 7000000000 scan at the same time", "/scan 8000000000 "));
    EXPECT_FALSE(content.cut);
  }
}

/// Every byte of a file with two chunks, as the specification has it.
TEST_F(McapWriterTest, LaysOutAFileAsSpecified) {
  using namespace mcap_by_hand;
  McapWriter writer(path_, {.chunk_size = 1});
  BagMetadata metadata{"mcap", "run.mcap"};
  std::string expected = kMagic + header("scrubjay");
  std::string metadata_indexes;
  const auto put_metadata = [&] {
    const std::string record_of_it = metadata_of(metadata);
    metadata_indexes += record(
        13, number(std::uint64_t{expected.size()}) + number(std::uint64_t{record_of_it.size()}) + text("rosbag2"));
    expected += record_of_it;
  };
  put_metadata();

  const auto declared = [](std::uint16_t id, const BagTopic& topic) {
    return channel(
        id, id, topic.name, "cdr",
        text("offered_qos_profiles") + text(qos_text(topic.qos)) + text("topic_type_hash") + text(topic.hash));
  };
  const std::string schemas[] = {schema(1, kMapTopic.type, kMapTopic.definition),
                                 schema(2, kScanTopic.type, kScanTopic.definition)};
  const std::string channels[] = {declared(1, kMapTopic), declared(2, kScanTopic)};
  const std::string messages[] = {message(1, 7, "map"), message(1, 9, "", 1)};
  const std::uint64_t times[] = {7, 9};
  std::string chunk_indexes;
  for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
    const BagTopic& topic = i == 0 ? kMapTopic : kScanTopic;
    writer.add(topic);
    metadata.add(topic);
    writer.write(0, static_cast<std::int64_t>(times[i]), bytes_of(i == 0 ? "map" : ""));
    metadata.count(0, static_cast<std::int64_t>(times[i]));
    const std::string records = schemas[i] + channels[i] + messages[i];
    const std::string chunk_of_it = chunk({times[i], records, "", "", checksum(records), 0, times[i]});
    const std::string index = message_index(1, times[i], records.size() - messages[i].size());
    const auto begin = std::uint64_t{expected.size()};
    expected += chunk_of_it;
    chunk_indexes +=
        record(8, number(times[i]) + number(times[i]) + number(begin) + number(std::uint64_t{chunk_of_it.size()}) +
                      text(number(std::uint16_t{1}) + number(std::uint64_t{expected.size()})) +
                      number(std::uint64_t{index.size()}) + text("") + number(std::uint64_t{records.size()}) +
                      number(std::uint64_t{records.size()}));
    expected += index;
    EXPECT_EQ(content_of(path_), expected + data_end() + footer());
  }
  writer.close();

  put_metadata();
  expected += data_end();
  const auto none = number(std::uint32_t{0});
  const auto two = number(std::uint32_t{2});
  const std::string statistics = record(11, number(std::uint64_t{2}) + number(std::uint16_t{2}) + two + none + two +
                                                two + number(times[0]) + number(times[1]) +
                                                text(number(std::uint16_t{1}) + number(std::uint64_t{2}) +
                                                     number(std::uint16_t{2}) + number(std::uint64_t{0})));
  const auto summary_at = std::uint64_t{expected.size()};
  std::string offsets;
  for (const auto& [opcode, group] : {std::pair<std::uint8_t, std::string>{3, schemas[0] + schemas[1]},
                                      {4, channels[0] + channels[1]},
                                      {11, statistics},
                                      {8, chunk_indexes},
                                      {13, metadata_indexes}}) {
    offsets +=
        record(14, number(opcode) + number(std::uint64_t{expected.size()}) + number(std::uint64_t{group.size()}));
    expected += group;
  }
  const auto offsets_at = std::uint64_t{expected.size()};
  expected += offsets;
  std::string end = record(2, number(summary_at) + number(offsets_at) + none);
  end.resize(end.size() - none.size());
  expected += end;
  expected += number(checksum(expected.substr(summary_at))) + kMagic;
  EXPECT_EQ(content_of(path_), expected);
}

TEST_F(McapWriterTest, TakesTopicsAtAnyTimeAndEachOnce) {
  McapWriter writer(path_);
  EXPECT_EQ(writer.add(kMapTopic), 0u);
  writer.write(0, 0, bytes_of("a"));
  EXPECT_EQ(writer.add(kScanTopic), 1u);
  EXPECT_EQ(writer.add(kMapTopic), 0u);
  BagTopic another = kMapTopic;
  another.name = "/global_costmap/costmap";
  EXPECT_EQ(writer.add(another), 2u);
  writer.write(2, 1, bytes_of("b"));
  writer.write(1, 2 * kSecond, bytes_of("c"));
  writer.close();
  const BagContent content = content_of_mcap(path_);
  EXPECT_THAT(content.topics, ElementsAre(kMapTopic, kScanTopic, another));
  EXPECT_THAT(content.messages, ElementsAre("/map 0 a", "/global_costmap/costmap 1 b", "/scan 2000000000 c"));
}

TEST_F(McapWriterTest, WritesStampsBeforeZeroAsZero) {
  McapWriter writer(path_);
  writer.add(kScanTopic);
  writer.write(0, -5, bytes_of("a"));
  writer.close();
  EXPECT_THAT(content_of_mcap(path_).messages, ElementsAre("/scan 0 a"));
}

TEST_F(McapWriterTest, GivesBackManyMessagesOfAllSizes) {
  std::mt19937 random(7);
  for (const bool zstd : {false, true}) {
    std::vector<std::string> expected;
    McapWriter writer(path_, {.chunk_size = 5000, .zstd = zstd});
    writer.add(kMapTopic);
    writer.add(kScanTopic);
    for (int i = 0; i < 2000; ++i) {
      const std::size_t topic = random() % 2;
      const std::string bytes(random() % (i % 100 == 0 ? 20'000 : 100), static_cast<char>('a' + random() % 26));
      writer.write(topic, i * 1'000'000LL, bytes_of(bytes));
      expected.push_back((topic == 0 ? "/map " : "/scan ") + std::to_string(i * 1'000'000LL) + " " + bytes);
    }
    writer.close();
    EXPECT_EQ(content_of_mcap(path_).messages, expected);
  }
}

TEST_F(McapWriterTest, PacksWhatBecomesSmaller) {
  const auto size_with = [this](bool zstd) {
    McapWriter writer(path_, {.zstd = zstd});
    writer.add(kMapTopic);
    writer.write(0, 0, bytes_of(std::string(500'000, 'x')));
    writer.close();
    return std::filesystem::file_size(path_);
  };
  EXPECT_LT(size_with(true), size_with(false) / 100);
}

TEST_F(McapWriterTest, HandsOverASecondOfStampsAtTheLatest) {
  McapWriter writer(path_);
  writer.add(kScanTopic);
  for (int i = 0; i < 300; ++i) writer.write(0, i * kSecond / 100, bytes_of("scan"));
  EXPECT_THAT(content_of_mcap(path_).messages, SizeIs(testing::Ge(200u)));
}

TEST_F(McapWriterTest, HandsOverWhenAClockWasSetBack) {
  McapWriter writer(path_);
  writer.add(kScanTopic);
  writer.write(0, 100 * kSecond, bytes_of("a"));
  writer.write(0, 5 * kSecond, bytes_of("b"));
  EXPECT_THAT(content_of_mcap(path_).messages, ElementsAre("/scan 5000000000 b", "/scan 100000000000 a"));
}

TEST_F(McapWriterTest, HandsOverWhatFillsAChunkAtOnce) {
  McapWriter writer(path_, {.chunk_size = 1000});
  writer.add(kMapTopic);
  writer.write(0, 5, bytes_of(std::string(2000, 'x')));
  EXPECT_THAT(content_of_mcap(path_).messages, SizeIs(1));
}

TEST_F(McapWriterTest, LeavesAFileThatEndsAsItShouldWhenItIsKilled) {
  McapWriter writer(path_, {.chunk_size = 100});
  const BagContent nothing = content_of_mcap(path_);
  EXPECT_THAT(nothing.topics, IsEmpty());
  EXPECT_TRUE(nothing.cut);
  writer.add(kScanTopic);
  for (int i = 0; i < 10; ++i) {
    writer.write(0, i, bytes_of(std::string(100, 'x')));
    // What a kill at this moment leaves.
    EXPECT_TRUE(content_of(path_).ends_with(mcap_by_hand::data_end() + mcap_by_hand::footer()));
    const BagContent content = content_of_mcap(path_);
    EXPECT_THAT(content.topics, ElementsAre(kScanTopic));
    EXPECT_THAT(content.messages, SizeIs(static_cast<std::size_t>(i) + 1));
    EXPECT_TRUE(content.cut) << "it isn't closed yet";
  }
  writer.close();
  EXPECT_FALSE(content_of_mcap(path_).cut);
}

TEST_F(McapWriterTest, TouchesNothingAgainThatWasHandedOver) {
  const std::string end = mcap_by_hand::data_end() + mcap_by_hand::footer();
  McapWriter writer(path_, {.chunk_size = 100});
  writer.add(kScanTopic);
  std::string before;
  for (int i = 0; i < 10; ++i) {
    writer.write(0, i, bytes_of(std::string(100, 'x')));
    const std::string now = content_of(path_);
    EXPECT_TRUE(now.starts_with(before));
    before = now.substr(0, now.size() - end.size());
  }
  writer.close();
  EXPECT_TRUE(content_of(path_).starts_with(before));
}

TEST_F(McapWriterTest, TellsRosbag2AboutTheBagAtBothEnds) {
  McapWriter writer(path_);
  const std::string first = content_of(path_);
  EXPECT_THAT(first, AllOf(HasSubstr("serialized_metadata"), HasSubstr("\nmessage_count: 0\n")));
  EXPECT_THAT(first, HasSubstr("version: 8")) << "or else policies as numbers would mean nothing to it";
  writer.add(kMapTopic);
  writer.write(0, 5, bytes_of("map"));
  writer.close();
  const std::string file = content_of(path_);
  EXPECT_THAT(file.substr(first.size()), AllOf(HasSubstr("serialized_metadata"), HasSubstr("\nmessage_count: 1\n")));
  EXPECT_THAT(file, testing::Not(HasSubstr("rosbag2_bagfile_information"))) << "its own record goes without the root";
}

TEST_F(McapWriterTest, KeepsAnOlderBagUntilThereIsAWholeNewOne) {
  const auto write = [](McapWriter& writer, std::string_view text) {
    writer.add(kMapTopic);
    writer.write(0, 0, bytes_of(text));
  };
  {
    McapWriter writer(path_);
    write(writer, "first");
  }
  {
    McapWriter writer(path_);
    write(writer, "second");
    EXPECT_THAT(content_of_mcap(folder_ / "run.mcap~").messages, ElementsAre("/map 0 first"));
    std::filesystem::copy_file(path_, folder_ / "killed");
  }
  EXPECT_THAT(content_of_mcap(path_).messages, ElementsAre("/map 0 second"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.mcap~"));
  // A killed one gives way, and the whole one beside it stays.
  std::filesystem::rename(path_, folder_ / "run.mcap~");
  std::filesystem::rename(folder_ / "killed", path_);
  McapWriter writer(path_);
  EXPECT_THAT(content_of_mcap(folder_ / "run.mcap~").messages, ElementsAre("/map 0 second"));
}

TEST_F(McapWriterTest, SaysThatTheFileCantBeMade) {
  EXPECT_THAT(message_of([] { McapWriter("no/such/run.mcap"); }),
              AllOf(HasSubstr("no/such/run.mcap: cannot write the bag"), HasSubstr("No such file or directory")));
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_THAT(message_of([] { McapWriter("/dev/full"); }), HasSubstr("No space left on device"));
}

TEST_F(McapWriterTest, GoesOnWhenTheDiscIsFullAndTellsItOnce) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{20'000, 20'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    McapWriter writer(path_, {.chunk_size = 1000});
    writer.add(kScanTopic);
    for (int i = 0; i < 1000; ++i) writer.write(0, i, bytes_of(std::string(100, 'x')));
    const std::string first = message_of([&] { writer.close(); });
    const std::string second = message_of([&] { writer.close(); });
    ::_exit(first.find("File too large") != std::string::npos && second.empty() ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(content_of(path_).ends_with(mcap_by_hand::footer())) << "half a chunk is taken away again";
  const BagContent content = content_of_mcap(path_);
  EXPECT_THAT(content.messages, SizeIs(testing::Ge(100u)));
  EXPECT_TRUE(content.cut);
}

TEST_F(McapWriterTest, PutsTheOlderBagBackWhenTheDiscIsFull) {
  {
    McapWriter writer(path_);
    writer.add(kMapTopic);
    writer.write(0, 0, bytes_of("first"));
  }
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{20'000, 20'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    McapWriter writer(path_);
    writer.write(writer.add(kMapTopic), 0, bytes_of(std::string(30'000, 'x')));
    ::_exit(message_of([&] { writer.close(); }).empty() ? 1 : 0);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_THAT(content_of_mcap(path_).messages, ElementsAre("/map 0 first"));
  EXPECT_EQ(folder_.file_count(), 1u);
}

TEST_F(McapWriterTest, WritesIntoAPipeToo) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    McapWriter writer(path_, {.chunk_size = 100});
    writer.add(kScanTopic);
    for (int i = 0; i < 5; ++i) writer.write(0, i, bytes_of(std::string(100, 'x')));
    writer.close();
    ::_exit(0);
  }
  const std::string file = content_of(path_);
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  McapReader reader(mcap_by_hand::bytes(file), "pipe");
  int messages = 0;
  while (reader.next()) ++messages;
  EXPECT_EQ(messages, 5);
  EXPECT_FALSE(reader.cut());
}

}  // namespace
}  // namespace scrubjay

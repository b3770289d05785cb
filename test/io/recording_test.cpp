#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <io/temporary_folder.hpp>
#include <random>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recording.hpp>

#include "recorded_chunks.hpp"

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::ptrdiff_t kEndSize = 7;  // of the last record: kind, stamp, size and checksum

Bytes file_bytes(const std::filesystem::path& path) {
  const std::string content = content_of(path);
  return {content.begin(), content.end()};
}

/// A run as a robot's link sees it: frames of 84 bytes of which few change, some torn in two, commands now and then.
std::vector<Chunk> some_run(unsigned seed, int ticks) {
  std::mt19937 random(seed);
  Bytes frame(84, 19);
  std::vector<Chunk> chunks;
  for (int tick = 0; tick < ticks; ++tick) {
    const double stamp = static_cast<double>(tick * 15'000'000LL + static_cast<int>(random() % 1000)) / 1e9;
    for (auto i = random() % 6; i > 0; --i) frame[random() % frame.size()] = static_cast<std::uint8_t>(random());
    const std::size_t torn = random() % 5 == 0 ? 62 : frame.size();
    chunks.push_back({Direction::Received, stamp, Bytes(frame.begin(), frame.begin() + static_cast<long>(torn))});
    if (torn < frame.size()) {
      chunks.push_back({Direction::Received, stamp, Bytes(frame.begin() + static_cast<long>(torn), frame.end())});
    }
    if (random() % 4 == 0)
      chunks.push_back({Direction::Sent, stamp, {145, 0, 100, 0, static_cast<std::uint8_t>(random())}});
    if (random() % 50 == 0) chunks.push_back({Direction::Received, stamp, Bytes(300 + random() % 700, 7)});
  }
  return chunks;
}

TEST(RecordingTest, ReadsBackExactlyWhatWasWritten) {
  const TemporaryFolder folder;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<Chunk> chunks = some_run(seed, 300);
    write_all(folder / "run.oilog", chunks);
    RecordingReader reader(folder / "run.oilog");
    EXPECT_EQ(reader.scenario(), "seed: 7\n");
    EXPECT_EQ(read_all(reader), chunks) << seed;
    EXPECT_FALSE(reader.cut());
  }
}

TEST(RecordingTest, IsLaidOutAsDocumented) {
  const TemporaryFolder folder;
  write_all(folder / "run.oilog", {{Direction::Received, 0.015, {0, 0, 5, 0}},
                                   {Direction::Received, 0.015, {0, 0, 6, 0}},
                                   {Direction::Sent, 0.014999999, {128}}});
  Bytes file = file_bytes(folder / "run.oilog");
  const auto next = [&file](std::size_t count) {
    const Bytes front(file.begin(), file.begin() + static_cast<long>(count));
    file.erase(file.begin(), file.begin() + static_cast<long>(count));
    return front;
  };
  EXPECT_EQ(next(9), (Bytes{0x89, 'O', 'I', 'L', 'O', 'G', '\r', '\n', 1}));
  EXPECT_EQ(next(11), (Bytes{1, 0, 8, 's', 'e', 'e', 'd', ':', ' ', '7', '\n'}));
  next(4);
  EXPECT_EQ(next(6), (Bytes{2, 0x80, 0x87, 0xa7, 0x0e, 4})) << "15000000 ns are 30000000 in zigzag";
  EXPECT_EQ(next(4), (Bytes{0, 0, 5, 0})) << "as it is: its difference to nothing is no shorter";
  next(4);
  EXPECT_EQ(next(3), (Bytes{2, 0, 4}));
  EXPECT_EQ(next(4), (Bytes{0, 0, 6, 0}));
  next(4);
  EXPECT_EQ(next(4), (Bytes{4, 1, 1, 128})) << "a nanosecond back";
  next(4);
  EXPECT_EQ(next(3), (Bytes{5, 0, 0})) << "the end";
  EXPECT_EQ(file.size(), 4u);
}

TEST(RecordingTest, TellsHowTheMissionEndedOnceItWasRead) {
  const TemporaryFolder folder;
  {
    RecordingWriter writer(folder / "run.oilog", "a: b\n");
    writer.record(Direction::Received, 0.015, Bytes{1, 2, 3});
    writer.record_end({300, "stopped"});
  }
  RecordingReader reader(folder / "run.oilog");
  EXPECT_FALSE(reader.mission_end());
  EXPECT_EQ(read_all(reader).size(), 1u);
  EXPECT_EQ(reader.mission_end(), (RecordedEnd{300, "stopped"}));
  EXPECT_FALSE(reader.cut());
  const Bytes file = file_bytes(folder / "run.oilog");
  const auto end = file.end() - kEndSize;
  EXPECT_EQ(Bytes(end - 16, end - 4), (Bytes{6, 0, 9, 0xac, 2, 's', 't', 'o', 'p', 'p', 'e', 'd'}));
  RecordingReader cut(Bytes(file.begin(), end - 1), "cut");
  EXPECT_EQ(read_all(cut).size(), 1u);
  EXPECT_FALSE(cut.mission_end());
  EXPECT_TRUE(cut.cut());
}

/// Recordings of one name, one run after another.
class OlderRecordingTest : public testing::Test {
 protected:
  enum class Fate { Closed, Killed };
  void run(const std::string& content, Fate fate) const {
    {
      RecordingWriter writer(path_, "a: b\n");
      writer.record(Direction::Received, 0.0, Bytes(content.begin(), content.end()));
      if (fate == Fate::Closed) return writer.close();
      writer.flush();
      std::filesystem::copy_file(path_, folder_ / "killed");
      if (std::filesystem::exists(aside_)) std::filesystem::copy_file(aside_, folder_ / "aside");
    }
    // As a kill at that moment would have left them.
    std::filesystem::rename(folder_ / "killed", path_);
    if (std::filesystem::exists(folder_ / "aside")) std::filesystem::rename(folder_ / "aside", aside_);
  }
  static std::string recorded(const std::filesystem::path& path) {
    RecordingReader reader(path);
    std::string text;
    while (const auto chunk = reader.next()) text.append(chunk->bytes.begin(), chunk->bytes.end());
    return text;
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "run.oilog";
  std::filesystem::path aside_ = folder_ / "run.oilog~";
};

TEST_F(OlderRecordingTest, IsKeptUntilThereIsAnotherWholeOne) {
  run("first", Fate::Closed);
  run("second", Fate::Killed);
  EXPECT_EQ(recorded(aside_), "first");
  run("third", Fate::Killed);
  EXPECT_EQ(recorded(aside_), "first") << "the second was never whole";
  EXPECT_EQ(recorded(path_), "third");
  run("fourth", Fate::Closed);
  EXPECT_EQ(recorded(path_), "fourth");
  EXPECT_FALSE(std::filesystem::exists(aside_));
}

TEST_F(OlderRecordingTest, GivesWayToAWholeOne) {
  run("first", Fate::Closed);
  std::filesystem::copy_file(path_, folder_ / "first");
  run("second", Fate::Closed);
  std::filesystem::rename(folder_ / "first", aside_);
  run("third", Fate::Killed);
  EXPECT_EQ(recorded(aside_), "second");
}

TEST_F(OlderRecordingTest, GivesWayWhereItIsNotWholeItself) {
  run("first", Fate::Killed);
  run("second", Fate::Killed);
  run("third", Fate::Killed);
  EXPECT_EQ(recorded(aside_), "second");
}

TEST(RecordingTest, KeepsOnlyWhatChangedInAFrame) {
  const TemporaryFolder folder;
  Bytes frame(84, 42);
  write_all(folder / "one.oilog", {{Direction::Received, 0.0, frame}});
  std::vector<Chunk> chunks{{Direction::Received, 0.0, frame}};
  frame[10] = 1;
  frame[83] = 2;
  chunks.push_back({Direction::Received, 0.0, frame});
  write_all(folder / "two.oilog", chunks);
  const Bytes one = file_bytes(folder / "one.oilog"), two = file_bytes(folder / "two.oilog");
  const Bytes delta(two.begin() + static_cast<long>(one.size()) - kEndSize, two.end() - 4 - kEndSize);
  EXPECT_EQ(delta, (Bytes{3, 0, 7, 84, 10, 1, 42 ^ 1, 72, 1, 42 ^ 2}));
}

TEST(RecordingTest, KeepsAnHourInAFewMegabytes) {
  const TemporaryFolder folder;
  write_all(folder / "run.oilog", some_run(1, 4000));  // a minute
  EXPECT_LT(std::filesystem::file_size(folder / "run.oilog") * 60, 20'000'000u);
}

TEST(RecordingTest, YieldsAllWholeRecordsWhereverItIsCut) {
  const TemporaryFolder folder;
  const std::vector<Chunk> chunks = some_run(3, 20);
  write_all(folder / "run.oilog", chunks);
  const Bytes whole = file_bytes(folder / "run.oilog");
  std::size_t records_before = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    RecordingReader reader(Bytes(whole.begin(), whole.begin() + static_cast<long>(size)), "cut");
    const std::vector<Chunk> read = read_all(reader);
    ASSERT_LE(read.size(), chunks.size());
    EXPECT_TRUE(std::equal(read.begin(), read.end(), chunks.begin())) << size;
    EXPECT_GE(read.size(), records_before) << "more bytes, no fewer records";
    records_before = read.size();
    EXPECT_EQ(reader.cut(), size < whole.size()) << size << ": between two records, too, something is missing";
  }
  EXPECT_EQ(records_before, chunks.size());
}

TEST(RecordingTest, StopsAtDamageAndSaysSo) {
  const TemporaryFolder folder;
  const std::vector<Chunk> chunks = some_run(4, 20);
  write_all(folder / "run.oilog", chunks);
  const Bytes whole = file_bytes(folder / "run.oilog");
  for (std::size_t place = 9; place < whole.size(); ++place) {
    for (const int bit : {0, 7}) {
      Bytes damaged = whole;
      damaged[place] = static_cast<std::uint8_t>(damaged[place] ^ (1 << bit));
      RecordingReader reader(damaged, "damaged");
      const std::vector<Chunk> read = read_all(reader);
      EXPECT_TRUE(reader.cut()) << place;
      const bool in_end = place + kEndSize >= whole.size();
      ASSERT_LE(read.size(), chunks.size() - (in_end ? 0 : 1)) << place;
      EXPECT_TRUE(std::equal(read.begin(), read.end(), chunks.begin())) << place;
    }
  }
}

TEST(RecordingTest, NoticesARecordThatIsMissingInTheMiddle) {
  const TemporaryFolder folder;
  write_all(folder / "run.oilog",
            {{Direction::Sent, 0.0, {1}}, {Direction::Sent, 0.0, {2}}, {Direction::Sent, 0.0, {3}}});
  Bytes file = file_bytes(folder / "run.oilog");
  const auto end = file.end() - kEndSize;
  file.erase(end - 16, end - 8);  // a sent byte makes a record of 8
  RecordingReader reader(file, "spliced");
  EXPECT_EQ(read_all(reader).size(), 1u);
  EXPECT_TRUE(reader.cut());
}

TEST(RecordingTest, RefusesOtherFilesAndOtherVersions) {
  const auto open = [](const std::string& content) {
    return message_of([&] { RecordingReader(Bytes(content.begin(), content.end()), "file.oilog"); });
  };
  EXPECT_EQ(open("P5 2 2 255\n"), "file.oilog: not a recording (.oilog)");
  EXPECT_EQ(open("\x89OILOG\n\x01"), "file.oilog: not a recording (.oilog)") << "a transfer as text broke it";
  EXPECT_EQ(open("\x89OILOG\r\n\x02"), "file.oilog: recording of version 2; this program reads version 1");
  EXPECT_EQ(open(""), "");
  EXPECT_THAT(message_of([] { RecordingReader("no/such.oilog"); }), HasSubstr("no/such.oilog"));
}

TEST(RecordingTest, StampsThatCameFromNanosecondsComeBackExactly) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 100000; ++i) {
    const auto nanoseconds = static_cast<std::int64_t>(random() % 8'000'000'000'000'000u) - 4'000'000'000'000'000;
    EXPECT_EQ(stamp_to_nanoseconds(stamp_from_nanoseconds(nanoseconds)), nanoseconds);
  }
  EXPECT_EQ(stamp_from_nanoseconds(15'000'000), 0.015);
  EXPECT_EQ(stamp_to_nanoseconds(-0.0000000006), -1);
}

TEST(RecordingTest, IsReadableWhileItIsWrittenUpToALittleAgo) {
  const TemporaryFolder folder;
  RecordingWriter writer(folder / "run.oilog", "a: b\n");
  for (int tick = 0; tick < 1000; ++tick) writer.record(Direction::Received, tick * 0.015, Bytes{1, 2, 3});
  RecordingReader early(folder / "run.oilog");
  EXPECT_EQ(early.scenario(), "a: b\n");
  EXPECT_GE(read_all(early).size(), 900u) << "at most a second is on its way";
  writer.flush();
  RecordingReader late(folder / "run.oilog");
  EXPECT_EQ(read_all(late).size(), 1000u);
  EXPECT_TRUE(late.cut()) << "it is not closed yet";
  writer.close();
  RecordingReader closed(folder / "run.oilog");
  EXPECT_EQ(read_all(closed).size(), 1000u);
  EXPECT_FALSE(closed.cut());
}

TEST(RecordingTest, TellsThatTheFileCantBeMade) {
  EXPECT_THAT(message_of([] { RecordingWriter("no/such/run.oilog", ""); }),
              AllOf(HasSubstr("no/such/run.oilog"), HasSubstr("No such file or directory")));
}

TEST(RecordingTest, GoesOnWhenTheDiscIsFullAndTellsItOnce) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{5000, 5000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    RecordingWriter writer(folder / "run.oilog", "");
    std::mt19937 random(1);
    for (int tick = 0; tick < 1000; ++tick) {
      writer.record(Direction::Sent, tick * 0.015, Bytes(100, static_cast<std::uint8_t>(random())));
    }
    const std::string first = message_of([&] { writer.flush(); });
    const std::string second = message_of([&] { writer.close(); });
    ::_exit(first.find("File too large") != std::string::npos && second.empty() ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  RecordingReader reader(folder / "run.oilog");
  EXPECT_GT(read_all(reader).size(), 30u) << "what was on the disc by then is whole";
  EXPECT_TRUE(reader.cut());
}

TEST(RecordingTest, SaysWhenTheFirstBytesAlreadyFindNoRoom) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_THAT(message_of([] { RecordingWriter("/dev/full", "a: b"); }), HasSubstr("No space left on device"));
}

}  // namespace
}  // namespace scrubjay

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <csignal>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>
#include <scrubjay/io/mcap.hpp>
#include <scrubjay/io/rosbag2.hpp>

#include "bag_content.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
namespace fs = std::filesystem;

class Rosbag2Test : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const fs::path bag_ = folder_ / "run";
  const fs::path database_ = bag_ / "run_0.db3";
};

TEST_F(Rosbag2Test, GivesBackWhatWasWritten) {
  Rosbag2Writer writer(bag_);
  EXPECT_EQ(writer.add(kMapTopic), 0U);
  EXPECT_EQ(writer.add(kScanTopic), 1U);
  EXPECT_EQ(writer.add(kMapTopic), 0U);
  writer.write(0, 5, bytes_of("map"));
  writer.write(1, 7'000'000'000, bytes_of("scan"));
  writer.write(1, 7'000'000'000, bytes_of("scan at the same time"));
  writer.write(1, 8'000'000'000, {});
  writer.close();

  const BagContent content = content_of_bag(bag_);
  EXPECT_THAT(content.topics, ElementsAre(kMapTopic, kScanTopic));
  EXPECT_THAT(content.messages, ElementsAre("/map 5 map", "/scan 7000000000 scan",
                                            "/scan 7000000000 scan at the same time", "/scan 8000000000 "));
  EXPECT_FALSE(content.cut);
}

TEST_F(Rosbag2Test, GivesMessagesInTheOrderOfTheirStamps) {
  Rosbag2Writer writer(bag_);
  writer.add(kScanTopic);
  for (const double seconds : {3.0, 1.0, -4.0, 2.0}) {
    writer.write(0, static_cast<std::int64_t>(seconds * 1e9), bytes_of("x"));
  }
  writer.close();
  EXPECT_THAT(content_of_bag(bag_).messages,
              ElementsAre("/scan 0 x", "/scan 1000000000 x", "/scan 2000000000 x", "/scan 3000000000 x"));
}

TEST_F(Rosbag2Test, LeavesTwoFilesOfWhichEachSaysWhatIsInTheBag) {
  Rosbag2Writer writer(bag_);
  writer.add(kScanTopic);
  writer.write(0, 1'000, bytes_of("scan"));
  writer.write(0, 3'500, bytes_of("scan"));
  writer.close();
  EXPECT_EQ(folder_.file_count(), 1U);
  EXPECT_EQ(std::distance(fs::directory_iterator(bag_), {}), 2);

  BagMetadata metadata{"sqlite3", "run_0.db3"};
  metadata.add(kScanTopic);
  metadata.count(0, 1'000);
  metadata.count(0, 3'500);
  EXPECT_EQ(content_of(bag_ / "metadata.yaml"), bag_metadata_file(metadata));
  EXPECT_EQ(sql(database_, "SELECT * FROM metadata"), "1|8|" + bag_metadata_text(metadata) + "\n");
  EXPECT_EQ(sql(database_, "SELECT * FROM schema"), "4|scrubjay\n");
  EXPECT_EQ(sql(database_, "SELECT * FROM topics"),
            "1|/scan|sensor_msgs/msg/LaserScan|cdr|" + qos_text(kScanTopic.qos) + "|RIHS01_64c1\n");
  EXPECT_EQ(sql(database_, "SELECT * FROM message_definitions"),
            "1|sensor_msgs/msg/LaserScan|ros2msg|float32 angle_min\n|RIHS01_64c1\n");
  EXPECT_EQ(sql(database_, "PRAGMA journal_mode"), "delete\n");
}

/// A writer at work, and copies of what a kill at that moment would leave.
class KilledBagTest : public Rosbag2Test {
 protected:
  KilledBagTest() {
    writer_.add(kScanTopic);
    for (int i = 0; i < 200; ++i) writer_.write(0, 1'000'000'000'000 + i * 100'000'000LL, bytes_of(kFilling));
  }

  fs::path kill() {
    fs::copy(bag_, killed_);
    return killed_;
  }

  const std::string kFilling = std::string(10'000, 'x');  // 2 MB in all
  const fs::path killed_ = folder_ / "killed";
  Rosbag2Writer writer_{bag_};
};

TEST_F(KilledBagTest, OpensWithAllButItsNewestSecond) {
  const BagContent content = content_of_bag(kill());
  EXPECT_GE(content.messages.size(), 190U);
  EXPECT_THAT(content.topics, ElementsAre(kScanTopic));
  EXPECT_TRUE(content.cut);
}

TEST_F(KilledBagTest, OpensWithoutItsLogForThoseWhoDoNotLookThere) {
  fs::remove(kill() / "run_0.db3-wal");
  const BagContent content = content_of_bag(killed_);
  EXPECT_GE(content.messages.size(), 80U);
  EXPECT_THAT(content.topics, ElementsAre(kScanTopic));
}

TEST_F(KilledBagTest, SaysInBothPlacesWhichTopicsThereAreAndWhenItBegan) {
  kill();
  const std::string inside = sql(killed_ / "run_0.db3", "SELECT metadata FROM metadata");
  for (const YAML::Node& metadata :
       {YAML::LoadFile((killed_ / "metadata.yaml").string())["rosbag2_bagfile_information"], YAML::Load(inside)}) {
    EXPECT_EQ(metadata["version"].as<int>(), 8);
    EXPECT_EQ(metadata["starting_time"]["nanoseconds_since_epoch"].as<std::int64_t>(), 1'000'000'000'000);
    EXPECT_EQ(metadata["topics_with_message_count"][0]["topic_metadata"]["name"].as<std::string>(), "/scan");
    EXPECT_EQ(metadata["relative_file_paths"][0].as<std::string>(), "run_0.db3");
  }
}

TEST_F(KilledBagTest, IsABagFromTheBeginning) {
  const Rosbag2Writer writer(folder_ / "young");
  fs::copy(folder_ / "young", killed_);
  EXPECT_THAT(content_of_bag(killed_).messages, IsEmpty());
  const std::string text = bag_metadata_text({"sqlite3", "young_0.db3"});
  EXPECT_EQ(sql(killed_ / "young_0.db3", "SELECT metadata FROM metadata"), text + "\n");
  EXPECT_EQ(content_of(killed_ / "metadata.yaml"), bag_metadata_file({"sqlite3", "young_0.db3"}));
}

TEST_F(KilledBagTest, CountsAtLeastAllThatIsOlderThanAMinute) {
  for (int i = 0; i < 70; ++i) writer_.write(0, 1'020'000'000'000 + i * 1'000'000'000LL, bytes_of("x"));
  kill();
  const YAML::Node file = YAML::LoadFile((killed_ / "metadata.yaml").string())["rosbag2_bagfile_information"];
  EXPECT_GE(file["message_count"].as<int>(), 200);
  EXPECT_GE(file["duration"]["nanoseconds"].as<std::int64_t>(), 20'000'000'000);
}

TEST_F(KilledBagTest, IsNoLongerCutOnceItIsClosed) {
  writer_.close();
  EXPECT_FALSE(content_of_bag(bag_).cut);
  EXPECT_EQ(content_of_bag(bag_).messages.size(), 200U);
}

TEST_F(KilledBagTest, MayBeReadWhileItIsWritten) {
  Rosbag2Reader reader(bag_);
  ASSERT_TRUE(reader.next());
  writer_.write(0, 1'100'000'000'000, bytes_of("x"));
  writer_.close();
  EXPECT_EQ(content_of_bag(bag_).messages.size(), 201U);
}

/// Bags of one name, one run after another.
class OlderBagTest : public Rosbag2Test {
 protected:
  enum class Fate { Closed, Killed };
  void run(const std::string& content, Fate fate) const {
    {
      Rosbag2Writer writer(bag_);
      writer.add(kScanTopic);
      writer.write(0, 9'000'000'000, bytes_of(content));
      if (fate == Fate::Closed) return writer.close();
      // As a kill at that moment leaves them.
      for (const fs::path& bag : {bag_, aside_}) {
        if (fs::exists(bag)) fs::copy(bag, folder_ / "left" / bag.filename(), fs::copy_options::recursive);
      }
    }
    for (const fs::path& bag : {bag_, aside_}) {
      fs::remove_all(bag);
      if (fs::exists(folder_ / "left" / bag.filename())) fs::rename(folder_ / "left" / bag.filename(), bag);
    }
  }

  OlderBagTest() { fs::create_directory(folder_ / "left"); }
  const fs::path aside_ = folder_ / "run~";
};

TEST_F(OlderBagTest, GoesOnceTheNewOneIsComplete) {
  run("first", Fate::Closed);
  run("second", Fate::Closed);
  EXPECT_THAT(content_of_bag(bag_).messages, ElementsAre("/scan 9000000000 second"));
  EXPECT_FALSE(fs::exists(aside_));
}

TEST_F(OlderBagTest, StaysBesideANewOneThatWasKilled) {
  run("first", Fate::Closed);
  run("second", Fate::Killed);
  EXPECT_THAT(content_of_bag(bag_).messages, ElementsAre("/scan 9000000000 second"));
  EXPECT_THAT(content_of_bag(aside_).messages, ElementsAre("/scan 9000000000 first"));
}

TEST_F(OlderBagTest, StaysUntilOneIsCompleteHoweverManyAreKilled) {
  run("first", Fate::Closed);
  run("second", Fate::Killed);
  run("third", Fate::Killed);
  EXPECT_THAT(content_of_bag(bag_).messages, ElementsAre("/scan 9000000000 third"));
  EXPECT_THAT(content_of_bag(aside_).messages, ElementsAre("/scan 9000000000 first"));
  run("fourth", Fate::Closed);
  EXPECT_THAT(content_of_bag(bag_).messages, ElementsAre("/scan 9000000000 fourth"));
  EXPECT_FALSE(fs::exists(aside_));
}

TEST_F(OlderBagTest, ThatWasKilledGivesWayToANewerOne) {
  run("first", Fate::Killed);
  run("second", Fate::Killed);
  EXPECT_THAT(content_of_bag(aside_).messages, ElementsAre("/scan 9000000000 first"));
  run("third", Fate::Killed);
  EXPECT_THAT(content_of_bag(aside_).messages, ElementsAre("/scan 9000000000 second"));
}

TEST_F(OlderBagTest, ComesBackWhenTheNewOneFindsNoRoom) {
  run("first", Fate::Closed);
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{100'000, 100'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    Rosbag2Writer writer(bag_);
    writer.add(kScanTopic);
    for (int i = 0; i < 100; ++i) writer.write(0, i * 1'000'000'000LL, bytes_of(std::string(10'000, 'x')));
    const std::string first = message_of([&] { writer.close(); });
    const std::string second = message_of([&] { writer.close(); });
    ::_exit(first.find("run_0.db3: cannot write the bag: ") != std::string::npos && second.empty() ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_THAT(content_of_bag(bag_).messages, ElementsAre("/scan 9000000000 first"));
  EXPECT_FALSE(fs::exists(aside_));
}

TEST_F(Rosbag2Test, TakesAnEmptyFolderAndMakesThoseAboveIt) {
  fs::create_directory(bag_);
  Rosbag2Writer(bag_).close();
  EXPECT_THAT(content_of_bag(bag_).messages, IsEmpty());
  Rosbag2Writer(folder_ / "a/b/").close();
  EXPECT_TRUE(fs::exists(folder_ / "a/b/b_0.db3"));
}

TEST_F(Rosbag2Test, LeavesAFolderAloneThatHoldsMoreThanABag) {
  Rosbag2Writer(bag_).close();
  folder_.write("run/notes.txt", "mine");
  EXPECT_EQ(message_of([this] { Rosbag2Writer writer(bag_); }),
            bag_.string() + ": holds notes.txt, which is no part of a bag; want the name of a new folder, or of a bag");
  fs::rename(bag_, folder_ / "run~");
  Rosbag2Writer(bag_).close();
  EXPECT_THAT(message_of([this] { Rosbag2Writer writer(bag_); }), HasSubstr("run~: holds notes.txt"));
  EXPECT_TRUE(fs::exists(bag_ / "metadata.yaml"));
  EXPECT_EQ(content_of(folder_ / "run~/notes.txt"), "mine");
}

TEST_F(Rosbag2Test, IsNotMadeWhereAFileIs) {
  folder_.write("run", "text");
  EXPECT_THAT(message_of([this] { Rosbag2Writer writer(bag_); }), HasSubstr("run: is a file; want"));
  EXPECT_THAT(message_of([this] { Rosbag2Writer writer(bag_ / "below"); }), HasSubstr("cannot make the bag's folder"));
  EXPECT_EQ(content_of(bag_), "text");
}

}  // namespace
}  // namespace scrubjay

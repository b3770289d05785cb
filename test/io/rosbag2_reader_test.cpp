#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
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

// As rosbag2 has made them from distribution to distribution.
const std::string kTopics1 =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL);";
const std::string kTopics2 =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);";
const std::string kTopics4 =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
    " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL, type_description_hash TEXT NOT NULL);"
    "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,"
    " encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);";
const std::string kSchema =
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT NULL);"
    "INSERT INTO schema VALUES (3, 'humble');";
const std::string kMessages =
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,"
    " data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    "INSERT INTO messages VALUES (1, 7, 20, X'6162'), (2, 7, 10, X'63');";
const std::string kOneTopic = kTopics1 + "INSERT INTO topics VALUES (7, '/scan', 'sensor_msgs/msg/LaserScan', 'cdr');";

BagTopic scan_topic(const ros::Qos& qos = {}, const std::string& hash = "", const std::string& definition = "") {
  return {"/scan", "sensor_msgs/msg/LaserScan", definition, hash, qos};
}

class Rosbag2ReaderTest : public testing::Test {
 protected:
  std::string error() const {
    return message_of([this] { content_of_bag(file_); });
  }
  void make_bag(const std::string& storage, const std::string& files, const std::string& more = "") const {
    fs::create_directory(folder_ / "bag");
    folder_.write("bag/metadata.yaml", "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: " + storage +
                                           "\n  relative_file_paths: [" + files + "]\n" + more);
  }

  const TemporaryFolder folder_;
  const fs::path file_ = folder_ / "a.db3";
  const fs::path bag_ = folder_ / "bag";
};

TEST_F(Rosbag2ReaderTest, ReadsTheDatabasesOfDashing) {
  sql(file_, kOneTopic + kMessages);
  const BagContent content = content_of_bag(file_);
  EXPECT_THAT(content.topics, ElementsAre(scan_topic()));
  EXPECT_THAT(content.messages, ElementsAre("/scan 10 c", "/scan 20 ab"));
  EXPECT_FALSE(content.cut);
}

TEST_F(Rosbag2ReaderTest, ReadsTheDatabasesOfFoxyAndHumble) {
  const std::string topic =
      "INSERT INTO topics VALUES (7, '/scan', 'sensor_msgs/msg/LaserScan', 'cdr', "
      "'- history: 1\n  depth: 3\n  reliability: 2\n  durability: 2\n');";
  const ros::Qos qos{ros::Reliability::BestEffort, ros::Durability::Volatile, 3};
  for (const std::string& schema : {std::string(), kSchema}) {
    fs::remove(file_);
    sql(file_, kTopics2 + topic + schema + kMessages);
    const BagContent content = content_of_bag(file_);
    EXPECT_THAT(content.topics, ElementsAre(scan_topic(qos)));
    EXPECT_THAT(content.messages, ElementsAre("/scan 10 c", "/scan 20 ab"));
  }
}

TEST_F(Rosbag2ReaderTest, ReadsTheDatabasesOfIronAndLater) {
  sql(file_, kTopics4 + kSchema + kMessages +
                 "INSERT INTO topics VALUES (7, '/scan', 'sensor_msgs/msg/LaserScan', 'cdr',"
                 " '- depth: 3\n  reliability: best_effort\n  durability: transient_local', 'RIHS01_64');"
                 "INSERT INTO message_definitions VALUES (1, 'sensor_msgs/msg/LaserScan', 'ros2idl', 'idl', ''),"
                 " (2, 'sensor_msgs/msg/LaserScan', 'ros2msg', 'float32 x', '');");
  EXPECT_THAT(content_of_bag(file_).topics,
              ElementsAre(scan_topic({ros::Reliability::BestEffort, ros::Durability::TransientLocal, 3}, "RIHS01_64",
                                     "float32 x")));
}

TEST_F(Rosbag2ReaderTest, LeavesTopicsOutThatAreNotCdr) {
  sql(file_, kTopics1 + "INSERT INTO topics VALUES (1, '/a', 'a/msg/A', 'cdr'), (7, '/b', 'b/msg/B', 'json');" +
                 kMessages + "INSERT INTO messages VALUES (3, 1, 15, X'64');");
  const BagContent content = content_of_bag(file_);
  ASSERT_EQ(content.topics.size(), 1U);
  EXPECT_THAT(content.messages, ElementsAre("/a 15 d"));
  EXPECT_FALSE(content.cut);
}

TEST_F(Rosbag2ReaderTest, ReadsTheFilesOfAFolderAsOneBag) {
  make_bag("sqlite3", "bag/bag_0.db3, bag_1.db3");
  sql(bag_ / "bag_0.db3",
      kTopics1 + kMessages + "INSERT INTO topics VALUES (7, '/a', 'a/A', 'cdr'), (8, '/b', 'b/B', 'cdr')");
  sql(bag_ / "bag_1.db3",
      kTopics1 + kMessages + "INSERT INTO topics VALUES (7, '/b', 'b/B', 'cdr'), (8, '/c', 'c/C', 'cdr')");
  const BagContent content = content_of_bag(bag_);
  EXPECT_EQ(content.topics.size(), 3U);
  EXPECT_THAT(content.messages, ElementsAre("/a 10 c", "/a 20 ab", "/b 10 c", "/b 20 ab"));
}

TEST_F(Rosbag2ReaderTest, ReadsAFolderOfMcap) {
  make_bag("mcap", "bag_0.mcap");
  McapWriter writer(bag_ / "bag_0.mcap");
  writer.add(kScanTopic);
  writer.write(0, 5, bytes_of("scan"));
  writer.close();
  const BagContent content = content_of_bag(bag_);
  EXPECT_THAT(content.topics, ElementsAre(kScanTopic));
  EXPECT_THAT(content.messages, ElementsAre("/scan 5 scan"));
  EXPECT_FALSE(content.cut);
}

TEST_F(Rosbag2ReaderTest, ReadsAFolderThatAKilledRosbag2LeftWithoutMetadata) {
  fs::create_directory(bag_);
  for (const std::string name : {"bag_2", "bag_10"}) {
    sql(bag_ / (name + ".db3"), kTopics1 + kMessages + "INSERT INTO topics VALUES (7, '/" + name + "', 'a/A', 'cdr')");
  }
  const BagContent content = content_of_bag(bag_);
  EXPECT_THAT(content.messages, ElementsAre("/bag_2 10 c", "/bag_2 20 ab", "/bag_10 10 c", "/bag_10 20 ab"));
  EXPECT_TRUE(content.cut);
}

TEST_F(Rosbag2ReaderTest, ReadsFromAFolderThatItMayNotWriteTo) {
  sql(file_, "PRAGMA journal_mode=WAL;" + kOneTopic + kMessages);
  constexpr auto kReadable = fs::perms{0555};
  fs::permissions(folder_.path(), kReadable);
  constexpr uid_t kNobody = 65534;
  const bool is_root = ::geteuid() == 0;  // who may write anywhere
  if (is_root) {
    ASSERT_EQ(::seteuid(kNobody), 0);
  }
  std::size_t messages = 0;
  const std::string what = message_of([&] { messages = content_of_bag(file_).messages.size(); });
  if (is_root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  fs::permissions(folder_.path(), fs::perms::owner_all);
  EXPECT_EQ(what, "");
  EXPECT_EQ(messages, 2U);
}

TEST_F(Rosbag2ReaderTest, TakesAnyNameOfAFile) {
  const fs::path odd = folder_ / "a?immutable=0#%41 .db3";
  sql(odd, kOneTopic + kMessages);
  EXPECT_EQ(content_of_bag(odd).messages.size(), 2U);
}

TEST_F(Rosbag2ReaderTest, SaysWhatItCannotRead) {
  EXPECT_EQ(error(), file_.string() + ": cannot read: No such file or directory");
  folder_.write("a.db3", "SQLite format 3 is what this isn't");
  EXPECT_EQ(error(), file_.string() + ": is no bag; want MCAP, a folder of rosbag2, or a .db3 out of one");
  folder_.write("a.db3", std::string("SQLite format 3\0", 16) + std::string(5000, 'x'));
  EXPECT_EQ(error(), file_.string() + ": cannot read the bag: file is not a database");
  fs::remove(file_);
  sql(file_, kMessages);
  EXPECT_EQ(error(), file_.string() + ": is no bag of rosbag2: it has no topics.id");
}

TEST_F(Rosbag2ReaderTest, SaysWhatAFolderLacks) {
  const auto folder_error = [this] { return message_of([this] { content_of_bag(bag_); }); };
  fs::create_directory(bag_);
  EXPECT_EQ(folder_error(), bag_.string() + ": is no bag; want a folder with metadata.yaml and .db3 or .mcap files");
  make_bag("sqlite3", "bag_0.db3");
  EXPECT_THAT(folder_error(), HasSubstr("bag_0.db3: cannot read the bag: unable to open database file"));
  make_bag("sqlite3", "bag_0.db3.zstd", "  compression_format: zstd\n  compression_mode: FILE\n");
  EXPECT_EQ(folder_error(), bag_.string() + ": is packed with zstd; want it unpacked, as `ros2 bag convert` does");
  make_bag("rosbag_v2", "a.bag");
  EXPECT_EQ(folder_error(), (bag_ / "metadata.yaml").string() + ": is stored by 'rosbag_v2'; want sqlite3 or mcap");
}

TEST_F(Rosbag2ReaderTest, ReadsUpToARowThatIsNoMessage) {
  const std::string kLoose =
      "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, data);"
      "INSERT INTO messages VALUES (1, 7, 10, X'61'), (3, 7, 30, X'62'), ";
  for (const std::string row : {"(2, 7, 20, NULL)", "(2, 7, 20, 'text')", "(2, 7, 20, 5)", "(2, 99, 20, X'00')",
                                "(2, NULL, 20, X'00')", "(2, 7, 20.5, X'00')"}) {
    fs::remove(file_);
    sql(file_, kOneTopic + kLoose + row);
    const BagContent content = content_of_bag(file_);
    EXPECT_THAT(content.messages, ElementsAre("/scan 10 a")) << row;
    EXPECT_TRUE(content.cut) << row;
  }
}

TEST_F(Rosbag2ReaderTest, RefusesTopicsWithoutAName) {
  sql(file_,
      "CREATE TABLE topics(id INTEGER PRIMARY KEY, name, type, serialization_format);"
      "INSERT INTO topics VALUES (7, NULL, 'a/A', 'cdr');" +
          kMessages);
  EXPECT_EQ(error(), file_.string() + ": a row of its topics is damaged");
}

TEST_F(Rosbag2ReaderTest, ReadsPlainTablesOnly) {
  sql(file_, kOneTopic +
                 "CREATE VIEW messages AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n)"
                 " SELECT id, 7 AS topic_id, id AS timestamp, X'00' AS data FROM n;");
  EXPECT_THAT(error(), HasSubstr("is no bag of rosbag2: it has no messages.id"));
  fs::remove(file_);
  sql(file_, kOneTopic +
                 "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp,"
                 " data BLOB AS (zeroblob(900000000)));"
                 "INSERT INTO messages(id, topic_id, timestamp) VALUES (1, 7, 10);");
  EXPECT_THAT(error(), HasSubstr("is no bag of rosbag2: it has no messages.data"));
}

TEST_F(Rosbag2ReaderTest, ReadsUpToWhereAFileWasCut) {
  sql(file_, kOneTopic + kMessages +
                 "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 2000)"
                 " INSERT INTO messages(topic_id, timestamp, data) SELECT 7, 100 + i, zeroblob(1000) FROM n");
  const std::string whole = content_of(file_);
  for (const std::size_t size : {whole.size() * 9 / 10, whole.size() / 2, std::size_t{9000}, std::size_t{5000}}) {
    folder_.write("a.db3", whole.substr(0, size));
    BagContent content;
    const std::string what = message_of([&] { content = content_of_bag(file_); });
    EXPECT_TRUE(content.cut || what.find("cannot read the bag") != std::string::npos) << size << ": " << what;
  }
}

TEST_F(Rosbag2ReaderTest, SurvivesDamageAnywhere) {
  sql(file_, "PRAGMA page_size=512;" + kOneTopic + kMessages);
  const std::string whole = content_of(file_);
  for (std::size_t at = 16; at < whole.size(); at += 7) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
    folder_.write("a.db3", damaged);
    const std::string what = message_of([this] { content_of_bag(file_); });
    EXPECT_EQ(what.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace scrubjay

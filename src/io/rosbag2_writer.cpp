#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>
#include <scrubjay/io/bag_metadata.hpp>
#include <scrubjay/io/rosbag2.hpp>
#include <set>
#include <utility>

#include "bag_place.hpp"
#include "sqlite.hpp"

namespace scrubjay {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;        // [ns]
constexpr std::int64_t kCommitEvery = kSecond;         // of stamps [ns]
constexpr std::int64_t kDescribeEvery = 60 * kSecond;  // of stamps [ns]

// As rosbag2 makes it (SqliteStorage::initialize), schema 4. A page is 4 KiB: the log is written back every mebibyte.
constexpr const char* kSchema = R"(
PRAGMA journal_mode = WAL;
PRAGMA synchronous = NORMAL;
PRAGMA wal_autocheckpoint = 256;
BEGIN;
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
  serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL, type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,
  encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
  data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages (timestamp ASC);
INSERT INTO schema(schema_version, ros_distro) VALUES (4, 'scrubjay');
)";

}  // namespace

class Rosbag2Writer::State {
 public:
  explicit State(const std::filesystem::path& folder);

  std::size_t add(const BagTopic& topic);
  void write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes);
  void close();

 private:
  void begin();
  template <class Action>
  void attempt(const Action& action);
  void insert_topic(std::size_t number, const BagTopic& topic);
  void insert_message(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes);
  bool must_describe(std::int64_t now) const;
  void insert_description();
  void write_description() const;
  void finish();

  BagPlace place_;
  BagMetadata metadata_;
  std::optional<Sqlite> database_;
  std::optional<SqliteStatement> insert_message_;
  std::set<std::string> defined_;  ///< types whose definition is in the database
  std::optional<Error> failure_;   ///< the first one, until it was told
  bool failed_ = false;
  std::int64_t committed_at_ = 0;  ///< [ns]
  std::int64_t described_at_ = 0;  ///< [ns]
  std::size_t described_topics_ = 0;
  bool described_messages_ = false;  ///< that there are any
};

Rosbag2Writer::State::State(const std::filesystem::path& folder) : place_(folder) {
  metadata_.storage = "sqlite3";
  metadata_.file = place_.folder().filename().string() + "_0.db3";
  try {
    begin();
  } catch (const Error&) {
    insert_message_.reset();
    database_.reset();
    place_.clear();
    place_.give_up();
    throw;
  }
}

void Rosbag2Writer::State::begin() {
  database_ = Sqlite::make(place_.folder() / metadata_.file);
  database_->run(kSchema);
  insert_message_ = database_->prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
  insert_description();
  database_->run("COMMIT; BEGIN");
  write_description();
}

/// Does something unless anything failed before, and keeps its failure.
template <class Action>
void Rosbag2Writer::State::attempt(const Action& action) {
  if (failed_) return;
  try {
    action();
  } catch (const Error& error) {
    failed_ = true;
    failure_ = error;
  }
}

std::size_t Rosbag2Writer::State::add(const BagTopic& topic) {
  const auto known = std::find(metadata_.topics.begin(), metadata_.topics.end(), topic);
  if (known != metadata_.topics.end()) return static_cast<std::size_t>(known - metadata_.topics.begin());
  const std::size_t number = metadata_.add(topic);
  if (database_) attempt([&] { insert_topic(number, topic); });
  return number;
}

void Rosbag2Writer::State::insert_topic(std::size_t number, const BagTopic& topic) {
  const std::string qos = qos_text(topic.qos);
  SqliteStatement insert = database_->prepare("INSERT INTO topics VALUES (?, ?, ?, 'cdr', ?, ?)");
  insert.bind(1, static_cast<std::int64_t>(number + 1));
  insert.bind(2, topic.name);
  insert.bind(3, topic.type);
  insert.bind(4, qos);
  insert.bind(5, topic.hash);
  insert.run();
  if (topic.definition.empty() || !defined_.insert(topic.type).second) return;
  SqliteStatement define = database_->prepare(
      "INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, type_description_hash) "
      "VALUES (?, 'ros2msg', ?, ?)");
  define.bind(1, topic.type);
  define.bind(2, topic.definition);
  define.bind(3, topic.hash);
  define.run();
}

void Rosbag2Writer::State::write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) {
  if (database_) attempt([&] { insert_message(topic, std::max<std::int64_t>(nanoseconds, 0), bytes); });
}

void Rosbag2Writer::State::insert_message(std::size_t topic, std::int64_t nanoseconds,
                                          std::span<const std::byte> bytes) {
  insert_message_->bind(1, static_cast<std::int64_t>(topic + 1));
  insert_message_->bind(2, nanoseconds);
  insert_message_->bind(3, bytes);
  insert_message_->run();
  metadata_.count(topic, nanoseconds);
  if (nanoseconds - committed_at_ < kCommitEvery && nanoseconds >= committed_at_) return;
  const bool describe = must_describe(nanoseconds);
  if (describe) insert_description();
  database_->run("COMMIT; BEGIN");
  committed_at_ = nanoseconds;
  if (!describe) return;
  write_description();
  described_at_ = nanoseconds;
  described_messages_ = true;
}

bool Rosbag2Writer::State::must_describe(std::int64_t now) const {
  return !described_messages_ || described_topics_ != metadata_.topics.size() ||
         now - described_at_ >= kDescribeEvery || now < described_at_;
}

/// Into the database. A bag that was killed must have it there, too: later distributions take the words of their own
/// version for its quality of service otherwise.
void Rosbag2Writer::State::insert_description() {
  const std::string text = bag_metadata_text(metadata_);
  SqliteStatement insert = database_->prepare("INSERT OR REPLACE INTO metadata VALUES (1, ?, ?)");
  insert.bind(1, std::int64_t{kBagMetadataVersion});
  insert.bind(2, text);
  insert.run();
  described_topics_ = metadata_.topics.size();
}

void Rosbag2Writer::State::write_description() const {
  write_file_atomically(place_.folder() / "metadata.yaml", bag_metadata_file(metadata_));
}

void Rosbag2Writer::State::close() {
  if (database_) {
    attempt([this] { finish(); });
    insert_message_.reset();
    database_.reset();
    attempt([this] { write_description(); });
    if (failed_) {
      place_.give_up();
    } else {
      place_.keep();
    }
  }
  if (failure_) throw *std::exchange(failure_, std::nullopt);
}

void Rosbag2Writer::State::finish() {
  // The last transaction waits for the disc, whether or not the log can be written back then.
  database_->run("COMMIT; PRAGMA synchronous = FULL; BEGIN");
  insert_description();
  database_->run("COMMIT");
  insert_message_.reset();
  try {
    database_->run("PRAGMA journal_mode = DELETE");
  } catch (const Error&) {
    // Somebody reads the bag. It is on the disc with its log, as SQLite reads it.
  }
}

Rosbag2Writer::Rosbag2Writer(const std::filesystem::path& folder) : state_(std::make_unique<State>(folder)) {}

Rosbag2Writer::~Rosbag2Writer() {
  try {
    close();
  } catch (const Error&) {
    // Whoever wants to know calls close().
  }
}

std::size_t Rosbag2Writer::add(const BagTopic& topic) {
  return state_->add(topic);
}

void Rosbag2Writer::write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) {
  state_->write(topic, nanoseconds, bytes);
}

void Rosbag2Writer::close() {
  state_->close();
}

}  // namespace scrubjay

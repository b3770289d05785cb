#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>
#include <scrubjay/io/mcap.hpp>
#include <scrubjay/io/rosbag2.hpp>
#include <utility>

#include "file_content.hpp"
#include "sqlite_bag.hpp"

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

/// `run_10.db3` comes behind `run_9.db3`: shorter numbers first, then by letter.
bool in_order(const fs::path& a, const fs::path& b) {
  const std::string& left = a.native();
  const std::string& right = b.native();
  return std::pair(left.size(), left) < std::pair(right.size(), right);
}

/// The folder's files of one plugin, without metadata.yaml to tell them.
BagFolder look_into(const fs::path& folder) {
  BagFolder found;
  std::vector<fs::path> files;
  for (const std::string_view storage : {"sqlite3", "mcap"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      if (entry.path().extension() == (storage == "mcap" ? ".mcap" : ".db3")) files.push_back(entry.path().filename());
    }
    found.storage = storage;
    if (!files.empty()) break;
  }
  if (files.empty()) {
    throw Error(
        fmt::format("{}: is no bag; want a folder with metadata.yaml and .db3 or .mcap files", folder.string()));
  }
  std::sort(files.begin(), files.end(), in_order);
  for (const fs::path& file : files) found.files.push_back(file.string());
  return found;
}

BagFolder read_folder(const fs::path& folder) {
  const fs::path metadata = folder / "metadata.yaml";
  const std::vector<std::uint8_t> content = read_file(metadata);
  BagFolder found = parse_bag_folder(std::string(content.begin(), content.end()), metadata.string());
  if (!found.compression.empty()) {
    throw Error(fmt::format("{}: is packed with {}; want it unpacked, as `ros2 bag convert` does", folder.string(),
                            found.compression));
  }
  if (found.storage != "sqlite3" && found.storage != "mcap") {
    throw Error(fmt::format("{}: is stored by '{}'; want sqlite3 or mcap", metadata.string(), found.storage));
  }
  return found;
}

}  // namespace

class Rosbag2Reader::State {
 public:
  explicit State(const fs::path& path);

  const std::vector<BagTopic>& topics() const { return topics_; }
  std::optional<BagMessage> next();
  bool cut() const { return cut_; }

 private:
  /// A file, and the numbers in topics_ of its topics.
  struct Part {
    std::unique_ptr<BagReader> reader;
    std::vector<std::size_t> numbers{};
  };
  void open_folder(const fs::path& folder);
  void add(std::unique_ptr<BagReader> reader);
  void take_topics(Part& part);

  std::vector<BagTopic> topics_;
  std::vector<Part> parts_;
  std::size_t current_ = 0;
  bool cut_ = false;
};

Rosbag2Reader::State::State(const fs::path& path) try {
  if (fs::is_directory(path)) {
    open_folder(path);
  } else {
    add(std::make_unique<SqliteBag>(path));
  }
} catch (const fs::filesystem_error& error) {
  throw Error(fmt::format("{}: cannot read: {}", path.string(), error.code().message()));
}

void Rosbag2Reader::State::open_folder(const fs::path& folder) {
  const bool described = fs::exists(folder / "metadata.yaml");
  const BagFolder found = described ? read_folder(folder) : look_into(folder);
  cut_ = !described;
  for (const std::string& file : found.files) {
    if (found.storage == "mcap") {
      add(std::make_unique<McapReader>(folder / file));
    } else {
      add(std::make_unique<SqliteBag>(folder / file));
    }
  }
}

void Rosbag2Reader::State::add(std::unique_ptr<BagReader> reader) {
  parts_.push_back({std::move(reader)});
  take_topics(parts_.back());
}

/// Those that it has more by now: one that another file has, too, is the same.
void Rosbag2Reader::State::take_topics(Part& part) {
  const std::vector<BagTopic>& topics = part.reader->topics();
  while (part.numbers.size() < topics.size()) {
    const BagTopic& topic = topics[part.numbers.size()];
    const auto known = std::find_if(topics_.begin(), topics_.end(), [&topic](const BagTopic& other) {
      return other.name == topic.name && other.type == topic.type;
    });
    part.numbers.push_back(static_cast<std::size_t>(known - topics_.begin()));
    if (known == topics_.end()) topics_.push_back(topic);
  }
}

std::optional<BagMessage> Rosbag2Reader::State::next() {
  while (current_ < parts_.size()) {
    Part& part = parts_[current_];
    if (auto message = part.reader->next()) {
      take_topics(part);
      message->topic = part.numbers[message->topic];
      return message;
    }
    cut_ = cut_ || part.reader->cut();
    ++current_;
  }
  return std::nullopt;
}

Rosbag2Reader::Rosbag2Reader(const fs::path& path) : state_(std::make_unique<State>(path)) {}
Rosbag2Reader::~Rosbag2Reader() = default;

const std::vector<BagTopic>& Rosbag2Reader::topics() const {
  return state_->topics();
}

std::optional<BagMessage> Rosbag2Reader::next() {
  return state_->next();
}

bool Rosbag2Reader::cut() const {
  return state_->cut();
}

}  // namespace scrubjay

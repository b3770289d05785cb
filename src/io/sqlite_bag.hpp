/// \file
/// One database of a rosbag2 folder.
#pragma once

#include <scrubjay/io/bag.hpp>
#include <unordered_map>

#include "sqlite.hpp"

namespace scrubjay {

/// Reads one: of schema 1 (Dashing), 2 (Foxy), 3 (Humble) and 4 (Iron to now), told apart by their columns.
///
/// A row that can't be a message, such as one of no topic, counts as damage.
class SqliteBag final : public BagReader {
 public:
  /// Throws Error if it isn't one.
  explicit SqliteBag(const std::filesystem::path& path);

  const std::vector<BagTopic>& topics() const override { return topics_; }
  std::optional<BagMessage> next() override;
  bool cut() const override { return cut_; }

 private:
  void read_topics();
  std::unordered_map<std::string, std::string> read_definitions();
  std::optional<BagMessage> read_row();

  std::string name_;
  Sqlite database_;
  std::vector<BagTopic> topics_;
  /// Number of a topic by its id; none of one that is left out.
  std::unordered_map<std::int64_t, std::optional<std::size_t>> number_of_;
  std::optional<SqliteStatement> messages_;
  bool cut_ = false;
};

}  // namespace scrubjay

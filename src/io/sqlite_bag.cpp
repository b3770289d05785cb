#include "sqlite_bag.hpp"

#include <fmt/format.h>

#include <array>
#include <scrubjay/io/bag_metadata.hpp>

#include "bag_place.hpp"

namespace scrubjay {

SqliteBag::SqliteBag(const std::filesystem::path& path)
    : name_(path.string()), database_(Sqlite::open(path)), cut_(has_sqlite_log(path)) {
  using Column = std::pair<std::string_view, std::string_view>;
  constexpr std::array kColumns{Column{"topics", "id"},          Column{"topics", "name"},
                                Column{"topics", "type"},        Column{"topics", "serialization_format"},
                                Column{"messages", "id"},        Column{"messages", "topic_id"},
                                Column{"messages", "timestamp"}, Column{"messages", "data"}};
  for (const auto& [table, column] : kColumns) {
    if (database_.has_column(table, column)) continue;
    throw Error(fmt::format("{}: is no bag of rosbag2: it has no {}.{}", name_, table, column));
  }
  read_topics();
  messages_ = database_.prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id");
}

void SqliteBag::read_topics() {
  const std::unordered_map<std::string, std::string> definitions = read_definitions();
  const bool has_qos = database_.has_column("topics", "offered_qos_profiles");
  const bool has_hash = database_.has_column("topics", "type_description_hash");
  SqliteStatement rows = database_.prepare(
      fmt::format("SELECT id, name, type, serialization_format, {}, {} FROM topics ORDER BY id",
                  has_qos ? "offered_qos_profiles" : "''", has_hash ? "type_description_hash" : "''"));
  while (rows.step()) {
    const auto id = rows.integer(0);
    const auto name = rows.text(1);
    const auto type = rows.text(2);
    const auto format = rows.text(3);
    if (!id || !name || !type || !format) throw Error(fmt::format("{}: a row of its topics is damaged", name_));
    if (*format != "cdr") {
      number_of_.emplace(*id, std::nullopt);
      continue;
    }
    BagTopic topic{std::string(*name), std::string(*type), "", std::string(rows.text(5).value_or("")),
                   parse_qos(rows.text(4).value_or(""))};
    const auto definition = definitions.find(topic.type);
    if (definition != definitions.end()) topic.definition = definition->second;
    number_of_.emplace(*id, topics_.size());
    topics_.push_back(std::move(topic));
  }
}

std::unordered_map<std::string, std::string> SqliteBag::read_definitions() {
  std::unordered_map<std::string, std::string> definitions;
  if (!database_.has_column("message_definitions", "topic_type") ||
      !database_.has_column("message_definitions", "encoding") ||
      !database_.has_column("message_definitions", "encoded_message_definition")) {
    return definitions;
  }
  SqliteStatement rows = database_.prepare(
      "SELECT topic_type, encoded_message_definition FROM message_definitions WHERE encoding = 'ros2msg'");
  while (rows.step()) {
    const auto type = rows.text(0);
    const auto text = rows.text(1);
    if (type && text) definitions.emplace(*type, *text);
  }
  return definitions;
}

std::optional<BagMessage> SqliteBag::next() {
  if (!messages_) return std::nullopt;
  try {
    if (auto message = read_row()) return message;
  } catch (const Error&) {
    cut_ = true;
  }
  messages_.reset();
  return std::nullopt;
}

std::optional<BagMessage> SqliteBag::read_row() {
  while (messages_->step()) {
    const auto topic = messages_->integer(0);
    const auto stamp = messages_->integer(1);
    const auto bytes = messages_->blob(2);
    const auto number = topic ? number_of_.find(*topic) : number_of_.end();
    if (number == number_of_.end() || !stamp || !bytes) {
      cut_ = true;
      return std::nullopt;
    }
    if (number->second) return BagMessage{*number->second, *stamp, *bytes};
  }
  return std::nullopt;
}

}  // namespace scrubjay

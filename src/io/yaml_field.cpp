#include "yaml_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/nearest_word.hpp>
#include <set>

namespace scrubjay {
namespace {

/// Text from a file, fit to stand in one line of an error.
std::string shown(const std::string& text) {
  constexpr std::size_t kLongest = 40;
  std::string line = text.substr(0, kLongest);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return text.size() > kLongest ? line + "..." : line;
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '\n') {
      out += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

YamlField YamlField::parse(const std::string& text, const std::string& file) {
  try {
    return {YAML::Load(text), "", file};
  } catch (const YAML::Exception& error) {
    throw Error(fmt::format("{}:{}: {}; want YAML", file, error.mark.line + 1, shown(error.msg)));
  }
}

void YamlField::expect_keys(const std::vector<std::string_view>& known) const {
  if (!node_.IsMap()) fail(fmt::format("fields such as {}", known.front()));
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    const std::string where = path_.empty() ? "" : " in " + path_;
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      const std::string_view nearest = nearest_word(shown(key), known);
      fail_at(entry.first.Mark(),
              fmt::format("there is no field '{}'{}; did you mean '{}'?", shown(key), where, nearest));
    }
    if (!seen.insert(key).second)
      fail_at(entry.first.Mark(), fmt::format("'{}' is given twice{}; want it once", key, where));
  }
}

bool YamlField::has(std::string_view key) const {
  const YAML::Node node = node_[std::string(key)];
  return node && !node.IsNull();
}

YamlField YamlField::at(std::string_view key) const {
  if (!node_.IsMap()) fail(fmt::format("a map with the field {}", key));
  const YAML::Node node = node_[std::string(key)];
  const std::string path = path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
  if (!node) fail_at(node_.Mark(), fmt::format("{} is missing", path));
  return {node, path, file_};
}

std::vector<YamlField> YamlField::items() const {
  if (!node_.IsSequence()) fail("a list");
  std::vector<YamlField> items;
  for (const YAML::Node& node : node_) {
    items.push_back({node, fmt::format("{}[{}]", path_, items.size()), file_});
  }
  return items;
}

YamlField YamlField::choice(std::string_view key, std::string_view kind) const {
  if (!node_.IsMap() || node_.size() == 0) fail(fmt::format("a map of {}s", kind));
  if (has(key)) return at(key);
  std::vector<std::string> names;
  for (const auto& entry : node_) names.push_back(entry.first.Scalar());
  throw Error(fmt::format("{}: there is no {} '{}'; did you mean '{}'? (known: {})", file_, kind,
                          shown(std::string(key)), nearest_word(key, {names.begin(), names.end()}),
                          fmt::join(names, ", ")));
}

std::vector<YamlField> YamlField::items_of(std::string_view key) const {
  if (!has(key)) return {};
  return at(key).items();
}

std::string YamlField::text() const {
  if (!node_.IsScalar()) fail("text");
  return node_.Scalar();
}

bool YamlField::boolean() const {
  const std::string word = node_.IsScalar() ? node_.Scalar() : "";
  if (word != "true" && word != "false") fail("true or false");
  return word == "true";
}

double YamlField::number(const NumberRange& range) const {
  if (!node_.IsScalar()) fail(range.want);
  const std::string& word = node_.Scalar();
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* end = word.data() + word.size();
  double value = 0.0;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) fail(range.want);
  if (value < range.low || value > range.high || (range.above_low && value == range.low)) fail(range.want);
  return value;
}

std::vector<double> YamlField::numbers(std::size_t count, const NumberRange& range, std::string_view want) const {
  if (!node_.IsSequence() || node_.size() != count) fail(want);
  std::vector<double> values;
  for (const YamlField& item : items()) values.push_back(item.number(range));
  return values;
}

void YamlField::fail(std::string_view want) const {
  fail_at(node_.Mark(), fmt::format("{} is {}; want {}", name(), value(), want));
}

void YamlField::fail_at(const YAML::Mark& mark, const std::string& what) const {
  // Empty values carry no mark.
  throw Error(fmt::format("{}:{}: {}", file_, std::max(mark.line, 0) + 1, what));
}

std::string YamlField::value() const {
  switch (node_.Type()) {
    case YAML::NodeType::Scalar:
      return node_.Scalar().empty() ? "''" : shown(node_.Scalar());
    case YAML::NodeType::Sequence:
      return fmt::format("a list of {}", node_.size());
    case YAML::NodeType::Map:
      return "a map";
    default:
      return "empty";
  }
}

}  // namespace scrubjay

/// \file
/// A field of a YAML document, which knows where it stands: what is wrong with it can be said in one line.
#pragma once

#include <yaml-cpp/yaml.h>

#include <limits>
#include <scrubjay/geometry/pose2.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace scrubjay {

/// Numbers that a field takes, and how to ask for them.
struct NumberRange {
  double low = -std::numeric_limits<double>::infinity();  ///< smallest that is taken
  double high = std::numeric_limits<double>::infinity();  ///< largest that is taken
  bool above_low = false;                                 ///< `low` itself isn't
  std::string_view want = "a number";
};

/// Any text as a scalar in double quotes, which reads back the same.
std::string quoted(const std::string& text);

/// A node of a YAML document with its path, such as furniture[3].disc.radius. All readers throw Error:
/// `worlds/flat.yaml:12: furniture[3].disc.radius is -0.2; want a positive length in metres`.
class YamlField {
 public:
  /// The root of a document. Throws Error where it isn't YAML.
  static YamlField parse(const std::string& text, const std::string& file);

  bool is_map() const { return node_.IsMap(); }
  bool is_null() const { return node_.IsNull(); }

  /// Refuses anything but a map of these keys, each at most once; names the nearest of them for a key that isn't one.
  void expect_keys(const std::vector<std::string_view>& known) const;
  bool has(std::string_view key) const;
  /// The field `key`, which must be there.
  YamlField at(std::string_view key) const;
  /// The field `key` of a map whose keys are names of a `kind`; throws Error that lists them, and the nearest, if none
  /// is.
  YamlField choice(std::string_view key, std::string_view kind) const;
  /// The entries of a list.
  std::vector<YamlField> items() const;
  /// The entries of the list `key`; none if there is no such key.
  std::vector<YamlField> items_of(std::string_view key) const;

  std::string text() const;
  bool boolean() const;
  double number(const NumberRange& range) const;
  /// So many numbers: [x, y] or [x, y, yaw].
  std::vector<double> numbers(std::size_t count, const NumberRange& range, std::string_view want) const;

  /// Throws: where this field stands, its value, and `want`.
  [[noreturn]] void fail(std::string_view want) const;

 private:
  YamlField(const YAML::Node& node, std::string path, const std::string& file)
      : node_(node), path_(std::move(path)), file_(file) {}
  [[noreturn]] void fail_at(const YAML::Mark& mark, const std::string& what) const;
  std::string name() const { return path_.empty() ? "the document" : path_; }
  std::string value() const;

  YAML::Node node_;
  std::string path_;
  std::string file_;
};

}  // namespace scrubjay

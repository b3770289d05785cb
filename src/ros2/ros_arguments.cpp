#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <scrubjay/error.hpp>
#include <scrubjay/ros2/node_name.hpp>

namespace scrubjay::ros {
namespace {

/// `[node:]from:=to`
Remapping parse_remapping(const std::string& rule) {
  const auto fail = [&] { throw Error(fmt::format("the remapping '{}' is none; want from:=to", rule)); };
  const std::size_t middle = rule.find(":=");
  if (middle == std::string::npos) fail();
  Remapping remapping{.from = rule.substr(0, middle), .to = rule.substr(middle + 2)};
  const std::size_t colon = remapping.from.find(':');
  if (colon != std::string::npos && remapping.from.compare(colon, 3, "://") != 0) {
    remapping.node = remapping.from.substr(0, colon);
    remapping.from.erase(0, colon + 1);
  }
  if (remapping.from.empty() || remapping.to.empty() || (colon == 0)) fail();
  return remapping;
}

bool is_one_of(const std::string& word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Goes through the words of one section.
class Section {
 public:
  using Word = std::vector<std::string>::const_iterator;

  Section(Word first, Word last, RosArguments& to) : word_(first), end_(last), to_(to) {}

  void read() {
    while (word_ != end_) {
      const std::string& word = *word_++;
      if (is_one_of(word, {"-r", "--remap"})) {
        to_.remappings.push_back(parse_remapping(value_of(word)));
      } else if (is_one_of(word, {"-e", "--enclave"})) {
        to_.enclave = value_of(word);
      } else if (is_one_of(word,
                           {"-p", "--param", "--params-file", "--log-level", "--log-config-file", "--log-file-name"})) {
        to_.warnings.push_back(fmt::format("{} {} means nothing to scrubjay", word, value_of(word)));
      } else if (word.starts_with("--enable-") || word.starts_with("--disable-")) {
        to_.warnings.push_back(fmt::format("{} means nothing to scrubjay", word));
      } else if (word != "--ros-args") {
        throw Error(fmt::format("'{}' is no argument of ROS; want -r from:=to, -e enclave, or -- before others", word));
      }
    }
  }

 private:
  const std::string& value_of(const std::string& word) {
    if (word_ == end_) throw Error(fmt::format("{} wants a word behind it", word));
    return *word_++;
  }

  Word word_;
  Word end_;
  RosArguments& to_;
};

}  // namespace

RosArguments take_ros_arguments(std::vector<std::string>& words) {
  RosArguments arguments;
  for (auto first = std::find(words.begin(), words.end(), "--ros-args"); first != words.end();
       first = std::find(first, words.end(), "--ros-args")) {
    auto last = std::find(first, words.end(), "--");
    Section(first + 1, last, arguments).read();
    if (last != words.end()) ++last;
    first = words.erase(first, last);
  }
  return arguments;
}

}  // namespace scrubjay::ros

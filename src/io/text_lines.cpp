#include "text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <scrubjay/error.hpp>

namespace scrubjay {
namespace {

constexpr std::string_view kBlanks = " \t\r";

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
}

/// A word as an error shows it: not all of it if it is long, and on one line.
std::string shown(std::string_view word) {
  if (word.empty()) return "missing";
  std::string text(word.substr(0, 20));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return "\"" + text + (word.size() > 20 ? "...\"" : "\"");
}

}  // namespace

std::string_view TextLine::word() {
  skip_blanks(rest_);
  const std::string_view found = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(found.size());
  ++field_;
  return found;
}

double TextLine::number(std::string_view what) {
  const std::string_view text = word();
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    fail_field(fmt::format("{} is {}; want a number", what, shown(text)));
  }
  return value;
}

int TextLine::count(std::string_view what) {
  constexpr int kMost = 1000000000;
  const std::string_view text = word();
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0 || value > kMost) {
    fail_field(fmt::format("{} is {}; want a whole number", what, shown(text)));
  }
  return value;
}

void TextLine::fail(const std::string& complaint) const {
  throw Error(fmt::format("{}:{}: {}", name_, number_, complaint));
}

void TextLine::fail_field(const std::string& complaint) const {
  fail(fmt::format("field {}: {}", field_, complaint));
}

std::optional<TextLine> TextLines::next() {
  while (!rest_.empty()) {
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++number_;
    skip_blanks(line);
    if (!line.empty() && line.front() != '#') return TextLine(name_, number_, line);
  }
  return std::nullopt;
}

}  // namespace scrubjay

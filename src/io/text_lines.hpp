/// \file
/// Words and numbers of text files, with errors that say where something is wrong.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scrubjay {

/// One line, taken apart word by word. Refers to the text and the name that it came from.
class TextLine {
 public:
  TextLine(const std::string& name, int number, std::string_view text) : name_(name), number_(number), rest_(text) {}

  /// The next word between blanks; empty at the line's end.
  std::string_view word();
  /// The next word as a finite number. `what` names it in the error: "x", "range".
  double number(std::string_view what);
  /// The next word as a whole number from 0 to 1000000000.
  int count(std::string_view what);
  /// Throws Error: "name:line: complaint".
  [[noreturn]] void fail(const std::string& complaint) const;
  /// The same of the word taken last: "name:line: field 3: complaint".
  [[noreturn]] void fail_field(const std::string& complaint) const;

 private:
  const std::string& name_;
  int number_;  ///< of the line, from 1
  std::string_view rest_;
  int field_ = 0;  ///< words taken so far
};

/// The lines of a text, without those that are empty or begin with #.
class TextLines {
 public:
  /// Both must outlive it; `name` stands in the errors.
  TextLines(std::string_view text, const std::string& name) : name_(name), rest_(text) {}
  std::optional<TextLine> next();

 private:
  const std::string& name_;
  std::string_view rest_;
  int number_ = 0;
};

}  // namespace scrubjay

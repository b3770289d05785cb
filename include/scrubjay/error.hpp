/// \file
/// The one exception of the hosted floors.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace scrubjay {

/// Bad input or a run that failed, in one line made for people: what, where, and what would be right.
class Error : public std::runtime_error {
 public:
  enum class Kind { Input, Failure };  ///< exit code 2 or 1

  /// Control characters, which a message may have from somebody's file, become spaces: it stays one line.
  explicit Error(std::string message, Kind kind = Kind::Input)
      : std::runtime_error(one_line(std::move(message))), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  static std::string one_line(std::string message) {
    for (char& c : message) {
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    return message;
  }

  Kind kind_;
};

}  // namespace scrubjay

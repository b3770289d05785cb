/// \file
/// The one exception of the hosted floors.
#pragma once

#include <stdexcept>
#include <string>

namespace scrubjay {

/// Bad input or a run that failed, in one line made for people: what, where, and what would be right.
class Error : public std::runtime_error {
 public:
  enum class Kind { Input, Failure };  ///< exit code 2 or 1

  explicit Error(const std::string& message, Kind kind = Kind::Input) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace scrubjay

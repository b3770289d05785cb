/// \file
/// A terminal with a user in front of it, and the program in it.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace scrubjay {

/// `scrubjay words...` as the only program of a terminal of 80 x 24, which is the one that controls it. The program is
/// killed if it doesn't end by itself.
class TerminalCall {
 public:
  explicit TerminalCall(const std::vector<std::string>& words);
  TerminalCall(const TerminalCall&) = delete;
  TerminalCall& operator=(const TerminalCall&) = delete;
  ~TerminalCall();

  void type(std::string_view keys) const;
  /// Reads what is on the screen until `text` is there; false if the program ends, or two minutes pass, before.
  bool wait_for(std::string_view text);
  /// The same while a key is held, which repeats itself.
  bool hold_until(std::string_view key, std::string_view text);
  /// Closes the terminal, as a window is closed.
  void hang_up();
  void send(int signal) const;
  /// Waits for the end: the exit code, or minus the signal that ended it. Killed after two minutes.
  int wait();
  /// All that was shown since the start, escape sequences and all.
  const std::string& shown() const { return shown_; }
  void forget() { shown_.clear(); }
  /// Whether the terminal gives lines again, and shows what is typed.
  bool is_cooked() const;

 private:
  bool read_some();

  int user_ = -1;      // our end
  int terminal_ = -1;  // the program's, kept open to look at its settings
  pid_t pid_ = -1;
  std::string shown_;
};

}  // namespace scrubjay

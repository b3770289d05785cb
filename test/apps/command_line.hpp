/// \file
/// The program `scrubjay` as a child process, as a user would call it.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scrubjay {

using Words = std::vector<std::string>;

/// What a call left behind.
struct Outcome {
  int code = -1;   ///< exit code; -1 if a signal ended it
  int signal = 0;  ///< the signal that ended it, if one did
  std::string out;
  std::string err;
};

/// Where and under what a call runs.
struct Surroundings {
  std::filesystem::path folder = ".";              ///< working folder
  std::optional<std::size_t> largest_file;         ///< no file of the child's may grow beyond it [bytes]
  std::optional<std::filesystem::path> err_to;     ///< a file or terminal for stderr, which is then not captured
  std::optional<std::filesystem::path> out_to;     ///< the same for stdout
  std::optional<std::filesystem::path> in_from{};  ///< a file or pipe for stdin, which is empty otherwise
};

/// A call that goes on while the test does. It is killed if nobody waits for it.
class Call {
 public:
  explicit Call(const Words& words, const Surroundings& surroundings = {});
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;
  ~Call();

  void send(int signal) const;
  Outcome wait();

 private:
  pid_t pid_ = -1;
  int out_ = -1;  ///< where to read what is printed
  int err_ = -1;
};

/// Calls `scrubjay words...` and waits for its end.
Outcome scrubjay(const Words& words, const Surroundings& surroundings = {});

/// The same in a working folder.
inline Outcome scrubjay_in(const std::filesystem::path& folder, const Words& words) {
  return scrubjay(words, {.folder = folder, .largest_file = {}, .err_to = {}, .out_to = {}});
}

/// Path of a world that comes with the program, such as "room".
std::string own_world(const std::string& name);

/// Whether `text` is a single line, with its end.
bool is_one_line(const std::string& text);

}  // namespace scrubjay

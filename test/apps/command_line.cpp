#include "command_line.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

namespace scrubjay {
namespace {

/// The ends to read from and to write to. What the program prints is little enough to fit into a pipe until it is over.
std::array<int, 2> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a child's output");
  return ends;
}

std::string read_to_the_end(int file) {
  std::string text;
  char buffer[4096];
  for (ssize_t count = 0; (count = ::read(file, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  return text;
}

/// In the child: becomes the program, or exits with a code that the program never has.
[[noreturn]] void become(const std::vector<char*>& words, const Surroundings& surroundings, int out, int err) {
  constexpr int kNotStarted = 127;
  const auto open_for = [](const std::optional<std::filesystem::path>& path, int otherwise) {
    return path ? ::open(path->c_str(), O_WRONLY | O_NOCTTY) : otherwise;
  };
  // A named pipe that is opened for both doesn't wait for somebody at the other end.
  const int in_file = ::open(surroundings.in_from ? surroundings.in_from->c_str() : "/dev/null", O_RDWR | O_NOCTTY);
  const int out_file = open_for(surroundings.out_to, out);
  const int err_file = open_for(surroundings.err_to, err);
  bool ready = ::dup2(in_file, STDIN_FILENO) >= 0 && ::dup2(out_file, STDOUT_FILENO) >= 0 &&
               ::dup2(err_file, STDERR_FILENO) >= 0 && ::chdir(surroundings.folder.c_str()) == 0;
  if (surroundings.largest_file) {
    const rlimit limit{*surroundings.largest_file, *surroundings.largest_file};
    ready = ready && ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
  }
  if (ready) ::execv(SCRUBJAY_PROGRAM, words.data());
  ::_exit(kNotStarted);
}

}  // namespace

Call::Call(const Words& words, const Surroundings& surroundings) {
  std::vector<std::string> owned{"scrubjay"};
  owned.insert(owned.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : owned) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const auto [out, out_end] = make_pipe();
  const auto [err, err_end] = make_pipe();
  out_ = out;
  err_ = err;
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("no child process");
  if (pid_ == 0) become(pointers, surroundings, out_end, err_end);
  ::close(out_end);
  ::close(err_end);
}

Call::~Call() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  ::close(out_);
  ::close(err_);
}

void Call::send(int signal) const {
  ::kill(pid_, signal);
}

Outcome Call::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  pid_ = -1;
  Outcome outcome;
  if (WIFEXITED(status)) outcome.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = read_to_the_end(out_);
  outcome.err = read_to_the_end(err_);
  return outcome;
}

Outcome scrubjay(const Words& words, const Surroundings& surroundings) {
  return Call(words, surroundings).wait();
}

std::string own_world(const std::string& name) {
  return std::string(SCRUBJAY_SOURCE_DIR "/worlds/") + name + ".yaml";
}

bool is_one_line(const std::string& text) {
  return text.size() > 1 && text.find('\n') == text.size() - 1 && text.find('\r') == std::string::npos;
}

}  // namespace scrubjay

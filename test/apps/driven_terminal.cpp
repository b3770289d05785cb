#include "driven_terminal.hpp"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

namespace scrubjay {
namespace {

/// How long a program may take for what needs a second or two, on a machine with much else to do.
constexpr std::chrono::minutes kPatience(2);

/// In the child: a session of its own in the terminal, then the program.
[[noreturn]] void become(std::vector<char*>& words, const char* terminal) {
  ::setsid();
  const int file = ::open(terminal, O_RDWR);  // the first one that a session opens controls it
  bool ready = file >= 0 && ::ioctl(file, TIOCSCTTY, 0) == 0;
  for (const int end : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ready = ready && ::dup2(file, end) >= 0;
  if (ready) ::execv(SCRUBJAY_PROGRAM, words.data());
  ::_exit(127);
}

}  // namespace

TerminalCall::TerminalCall(const std::vector<std::string>& words)
    : user_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
  if (user_ < 0 || ::grantpt(user_) != 0 || ::unlockpt(user_) != 0) throw std::runtime_error("no terminal");
  const std::string name = ::ptsname(user_);
  terminal_ = ::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  const winsize size{24, 80, 0, 0};
  ::ioctl(user_, TIOCSWINSZ, &size);
  std::vector<std::string> owned{"scrubjay"};
  owned.insert(owned.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  for (std::string& word : owned) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("no child process");
  if (pid_ == 0) become(pointers, name.c_str());
}

TerminalCall::~TerminalCall() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  hang_up();
}

void TerminalCall::type(std::string_view keys) const {
  if (::write(user_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("can't type");
  }
}

bool TerminalCall::read_some() {
  char buffer[4096];
  pollfd end{user_, POLLIN, 0};
  if (::poll(&end, 1, 50) <= 0) return pid_ > 0 && ::kill(pid_, 0) == 0;
  const ssize_t count = ::read(user_, buffer, sizeof buffer);
  if (count > 0) shown_.append(buffer, static_cast<std::size_t>(count));
  return count > 0;
}

bool TerminalCall::wait_for(std::string_view text) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (shown_.find(text) == std::string::npos) {
    if (std::chrono::steady_clock::now() > end || !read_some()) return false;
  }
  return true;
}

bool TerminalCall::hold_until(std::string_view key, std::string_view text) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (shown_.find(text) == std::string::npos) {
    type(key);
    if (std::chrono::steady_clock::now() > end || !read_some()) return false;
  }
  return true;
}

void TerminalCall::hang_up() {
  if (terminal_ >= 0) ::close(terminal_);
  if (user_ >= 0) ::close(user_);
  user_ = terminal_ = -1;
}

void TerminalCall::send(int signal) const {
  ::kill(pid_, signal);
}

int TerminalCall::wait() {
  int status = 0;
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (::waitpid(pid_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) ::kill(pid_, SIGKILL);
    if (user_ >= 0) read_some();  // what nobody reads would hold the program up
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  pid_ = -1;
  while (user_ >= 0) {
    const std::size_t before = shown_.size();
    read_some();
    if (shown_.size() == before) break;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

bool TerminalCall::is_cooked() const {
  termios now{};
  constexpr tcflag_t kCooked = ICANON | ECHO | ISIG;
  return ::tcgetattr(terminal_, &now) == 0 && (now.c_lflag & kCooked) == kCooked;
}

}  // namespace scrubjay

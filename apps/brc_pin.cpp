#include "brc_pin.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <numeric>

namespace scrubjay::apps {
namespace {

std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

/// Whether there is something to read. A terminal is only read in the foreground: it stops whoever does behind.
bool stdin_ready() {
  pollfd file{STDIN_FILENO, POLLIN, 0};
  if (::poll(&file, 1, 0) <= 0) return false;
  return ::isatty(STDIN_FILENO) == 0 || ::tcgetpgrp(STDIN_FILENO) == ::getpgrp();
}

void add_all(std::size_t count, std::vector<std::size_t>& robots) {
  robots.resize(count);
  std::iota(robots.begin(), robots.end(), std::size_t{0});
}

}  // namespace

BrcPin::BrcPin(std::size_t robots) : count_(robots) {
  std::signal(SIGUSR1, [](int) { signalled = true; });
}

BrcPin::~BrcPin() {
  std::signal(SIGUSR1, SIG_IGN);
}

std::vector<std::size_t> BrcPin::pulsed() {
  std::vector<std::size_t> robots;
  if (listens_ && stdin_ready()) read_lines(robots);
  if (signalled.exchange(false)) add_all(count_, robots);
  return robots;
}

void BrcPin::read_lines(std::vector<std::size_t>& robots) {
  constexpr std::size_t kLongestLine = 64;
  std::array<char, 256> buffer{};
  const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (count <= 0) {
    listens_ = false;
    return;
  }
  for (const char c : std::string_view(buffer.data(), static_cast<std::size_t>(count))) {
    if (c != '\n') {
      if (line_.size() < kLongestLine) line_.push_back(c);
      continue;
    }
    obey(line_, robots);
    line_.clear();
  }
}

void BrcPin::obey(const std::string& line, std::vector<std::size_t>& robots) const {
  if (line.empty()) return;
  if (line == "brc") return add_all(count_, robots);
  constexpr std::string_view kOne = "brc ";
  if (line.starts_with(kOne)) {
    std::size_t robot = 0;
    const auto [end, error] = std::from_chars(line.data() + kOne.size(), line.data() + line.size(), robot);
    if (error == std::errc() && end == line.data() + line.size() && robot < count_) return robots.push_back(robot);
  }
  fmt::print(stderr, "scrubjay: '{}' on stdin says nothing; want brc, or brc 0 to brc {}\n", line, count_ - 1);
}

}  // namespace scrubjay::apps

/// \file
/// Somebody at a TCP port of this machine who reads lines.
#pragma once

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>

namespace scrubjay {

/// Waits for what it reads.
class LineListener {
 public:
  explicit LineListener(std::uint16_t port, int receive_buffer = 0) : file_(::socket(AF_INET, SOCK_STREAM, 0)) {
    const timeval patience{60, 0};
    ::setsockopt(file_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    if (receive_buffer > 0) ::setsockopt(file_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(file_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  LineListener(const LineListener&) = delete;
  LineListener& operator=(const LineListener&) = delete;
  ~LineListener() { ::close(file_); }

  /// A line with its end; what there was if the server ends before, or says nothing for a minute.
  std::string line() {
    std::array<char, 4096> some{};
    std::size_t end = 0;
    while ((end = text_.find('\n')) == std::string::npos) {
      const ssize_t count = ::read(file_, some.data(), some.size());
      if (count <= 0) return std::exchange(text_, {});
      text_.append(some.data(), static_cast<std::size_t>(count));
    }
    const std::string line = text_.substr(0, end + 1);
    text_.erase(0, end + 1);
    return line;
  }

 private:
  int file_;
  std::string text_;  // read, but no whole line yet or a later one
};

}  // namespace scrubjay

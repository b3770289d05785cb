/// \file
/// A client of a robot behind a pseudo-terminal, as plain as one can be.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <thread>
#include <vector>

namespace scrubjay {

/// Looks again and again until `condition` holds; false if it never did.
template <typename Condition>
bool eventually(const Condition& condition) {
  using Clock = std::chrono::steady_clock;
  for (const auto deadline = Clock::now() + std::chrono::seconds(60); Clock::now() < deadline;) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

class PtyClient {
 public:
  using Bytes = std::vector<std::uint8_t>;

  /// Waits until there is such a port.
  explicit PtyClient(const std::filesystem::path& port) {
    EXPECT_TRUE(eventually([&] { return (file_ = ::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) >= 0; }));
  }
  PtyClient(const PtyClient&) = delete;
  PtyClient& operator=(const PtyClient&) = delete;
  ~PtyClient() { ::close(file_); }

  void send(const Bytes& bytes) const {
    EXPECT_EQ(::write(file_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  /// What there is to read now.
  Bytes receive() const {
    Bytes bytes(4096);
    const ssize_t count = ::read(file_, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }
  /// Waits for so many bytes.
  Bytes receive(std::size_t count) const {
    Bytes all;
    EXPECT_TRUE(eventually([&] {
      const Bytes some = receive();
      all.insert(all.end(), some.begin(), some.end());
      return all.size() >= count;
    })) << "only "
        << all.size() << " bytes of " << count << " came";
    return all;
  }
  /// Asks for a packet of one or two bytes; an unsigned value, -1 if no answer came.
  int ask(std::uint8_t packet, std::size_t bytes) const {
    receive();
    send({142, packet});
    const Bytes answer = receive(bytes);
    if (answer.size() != bytes) return -1;
    return bytes == 1 ? answer[0] : answer[0] << 8 | answer[1];
  }

 private:
  int file_ = -1;
};

}  // namespace scrubjay

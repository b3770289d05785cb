#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/io/line_server.hpp>
#include <utility>

namespace scrubjay {
namespace {

/// A listener that waits for what it reads.
class Listener {
 public:
  explicit Listener(std::uint16_t port, int receive_buffer = 0) : file_(::socket(AF_INET, SOCK_STREAM, 0)) {
    if (receive_buffer > 0) ::setsockopt(file_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(file_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;
  ~Listener() { ::close(file_); }

  /// A line with its end; what there was if the server ends before.
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

TEST(LineServerTest, TellsEverybodyWhoListens) {
  LineServer server(0);
  EXPECT_NE(server.port(), 0);
  server.tell("nobody hears this");
  Listener one(server.port());
  server.tell("first");
  Listener other(server.port());
  server.tell("second");
  EXPECT_EQ(one.line(), "first\n");
  EXPECT_EQ(one.line(), "second\n");
  EXPECT_EQ(other.line(), "second\n");
}

TEST(LineServerTest, SurvivesListenersThatGo) {
  LineServer server(0);
  Listener stays(server.port());
  for (int i = 0; i < 5; ++i) {
    Listener goes(server.port());
    server.tell("hello");
    EXPECT_EQ(goes.line(), "hello\n");
    EXPECT_EQ(stays.line(), "hello\n");
  }
  for (int i = 0; i < 5; ++i) {
    server.tell("more");
    EXPECT_EQ(stays.line(), "more\n");
  }
}

TEST(LineServerTest, NeverWaitsForOneThatDoesntReadAndLosesWholeLines) {
  LineServer server(0);
  Listener slow(server.port(), 4096);
  const std::string line(1000, 'x');
  const int count = 20'000;
  for (int i = 0; i < count; ++i) server.tell(line + std::to_string(i));
  int last = -1;
  int heard = 0;
  // What is on its way and one line more, for the rest of the one that was cut.
  std::string text;
  for (; last < count; ++heard) {
    server.tell(line + std::to_string(count + heard));
    text = slow.line();
    ASSERT_EQ(text.substr(0, line.size()), line);
    const int number = std::stoi(text.substr(line.size()));
    EXPECT_GT(number, last);
    last = number;
  }
  EXPECT_LT(heard, count);
}

TEST(LineServerTest, RefusesAPortThatIsTaken) {
  const LineServer server(0);
  EXPECT_THROW(LineServer{server.port()}, Error);
}

}  // namespace
}  // namespace scrubjay

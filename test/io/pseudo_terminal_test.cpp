#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <numeric>
#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "all_values.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// A program that opens the link and knows nothing of us.
class Client {
 public:
  explicit Client(const fs::path& path) : file_(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK)) {}
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  ~Client() { ::close(file_); }

  bool is_open() const { return file_ >= 0; }
  int file() const { return file_; }
  void write(const Bytes& bytes) const {
    EXPECT_EQ(::write(file_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  /// Waits for so many, for as long as a loaded machine may need.
  Bytes read(std::size_t count) const {
    Bytes bytes;
    while (bytes.size() < count && wait(10000)) {
      Bytes piece(count - bytes.size());
      const ssize_t size = ::read(file_, piece.data(), piece.size());
      if (size <= 0) break;
      bytes.insert(bytes.end(), piece.begin(), piece.begin() + size);
    }
    return bytes;
  }
  std::size_t unread() const {
    int count = 0;
    EXPECT_EQ(::ioctl(file_, FIONREAD, &count), 0);
    return static_cast<std::size_t>(count);
  }
  void set(void (*change)(termios&)) const {
    termios settings{};
    ASSERT_EQ(::tcgetattr(file_, &settings), 0);
    change(settings);
    ASSERT_EQ(::tcsetattr(file_, TCSANOW, &settings), 0);
  }

 private:
  bool wait(int milliseconds) const {
    pollfd waiting{.fd = file_, .events = POLLIN, .revents = 0};
    return ::poll(&waiting, 1, milliseconds) > 0;
  }
  int file_;
};

void cook(termios& settings) {
  settings.c_iflag |= ICRNL | IXON | ISTRIP;
  settings.c_oflag |= OPOST | ONLCR;
  settings.c_lflag |= ICANON | ECHO | ISIG | IEXTEN;
}

Bytes read_from(PseudoTerminal& terminal, std::size_t count) {
  Bytes bytes;
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (bytes.size() < count && std::chrono::steady_clock::now() < limit) {
    pollfd waiting{.fd = terminal.descriptor(), .events = POLLIN, .revents = 0};
    ::poll(&waiting, 1, 100);
    Bytes piece(count - bytes.size());
    const ByteRead got = terminal.read(piece);
    EXPECT_TRUE(got.open);
    bytes.insert(bytes.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got.count));
  }
  return bytes;
}

/// Waits for a condition, for as long as a loaded machine may need.
template <typename Condition>
bool eventually(Condition condition) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    std::this_thread::yield();
  }
  return true;
}

class PseudoTerminalTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path link_ = folder_ / "robot";
};

TEST_F(PseudoTerminalTest, PassesEveryByteValueToTheClient) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  EXPECT_TRUE(terminal.write(all_values()));
  EXPECT_EQ(client.read(256), all_values());
}

TEST_F(PseudoTerminalTest, PassesEveryByteValueFromTheClient) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  client.write(all_values());
  EXPECT_EQ(read_from(terminal, 256), all_values());
}

TEST_F(PseudoTerminalTest, ReadsNothingWithoutAClientAndStaysOpen) {
  PseudoTerminal terminal(link_);
  std::array<std::uint8_t, 8> buffer{};
  const ByteRead got = terminal.read(buffer);
  EXPECT_EQ(got.count, 0U);
  EXPECT_TRUE(got.open);
}

TEST_F(PseudoTerminalTest, IsRawAgainAfterAClientHasCookedIt) {
  PseudoTerminal terminal(link_);
  { Client(link_).set(cook); }
  EXPECT_TRUE(terminal.write(all_values()));
  const Client client(link_);
  EXPECT_EQ(client.read(256), all_values());
  client.write(all_values());
  EXPECT_EQ(read_from(terminal, 256), all_values());
}

TEST_F(PseudoTerminalTest, EchoesNothingThatItWrites) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  client.set(cook);
  EXPECT_TRUE(terminal.write(all_values()));
  EXPECT_EQ(client.read(256), all_values());
  client.write({42});
  EXPECT_EQ(read_from(terminal, 1), Bytes{42});  // no echo came before it
}

TEST_F(PseudoTerminalTest, LetsClientsWaitAsTheyLike) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  client.set([](termios& settings) {
    cook(settings);
    settings.c_cc[VMIN] = 7;
    settings.c_cc[VTIME] = 3;
  });
  EXPECT_TRUE(terminal.write(Bytes{1}));
  termios settings{};
  ASSERT_EQ(::tcgetattr(client.file(), &settings), 0);
  EXPECT_EQ(settings.c_cc[VMIN], 7);
  EXPECT_EQ(settings.c_cc[VTIME], 3);
}

TEST_F(PseudoTerminalTest, OutlivesClientsThatComeAndGo) {
  PseudoTerminal terminal(link_);
  for (std::uint8_t i = 0; i < 20; ++i) {
    const Client client(link_);
    ASSERT_TRUE(client.is_open());
    client.write({i});
    EXPECT_EQ(read_from(terminal, 1), Bytes{i});
    EXPECT_TRUE(terminal.write(Bytes{i, 255}));
    EXPECT_EQ(client.read(2), (Bytes{i, 255}));
  }
  EXPECT_EQ(terminal.dropped(), 0U);
}

TEST_F(PseudoTerminalTest, NeverWaitsForAClientThatDoesNotRead) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  const Bytes frame(84, 1);
  for (int i = 0; i < 20000; ++i) EXPECT_TRUE(terminal.write(frame));  // or hangs
  EXPECT_GT(terminal.dropped(), PseudoTerminal::kBacklog);
}

TEST_F(PseudoTerminalTest, GivesAClientThatComesBackTheFreshBytes) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  std::size_t sent = 0;
  for (std::uint8_t i = 0; i < 250; ++i) {
    const std::size_t before = client.unread();
    EXPECT_TRUE(terminal.write(Bytes(84, i)));
    sent += 84;
    // As the robot's pauses do, lets it arrive.
    ASSERT_TRUE(eventually([&] { return client.unread() != before; }));
  }
  const std::size_t unread = client.unread();
  EXPECT_EQ(terminal.dropped() + unread, sent);
  EXPECT_LE(unread, PseudoTerminal::kBacklog);
  const Bytes got = client.read(unread);
  ASSERT_EQ(got.size(), unread);
  EXPECT_GE(got.front(), 250 - PseudoTerminal::kBacklog / 84);
  EXPECT_EQ(got.back(), 249);
}

TEST_F(PseudoTerminalTest, DropsNothingAsLongAsTheBacklogHoldsIt) {
  PseudoTerminal terminal(link_);
  Bytes sent(PseudoTerminal::kBacklog);
  std::iota(sent.begin(), sent.end(), std::uint8_t{0});
  for (std::size_t at = 0; at < sent.size(); at += 315) EXPECT_TRUE(terminal.write(std::span(sent).subspan(at, 315)));
  EXPECT_EQ(Client(link_).read(sent.size()), sent);
  EXPECT_EQ(terminal.dropped(), 0U);
}

TEST_F(PseudoTerminalTest, SendsMoreThanTheBacklogAtOnceToAClientThatReads) {
  PseudoTerminal terminal(link_);
  const Client client(link_);
  EXPECT_TRUE(terminal.write(Bytes(8000, 3)));
  EXPECT_EQ(client.read(8000), Bytes(8000, 3));
}

TEST_F(PseudoTerminalTest, LinksToItsDeviceAndTakesTheLinkAway) {
  {
    const PseudoTerminal terminal(link_);
    EXPECT_EQ(fs::read_symlink(link_), terminal.device());
    EXPECT_EQ(folder_.file_count(), 1U);
  }
  EXPECT_FALSE(fs::is_symlink(link_));
}

TEST_F(PseudoTerminalTest, ReplacesALinkToNowhere) {
  fs::create_symlink(folder_ / "gone", link_);
  const PseudoTerminal terminal(link_);
  EXPECT_EQ(fs::read_symlink(link_), terminal.device());
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(PseudoTerminalTest, RefusesToReplaceALinkToAPseudoTerminalThatLives) {
  const PseudoTerminal older(link_);
  const std::string message = message_of([&] { PseudoTerminal newer(link_); });
  EXPECT_NE(message.find(link_.string() + ": leads to " + older.device().string()), std::string::npos) << message;
  EXPECT_NE(message.find("in use"), std::string::npos) << message;
  EXPECT_EQ(fs::read_symlink(link_), older.device());
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(PseudoTerminalTest, ReplacesALinkToAPseudoTerminalThatIsGone) {
  fs::path gone;
  {
    const PseudoTerminal older(folder_ / "older");
    gone = older.device();
  }
  fs::create_symlink(gone, link_);  // its number may be the next one's
  const PseudoTerminal newer(link_);
  EXPECT_EQ(fs::read_symlink(link_), newer.device());
}

TEST_F(PseudoTerminalTest, LeavesALinkAloneThatSomebodyElseHasReplaced) {
  std::optional<PseudoTerminal> older(std::in_place, link_);
  fs::remove(link_);
  const PseudoTerminal newer(link_);
  older.reset();
  EXPECT_EQ(fs::read_symlink(link_), newer.device());
}

TEST_F(PseudoTerminalTest, RefusesToReplaceAFile) {
  folder_.write("robot", "precious");
  const std::string message = message_of([&] { PseudoTerminal terminal(link_); });
  EXPECT_NE(message.find(link_.string()), std::string::npos) << message;
  EXPECT_EQ(content_of(link_), "precious");
}

TEST_F(PseudoTerminalTest, RefusesToReplaceALinkToAFile) {
  folder_.write("file", "precious");
  fs::create_symlink(folder_ / "file", link_);
  EXPECT_THROW(PseudoTerminal terminal(link_), Error);
  EXPECT_EQ(content_of(link_), "precious");
}

TEST_F(PseudoTerminalTest, NamesALinkInAFolderThatIsNotThere) {
  const fs::path link = folder_ / "nowhere" / "robot";
  const std::string message = message_of([&] { PseudoTerminal terminal(link); });
  EXPECT_NE(message.find(link.string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file"), std::string::npos) << message;
}

}  // namespace
}  // namespace scrubjay

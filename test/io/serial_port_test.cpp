#include <asm/termbits.h>
#include <fcntl.h>
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/pseudo_terminal.hpp>
#include <scrubjay/io/serial_port.hpp>
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

/// Reads until so many came, the channel has closed, or a loaded machine had time enough.
Bytes read_all(ByteChannel& channel, std::size_t count) {
  Bytes bytes;
  std::array<std::uint8_t, 512> buffer{};
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (bytes.size() < count && std::chrono::steady_clock::now() < limit) {
    const ByteRead got = channel.read(buffer);
    bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(got.count));
    if (!got.open) break;
  }
  return bytes;
}

/// The clients' end of a pseudo-terminal, opened by somebody else.
struct Descriptor {
  explicit Descriptor(const fs::path& path) : file(::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(file); }
  termios2 settings() const {
    termios2 now{};
    EXPECT_EQ(::ioctl(file, TCGETS2, &now), 0);
    return now;
  }
  int file;
};

/// While it lives, root has no more rights than anybody.
class Nobody {
 public:
  Nobody() {
    if (!is_root_) return;
    groups_.resize(static_cast<std::size_t>(::getgroups(0, nullptr)));
    EXPECT_GE(::getgroups(static_cast<int>(groups_.size()), groups_.data()), 0);
    EXPECT_EQ(::setgroups(0, nullptr), 0);
    EXPECT_EQ(::setegid(65534), 0);
    EXPECT_EQ(::seteuid(65534), 0);
  }
  Nobody(const Nobody&) = delete;
  Nobody& operator=(const Nobody&) = delete;
  ~Nobody() {
    if (!is_root_) return;
    EXPECT_EQ(::seteuid(0), 0);
    EXPECT_EQ(::setegid(group_), 0);
    EXPECT_EQ(::setgroups(groups_.size(), groups_.data()), 0);
  }

 private:
  bool is_root_ = ::geteuid() == 0;
  gid_t group_ = ::getegid();
  std::vector<gid_t> groups_;
};

class SerialPortTest : public testing::Test {
 protected:
  TemporaryFolder folder_;
  fs::path link_ = folder_ / "robot";
  std::optional<PseudoTerminal> robot_{std::in_place, link_};
};

TEST_F(SerialPortTest, PassesEveryByteValueBothWays) {
  SerialPort port({.path = link_});
  EXPECT_TRUE(port.write(all_values()));
  EXPECT_EQ(read_all(*robot_, 256), all_values());
  EXPECT_TRUE(robot_->write(all_values()));
  EXPECT_EQ(read_all(port, 256), all_values());
}

TEST_F(SerialPortTest, StaysOpenWhileNothingComes) {
  SerialPort port({.path = link_});
  std::array<std::uint8_t, 8> buffer{};
  const ByteRead first = port.read(buffer);
  EXPECT_EQ(first.count, 0U);
  EXPECT_TRUE(first.open);
  const ByteRead second = port.read(buffer);
  EXPECT_GE(second.stamp - first.stamp, 0.010);
  EXPECT_GE(port.now(), second.stamp);
}

TEST_F(SerialPortTest, ClosesWhenTheDeviceGoes) {
  SerialPort port({.path = link_});
  robot_.reset();
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(port.read(buffer).open);
  EXPECT_FALSE(port.read(buffer).open);
  EXPECT_FALSE(port.write(Bytes{128}));
  EXPECT_NE(message_of([&] { port.set_baud(19200); }).find("the port is gone"), std::string::npos);
}

TEST_F(SerialPortTest, GivesUpWritingWhatNobodyTakes) {
  SerialPort port({.path = link_});
  EXPECT_FALSE(port.write(Bytes(1 << 20)));
  EXPECT_FALSE(port.write(Bytes(1 << 20)));
}

TEST_F(SerialPortTest, DropsWhatCameBeforeItWasOpened) {
  robot_->write(Bytes(100, 1));
  SerialPort port({.path = link_});
  robot_->write(Bytes{2});
  EXPECT_EQ(read_all(port, 1), Bytes{2});
}

TEST_F(SerialPortTest, ReadsAndWritesFromTwoThreads) {
  SerialPort port({.path = link_});
  Bytes sent(20000);
  for (std::size_t i = 0; i < sent.size(); ++i) sent[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
  std::atomic<std::size_t> received = 0;
  std::jthread writer([&](const std::stop_token& stop) {
    for (std::size_t at = 0; at < sent.size() && !stop.stop_requested();) {
      if (at - received > 1000) {
        std::this_thread::yield();  // more would be dropped on the way back
      } else {
        EXPECT_TRUE(port.write(std::span(sent).subspan(at, 16)));
        at += 16;
      }
    }
  });
  std::jthread echo([&](const std::stop_token& stop) {
    std::array<std::uint8_t, 64> buffer{};
    while (!stop.stop_requested()) {
      const ByteRead got = robot_->read(buffer);
      if (got.count > 0) robot_->write(std::span(buffer).first(got.count));
    }
  });
  Bytes got;
  while (got.size() < sent.size()) {
    const Bytes piece = read_all(port, 1);
    if (piece.empty()) break;  // too long
    got.insert(got.end(), piece.begin(), piece.end());
    received = got.size();
  }
  EXPECT_EQ(got, sent);
}

TEST_F(SerialPortTest, RefusesAPortThatIsInUseAndSaysByWhom) {
  std::optional<SerialPort> first(std::in_place, SerialAddress{.path = link_});
  const std::string message = message_of([&] { SerialPort second({.path = link_}); });
  EXPECT_NE(message.find(link_.string() + ": in use"), std::string::npos) << message;
  EXPECT_NE(message.find("(" + std::to_string(::getpid()) + ")"), std::string::npos) << message;
  first.reset();
  EXPECT_NO_THROW(SerialPort({.path = link_}));
}

TEST_F(SerialPortTest, RefusesAPortThatOthersHoldExclusivelyUntilTheRobotReadsAgain) {
  const Descriptor other(robot_->device());
  ASSERT_EQ(::ioctl(other.file, TIOCEXCL), 0);
  fs::permissions(robot_->device(), fs::perms(0666));
  const Nobody nobody;
  const std::string message = message_of([&] { SerialPort port({.path = robot_->device()}); });
  EXPECT_NE(message.find(": in use"), std::string::npos) << message;
  std::array<std::uint8_t, 1> none{};
  robot_->read(none);
  EXPECT_NO_THROW(SerialPort({.path = robot_->device()}));
}

TEST_F(SerialPortTest, NamesTheGroupThatMayUseThePort) {
  fs::permissions(robot_->device(), fs::perms(0060));
  const Nobody nobody;
  const std::string message = message_of([&] { SerialPort port({.path = robot_->device()}); });
  struct stat status {};
  ASSERT_EQ(::stat(robot_->device().c_str(), &status), 0);
  EXPECT_NE(message.find("no permission; its group " + std::string(::getgrgid(status.st_gid)->gr_name)),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("usermod"), std::string::npos) << message;
}

TEST_F(SerialPortTest, SaysWhenThePortIsItsOwnersAlone) {
  fs::permissions(robot_->device(), fs::perms::none);
  const Nobody nobody;
  const std::string message = message_of([&] { SerialPort port({.path = robot_->device()}); });
  EXPECT_NE(message.find("no permission; its owner alone"), std::string::npos) << message;
}

TEST_F(SerialPortTest, KeepsOthersOutWhileItIsOpen) {
  fs::permissions(robot_->device(), fs::perms(0666));
  const Nobody nobody;
  {
    const SerialPort port({.path = robot_->device()});
    EXPECT_EQ(Descriptor(robot_->device()).file, -1);
  }
  EXPECT_GE(Descriptor(robot_->device()).file, 0);
}

TEST_F(SerialPortTest, IsRawWhateverItFound) {
  const Descriptor other(link_);
  termios2 cooked = other.settings();
  cooked.c_iflag |= ICRNL | IXON | ISTRIP;
  cooked.c_oflag |= OPOST | ONLCR;
  cooked.c_lflag |= ECHO | ICANON | ISIG;
  cooked.c_cflag |= CSTOPB | PARENB | CRTSCTS;
  cooked.c_cc[VMIN] = 9;
  ASSERT_EQ(::ioctl(other.file, TCSETS2, &cooked), 0);
  SerialPort port({.path = link_});
  EXPECT_TRUE(port.write(all_values()));
  EXPECT_EQ(read_all(*robot_, 256), all_values());
}

TEST_F(SerialPortTest, ReadsRawBytesAndDoesNotWaitForMany) {
  const Descriptor other(link_);
  termios2 cooked = other.settings();
  cooked.c_iflag |= ICRNL | IXON | ISTRIP;
  cooked.c_cc[VMIN] = 9;
  ASSERT_EQ(::ioctl(other.file, TCSETS2, &cooked), 0);
  SerialPort port({.path = link_});
  // Past the robot, which would make them raw by itself.
  ASSERT_EQ(::write(robot_->descriptor(), all_values().data(), 256), 256);
  EXPECT_EQ(read_all(port, 256), all_values());
  ASSERT_EQ(::write(robot_->descriptor(), "x", 1), 1);
  EXPECT_EQ(read_all(port, 1), Bytes{'x'});
}

TEST_F(SerialPortTest, PutsTheSettingsBack) {
  // The robot's end would make them raw, but it isn't asked in between.
  const Descriptor other(link_);
  termios2 before = other.settings();
  before.c_lflag |= ECHO | ICANON;
  before.c_cc[VMIN] = 9;
  before.c_cflag = (before.c_cflag & ~static_cast<tcflag_t>(CBAUD)) | B9600;
  ASSERT_EQ(::ioctl(other.file, TCSETS2, &before), 0);
  {
    const SerialPort port({.path = link_});
    EXPECT_EQ(other.settings().c_lflag, 0U);
  }
  EXPECT_EQ(other.settings().c_lflag, before.c_lflag);
  EXPECT_EQ(other.settings().c_cc[VMIN], 9);
  EXPECT_EQ(other.settings().c_ospeed, 9600U);
}

TEST_F(SerialPortTest, TakesStandardAndOtherRates) {
  const Descriptor other(link_);
  SerialPort port({.path = link_, .baud = 57600});
  EXPECT_EQ(other.settings().c_ospeed, 57600U);
  EXPECT_EQ(other.settings().c_ispeed, 57600U);
  for (const int baud : {300, 19200, 115200, 123456, 921600}) {
    port.set_baud(baud);
    EXPECT_EQ(other.settings().c_ospeed, static_cast<speed_t>(baud));
    EXPECT_EQ(other.settings().c_lflag, 0U);
  }
}

TEST_F(SerialPortTest, RefusesARateThatIsNone) {
  const Descriptor other(link_);
  SerialPort port({.path = link_});
  for (const int baud : {0, -9600}) {
    const std::string message = message_of([&] { port.set_baud(baud); });
    EXPECT_NE(message.find(std::to_string(baud) + " baud"), std::string::npos) << message;
  }
  EXPECT_EQ(other.settings().c_ospeed, 115200U);
}

TEST_F(SerialPortTest, HasNeitherWakeLinesNorLowLatencyOnAPseudoTerminal) {
  SerialPort port({.path = link_});
  EXPECT_FALSE(port.pulse_wake());
  EXPECT_FALSE(port.low_latency());
}

TEST(SerialPortErrorTest, NamesAPortThatIsNotThereAndWhatToDo) {
  const std::string message = message_of([] { SerialPort port({.path = "/dev/ttyUSB-none"}); });
  EXPECT_NE(message.find("/dev/ttyUSB-none: no such port"), std::string::npos) << message;
  EXPECT_TRUE(message.find("plug") != std::string::npos || message.find("/dev/tty", 10) != std::string::npos)
      << message;
}

TEST(SerialPortErrorTest, RefusesAFile) {
  const TemporaryFolder folder;
  const std::string message = message_of([&] { SerialPort port({.path = folder.write("file", "x")}); });
  EXPECT_NE(message.find("is no serial port"), std::string::npos) << message;
  const std::string of_folder = message_of([&] { SerialPort port({.path = folder.path()}); });
  EXPECT_NE(of_folder.find("is no serial port"), std::string::npos) << of_folder;
}

TEST(RatesToTryTest, BeginWithTheAddressesAndNameNoneTwice) {
  EXPECT_EQ(rates_to_try({.path = "port"}), (std::vector<int>{115200, 57600, 19200}));
  EXPECT_EQ(rates_to_try({.path = "port", .baud = 57600}), (std::vector<int>{57600, 115200, 19200}));
  EXPECT_EQ(rates_to_try({.path = "port", .baud = 38400}), (std::vector<int>{38400, 115200, 57600, 19200}));
}

TEST(SerialPortsTest, AreThoseOnUsb) {
  const TemporaryFolder folder;
  for (const char* name : {"ttyUSB1", "ttyACM0", "ttyUSB0", "tty1", "ttyS0", "null"}) folder.write(name, "");
  EXPECT_EQ(serial_ports(folder.path()),
            (std::vector<fs::path>{folder / "ttyACM0", folder / "ttyUSB0", folder / "ttyUSB1"}));
  EXPECT_TRUE(serial_ports(folder / "nowhere").empty());
}

TEST(SerialPortsTest, AreToldApartByTheirAdapters) {
  const TemporaryFolder folder;
  for (const char* name : {"ttyUSB0", "ttyUSB1"}) folder.write(name, "");
  fs::create_directories(folder / "serial/by-id");
  fs::create_symlink("../../ttyUSB7", folder / "serial/by-id/usb-gone");
  fs::create_symlink("../../ttyUSB1", folder / "serial/by-id/usb-FTDI_cable");
  EXPECT_EQ(adapter_name(folder / "ttyUSB1", folder.path()), "usb-FTDI_cable");
  EXPECT_EQ(adapter_name(folder / "ttyUSB0", folder.path()), "");
}

}  // namespace
}  // namespace scrubjay

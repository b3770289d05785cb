#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/io/serial_driver.hpp>

namespace scrubjay {
namespace {

namespace fs = std::filesystem;

TEST(SerialDriverTest, ReadsNameAndLatencyThroughALinkToThePort) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "sys/class/tty/ttyUSB3/device");
  fs::create_directories(folder / "sys/bus/drivers/ftdi_sio");
  fs::create_directory_symlink(folder / "sys/bus/drivers/ftdi_sio", folder / "sys/class/tty/ttyUSB3/device/driver");
  folder.write("sys/class/tty/ttyUSB3/device/latency_timer", "16\n");
  folder.write("ttyUSB3", "");
  fs::create_symlink(folder / "ttyUSB3", folder / "usb-FTDI_cable-port0");
  const SerialDriver driver = serial_driver(folder / "usb-FTDI_cable-port0", folder / "sys");
  EXPECT_EQ(driver.name, "ftdi_sio");
  EXPECT_EQ(driver.latency_ms, 16);
}

TEST(SerialDriverTest, KnowsNothingOfOtherPorts) {
  const TemporaryFolder folder;
  EXPECT_EQ(serial_driver(folder / "nowhere", folder / "sys").name, "");
  EXPECT_FALSE(serial_driver(folder / "nowhere", folder / "sys").latency_ms.has_value());
}

}  // namespace
}  // namespace scrubjay

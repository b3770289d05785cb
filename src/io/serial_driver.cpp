#include <fstream>
#include <scrubjay/io/serial_driver.hpp>

namespace scrubjay {

SerialDriver serial_driver(const std::filesystem::path& port, const std::filesystem::path& sys) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path device = fs::canonical(port, error);  // a name under /dev/serial/by-id is a link
  const fs::path adapter = sys / "class/tty" / (error ? port : device).filename() / "device";
  SerialDriver driver;
  const fs::path target = fs::read_symlink(adapter / "driver", error);
  if (!error) driver.name = target.filename().string();
  int latency = 0;
  if (std::ifstream(adapter / "latency_timer") >> latency) driver.latency_ms = latency;
  return driver;
}

}  // namespace scrubjay

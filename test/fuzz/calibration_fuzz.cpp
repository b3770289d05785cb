/// \file
/// Any text is a calibration that reads back as it was written, or is refused with an Error of one line.
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/calibration_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    CalibrationRecord record = parse_calibration(std::string(data, data + size), "fuzz");
    // The name holds what it holds; the rest has to survive.
    record.model = std::string(1, 'a');
    if (parse_calibration(calibration_text(record), "again") != record) std::abort();
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

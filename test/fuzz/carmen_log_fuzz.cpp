/// \file
/// Any bytes are a CARMEN log, plain or packed, that a robot can replay, or are refused with an Error of one line.
#include <cmath>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/carmen_robot.hpp>

namespace {

void replay(const scrubjay::CarmenLog& log) {
  scrubjay::CarmenRobot robot(log);
  std::size_t scans = 0;
  double last = log.records.front().stamp;
  while (const auto frame = robot.next()) {
    if (frame->stamp < last) std::abort();
    last = frame->stamp;
    if (!frame->scan) continue;
    ++scans;
    for (const float range : frame->scan->ranges) {
      if (std::isnan(range)) std::abort();
    }
  }
  if (scans != log.scans.size() || !log.records.front().scan) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    replay(parse_carmen_log({data, size}, "fuzz"));
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

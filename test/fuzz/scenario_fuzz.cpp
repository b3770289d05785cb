/// \file
/// Any text is a scenario that reads back as it was written, or is refused with an Error of one line.
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/scenario_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    const Scenario scenario = parse_scenario(std::string(data, data + size), "fuzz");
    // Names hold what they hold; the numbers have to survive.
    Scenario plain = scenario;
    plain.world = plain.model = plain.strategy = plain.noise = std::string(1, 'a');
    if (parse_scenario(scenario_text(plain), "again") != plain) std::abort();
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

/// \file
/// Any text after `"verts":` makes one closed wall, or is refused with an Error of one line.
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/world_reader.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  const std::string text = R"({"id": "fuzz", "verts": )" + std::string(data, data + size);
  try {
    const World world = parse_world(text, "fuzz");
    if (world.walls.size() != 1 || world.walls[0].points.size() < 3) std::abort();
    if (world.walls[0].points.front() != world.walls[0].points.back()) std::abort();
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

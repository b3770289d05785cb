/// \file
/// Any text is a world within its limits, or refused with an Error of one line.
#include <cmath>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/world_reader.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  const std::string text(data, data + size);
  try {
    const World world = parse_world(text, "fuzz");
    const std::vector<SolidSegment> solid = solid_segments(world);
    for (const SolidSegment& s : solid) {
      // A box or disc as large as the extent may lie at its edge.
      if (!(s.segment.a.cwiseAbs().maxCoeff() <= 3.0 * kWorldExtent)) std::abort();
      if (s.piece >= world.walls.size() + world.furniture.size() + world.doors.size()) std::abort();
    }
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

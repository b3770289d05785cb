/// \file
/// Any bytes are relations, plain or packed, or are refused with an Error of one line.
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/relations_file.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    const std::vector<Relation> relations = parse_relations({data, size}, "fuzz");
    // Whatever they say, they can be asked about; there is a trajectory of two poses.
    const StampedPose track[] = {{0.0, {}}, {1.0, {1.0, 0.0, 0.5}}};
    if (relation_error(track, relations, 0.0).matched > relations.size()) std::abort();
  } catch (const Error& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}

/// \file
/// Any bytes are a recording, a cut one, or refused with an Error.
#include <array>
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/recording.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    RecordingReader reader(std::vector<std::uint8_t>(data, data + size), "fuzz");
    RecordedChannel channel(reader);
    std::array<std::uint8_t, 100> buffer{};
    std::size_t total = 0;
    while (true) {
      const ByteRead got = channel.read(buffer);
      if (got.count > buffer.size()) std::abort();
      if (!got.open) break;
      total += got.count;
    }
    // No record of one byte or more stands for more than 255 bytes that aren't in the file.
    if (total > size * 256) std::abort();
  } catch (const Error&) {
  }
  return 0;
}

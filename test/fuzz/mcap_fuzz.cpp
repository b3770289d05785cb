/// \file
/// Any bytes are a bag, a cut one, or refused with an Error.
#include <cstdlib>
#include <scrubjay/error.hpp>
#include <scrubjay/io/mcap.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scrubjay;
  try {
    McapReader reader(std::vector<std::uint8_t>(data, data + size), "fuzz");
    unsigned sum = 0;
    while (const auto message = reader.next()) {
      if (message->topic >= reader.topics().size() || message->nanoseconds < 0) std::abort();
      if (!message->bytes.empty()) {
        sum += std::to_integer<unsigned>(message->bytes.front()) + std::to_integer<unsigned>(message->bytes.back());
      }
    }
    [[maybe_unused]] const volatile unsigned read = sum;
    // Once at the end, it stays there.
    if (reader.next()) std::abort();
  } catch (const Error&) {
  }
  return 0;
}

/// \file
/// Any bytes are a message or none, of whichever type is asked for; what is one is the same after its bytes.
#include <cstdlib>
#include <scrubjay/messages/cdr.hpp>

#include "messages/every_message.hpp"

namespace {

using namespace scrubjay::ros;

template <Message M>
void read(std::span<const std::byte> bytes) {
  const auto message = decode<M>(bytes);
  if (!message) return;
  const Bytes again = encode(*message);
  const auto back = decode<M>(again);
  // By their bytes: not every number equals itself.
  if (!back || encode(*back) != again) std::abort();
}

template <class... M>
void read_one(std::size_t which, std::span<const std::byte> bytes, Messages<M...>*) {
  std::size_t i = 0;
  ((i++ == which ? read<M>(bytes) : void()), ...);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto bytes = std::as_bytes(std::span(data, size));
  read_one(std::to_integer<std::size_t>(bytes.front()), bytes.subspan(1), static_cast<EveryMessage*>(nullptr));
  return 0;
}

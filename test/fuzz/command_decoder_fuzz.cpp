// Any bytes through the command decoder: what it accepts is valid, and encodes to bytes that decode to the same
// command; chunks don't matter.
//
// The first byte chooses the model, the second one the size of the chunks.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <scrubjay/oi/command_decoder.hpp>
#include <span>
#include <variant>
#include <vector>

namespace {

using namespace scrubjay::oi;
using Events = std::vector<std::variant<Command, Rejected>>;

void require(bool holds) {
  if (!holds) std::abort();
}

Events decode(std::span<const std::uint8_t> bytes, std::size_t chunk, Model model) {
  CommandDecoder decoder(model);
  Events events;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    decoder.feed(
        bytes.subspan(at, std::min(chunk, bytes.size() - at)), [&](const Command& c) { events.emplace_back(c); },
        [&](const Rejected& r) { events.emplace_back(r); });
  }
  require(decoder.commands() + decoder.rejected() + decoder.unknown_opcodes() == events.size());
  return events;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const Model model{static_cast<std::uint8_t>(data[0] % kModelCount)};
  const std::span<const std::uint8_t> bytes(data + 2, size - 2);
  const Events events = decode(bytes, bytes.size() + 1, model);
  require(decode(bytes, 1U + data[1], model) == events);
  for (const auto& event : events) {
    const auto* command = std::get_if<Command>(&event);
    if (command == nullptr) continue;
    require(valid_on(*command, model));
    const CommandBytes again = encode(*command);
    const Events same = decode(again.bytes(), again.size, model);
    require(same.size() == 1 && same.front() == event);
  }
  return 0;
}

// Any bytes, in any chunks, through the stream parser: it must keep its books, and its frames must be frames.
//
// The first byte chooses the model and whether a length is expected; the second one the size of the chunks.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <scrubjay/oi/stream_parser.hpp>
#include <span>
#include <vector>

namespace {

using namespace scrubjay::oi;

void require(bool holds) {
  if (!holds) std::abort();
}

struct Result {
  std::vector<std::uint8_t> payloads;
  StreamParser::Counters counters;
  std::size_t pending = 0;
  Sensors sensors;
  bool operator==(const Result&) const = default;
};

Result parse(std::span<const std::uint8_t> bytes, std::size_t chunk, Model model,
             std::optional<std::uint8_t> expected) {
  StreamParser parser(model, expected);
  Result result;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    parser.feed(bytes.subspan(at, std::min(chunk, bytes.size() - at)), [&](const StreamFrame& frame) {
      std::size_t inside = 0;
      for (const StreamFrame::Entry& entry : frame) {
        require(entry.id.exists_on(model) && entry.data.size() == entry.id.bytes());
        inside += 1 + entry.data.size();
      }
      require(inside == frame.payload().size() && (!expected || inside == *expected));
      require(decode(frame, model, result.sensors).ok);
      result.payloads.insert(result.payloads.end(), frame.payload().begin(), frame.payload().end());
    });
  }
  result.counters = parser.counters();
  result.pending = parser.pending();
  require(result.counters.frame_bytes + result.counters.skipped + result.pending == bytes.size());
  for (const PacketInfo& packet : kPackets) {
    if (result.sensors.has(packet.id)) require(accepted_range(packet.id, model).contains(result.sensors[packet.id]));
  }
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const Model model{static_cast<std::uint8_t>(data[0] % kModelCount)};
  const auto expected = data[0] >= 128 ? std::optional<std::uint8_t>(81) : std::nullopt;
  const std::span<const std::uint8_t> bytes(data + 2, size - 2);
  require(parse(bytes, 1U + data[1], model, expected) == parse(bytes, bytes.size() + 1, model, expected));
  return 0;
}

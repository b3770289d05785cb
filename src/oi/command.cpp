#include <algorithm>
#include <scrubjay/oi/command.hpp>
#include <utility>

#include "wire.hpp"

namespace scrubjay::oi {
namespace {

template <typename C>
std::size_t encoded_size(const C& command) {
  std::size_t size = 1U + wire::Codec<C>::kLength.fixed;
  if constexpr (wire::Codec<C>::kLength.variable()) {
    const auto& list = command.*std::get<std::tuple_size_v<decltype(C::kFields)> - 1>(C::kFields);
    size += list.size() * wire::Codec<C>::kLength.per_item;
  }
  return size;
}

template <typename C>
void write(const C& command, std::uint8_t* out) {
  *out++ = static_cast<std::uint8_t>(C::kOpcode);
  wire::Codec<C>::write(command, out);
}

/// Each row of the table of opcodes has one command, on each of its models.
template <typename... C>
constexpr bool covers_table(std::type_identity<std::variant<C...>>) {
  for (const OpcodeInfo& row : kOpcodes) {
    for (std::size_t i = 0; i < kModelCount; ++i) {
      const Model model{static_cast<std::uint8_t>(i)};
      if (!row.models.contains(model)) continue;
      if ((0 + ... + static_cast<int>(C::kOpcode == row.opcode && wire::spoken_by<C>(model))) != 1) return false;
    }
  }
  return true;
}
static_assert(covers_table(std::type_identity<Command>{}), "a command is missing, or its layout isn't the table's");

}  // namespace

std::size_t encode(const Command& command, std::span<std::uint8_t> out) {
  return std::visit(
      [out](const auto& c) -> std::size_t {
        const std::size_t size = encoded_size(c);
        if (size > out.size()) return 0;
        write(c, out.data());
        return size;
      },
      command);
}

CommandBytes encode(const Command& command) {
  CommandBytes bytes;
  bytes.size = encode(command, bytes.storage);
  return bytes;
}

Opcode opcode_of(const Command& command) {
  return std::visit([](const auto& c) { return c.kOpcode; }, command);
}

bool valid_on(const Command& command, Model model) {
  return std::visit(
      [model](const auto& c) {
        using C = std::remove_cvref_t<decltype(c)>;
        if (!wire::spoken_by<C>(model)) return false;
        if constexpr (requires { c.slot; }) return c.slot.value() < song_slots(model);
        if constexpr (requires { c.id; }) return c.id.exists_on(model);
        if constexpr (requires { c.ids; }) {
          return std::all_of(c.ids.begin(), c.ids.end(), [model](SensorId id) { return id.exists_on(model); });
        }
        return true;
      },
      command);
}

}  // namespace scrubjay::oi

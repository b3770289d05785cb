/// \file
/// How each type of a command's data goes over the wire. Encoder and decoder are both made from these.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <scrubjay/oi/command.hpp>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace scrubjay::oi::wire {

/// Bytes still to be read; reading past the end gives nothing.
using Input = std::span<const std::uint8_t>;

/// For each type: `kLength`, `write(value, out)`, which returns where the next value goes, and `read(in, value)`, which
/// takes its bytes off the front of `in` and says whether they are a value of the type.
template <typename T>
struct Codec;

template <typename T>
requires std::is_integral_v<T>
struct Codec<T> {
  static constexpr DataLength kLength{sizeof(T), 0};
  static std::uint8_t* write(T value, std::uint8_t* out) {
    const auto bits = static_cast<std::make_unsigned_t<T>>(value);
    if constexpr (sizeof(T) == 2) *out++ = static_cast<std::uint8_t>(bits >> 8);
    *out++ = static_cast<std::uint8_t>(bits);
    return out;
  }
  static bool read(Input& in, T& value) {
    if (in.size() < sizeof(T)) return false;
    std::uint32_t bits = in[0];
    if constexpr (sizeof(T) == 2) bits = bits << 8 | in[1];
    value = static_cast<T>(bits);
    in = in.subspan(sizeof(T));
    return true;
  }
};

/// A type that is made from a number by `of`, and goes over the wire as `Number`.
template <typename T, typename Number>
struct CheckedCodec {
  static constexpr DataLength kLength{sizeof(Number), 0};
  static bool read(Input& in, T& value) {
    Number number{};
    if (!Codec<Number>::read(in, number)) return false;
    const auto checked = T::of(number);
    if (checked) value = *checked;
    return checked.has_value();
  }
};

template <int Lo, int Hi>
struct Codec<Bounded<Lo, Hi>> : CheckedCodec<Bounded<Lo, Hi>, typename Bounded<Lo, Hi>::Wire> {
  using Number = typename Bounded<Lo, Hi>::Wire;
  static std::uint8_t* write(Bounded<Lo, Hi> value, std::uint8_t* out) {
    return Codec<Number>::write(static_cast<Number>(value.value()), out);
  }
};

template <>
struct Codec<Radius> : CheckedCodec<Radius, std::int16_t> {
  static std::uint8_t* write(Radius value, std::uint8_t* out) {
    return Codec<std::int16_t>::write(static_cast<std::int16_t>(value.value()), out);
  }
};

template <>
struct Codec<SensorId> : CheckedCodec<SensorId, std::uint8_t> {
  static std::uint8_t* write(SensorId value, std::uint8_t* out) {
    return Codec<std::uint8_t>::write(value.number(), out);
  }
};

template <typename T, std::size_t Count>
struct Codec<std::array<T, Count>> {
  static constexpr DataLength kLength{static_cast<std::uint8_t>(Codec<T>::kLength.fixed * Count), 0};
  static std::uint8_t* write(const std::array<T, Count>& values, std::uint8_t* out) {
    for (const T& value : values) out = Codec<T>::write(value, out);
    return out;
  }
  static bool read(Input& in, std::array<T, Count>& values) {
    return std::all_of(values.begin(), values.end(), [&](T& value) { return Codec<T>::read(in, value); });
  }
};

template <typename T, std::size_t Min, std::size_t Max>
struct Codec<FixedList<T, Min, Max>> {
  static constexpr DataLength kLength{1, Codec<T>::kLength.fixed};
  static std::uint8_t* write(const FixedList<T, Min, Max>& list, std::uint8_t* out) {
    *out++ = static_cast<std::uint8_t>(list.size());
    for (const T& value : list) out = Codec<T>::write(value, out);
    return out;
  }
  static bool read(Input& in, FixedList<T, Min, Max>& list) {
    std::uint8_t count = 0;
    if (!Codec<std::uint8_t>::read(in, count) || count > Max) return false;
    std::array<T, Max> items{};
    for (std::size_t i = 0; i < count; ++i) {
      if (!Codec<T>::read(in, items[i])) return false;
    }
    const auto checked = FixedList<T, Min, Max>::of({items.data(), count});
    if (checked) list = *checked;
    return checked.has_value();
  }
};

/// One part of a command after another; a list comes last.
constexpr DataLength operator+(DataLength a, DataLength b) {
  return {static_cast<std::uint8_t>(a.fixed + b.fixed), b.per_item};
}

template <typename T, typename Field>
using Member = std::remove_cvref_t<decltype(std::declval<T>().*std::declval<Field>())>;

template <Fielded T>
struct Codec<T> {
  static constexpr DataLength kLength = std::apply(
      [](auto... field) { return (DataLength{} + ... + Codec<Member<T, decltype(field)>>::kLength); }, T::kFields);
  static std::uint8_t* write(const T& value, std::uint8_t* out) {
    const auto put = [&](const auto& member) {
      out = Codec<std::remove_cvref_t<decltype(member)>>::write(member, out);
    };
    std::apply([&](auto... field) { (put(value.*field), ...); }, T::kFields);
    return out;
  }
  static bool read(Input& in, T& value) {
    return std::apply([&](auto... field) { return (... && Codec<Member<T, decltype(field)>>::read(in, value.*field)); },
                      T::kFields);
  }
};

/// Whether that model knows the command under this struct.
template <typename C>
constexpr bool spoken_by(Model model) {
  // Not by opcode_info: GCC 12 with -fsanitize=undefined can't compare its pointer with null in constant expressions.
  const std::size_t row = detail::kOpcodeRows[static_cast<std::size_t>(model)][static_cast<std::size_t>(C::kOpcode)];
  if (row == 0 || kOpcodes[row - 1].data != Codec<C>::kLength) return false;
  if constexpr (requires { C::kModels; }) return C::kModels.contains(model);
  return true;
}

}  // namespace scrubjay::oi::wire

/// \file
/// Values that can't be out of range: what commands are made of.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <type_traits>

namespace scrubjay::oi {

namespace detail {

void value_out_of_range();  // never defined: a call of it in a constant expression is the error message

}  // namespace detail

/// An integer from Lo to Hi, both included. Its size on the wire follows from the range.
template <int Lo, int Hi>
class Bounded {
  static_assert(Lo <= Hi && Lo >= -32768 && Hi <= 32767);

 public:
  using Wire = std::conditional_t<Lo >= 0 && Hi <= 255, std::uint8_t,
                                  std::conditional_t<Lo >= -128 && Hi <= 127, std::int8_t, std::int16_t>>;
  static constexpr int kMin = Lo;
  static constexpr int kMax = Hi;

  /// The value nearest to 0.
  constexpr Bounded() = default;
  /// From a literal; doesn't compile when out of range.
  consteval Bounded(int literal) : value_(static_cast<Wire>(literal)) {
    if (literal < Lo || literal > Hi) detail::value_out_of_range();
  }
  /// None when out of range.
  static constexpr std::optional<Bounded> of(int value) {
    if (value < Lo || value > Hi) return {};
    return clamped(value);
  }
  /// The nearest value in range.
  static constexpr Bounded clamped(int value) {
    Bounded bounded;
    bounded.value_ = static_cast<Wire>(value < Lo ? Lo : value > Hi ? Hi : value);
    return bounded;
  }

  constexpr int value() const { return value_; }
  bool operator==(const Bounded&) const = default;

 private:
  Wire value_ = static_cast<Wire>(Lo > 0 ? Lo : Hi < 0 ? Hi : 0);
};

/// A list of Min to Max items in its own storage. On the wire: the count in one byte, then the items.
template <typename T, std::size_t Min, std::size_t Max>
class FixedList {
  static_assert(Min <= Max && Max <= 255);

 public:
  using Item = T;
  static constexpr std::size_t kMin = Min;
  static constexpr std::size_t kMax = Max;

  /// As few items as there may be.
  constexpr FixedList() = default;
  /// From literals; doesn't compile with too few or too many.
  consteval FixedList(std::initializer_list<T> items) {
    if (items.size() < Min || items.size() > Max) detail::value_out_of_range();
    fill({items.begin(), items.size()});
  }
  /// None with too few or too many.
  static constexpr std::optional<FixedList> of(std::span<const T> items) {
    if (items.size() < Min || items.size() > Max) return {};
    FixedList list;
    list.fill(items);
    return list;
  }

  constexpr std::size_t size() const { return size_; }
  constexpr const T* begin() const { return items_.data(); }
  constexpr const T* end() const { return items_.data() + size_; }
  constexpr const T& operator[](std::size_t i) const { return items_[i]; }
  constexpr bool operator==(const FixedList& other) const {
    return std::equal(begin(), end(), other.begin(), other.end());
  }

 private:
  constexpr void fill(std::span<const T> items) {
    std::copy(items.begin(), items.end(), items_.begin());
    size_ = static_cast<std::uint8_t>(items.size());
  }

  std::array<T, Max> items_{};
  std::uint8_t size_ = Min;
};

}  // namespace scrubjay::oi

/// \file
/// The fields of a message by name, which encoder, decoder, text and type hash are all made from.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace scrubjay::ros {

/// One field of a message: its name in the interface's definition, and where it is in ours.
template <class Message, class Value>
struct Field {
  std::string_view name;
  Value Message::*member;
};

template <class Message, class Value>
constexpr Field<Message, Value> field(std::string_view name, Value Message::*member) {
  return {name, member};
}

/// A string that the interface bounds, as `string<=256`. The bound is a part of the type, not enforced here.
template <std::size_t Bound>
struct BoundedString {
  std::string text;
  bool operator==(const BoundedString&) const = default;
};

/// A constant of an interface's definition, of one of its integer types.
struct Constant {
  std::string_view type;
  std::string_view name;
  int value = 0;
};

/// What names its type (`kType`, as std_msgs/msg/Header), its RIHS01 hash (`kHash`) and its fields (`fields()`, a tuple
/// in the order of the definition). Some have `constants()`, too: an array of Constant.
template <class T>
concept Message = requires {
  T::kType;
  T::kHash;
  T::fields();
};

/// Calls `visit(name, value)` for each field in turn. `message` may be const.
template <class M, class Visit>
constexpr void for_each_field(M& message, Visit&& visit) {
  std::apply([&](const auto&... f) { (visit(f.name, message.*f.member), ...); }, std::remove_cvref_t<M>::fields());
}

}  // namespace scrubjay::ros

/// \file
/// The text of a message's definition, made from its fields.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace scrubjay::ros {
namespace detail {

template <class T>
struct Elements {};
template <class T>
struct Elements<std::vector<T>> {
  using Type = T;
  static std::string brackets() { return "[]"; }
};
template <class T, std::size_t N>
struct Elements<std::array<T, N>> {
  using Type = T;
  static std::string brackets() { return std::string("[").append(std::to_string(N)).append("]"); }
};

template <class T>
inline constexpr std::size_t kBound = 0;
template <std::size_t N>
inline constexpr std::size_t kBound<BoundedString<N>> = N;

template <class T>
constexpr std::string_view primitive_name() {
  if constexpr (std::is_same_v<T, bool>) return "bool";
  if constexpr (std::is_same_v<T, std::byte>) return "byte";
  if constexpr (std::is_same_v<T, char>) return "char";
  if constexpr (std::is_same_v<T, std::int8_t>) return "int8";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "uint8";
  if constexpr (std::is_same_v<T, std::int16_t>) return "int16";
  if constexpr (std::is_same_v<T, std::uint16_t>) return "uint16";
  if constexpr (std::is_same_v<T, std::int32_t>) return "int32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "uint32";
  if constexpr (std::is_same_v<T, float>) return "float32";
  if constexpr (std::is_same_v<T, double>) return "float64";
  if constexpr (std::is_same_v<T, std::string>) return "string";
  return "";
}

/// `package/msg/Name` as definitions write it: `package/Name`.
std::string short_name(std::string_view type);

/// A field's type as definitions write it.
template <class T>
std::string type_text() {
  if constexpr (requires { typename Elements<T>::Type; }) {
    return type_text<typename Elements<T>::Type>() + Elements<T>::brackets();
  } else if constexpr (Message<T>) {
    return short_name(T::kType);
  } else if constexpr (kBound<T> > 0) {
    return std::string("string<=").append(std::to_string(kBound<T>));
  } else {
    static_assert(!primitive_name<T>().empty(), "no type of an interface");
    return std::string(primitive_name<T>());
  }
}

/// Definitions one below the other.
class DefinitionText {
 public:
  /// `M`, then what it is made of and isn't there yet.
  template <Message M>
  void add() {
    if (!begin(M::kType)) return;
    if constexpr (requires { M::constants(); }) {
      for (const Constant& constant : M::constants()) add_constant(constant);
    }
    const M message{};
    for_each_field(message, [this]<class T>(std::string_view name, const T&) { add_field(type_text<T>(), name); });
    for_each_field(message, [this]<class T>(std::string_view, const T&) { this->template add_parts<T>(); });
  }
  std::string text() && { return std::move(text_); }

 private:
  template <class T>
  void add_parts() {
    if constexpr (requires { typename Elements<T>::Type; }) add_parts<typename Elements<T>::Type>();
    if constexpr (Message<T>) add<T>();
  }
  bool begin(std::string_view type);
  void add_constant(const Constant& constant);
  void add_field(const std::string& type, std::string_view name);

  std::string text_;
  std::vector<std::string_view> added_;
};

}  // namespace detail

/// The definition of `M` in ROS's own language and, below it, those of all messages that it is made of, as rosbag2 and
/// MCAP keep them (schema encoding `ros2msg`).
template <Message M>
std::string definition() {
  detail::DefinitionText text;
  text.add<M>();
  return std::move(text).text();
}

}  // namespace scrubjay::ros

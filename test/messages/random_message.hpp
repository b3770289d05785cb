/// \file
/// Messages full of anything.
#pragma once

#include <scrubjay/geometry/random.hpp>
#include <scrubjay/messages/definition.hpp>

namespace scrubjay::ros {

template <class T>
void fill(T& value, Random& random) {
  if constexpr (std::is_same_v<T, bool>) {
    value = random.uniform() < 0.5;
  } else if constexpr (std::is_same_v<T, std::byte>) {
    value = static_cast<std::byte>(random.below(256));
  } else if constexpr (std::is_floating_point_v<T>) {
    value = static_cast<T>(random.uniform(-1e6, 1e6));
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(random.next());
  } else if constexpr (std::is_same_v<T, std::string>) {
    value.assign(random.below(9), static_cast<char>('a' + random.below(26)));
  } else if constexpr (detail::kBound<T> > 0) {
    fill(value.text, random);
  } else if constexpr (Message<T>) {
    for_each_field(value, [&random](std::string_view, auto& part) { fill(part, random); });
  } else {
    using Element = typename detail::Elements<T>::Type;
    if constexpr (std::is_same_v<T, std::vector<Element>>) value.resize(random.below(5));
    for (Element& element : value) fill(element, random);
  }
}

template <Message M>
M random_message(Random& random) {
  M message;
  fill(message, random);
  return message;
}

}  // namespace scrubjay::ros

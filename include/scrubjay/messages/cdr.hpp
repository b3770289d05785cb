/// \file
/// Messages as the bytes that go over DDS and into recordings.
///
/// XCDR1 (OMG DDS-XTYPES 1.3, 7.4.3.4): an encapsulation of four bytes, then every value on a boundary of its own size,
/// counted from behind the encapsulation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <scrubjay/messages/definition.hpp>
#include <span>

namespace scrubjay::ros {

using Bytes = std::vector<std::byte>;

namespace detail {

template <class T>
concept Primitive = std::is_arithmetic_v<T> || std::is_same_v<T, std::byte>;

/// How many bytes a message has.
class CdrSize {
 public:
  template <Primitive T>
  void put(std::span<const T> values) {
    if (values.empty()) return;
    size_ = (size_ + sizeof(T) - 1) / sizeof(T) * sizeof(T) + values.size_bytes();
  }
  void put(const std::string& text) {
    put_length(0);
    size_ += text.size() + 1;
  }
  void put_length(std::size_t) { size_ = (size_ + 3) / 4 * 4 + 4; }
  std::size_t bytes() const { return size_; }

 private:
  std::size_t size_ = 0;
};

class CdrWriter {
 public:
  /// `payload`: bytes without the encapsulation, as CdrSize says; they begin on a boundary of eight.
  explicit CdrWriter(std::size_t payload);
  CdrWriter(const CdrWriter&) = delete;
  CdrWriter& operator=(const CdrWriter&) = delete;
  ~CdrWriter();

  template <Primitive T>
  void put(std::span<const T> values);
  void put(const std::string& text);
  void put_length(std::size_t length);
  Bytes finish() &&;

 private:
  struct Stream;
  Bytes bytes_;
  std::unique_ptr<Stream> stream_;
};

/// Once anything didn't fit, every further value stays as it is.
class CdrReader {
 public:
  explicit CdrReader(std::span<const std::byte> bytes);
  CdrReader(const CdrReader&) = delete;
  CdrReader& operator=(const CdrReader&) = delete;
  ~CdrReader();

  template <Primitive T>
  void get(std::span<T> values);
  void get(std::string& text);
  /// Of a sequence whose elements have `least` bytes each at least; 0 if so many aren't left.
  std::size_t get_length(std::size_t least);
  bool failed() const { return failed_; }

 private:
  struct Stream;
  std::size_t left() const;
  std::unique_ptr<Stream> stream_;
  bool failed_ = false;
};

template <class Stream, class T>
void put(Stream& out, const T& value) {
  if constexpr (Primitive<T>) {
    out.put(std::span(&value, 1));
  } else if constexpr (std::is_same_v<T, std::string>) {
    out.put(value);
  } else if constexpr (kBound<T> > 0) {
    out.put(value.text);
  } else if constexpr (Message<T>) {
    for_each_field(value, [&out](std::string_view, const auto& part) { put(out, part); });
    if constexpr (std::tuple_size_v<decltype(T::fields())> == 0) put(out, std::uint8_t{0});
  } else {
    using Element = typename Elements<T>::Type;
    if constexpr (std::is_same_v<T, std::vector<Element>>) out.put_length(value.size());
    if constexpr (Primitive<Element>) {
      out.put(std::span<const Element>(value));
    } else {
      for (const Element& element : value) put(out, element);
    }
  }
}

/// Bytes that no value of the type can do without.
template <class T>
constexpr std::size_t least_size() {
  if constexpr (Primitive<T>) {
    return sizeof(T);
  } else if constexpr (Message<T>) {
    const auto sum = []<class... V>(const Field<T, V>&...) { return (std::size_t{0} + ... + least_size<V>()); };
    return std::max<std::size_t>(1, std::apply(sum, T::fields()));
  } else if constexpr (requires { std::tuple_size<T>::value; }) {
    return std::tuple_size_v<T> * least_size<typename Elements<T>::Type>();
  } else {
    return sizeof(std::uint32_t);  // the length of a string or sequence
  }
}

template <class T>
void get(CdrReader& in, T& value) {
  if constexpr (Primitive<T>) {
    in.get(std::span(&value, 1));
  } else if constexpr (std::is_same_v<T, std::string>) {
    in.get(value);
  } else if constexpr (kBound<T> > 0) {
    in.get(value.text);
  } else if constexpr (Message<T>) {
    for_each_field(value, [&in](std::string_view, auto& part) { get(in, part); });
  } else {
    using Element = typename Elements<T>::Type;
    if constexpr (std::is_same_v<T, std::vector<Element>>) value.resize(in.get_length(least_size<Element>()));
    if constexpr (Primitive<Element>) {
      in.get(std::span<Element>(value));
    } else {
      for (Element& element : value) {
        get(in, element);
        if (in.failed()) return;
      }
    }
  }
}

}  // namespace detail

/// The bytes of a message, little endian.
template <Message M>
Bytes encode(const M& message) {
  detail::CdrSize size;
  detail::put(size, message);
  detail::CdrWriter writer(size.bytes());
  detail::put(writer, message);
  return std::move(writer).finish();
}

/// The message that these are the bytes of, little or big endian; none if they are cut, or hold a length that they
/// can't have. Takes memory in proportion to the bytes at most. What follows the message is ignored.
template <Message M>
std::optional<M> decode(std::span<const std::byte> bytes) {
  detail::CdrReader reader(bytes);
  M message;
  detail::get(reader, message);
  if (reader.failed()) return std::nullopt;
  return message;
}

}  // namespace scrubjay::ros

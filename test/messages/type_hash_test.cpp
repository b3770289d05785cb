#include <gtest/gtest.h>

#include <fmt/format.h>
#include <openssl/sha.h>

#include <map>
#include <scrubjay/messages/definition.hpp>

#include "messages/every_message.hpp"

namespace scrubjay::ros {
namespace {

/// Of type_description_interfaces/FieldType.
enum TypeId { kNested = 1, kInt8, kUInt8, kInt16, kUInt16, kInt32, kUInt32, kInt64, kUInt64, kFloat, kDouble };
constexpr int kBoolean = 15, kByte = 16, kString = 17, kBoundedString = 21, kArray = 48, kSequence = 144;

template <class T>
int type_id() {
  if constexpr (Message<T>) return kNested;
  if constexpr (detail::kBound < T >> 0) return kBoundedString;
  if constexpr (std::is_same_v<T, std::string>) return kString;
  if constexpr (std::is_same_v<T, bool>) return kBoolean;
  if constexpr (std::is_same_v<T, std::byte>) return kByte;
  if constexpr (std::is_same_v<T, char>) return kUInt8;  // rosidl's `char` is one
  if constexpr (std::is_same_v<T, std::int8_t>) return kInt8;
  if constexpr (std::is_same_v<T, std::uint8_t>) return kUInt8;
  if constexpr (std::is_same_v<T, std::int16_t>) return kInt16;
  if constexpr (std::is_same_v<T, std::uint16_t>) return kUInt16;
  if constexpr (std::is_same_v<T, std::int32_t>) return kInt32;
  if constexpr (std::is_same_v<T, std::uint32_t>) return kUInt32;
  if constexpr (std::is_same_v<T, float>) return kFloat;
  if constexpr (std::is_same_v<T, double>) return kDouble;
  return 0;
}

template <class T>
std::string type_json(int id_offset = 0, std::size_t capacity = 0) {
  if constexpr (requires { typename detail::Elements<T>::Type; }) {
    using Element = typename detail::Elements<T>::Type;
    if constexpr (std::is_same_v<T, std::vector<Element>>) {
      return type_json<Element>(kSequence);
    } else {
      return type_json<Element>(kArray, std::tuple_size_v<T>);
    }
  } else {
    std::string_view nested;
    if constexpr (Message<T>) nested = T::kType;
    return fmt::format(R"({{"type_id": {}, "capacity": {}, "string_capacity": {}, "nested_type_name": "{}"}})",
                       type_id<T>() + id_offset, capacity, detail::kBound<T>, nested);
  }
}

/// Descriptions by name, of a message and all that it is made of.
class Descriptions {
 public:
  template <class T>
  void add() {
    if constexpr (requires { typename detail::Elements<T>::Type; }) {
      add<typename detail::Elements<T>::Type>();
    } else if constexpr (Message<T>) {
      std::string fields;
      const T message{};
      for_each_field(message, [&]<class Part>(std::string_view name, const Part&) {
        fields += fmt::format(R"({}{{"name": "{}", "type": {}}})", fields.empty() ? "" : ", ", name, type_json<Part>());
        add<Part>();
      });
      if (fields.empty()) {
        fields =
            fmt::format(R"({{"name": "structure_needs_at_least_one_member", "type": {}}})", type_json<std::uint8_t>());
      }
      text_[std::string(T::kType)] = fmt::format(R"({{"type_name": "{}", "fields": [{}]}})", T::kType, fields);
    }
  }
  std::string json(std::string_view own) {
    std::string others;
    for (const auto& [name, text] : text_) {
      if (name != own) others += (others.empty() ? "" : ", ") + text;
    }
    return fmt::format(R"({{"type_description": {}, "referenced_type_descriptions": [{}]}})", text_[std::string(own)],
                       others);
  }

 private:
  std::map<std::string, std::string> text_;
};

/// REP-2011: SHA-256 of the type's description as JSON, of all that it refers to by name, default values aside.
template <Message M>
std::string rihs01() {
  Descriptions descriptions;
  descriptions.add<M>();
  const std::string json = descriptions.json(M::kType);
  std::array<unsigned char, SHA256_DIGEST_LENGTH> digest{};
  SHA256(reinterpret_cast<const unsigned char*>(json.data()), json.size(), digest.data());
  std::string hash = "RIHS01_";
  for (const unsigned char byte : digest) hash += fmt::format("{:02x}", byte);
  return hash;
}

template <Message M>
class TypeHashTest : public testing::Test {};
TYPED_TEST_SUITE(TypeHashTest, EveryMessage::In<testing::Types>, MessageName);

TYPED_TEST(TypeHashTest, IsThatOfTheFieldsThatWeHave) {
  EXPECT_EQ(TypeParam::kHash, rihs01<TypeParam>());
}

}  // namespace
}  // namespace scrubjay::ros

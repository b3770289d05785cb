/// \file
/// builtin_interfaces, std_msgs and rosgraph_msgs, as far as we use them.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>

namespace scrubjay::ros {

struct Time {
  static constexpr std::string_view kType = "builtin_interfaces/msg/Time";
  static constexpr std::string_view kHash = "RIHS01_b106235e25a4c5ed35098aa0a61a3ee9c9b18d197f398b0e4206cea9acf9c197";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  static constexpr auto fields() { return std::tuple(field("sec", &Time::sec), field("nanosec", &Time::nanosec)); }
  bool operator==(const Time&) const = default;
};

/// From nanoseconds, as recordings count them; what an int32 of seconds doesn't hold is moved to its end.
Time time_from_nanoseconds(std::int64_t nanoseconds);
std::int64_t to_nanoseconds(const Time& time);

struct Duration {
  static constexpr std::string_view kType = "builtin_interfaces/msg/Duration";
  static constexpr std::string_view kHash = "RIHS01_e8d009f659816f758b75334ee1a9ca5b5c0b859843261f14c7f937349599d93b";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  static constexpr auto fields() {
    return std::tuple(field("sec", &Duration::sec), field("nanosec", &Duration::nanosec));
  }
  bool operator==(const Duration&) const = default;
};

struct Header {
  static constexpr std::string_view kType = "std_msgs/msg/Header";
  static constexpr std::string_view kHash = "RIHS01_f49fb3ae2cf070f793645ff749683ac6b06203e41c891e17701b1cb597ce6a01";
  Time stamp;
  std::string frame_id;

  static constexpr auto fields() {
    return std::tuple(field("stamp", &Header::stamp), field("frame_id", &Header::frame_id));
  }
  bool operator==(const Header&) const = default;
};

struct Bool {
  static constexpr std::string_view kType = "std_msgs/msg/Bool";
  static constexpr std::string_view kHash = "RIHS01_feb91e995ff9ebd09c0cb3d2aed18b11077585839fb5db80193b62d74528f6c9";
  bool data = false;

  static constexpr auto fields() { return std::tuple(field("data", &Bool::data)); }
  bool operator==(const Bool&) const = default;
};

struct Int16 {
  static constexpr std::string_view kType = "std_msgs/msg/Int16";
  static constexpr std::string_view kHash = "RIHS01_1dcc3464e47c288a55f943a389d337cdb06804de3f5cd7a266b0de718eee17e5";
  std::int16_t data = 0;

  static constexpr auto fields() { return std::tuple(field("data", &Int16::data)); }
  bool operator==(const Int16&) const = default;
};

struct UInt16 {
  static constexpr std::string_view kType = "std_msgs/msg/UInt16";
  static constexpr std::string_view kHash = "RIHS01_08a406e4b022bc22e907f985d6a9e9dd1d4fbecae573549cf49350113e7757b1";
  std::uint16_t data = 0;

  static constexpr auto fields() { return std::tuple(field("data", &UInt16::data)); }
  bool operator==(const UInt16&) const = default;
};

struct Float32 {
  static constexpr std::string_view kType = "std_msgs/msg/Float32";
  static constexpr std::string_view kHash = "RIHS01_7170d3d8f841f7be3172ce5f4f59f3a4d7f63b0447e8b33327601ad64d83d6e2";
  float data = 0.0F;

  static constexpr auto fields() { return std::tuple(field("data", &Float32::data)); }
  bool operator==(const Float32&) const = default;
};

struct String {
  static constexpr std::string_view kType = "std_msgs/msg/String";
  static constexpr std::string_view kHash = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18";
  std::string data;

  static constexpr auto fields() { return std::tuple(field("data", &String::data)); }
  bool operator==(const String&) const = default;
};

/// No field; on the wire it is one octet, which is 0, for IDL knows no empty structure.
struct Empty {
  static constexpr std::string_view kType = "std_msgs/msg/Empty";
  static constexpr std::string_view kHash = "RIHS01_20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312";

  static constexpr auto fields() { return std::tuple(); }
  bool operator==(const Empty&) const = default;
};

/// Each from 0 to 1.
struct ColorRGBA {
  static constexpr std::string_view kType = "std_msgs/msg/ColorRGBA";
  static constexpr std::string_view kHash = "RIHS01_77a7a5b9ae477306097665106e0413ba74440245b1f3d0c6d6405fe5c7813fe8";
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
  float a = 0.0F;

  static constexpr auto fields() {
    return std::tuple(field("r", &ColorRGBA::r), field("g", &ColorRGBA::g), field("b", &ColorRGBA::b),
                      field("a", &ColorRGBA::a));
  }
  bool operator==(const ColorRGBA&) const = default;
};

struct MultiArrayDimension {
  static constexpr std::string_view kType = "std_msgs/msg/MultiArrayDimension";
  static constexpr std::string_view kHash = "RIHS01_5e773a60a4c7fc8a54985f307c7837aa2994252a126c301957a24e31282c9cbe";
  std::string label;
  std::uint32_t size = 0;
  std::uint32_t stride = 0;

  static constexpr auto fields() {
    return std::tuple(field("label", &MultiArrayDimension::label), field("size", &MultiArrayDimension::size),
                      field("stride", &MultiArrayDimension::stride));
  }
  bool operator==(const MultiArrayDimension&) const = default;
};

struct MultiArrayLayout {
  static constexpr std::string_view kType = "std_msgs/msg/MultiArrayLayout";
  static constexpr std::string_view kHash = "RIHS01_4c66e6f78e740ac103a94cf63259f968e48c617e7699e829b63c21a5cb50dac6";
  std::vector<MultiArrayDimension> dim;
  std::uint32_t data_offset = 0;

  static constexpr auto fields() {
    return std::tuple(field("dim", &MultiArrayLayout::dim), field("data_offset", &MultiArrayLayout::data_offset));
  }
  bool operator==(const MultiArrayLayout&) const = default;
};

struct UInt8MultiArray {
  static constexpr std::string_view kType = "std_msgs/msg/UInt8MultiArray";
  static constexpr std::string_view kHash = "RIHS01_5687e861b8d307a5e48b7515467ae7a5fc2daf805bd0ce6d8e9e604bade9f385";
  MultiArrayLayout layout;
  std::vector<std::uint8_t> data;

  static constexpr auto fields() {
    return std::tuple(field("layout", &UInt8MultiArray::layout), field("data", &UInt8MultiArray::data));
  }
  bool operator==(const UInt8MultiArray&) const = default;
};

struct Clock {
  static constexpr std::string_view kType = "rosgraph_msgs/msg/Clock";
  static constexpr std::string_view kHash = "RIHS01_692f7a66e93a3c83e71765d033b60349ba68023a8c689a79e48078bcb5c58564";
  Time clock;

  static constexpr auto fields() { return std::tuple(field("clock", &Clock::clock)); }
  bool operator==(const Clock&) const = default;
};

}  // namespace scrubjay::ros

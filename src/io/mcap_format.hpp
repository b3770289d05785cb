/// \file
/// What writer and reader of MCAP files must agree on: records, and the fields that they are made of.
///
/// Names as in the specification (mcap.dev/spec), "Records" and "Serialization".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scrubjay::mcap {

/// A byte that isn't text, a name, the version, and a line end that text-mode transfers would break.
inline constexpr std::array<std::byte, 8> kMagic{std::byte{0x89}, std::byte{'M'}, std::byte{'C'},  std::byte{'A'},
                                                 std::byte{'P'},  std::byte{'0'}, std::byte{'\r'}, std::byte{'\n'}};
inline constexpr std::size_t kVersionAt = 5;

/// First byte of a record.
enum class Opcode : std::uint8_t {
  Header = 0x01,
  Footer = 0x02,
  Schema = 0x03,
  Channel = 0x04,
  Message = 0x05,
  Chunk = 0x06,
  MessageIndex = 0x07,
  ChunkIndex = 0x08,
  Statistics = 0x0B,
  Metadata = 0x0C,
  MetadataIndex = 0x0D,
  SummaryOffset = 0x0E,
  DataEnd = 0x0F,
};

/// Opcode and length, before each record's content.
inline constexpr std::size_t kRecordHead = 1 + 8;
/// Of a message before its data: channel, sequence, log time, publish time.
inline constexpr std::size_t kMessageHead = 2 + 4 + 8 + 8;
inline constexpr std::size_t kFooterSize = 8 + 8 + 4;

/// The `library` that our headers name.
inline constexpr std::string_view kLibrary = "scrubjay";
/// rosbag2's own metadata record.
inline constexpr std::string_view kMetadataName = "rosbag2";
/// The encoding of ROS 2's messages.
inline constexpr std::string_view kCdr = "cdr";
inline constexpr std::string_view kQosKey = "offered_qos_profiles";
inline constexpr std::string_view kHashKey = "topic_type_hash";

using Bytes = std::vector<std::byte>;
using TextMap = std::vector<std::pair<std::string, std::string>>;

/// Appends fields to bytes. Numbers are little endian, lengths of strings and maps have 32 bits.
class Writer {
 public:
  /// `out` must outlive it.
  explicit Writer(Bytes& out) : out_(out) {}

  template <class T>
  Writer& number(T value) {
    std::array<std::byte, sizeof(T)> bytes{};
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = static_cast<std::byte>(value >> (8 * i));
    return this->bytes(bytes);
  }
  Writer& bytes(std::span<const std::byte> bytes);
  Writer& text(std::string_view text);
  Writer& map(const TextMap& map);
  /// Writes a record; `content` writes its fields to the writer that it gets.
  template <class Content>
  Writer& record(Opcode opcode, Content content) {
    number(static_cast<std::uint8_t>(opcode));
    return sized<std::uint64_t>(content);
  }
  /// What `content` writes, after its length in bytes as a `Length`.
  template <class Length, class Content>
  Writer& sized(Content content) {
    const std::size_t at = out_.size();
    number(Length{0});
    content(*this);
    set(at, static_cast<Length>(out_.size() - at - sizeof(Length)));
    return *this;
  }

 private:
  template <class T>
  void set(std::size_t at, T value) {
    for (std::size_t i = 0; i < sizeof(T); ++i) out_[at + i] = static_cast<std::byte>(value >> (8 * i));
  }

  Bytes& out_;
};

/// Takes fields from bytes. Once anything didn't fit, all further fields are zero or empty.
class Fields {
 public:
  explicit Fields(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class T>
  T number() {
    const std::span<const std::byte> taken = take(sizeof(T));
    T value = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) {
      value = static_cast<T>(value | (static_cast<T>(taken[i]) << (8 * i)));
    }
    return value;
  }
  std::string text();
  TextMap map();
  std::span<const std::byte> take(std::uint64_t size);
  std::span<const std::byte> rest() const { return rest_; }
  bool failed() const { return failed_; }

 private:
  std::span<const std::byte> rest_;
  bool failed_ = false;
};

struct Record {
  Opcode opcode{};
  std::span<const std::byte> content;
};

/// Takes a record; none at the end of `bytes`, or if it isn't whole.
std::optional<Record> take_record(std::span<const std::byte>& bytes);

struct Schema {
  std::uint16_t id = 0;
  std::string name;
  std::string encoding;
  std::string data;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;
  std::string topic;
  std::string encoding;
  TextMap metadata;
};

void put(Writer& out, const Schema& schema);
void put(Writer& out, const Channel& channel);
/// None if it is cut.
std::optional<Schema> parse_schema(std::span<const std::byte> content);
std::optional<Channel> parse_channel(std::span<const std::byte> content);

/// CRC-32 (ISO 3309, as in zlib) of `bytes`, going on from `previous`.
std::uint32_t checksum(std::span<const std::byte> bytes, std::uint32_t previous = 0);

}  // namespace scrubjay::mcap

#include <fastcdr/Cdr.h>

#include <scrubjay/messages/cdr.hpp>

namespace scrubjay::ros::detail {

namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::size_t kEncapsulation = 4;

/// What Fast CDR takes for a value of ours.
template <class T>
auto as_fast_cdr(T* values) {
  using Value = std::remove_const_t<T>;
  if constexpr (std::is_same_v<Value, std::byte>) {
    return reinterpret_cast<std::conditional_t<std::is_const_v<T>, const std::uint8_t, std::uint8_t>*>(values);
  } else {
    return values;
  }
}

}  // namespace

struct CdrWriter::Stream {
  explicit Stream(Bytes& bytes)
      : buffer(reinterpret_cast<char*>(bytes.data()), bytes.size()), cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR) {
    cdr.serialize_encapsulation();
  }
  FastBuffer buffer;
  Cdr cdr;
};

CdrWriter::CdrWriter(std::size_t payload)
    : bytes_(kEncapsulation + payload), stream_(std::make_unique<Stream>(bytes_)) {}
CdrWriter::~CdrWriter() = default;

template <Primitive T>
void CdrWriter::put(std::span<const T> values) {
  if (values.empty()) return;  // nor a boundary
  stream_->cdr.serializeArray(as_fast_cdr(values.data()), values.size());
}

void CdrWriter::put(const std::string& text) {
  put_length(text.size() + 1);
  stream_->cdr.serializeArray(text.c_str(), text.size() + 1);
}

void CdrWriter::put_length(std::size_t length) {
  stream_->cdr.serialize(static_cast<std::uint32_t>(length));
}

Bytes CdrWriter::finish() && {
  return std::move(bytes_);
}

struct CdrReader::Stream {
  explicit Stream(std::span<const std::byte> bytes)
      // Fast CDR has no buffer that can only be read; nothing is written through this one.
      : buffer(const_cast<char*>(reinterpret_cast<const char*>(bytes.data())), bytes.size()),
        cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR),
        size(bytes.size()) {}
  FastBuffer buffer;
  Cdr cdr;
  std::size_t size;
};

CdrReader::CdrReader(std::span<const std::byte> bytes) : stream_(std::make_unique<Stream>(bytes)) {
  // Plain CDR in either order of bytes, and no parameter list; of the options, rmw looks at none.
  failed_ = bytes.size() < kEncapsulation || bytes[0] != std::byte{0} || bytes[1] > std::byte{1};
  if (!failed_) stream_->cdr.read_encapsulation();
}
CdrReader::~CdrReader() = default;

template <Primitive T>
void CdrReader::get(std::span<T> values) {
  if (failed_ || values.empty()) return;
  try {
    if constexpr (std::is_same_v<T, bool>) {
      for (bool& value : values) stream_->cdr.deserialize(value);  // looks at each: a byte of 2 is none
    } else {
      stream_->cdr.deserializeArray(as_fast_cdr(values.data()), values.size());
    }
  } catch (const eprosima::fastcdr::exception::Exception&) {
    failed_ = true;
  }
}

void CdrReader::get(std::string& text) {
  // Without its NUL in some vendors' empty strings, which then have no byte at all.
  text.resize(get_length(sizeof(char)));
  get(std::span(text.data(), text.size()));
  if (failed_ || text.empty()) return;
  if (text.back() != '\0') failed_ = true;
  text.pop_back();
}

std::size_t CdrReader::get_length(std::size_t least) {
  std::uint32_t length = 0;
  get(std::span(&length, 1));
  if (length > left() / least) failed_ = true;
  return failed_ ? 0 : length;
}

std::size_t CdrReader::left() const {
  return stream_->size - stream_->cdr.getSerializedDataLength();
}

// All primitive types of messages.
template void CdrWriter::put(std::span<const bool>);
template void CdrWriter::put(std::span<const std::byte>);
template void CdrWriter::put(std::span<const char>);
template void CdrWriter::put(std::span<const std::int8_t>);
template void CdrWriter::put(std::span<const std::uint8_t>);
template void CdrWriter::put(std::span<const std::int16_t>);
template void CdrWriter::put(std::span<const std::uint16_t>);
template void CdrWriter::put(std::span<const std::int32_t>);
template void CdrWriter::put(std::span<const std::uint32_t>);
template void CdrWriter::put(std::span<const float>);
template void CdrWriter::put(std::span<const double>);
template void CdrReader::get(std::span<bool>);
template void CdrReader::get(std::span<std::byte>);
template void CdrReader::get(std::span<char>);
template void CdrReader::get(std::span<std::int8_t>);
template void CdrReader::get(std::span<std::uint8_t>);
template void CdrReader::get(std::span<std::int16_t>);
template void CdrReader::get(std::span<std::uint16_t>);
template void CdrReader::get(std::span<std::int32_t>);
template void CdrReader::get(std::span<std::uint32_t>);
template void CdrReader::get(std::span<float>);
template void CdrReader::get(std::span<double>);

}  // namespace scrubjay::ros::detail

/// \file
/// How the records of an MCAP chunk are packed and unpacked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

struct ZSTD_CCtx_s;

namespace scrubjay::mcap {

inline constexpr std::string_view kZstd = "zstd";
inline constexpr std::string_view kLz4 = "lz4";

/// Packs with zstd.
class Packer {
 public:
  Packer();
  /// None if the bytes don't become fewer. Valid until the next call.
  std::optional<std::span<const std::byte>> pack(std::span<const std::byte> bytes);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
  std::vector<std::byte> packed_;
};

/// Bytes that were left as they are when their place was taken: a size that turns out to be a lie costs no memory.
class Unpacked {
 public:
  Unpacked() = default;
  explicit Unpacked(std::size_t size) : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {}

  std::span<std::byte> bytes() { return {bytes_.get(), size_}; }
  std::span<const std::byte> bytes() const { return {bytes_.get(), size_}; }

 private:
  std::unique_ptr<std::byte[]> bytes_;
  std::size_t size_ = 0;
};

/// Whether `packed` bytes can become `unpacked` ones at all.
bool plausible(std::string_view compression, std::uint64_t packed, std::uint64_t unpacked);
/// What `packed` becomes, exactly as many bytes as `out` has; false if it doesn't, or the compression isn't known.
bool unpack(std::string_view compression, std::span<const std::byte> packed, std::span<std::byte> out);

}  // namespace scrubjay::mcap

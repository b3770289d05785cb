#include "mcap_packing.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>

namespace scrubjay::mcap {
namespace {

/// Fast enough for a robot's computer: the bench McapWrite tells what it costs.
constexpr int kLevel = 1;

// The most that one byte becomes: a block of 128 KiB from one byte repeated takes four in zstd (RFC 8878, 3.1.1.2),
// and a length in lz4 grows by 255 a byte.
constexpr std::uint64_t kMostZstd = (std::uint64_t{128} << 10) / 4;
constexpr std::uint64_t kMostLz4 = 255;

bool unpack_zstd(std::span<const std::byte> packed, std::span<std::byte> out) {
  const std::size_t size = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
  return ZSTD_isError(size) == 0 && size == out.size();
}

bool unpack_lz4(std::span<const std::byte> packed, std::span<std::byte> out) {
  struct Free {
    void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
  };
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0) return false;
  const std::unique_ptr<LZ4F_dctx, Free> context(made);
  while (true) {
    std::size_t written = out.size();
    std::size_t read = packed.size();
    const std::size_t wanted = LZ4F_decompress(context.get(), out.data(), &written, packed.data(), &read, nullptr);
    if (LZ4F_isError(wanted) != 0) return false;
    out = out.subspan(written);
    packed = packed.subspan(read);
    if (wanted == 0) return out.empty() && packed.empty();  // the frame's end
    if (written == 0 && read == 0) return false;
  }
}

}  // namespace

void Packer::Free::operator()(ZSTD_CCtx_s* context) const {
  ZSTD_freeCCtx(context);
}

Packer::Packer() : context_(ZSTD_createCCtx()) {}

std::optional<std::span<const std::byte>> Packer::pack(std::span<const std::byte> bytes) {
  packed_.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compressCCtx(context_.get(), packed_.data(), packed_.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0 || size >= bytes.size()) return std::nullopt;
  return std::span<const std::byte>(packed_).first(size);
}

bool plausible(std::string_view compression, std::uint64_t packed, std::uint64_t unpacked) {
  if (compression.empty()) return packed == unpacked;
  return unpacked / (compression == kLz4 ? kMostLz4 : kMostZstd) <= packed;
}

bool unpack(std::string_view compression, std::span<const std::byte> packed, std::span<std::byte> out) {
  if (compression == kZstd) return unpack_zstd(packed, out);
  if (compression == kLz4) return unpack_lz4(packed, out);
  if (!compression.empty() || packed.size() != out.size()) return false;
  std::copy(packed.begin(), packed.end(), out.begin());
  return true;
}

}  // namespace scrubjay::mcap

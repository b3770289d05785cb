#include "mcap_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/error.hpp>
#include <utility>

namespace scrubjay::mcap {
namespace {

/// Messages without a chunk are read about so many bytes at a time.
constexpr std::size_t kRunSize = std::size_t{1} << 20;
/// Of a chunk before the compression's name: times, size, checksum, the name's length.
constexpr std::size_t kChunkFixed = 8 + 8 + 8 + 4 + 4;
constexpr std::size_t kLongestCompression = 64;

class Scan {
 public:
  Scan(const Source& source, const std::string& name, Topics& topics)
      : source_(source), name_(name), cursor_(source), topics_(topics) {}

  Layout run() {
    check_magic();
    while (step()) {
    }
    take_summary();
    return std::move(layout_);
  }

 private:
  void check_magic();
  bool step();
  bool read_record(Opcode opcode, std::uint64_t size);
  bool read_message(std::uint64_t size);
  bool read_chunk(std::uint64_t size);
  bool read_declaration(Opcode opcode, std::uint64_t size);
  void take_summary();
  void read_data_end(std::uint64_t size);
  void read_footer(std::uint64_t size);
  std::optional<Bytes> content(std::uint64_t size) const;
  std::uint32_t checksum_of(std::uint64_t begin, std::uint64_t end) const;

  const Source& source_;
  const std::string& name_;
  Cursor cursor_;
  Topics& topics_;
  using Declarations = std::vector<std::pair<Opcode, Bytes>>;  ///< schemas and channels
  Declarations of_data_;
  Declarations of_summary_;
  std::optional<std::uint64_t> messages_;  ///< by the summary
  Layout layout_;
  bool in_summary_ = false;
  bool in_run_ = false;  ///< whether the last piece is a run of messages that goes on
};

void Scan::check_magic() {
  const auto given = cursor_.peek(kMagic.size());
  const auto differs = std::mismatch(given.begin(), given.end(), kMagic.begin()).first - given.begin();
  if (differs == static_cast<std::ptrdiff_t>(kVersionAt)) {
    throw Error(fmt::format("{}: MCAP file of version {}; this program reads version 0", name_,
                            static_cast<char>(given[kVersionAt])));
  }
  if (given.empty() || given.size() != static_cast<std::size_t>(differs)) {
    throw Error(fmt::format("{}: not an MCAP file; want one that begins with \\x89MCAP0\\r\\n", name_));
  }
  cursor_.skip(kMagic.size());
}

/// Steps over a record; false at the end, and where anything is damaged.
bool Scan::step() {
  Fields head(cursor_.peek(kRecordHead));
  const auto opcode = static_cast<Opcode>(head.number<std::uint8_t>());
  const auto size = head.number<std::uint64_t>();
  if (head.failed() || opcode == Opcode{} || size > cursor_.left() - kRecordHead) return false;
  if (opcode != Opcode::Message) in_run_ = false;
  if (!read_record(opcode, size)) return false;
  cursor_.skip(kRecordHead + size);
  return opcode != Opcode::Footer;
}

bool Scan::read_record(Opcode opcode, std::uint64_t size) {
  switch (opcode) {
    case Opcode::Header:
      if (const auto bytes = content(size)) {
        Fields fields(*bytes);
        fields.text();  // the profile: what counts is each channel's encoding
        layout_.library = fields.text();
      }
      return true;
    case Opcode::Schema:
    case Opcode::Channel:
      return read_declaration(opcode, size);
    case Opcode::Message:
      return in_summary_ || read_message(size);
    case Opcode::Chunk:
      return in_summary_ || read_chunk(size);
    case Opcode::Statistics:
      if (const auto bytes = content(size)) messages_ = Fields(*bytes).number<std::uint64_t>();
      return true;
    case Opcode::DataEnd:
      read_data_end(size);
      return true;
    case Opcode::Footer:
      read_footer(size);
      return true;
    default:
      return true;
  }
}

std::optional<Bytes> Scan::content(std::uint64_t size) const {
  Bytes bytes(static_cast<std::size_t>(size));
  if (!source_.read(cursor_.position() + kRecordHead, bytes)) return std::nullopt;
  return bytes;
}

bool Scan::read_declaration(Opcode opcode, std::uint64_t size) {
  auto bytes = content(size);
  if (bytes) (in_summary_ ? of_summary_ : of_data_).emplace_back(opcode, std::move(*bytes));
  return bytes.has_value();
}

/// Its schemas and channels come before the data's, for they have a checksum.
void Scan::take_summary() {
  if (layout_.has_summary) {
    layout_.messages = messages_;
  } else {
    of_summary_.clear();
  }
  for (const Declarations* declarations : {&of_summary_, &of_data_}) {
    for (const auto& [opcode, bytes] : *declarations) {
      layout_.damaged = !topics_.take({opcode, bytes}) || layout_.damaged;
      if (declarations == &of_summary_ && opcode == Opcode::Channel) layout_.channels_known = true;
    }
  }
}

bool Scan::read_message(std::uint64_t size) {
  Fields fields(cursor_.peek(kRecordHead + kMessageHead));
  fields.take(kRecordHead + 2 + 4);  // channel and sequence
  const auto time = fields.number<std::uint64_t>();
  if (fields.failed() || size < kMessageHead) return false;
  const std::uint64_t whole = kRecordHead + size;
  if (!in_run_ || layout_.pieces.back().packed + whole > kRunSize) {
    layout_.pieces.push_back({cursor_.position(), 0, 0, {}, 0, time});
    in_run_ = true;
  }
  Piece& run = layout_.pieces.back();
  run.packed += whole;
  run.unpacked += whole;
  run.first = std::min(run.first, time);
  return true;
}

bool Scan::read_chunk(std::uint64_t size) {
  if (size < kChunkFixed) return false;
  Fields fields(cursor_.peek(static_cast<std::size_t>(
      std::min<std::uint64_t>(kRecordHead + size, kRecordHead + kChunkFixed + kLongestCompression + 8))));
  fields.take(kRecordHead);
  Piece piece;
  piece.first = fields.number<std::uint64_t>();
  fields.number<std::uint64_t>();  // latest message
  piece.unpacked = fields.number<std::uint64_t>();
  piece.checksum = fields.number<std::uint32_t>();
  piece.compression = fields.text();
  piece.packed = fields.number<std::uint64_t>();
  const std::uint64_t head = kChunkFixed + piece.compression.size() + 8;
  if (fields.failed() || head > size || piece.packed > size - head) return false;
  if (!piece.compression.empty() && piece.compression != kZstd && piece.compression != kLz4) {
    throw Error(fmt::format("{}: packed with {}; want zstd, lz4 or nothing", name_, piece.compression));
  }
  piece.position = cursor_.position() + kRecordHead + head;
  layout_.pieces.push_back(std::move(piece));
  return true;
}

/// The data's own checksum is worth another look at all of it only where messages have no other.
void Scan::read_data_end(std::uint64_t size) {
  in_summary_ = true;
  const auto bytes = content(size);
  if (!bytes) return;
  const auto sum = Fields(*bytes).number<std::uint32_t>();
  const bool needed =
      std::any_of(layout_.pieces.begin(), layout_.pieces.end(), [](const Piece& piece) { return piece.checksum == 0; });
  if (sum != 0 && needed && checksum_of(0, cursor_.position()) != sum) layout_.damaged = true;
}

void Scan::read_footer(std::uint64_t size) {
  const std::uint64_t content_at = cursor_.position() + kRecordHead;
  const auto bytes = content(size);
  if (!bytes || size != kFooterSize) return;
  Fields fields(*bytes);
  const auto summary = fields.number<std::uint64_t>();
  fields.number<std::uint64_t>();  // summary offsets
  const auto sum = fields.number<std::uint32_t>();
  Bytes magic(kMagic.size());
  layout_.ended = cursor_.left() == kRecordHead + size + magic.size() && source_.read(content_at + size, magic) &&
                  std::equal(magic.begin(), magic.end(), kMagic.begin());
  if (summary == 0 || summary > cursor_.position()) return;
  const std::uint64_t summed_end = content_at + kFooterSize - sizeof(sum);
  layout_.has_summary = sum == 0 || checksum_of(summary, summed_end) == sum;
  layout_.damaged = layout_.damaged || !layout_.has_summary;
}

std::uint32_t Scan::checksum_of(std::uint64_t begin, std::uint64_t end) const {
  std::uint32_t sum = 0;
  Bytes block;
  while (begin < end) {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(end - begin, kRunSize)));
    if (!source_.read(begin, block)) return 0;
    sum = checksum(block, sum);
    begin += block.size();
  }
  return sum;
}

}  // namespace

Layout scan(const Source& source, const std::string& name, Topics& topics) {
  return Scan(source, name, topics).run();
}

}  // namespace scrubjay::mcap

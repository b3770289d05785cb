#include <fmt/format.h>

#include <algorithm>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>
#include <scrubjay/io/mcap.hpp>
#include <utility>

#include "growing_file.hpp"
#include "mcap_chunk.hpp"
#include "mcap_format.hpp"
#include "mcap_packing.hpp"
#include "mcap_summary.hpp"

namespace scrubjay {
namespace {

using mcap::Opcode;
using mcap::Writer;

constexpr std::int64_t kChunkTime = 1'000'000'000;  // [ns]
constexpr std::size_t kMostTopics = 65535;

bool is_whole_bag(const std::filesystem::path& path) {
  try {
    McapReader reader(path);
    while (reader.next()) {
    }
    return !reader.cut();
  } catch (const Error&) {
    return false;
  }
}

constexpr GrowingFile::Kind kBag{"the bag", &is_whole_bag};

/// rosbag2 writes it at the beginning, too: from it, its readers know how policies are written in a file without end.
void put_metadata(mcap::Bytes& file, const BagMetadata& metadata) {
  Writer(file).record(Opcode::Metadata, [&metadata](Writer& fields) {
    fields.text(mcap::kMetadataName).map({{"serialized_metadata", bag_metadata_text(metadata)}});
  });
}

/// What stands behind the newest chunk.
mcap::Bytes provisional_end() {
  mcap::Bytes end;
  mcap::put_data_end(end);
  mcap::put_footer(end, {});
  return end;
}

}  // namespace

class McapWriter::State {
 public:
  State(const std::filesystem::path& path, const McapOptions& options)
      : options_(options), metadata_{"mcap", path.filename().string()}, file_(path, kBag, begin(), provisional_end()) {}

  std::size_t add(const BagTopic& topic);
  void write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes);
  void close();

 private:
  mcap::Bytes begin();
  std::uint16_t schema_of(const BagTopic& topic);
  void hand_over();

  McapOptions options_;
  BagMetadata metadata_;
  std::vector<std::uint16_t> schemas_;  ///< numbers of the topics' schemas
  mcap::ChunkBuilder chunk_;
  std::optional<std::int64_t> handed_over_at_;  ///< or the first stamp [ns]
  mcap::Summary summary_;
  mcap::Packer packer_;
  mcap::Bytes buffer_;
  std::uint64_t position_ = 0;  ///< size of all that was handed over
  GrowingFile file_;
};

mcap::Bytes McapWriter::State::begin() {
  mcap::Bytes head;
  Writer out(head);
  out.bytes(mcap::kMagic).record(Opcode::Header, [](Writer& fields) { fields.text("ros2").text(mcap::kLibrary); });
  const std::size_t at = head.size();
  put_metadata(head, metadata_);
  summary_.add_metadata(at, head.size() - at);
  position_ = head.size();
  return head;
}

std::uint16_t McapWriter::State::schema_of(const BagTopic& topic) {
  const auto same = std::find_if(metadata_.topics.begin(), metadata_.topics.end(), [&topic](const BagTopic& other) {
    return other.type == topic.type && other.definition == topic.definition;
  });
  if (same != metadata_.topics.end()) {
    return schemas_[static_cast<std::size_t>(same - metadata_.topics.begin())];
  }
  // Numbers from 1; an empty encoding stands for no text.
  const auto last = std::max_element(schemas_.begin(), schemas_.end());
  const mcap::Schema schema{static_cast<std::uint16_t>(last == schemas_.end() ? 1 : *last + 1), topic.type,
                            topic.definition.empty() ? "" : "ros2msg", topic.definition};
  summary_.add(schema, chunk_.records());
  return schema.id;
}

std::size_t McapWriter::State::add(const BagTopic& topic) {
  const auto same = std::find(metadata_.topics.begin(), metadata_.topics.end(), topic);
  if (same != metadata_.topics.end()) return static_cast<std::size_t>(same - metadata_.topics.begin());
  if (metadata_.topics.size() == kMostTopics) {
    throw Error(fmt::format("{}: no room for topic {}; a bag has {} at most", metadata_.file, topic.name, kMostTopics));
  }
  const std::uint16_t schema = schema_of(topic);
  const std::size_t number = metadata_.add(topic);
  schemas_.push_back(schema);
  mcap::Channel channel{mcap::channel_id(number), schema, topic.name, std::string(mcap::kCdr), {}};
  channel.metadata.emplace_back(mcap::kQosKey, qos_text(topic.qos));
  channel.metadata.emplace_back(mcap::kHashKey, topic.hash);
  summary_.add(channel, chunk_.records());
  return number;
}

void McapWriter::State::write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) {
  if (!file_.writable()) return;
  const std::int64_t now = std::max<std::int64_t>(0, nanoseconds);
  if (!handed_over_at_) handed_over_at_ = now;
  chunk_.add({mcap::channel_id(topic), static_cast<std::uint32_t>(metadata_.messages[topic]),
              static_cast<std::uint64_t>(now), bytes});
  metadata_.count(topic, now);
  const bool late = now - *handed_over_at_ >= kChunkTime || now < *handed_over_at_;
  if (chunk_.bytes() < options_.chunk_size && !late) return;
  handed_over_at_ = now;
  hand_over();
}

void McapWriter::State::hand_over() {
  if (chunk_.empty()) return;
  chunk_.finish(options_.zstd ? &packer_ : nullptr, buffer_, position_, summary_.next_chunk_index());
  file_.append(buffer_);
  position_ += buffer_.size();
  buffer_.clear();
}

void McapWriter::State::close() {
  if (file_.open()) {
    hand_over();
    mcap::Bytes end;
    put_metadata(end, metadata_);
    summary_.add_metadata(position_, end.size());
    mcap::put_data_end(end);
    summary_.finish(metadata_, end, position_);
    file_.complete(end);
  }
  file_.throw_failure();
}

McapWriter::McapWriter(const std::filesystem::path& path, const McapOptions& options)
    : state_(std::make_unique<State>(path, options)) {}

McapWriter::~McapWriter() {
  try {
    close();
  } catch (const Error&) {
    // Whoever wants to know calls close().
  }
}

std::size_t McapWriter::add(const BagTopic& topic) {
  return state_->add(topic);
}

void McapWriter::write(std::size_t topic, std::int64_t nanoseconds, std::span<const std::byte> bytes) {
  state_->write(topic, nanoseconds, bytes);
}

void McapWriter::close() {
  state_->close();
}

}  // namespace scrubjay

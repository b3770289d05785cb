#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <scrubjay/error.hpp>
#include <scrubjay/io/mcap.hpp>
#include <utility>

#include "mcap_piece.hpp"
#include "mcap_scan.hpp"
#include "mcap_source.hpp"
#include "mcap_topics.hpp"

namespace scrubjay {

class McapReader::State {
 public:
  State(std::unique_ptr<mcap::Source> source, const std::string& name);

  const std::vector<BagTopic>& topics() const { return topics_.all(); }
  std::optional<BagMessage> next();
  bool cut() const { return cut_; }

 private:
  /// A piece of which some messages weren't given yet.
  struct Loaded {
    mcap::Messages messages;
    std::uint64_t position = 0;  ///< in the file
  };
  static bool later(const std::unique_ptr<Loaded>& a, const std::unique_ptr<Loaded>& b) {
    return std::pair(a->messages.next_time(), a->position) > std::pair(b->messages.next_time(), b->position);
  }
  void collect_topics();
  bool wants_piece() const;
  void load_piece();
  void put_away(std::unique_ptr<Loaded> loaded);

  std::unique_ptr<mcap::Source> source_;
  mcap::Topics topics_;
  std::vector<mcap::Piece> pieces_;  ///< by their earliest message
  std::size_t next_piece_ = 0;
  std::vector<std::unique_ptr<Loaded>> loaded_;  ///< a heap, the one with the earliest message first
  std::unique_ptr<Loaded> current_;              ///< that the last message is from
  std::optional<std::uint64_t> expected_;        ///< messages by the summary
  std::uint64_t count_ = 0;                      ///< messages of all pieces that were loaded
  std::size_t window_ = 0;                       ///< bytes of all that are loaded
  bool cut_ = false;
};

McapReader::State::State(std::unique_ptr<mcap::Source> source, const std::string& name) : source_(std::move(source)) {
  mcap::Layout layout = mcap::scan(*source_, name, topics_);
  // Our own writer leaves a summary out only where it was killed.
  cut_ = !layout.ended || layout.damaged || (layout.library == mcap::kLibrary && !layout.has_summary);
  expected_ = layout.messages;
  pieces_ = std::move(layout.pieces);
  if (!layout.channels_known) collect_topics();
  const auto& others = topics_.other_encodings();
  if (topics_.all().empty() && !others.empty()) {
    throw Error(fmt::format("{}: its messages are {}; want ROS 2's encoding, cdr", name, fmt::join(others, ", ")));
  }
  std::stable_sort(pieces_.begin(), pieces_.end(),
                   [](const mcap::Piece& a, const mcap::Piece& b) { return a.first < b.first; });
}

/// Channels may be declared in any chunk.
void McapReader::State::collect_topics() {
  for (const mcap::Piece& piece : pieces_) {
    std::optional<mcap::Unpacked> records = mcap::load(*source_, piece, kLargestChunk);
    if (!records || mcap::Messages(std::move(*records), topics_).damaged()) return;
  }
}

std::optional<BagMessage> McapReader::State::next() {
  if (current_) put_away(std::move(current_));
  while (wants_piece()) load_piece();
  if (loaded_.empty()) {
    cut_ = cut_ || (expected_ && *expected_ != count_);
    return std::nullopt;
  }
  std::pop_heap(loaded_.begin(), loaded_.end(), later);
  current_ = std::move(loaded_.back());
  loaded_.pop_back();
  const mcap::ReadMessage& message = current_->messages.take();
  constexpr std::uint64_t kLatest = std::numeric_limits<std::int64_t>::max();
  return BagMessage{message.topic, static_cast<std::int64_t>(std::min(message.time, kLatest)), message.data};
}

/// Whether the next piece may hold a message that comes before all that are loaded.
bool McapReader::State::wants_piece() const {
  if (next_piece_ == pieces_.size()) return false;
  if (loaded_.empty()) return true;
  return window_ < kWindow && pieces_[next_piece_].first <= loaded_.front()->messages.next_time();
}

void McapReader::State::load_piece() {
  const mcap::Piece& piece = pieces_[next_piece_++];
  std::optional<mcap::Unpacked> records = mcap::load(*source_, piece, kLargestChunk);
  bool damaged = !records;
  if (records) {
    auto loaded = std::make_unique<Loaded>(Loaded{mcap::Messages(std::move(*records), topics_), piece.position});
    damaged = loaded->messages.damaged();
    count_ += loaded->messages.count();
    window_ += loaded->messages.size();
    put_away(std::move(loaded));
  }
  if (!damaged) return;
  cut_ = true;
  next_piece_ = pieces_.size();
}

void McapReader::State::put_away(std::unique_ptr<Loaded> loaded) {
  if (loaded->messages.done()) {
    window_ -= loaded->messages.size();
    return;
  }
  loaded_.push_back(std::move(loaded));
  std::push_heap(loaded_.begin(), loaded_.end(), later);
}

McapReader::McapReader(const std::filesystem::path& path)
    : state_(std::make_unique<State>(mcap::open_source(path), path.string())) {}

McapReader::McapReader(std::vector<std::uint8_t> file, const std::string& name)
    : state_(std::make_unique<State>(mcap::memory_source(std::move(file)), name)) {}

McapReader::~McapReader() = default;

const std::vector<BagTopic>& McapReader::topics() const {
  return state_->topics();
}

std::optional<BagMessage> McapReader::next() {
  return state_->next();
}

bool McapReader::cut() const {
  return state_->cut();
}

}  // namespace scrubjay

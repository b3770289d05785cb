#include <algorithm>
#include <scrubjay/oi/query.hpp>

namespace scrubjay::oi {

bool QueryReader::expect(const Query& query) {
  reset();
  // Every model knows the command. Asking valid_on would bring the table of all commands into firmware that asks.
  if (!query.id.exists_on(model_)) return false;
  await(*Ids::of({&query.id, 1}));
  return true;
}

bool QueryReader::expect(const QueryList& query) {
  reset();
  if (!valid_on(query, model_)) return false;
  await(query.ids);
  return true;
}

void QueryReader::await(const Ids& ids) {
  ids_ = ids;
  for (const SensorId id : ids_) awaited_ += id.bytes();
}

void QueryReader::reset() {
  next_ = 0;
  part_size_ = 0;
  awaited_ = 0;
  rejected_ = 0;
  reply_ = {};
}

std::size_t QueryReader::feed(std::span<const std::uint8_t> bytes, Sensors& sensors) {
  bytes = bytes.first(std::min(bytes.size(), awaited_));
  const std::size_t taken = bytes.size();
  while (!bytes.empty()) {
    const SensorId id = ids_[next_];
    const std::size_t count = std::min(id.bytes() - part_size_, bytes.size());
    std::copy_n(bytes.begin(), count, part_.begin() + static_cast<std::ptrdiff_t>(part_size_));
    bytes = bytes.subspan(count);
    part_size_ += count;
    if (part_size_ < id.bytes()) break;
    const DecodeStatus status = decode(id, {part_.data(), part_size_}, model_, reply_);
    rejected_ = static_cast<std::uint16_t>(rejected_ + status.rejected);
    part_size_ = 0;
    ++next_;
  }
  awaited_ -= taken;
  if (taken > 0 && awaited_ == 0) sensors.update(reply_);
  return taken;
}

}  // namespace scrubjay::oi

#include <algorithm>
#include <scrubjay/oi/command_decoder.hpp>

#include "wire.hpp"

namespace scrubjay::oi {
namespace {

using Read = bool (*)(wire::Input data, Command& command);

template <typename C>
bool read(wire::Input data, Command& command) {
  return wire::Codec<C>::read(data, command.emplace<C>()) && data.empty();
}

/// The reader of each opcode on a model; null where the model doesn't know it.
using Readers = std::array<Read, 256>;

template <typename... C>
constexpr Readers readers(Model model, std::type_identity<std::variant<C...>>) {
  Readers table{};
  ((wire::spoken_by<C>(model) ? void(table[static_cast<std::size_t>(C::kOpcode)] = &read<C>) : void()), ...);
  return table;
}

constexpr std::array<Readers, kModelCount> kReaders{readers(Model::Create2, std::type_identity<Command>{}),
                                                    readers(Model::Create1, std::type_identity<Command>{}),
                                                    readers(Model::Roomba400, std::type_identity<Command>{})};

}  // namespace

CommandDecoder::Step CommandDecoder::take(std::uint8_t byte) {
  if (info_ == nullptr) return begin(byte);
  if (received_ < data_.size()) data_[received_] = byte;
  ++received_;
  // The last of the fixed bytes counts the items that follow.
  if (received_ == info_->data.fixed) awaited_ += std::size_t{byte} * info_->data.per_item;
  return received_ == awaited_ ? complete() : Step::Wait;
}

CommandDecoder::Step CommandDecoder::begin(std::uint8_t opcode) {
  const OpcodeInfo* info = opcode_info(opcode, model_);
  foreign_ = info == nullptr;
  for (std::uint8_t other = 0; info == nullptr && other < kModelCount; ++other)
    info = opcode_info(opcode, Model{other});
  if (info == nullptr) {
    ++unknown_opcodes_;
    rejected_ = {opcode, Rejected::Why::UnknownOpcode};
    return Step::Reject;
  }
  info_ = info;
  awaited_ = info->data.fixed;
  received_ = 0;
  return awaited_ == 0 ? complete() : Step::Wait;
}

CommandDecoder::Step CommandDecoder::complete() {
  const auto opcode = static_cast<std::uint8_t>(info_->opcode);
  info_ = nullptr;
  if (foreign_) return reject(opcode, Rejected::Why::NotOnThisModel);
  const wire::Input data(data_.data(), std::min(received_, data_.size()));
  const Read read = kReaders[static_cast<std::size_t>(model_)][opcode];
  if (!read(data, command_) || !valid_on(command_, model_)) return reject(opcode, Rejected::Why::OutOfRange);
  ++commands_;
  return Step::Accept;
}

CommandDecoder::Step CommandDecoder::reject(std::uint8_t opcode, Rejected::Why why) {
  ++rejections_;
  rejected_ = {opcode, why};
  return Step::Reject;
}

}  // namespace scrubjay::oi

/// \file
/// The robot's end of the line: bytes to commands, in any chunking.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <scrubjay/oi/command.hpp>
#include <scrubjay/oi/opcode.hpp>
#include <span>

namespace scrubjay::oi {

/// A command that the robot doesn't obey.
struct Rejected {
  enum class Why : std::uint8_t {
    UnknownOpcode,   ///< no model knows it: this one byte is skipped
    OutOfRange,      ///< data that the command, or this model, doesn't have; consumed whole
    NotOnThisModel,  ///< a command of another model; consumed whole, so that its data aren't taken for commands
  };
  std::uint8_t opcode = 0;
  Why why{};
  bool operator==(const Rejected&) const = default;
};

/// Splits what a robot receives into commands.
///
/// It knows no modes: ask `allowed_in` for each command. Memory is fixed, a command of more data than it may have is
/// consumed to its end.
class CommandDecoder {
 public:
  explicit CommandDecoder(Model model) : model_(model) {}

  /// Calls `on_command(const Command&)` and `on_rejected(const Rejected&)`, in the order of the bytes.
  template <typename OnCommand, typename OnRejected>
  void feed(std::span<const std::uint8_t> bytes, OnCommand&& on_command, OnRejected&& on_rejected) {
    for (const std::uint8_t byte : bytes) {
      switch (take(byte)) {
        case Step::Wait:
          break;
        case Step::Accept:
          on_command(static_cast<const Command&>(command_));
          break;
        case Step::Reject:
          on_rejected(static_cast<const Rejected&>(rejected_));
          break;
      }
    }
  }
  /// Forgets a command that has only begun: the line was silent, or its speed changed.
  void reset() { info_ = nullptr; }

  /// Bytes of a command that has only begun.
  std::size_t pending() const { return info_ == nullptr ? 0 : received_ + 1; }
  std::uint64_t commands() const { return commands_; }
  /// Commands with wrong data or of another model.
  std::uint64_t rejected() const { return rejections_; }
  /// Bytes skipped because no command begins with them.
  std::uint64_t unknown_opcodes() const { return unknown_opcodes_; }

 private:
  enum class Step : std::uint8_t { Wait, Accept, Reject };

  Step take(std::uint8_t byte);
  Step begin(std::uint8_t opcode);
  Step complete();
  Step reject(std::uint8_t opcode, Rejected::Why why);

  Model model_;
  bool foreign_ = false;              ///< the command is another model's
  const OpcodeInfo* info_ = nullptr;  ///< the command that has begun
  std::size_t awaited_ = 0;           ///< its data bytes, as far as known
  std::size_t received_ = 0;          ///< ... of which came
  std::array<std::uint8_t, kMaxCommandBytes - 1> data_{};
  Command command_;
  Rejected rejected_;
  std::uint64_t commands_ = 0;
  std::uint64_t rejections_ = 0;
  std::uint64_t unknown_opcodes_ = 0;
};

}  // namespace scrubjay::oi

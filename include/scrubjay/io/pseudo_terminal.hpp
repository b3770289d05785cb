/// \file
/// A pseudo-terminal that clients open as if it were a serial port.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <scrubjay/robot/byte_channel.hpp>
#include <span>

namespace scrubjay {

/// The device's end.
///
/// Raw by itself: what clients set of echo, line editing or translation is undone with the next read or write, so that
/// every byte passes as it is. Clients may come and go, and what one of them set exclusively holds no other one off.
/// One that doesn't read never holds the device up: it finds the last kBacklog bytes or fewer when it comes back, not
/// those of long ago.
class PseudoTerminal final : public ByteChannel {
 public:
  /// Unread bytes that are kept for a client, at most: three quarters of a second of the stream of all packets.
  /// It is also what a terminal holds in Linux.
  static constexpr std::size_t kBacklog = 4095;

  /// Opens a pair, and makes `link` a symbolic link to the clients' end. A link that leads nowhere, as one of a
  /// program that was killed, is replaced; anything else is not. Throws Error (Kind::Failure where the system is out of
  /// them).
  explicit PseudoTerminal(const std::filesystem::path& link);
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal() override;  ///< takes the link away, unless somebody else has replaced it

  /// Doesn't wait. Always open: without a client there is nothing to read. The stamp is 0.
  ByteRead read(std::span<std::uint8_t> buffer) override;
  /// Never waits. Where more than kBacklog bytes would be unread, those unread so far are dropped first. True, always.
  bool write(std::span<const std::uint8_t> bytes) override;

  /// Bytes that were dropped so far: those that had arrived at the clients' end. What the system was just passing on
  /// there can't be counted; at a robot's pace that is nothing.
  std::uint64_t dropped() const { return dropped_; }
  /// To wait on with poll().
  int descriptor() const { return device_file_; }
  /// Where clients find it, without the link.
  const std::filesystem::path& device() const { return device_; }

 private:
  void open_pair();
  void close_pair();
  void keep_raw();
  void drop_unread();

  int device_file_ = -1;
  int client_file_ = -1;  ///< held open, so that settings stay and the device never sees the last client leave
  std::filesystem::path link_;
  std::filesystem::path device_;
  std::uint64_t dropped_ = 0;
};

}  // namespace scrubjay

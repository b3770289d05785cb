#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <scrubjay/error.hpp>
#include <scrubjay/io/keyboard.hpp>

namespace scrubjay {
namespace {

constexpr std::uint8_t kEscape = 0x1B;
constexpr int kPauseReads = 4;  // without a byte, after which an ESC stands alone; the rest of a sequence comes sooner

Key::Kind arrow(std::uint8_t final_byte) {
  switch (final_byte) {
    case 'A':
      return Key::Kind::Up;
    case 'B':
      return Key::Kind::Down;
    case 'C':
      return Key::Kind::Right;
    case 'D':
      return Key::Kind::Left;
    default:
      return Key::Kind::Other;
  }
}

}  // namespace

void KeyDecoder::feed(std::span<const std::uint8_t> bytes, std::vector<Key>& keys) {
  for (const std::uint8_t byte : bytes) take(byte, keys);
}

void KeyDecoder::take(std::uint8_t byte, std::vector<Key>& keys) {
  switch (state_) {
    case State::Ground:
      if (byte == kEscape) {
        state_ = State::Escape;
      } else if (byte < 0x80) {
        keys.push_back({Key::Kind::Character, static_cast<char>(byte)});
      } else if (byte >= 0xC0) {  // the first byte of a character beyond ASCII; the others say nothing
        keys.push_back({Key::Kind::Other, 0});
      }
      return;
    case State::Escape:
      if (byte == kEscape) {
        keys.push_back({Key::Kind::Escape, 0});
        return;
      }
      state_ = byte == '[' ? State::Csi : byte == 'O' ? State::Ss3 : State::Ground;
      if (state_ == State::Ground) keys.push_back({Key::Kind::Other, 0});  // Alt and a key
      return;
    case State::Csi:
      if (byte >= 0x20 && byte < 0x40) return;  // parameters, such as the modifiers of an arrow
      [[fallthrough]];
    case State::Ss3:
      keys.push_back({arrow(byte), 0});
      state_ = State::Ground;
      return;
  }
}

void KeyDecoder::pause(std::vector<Key>& keys) {
  if (state_ == State::Ground) return;
  keys.push_back({state_ == State::Escape ? Key::Kind::Escape : Key::Kind::Other, 0});
  state_ = State::Ground;
}

struct Keyboard::Settings {
  termios settings{};
};

Keyboard::Keyboard(int file) : file_(file), before_(std::make_unique<Settings>()) {
  if (::tcgetattr(file, &before_->settings) != 0) {
    throw Error("the keyboard is no terminal; run this in one, without redirecting its input");
  }
  termios raw = before_->settings;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | IEXTEN);
  raw.c_iflag &= ~static_cast<tcflag_t>(IXON | IXOFF | ISTRIP | INLCR | ICRNL | IGNCR);
  raw.c_cc[VSUSP] = raw.c_cc[VQUIT] = _POSIX_VDISABLE;
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  if (::tcsetattr(file, TCSAFLUSH, &raw) != 0) throw Error("the terminal can't give single keys");
}

Keyboard::~Keyboard() {
  ::tcsetattr(file_, TCSAFLUSH, &before_->settings);
}

std::optional<std::vector<Key>> Keyboard::read() {
  std::vector<Key> keys;
  std::array<std::uint8_t, 256> buffer;
  pollfd terminal{file_, POLLIN, 0};
  const bool ready = ::poll(&terminal, 1, 0) > 0;
  const ssize_t count = ready ? ::read(file_, buffer.data(), buffer.size()) : 0;
  if (count > 0) {
    decoder_.feed({buffer.data(), static_cast<std::size_t>(count)}, keys);
    empty_reads_ = 0;
    return keys;
  }
  // A terminal that is there, and ready, has bytes.
  if (ready && (terminal.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) return std::nullopt;
  if (++empty_reads_ == kPauseReads) decoder_.pause(keys);
  return keys;
}

}  // namespace scrubjay

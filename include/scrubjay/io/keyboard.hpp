/// \file
/// Single keys from a terminal, as they are pressed.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace scrubjay {

struct Key {
  enum class Kind : std::uint8_t { Character, Up, Down, Left, Right, Escape, Other };
  Kind kind = Kind::Other;
  char character = 0;  ///< of Kind::Character: ASCII, control characters too

  bool operator==(const Key&) const = default;
};

/// Makes keys of a terminal's bytes: characters, and the escape sequences of ECMA-48 that arrows send (ESC [ A, and
/// ESC O A in a terminal's application mode). Every other sequence is one Key::Kind::Other, never its letters.
class KeyDecoder {
 public:
  /// Appends the keys that these bytes complete.
  void feed(std::span<const std::uint8_t> bytes, std::vector<Key>& keys);
  /// To be called when nothing came for a while: an escape sequence that has only begun was a key by itself.
  void pause(std::vector<Key>& keys);

 private:
  enum class State : std::uint8_t { Ground, Escape, Csi, Ss3 };

  void take(std::uint8_t byte, std::vector<Key>& keys);

  State state_ = State::Ground;
};

/// A terminal that gives each key at once and shows none. Ctrl-C stays a signal; what would suspend the program or its
/// output (Ctrl-Z, Ctrl-S) is a key like any other, since a robot mustn't be left driving. At the end the terminal is
/// as it was.
class Keyboard {
 public:
  /// `file`: an open terminal. Throws Error if it is none.
  explicit Keyboard(int file);
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// The keys since the last call, in order; doesn't wait. None at all once the terminal is gone.
  std::optional<std::vector<Key>> read();

 private:
  struct Settings;
  int file_;
  std::unique_ptr<Settings> before_;
  KeyDecoder decoder_;
  int empty_reads_ = 0;
};

}  // namespace scrubjay

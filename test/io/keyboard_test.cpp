#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/keyboard.hpp>
#include <string_view>

namespace scrubjay {
namespace {

using Kind = Key::Kind;

std::vector<Key> decode(std::initializer_list<std::string_view> chunks, bool pause = false) {
  KeyDecoder decoder;
  std::vector<Key> keys;
  for (const std::string_view chunk : chunks) {
    decoder.feed({reinterpret_cast<const std::uint8_t*>(chunk.data()), chunk.size()}, keys);
  }
  if (pause) decoder.pause(keys);
  return keys;
}

Key typed(char character) {
  return {Kind::Character, character};
}

TEST(KeyDecoderTest, GivesCharactersAsTheyAre) {
  EXPECT_EQ(decode({"w A+\x04"}), (std::vector<Key>{typed('w'), typed(' '), typed('A'), typed('+'), typed(4)}));
}

TEST(KeyDecoderTest, KnowsArrowsOfBothKinds) {
  const std::vector<Key> arrows{{Kind::Up, 0}, {Kind::Down, 0}, {Kind::Right, 0}, {Kind::Left, 0}};
  EXPECT_EQ(decode({"\033[A\033[B\033[C\033[D"}), arrows);
  EXPECT_EQ(decode({"\033OA\033OB\033OC\033OD"}), arrows);
  EXPECT_EQ(decode({"\033[1;5A\033[1;2B\033[1;3C\033[1;9D"}), arrows);
}

TEST(KeyDecoderTest, PutsSequencesTogetherFromPieces) {
  EXPECT_EQ(decode({"\033", "[", "A", "w"}), (std::vector<Key>{{Kind::Up, 0}, typed('w')}));
}

TEST(KeyDecoderTest, NeverTakesALetterOutOfASequence) {
  const std::vector<Key> other{{Kind::Other, 0}};
  // Delete, page up, F5, F1, Alt-w, an umlaut, a euro sign
  for (const std::string_view bytes :
       {"\033[3~", "\033[5~", "\033[15~", "\033OP", "\033w", "\xC3\xA4", "\xE2\x82\xAC"}) {
    EXPECT_EQ(decode({bytes}), other) << bytes.substr(1);
  }
}

TEST(KeyDecoderTest, AnEscapeAloneIsAKeyOnceNothingFollows) {
  EXPECT_TRUE(decode({"\033"}).empty());
  EXPECT_EQ(decode({"\033"}, true), (std::vector<Key>{{Kind::Escape, 0}}));
  EXPECT_EQ(decode({"\033\033"}, true), (std::vector<Key>{{Kind::Escape, 0}, {Kind::Escape, 0}}));
  EXPECT_EQ(decode({"w"}, true), (std::vector<Key>{typed('w')}));
}

/// A terminal: what is written to `user` is typed.
class KeyboardTest : public testing::Test {
 protected:
  KeyboardTest() : user_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(user_);
    ::unlockpt(user_);
    terminal_ = ::open(::ptsname(user_), O_RDWR | O_NOCTTY);
  }
  ~KeyboardTest() override {
    hang_up();
    ::close(terminal_);
  }
  void hang_up() {
    if (user_ >= 0) ::close(user_);
    user_ = -1;
  }
  void type(std::string_view text) { ASSERT_EQ(::write(user_, text.data(), text.size()), ssize_t(text.size())); }
  /// Keys, as soon as there are `count`.
  std::vector<Key> wait_for(Keyboard& keyboard, std::size_t count) {
    std::vector<Key> all;
    for (int i = 0; i < 10'000 && all.size() < count; ++i) {
      pollfd terminal{terminal_, POLLIN, 0};
      ::poll(&terminal, 1, 1);
      const auto keys = keyboard.read();
      if (!keys) break;
      all.insert(all.end(), keys->begin(), keys->end());
    }
    return all;
  }
  termios settings() const {
    termios now{};
    ::tcgetattr(terminal_, &now);
    return now;
  }

  int user_;
  int terminal_ = -1;
};

TEST_F(KeyboardTest, GivesKeysWithoutEnterAndShowsNone) {
  Keyboard keyboard(terminal_);
  EXPECT_TRUE(keyboard.read()->empty());
  type("w\033[Aq");
  EXPECT_EQ(wait_for(keyboard, 3), (std::vector<Key>{typed('w'), {Kind::Up, 0}, typed('q')}));
  pollfd echo{user_, POLLIN, 0};
  EXPECT_EQ(::poll(&echo, 1, 0), 0);
}

TEST_F(KeyboardTest, WhatWouldSuspendTheProgramIsAKey) {
  Keyboard keyboard(terminal_);
  const std::vector<Key> keys{typed(26), typed(19), typed(17), typed(28), typed(4)};
  type("\x1A\x13\x11\x1C\x04");
  EXPECT_EQ(wait_for(keyboard, keys.size()), keys);
}

TEST_F(KeyboardTest, AnEscapeAloneComesAfterAFewReads) {
  Keyboard keyboard(terminal_);
  type("\033");
  EXPECT_EQ(wait_for(keyboard, 1), (std::vector<Key>{{Kind::Escape, 0}}));
}

TEST_F(KeyboardTest, PutsTheTerminalBack) {
  const termios before = settings();
  {
    Keyboard keyboard(terminal_);
    EXPECT_EQ(settings().c_lflag & (ICANON | ECHO), 0U);
    EXPECT_NE(settings().c_lflag & ISIG, 0U) << "Ctrl-C is to stay a signal";
  }
  EXPECT_EQ(settings().c_lflag, before.c_lflag);
  EXPECT_EQ(settings().c_iflag, before.c_iflag);
  EXPECT_EQ(settings().c_cc[VSUSP], before.c_cc[VSUSP]);
}

TEST_F(KeyboardTest, TellsThatTheTerminalWentAway) {
  Keyboard keyboard(terminal_);
  type("w");
  EXPECT_EQ(wait_for(keyboard, 1).size(), 1U);
  hang_up();
  EXPECT_FALSE(keyboard.read().has_value());
}

TEST(KeyboardOfAFileTest, IsRefused) {
  const int file = ::open("/dev/null", O_RDONLY);
  EXPECT_THROW(Keyboard{file}, Error);
  ::close(file);
}

}  // namespace
}  // namespace scrubjay

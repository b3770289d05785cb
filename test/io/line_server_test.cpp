#include <gtest/gtest.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/line_server.hpp>
#include <string>

#include "line_listener.hpp"

namespace scrubjay {
namespace {

TEST(LineServerTest, TellsEverybodyWhoListens) {
  LineServer server(0);
  EXPECT_NE(server.port(), 0);
  server.tell("nobody hears this");
  LineListener one(server.port());
  server.tell("first");
  LineListener other(server.port());
  server.tell("second");
  EXPECT_EQ(one.line(), "first\n");
  EXPECT_EQ(one.line(), "second\n");
  EXPECT_EQ(other.line(), "second\n");
}

TEST(LineServerTest, SurvivesListenersThatGo) {
  LineServer server(0);
  LineListener stays(server.port());
  for (int i = 0; i < 5; ++i) {
    LineListener goes(server.port());
    server.tell("hello");
    EXPECT_EQ(goes.line(), "hello\n");
    EXPECT_EQ(stays.line(), "hello\n");
  }
  for (int i = 0; i < 5; ++i) {
    server.tell("more");
    EXPECT_EQ(stays.line(), "more\n");
  }
}

TEST(LineServerTest, NeverWaitsForOneThatDoesntReadAndLosesWholeLines) {
  LineServer server(0);
  LineListener slow(server.port(), 4096);
  const std::string line(1000, 'x');
  const int count = 20'000;
  for (int i = 0; i < count; ++i) server.tell(line + std::to_string(i));
  int last = -1;
  int heard = 0;
  // What is on its way and one line more, for the rest of the one that was cut.
  std::string text;
  for (; last < count; ++heard) {
    server.tell(line + std::to_string(count + heard));
    text = slow.line();
    ASSERT_EQ(text.substr(0, line.size()), line);
    const int number = std::stoi(text.substr(line.size()));
    EXPECT_GT(number, last);
    last = number;
  }
  EXPECT_LT(heard, count);
}

TEST(LineServerTest, RefusesAPortThatIsTaken) {
  const LineServer server(0);
  EXPECT_THROW(LineServer{server.port()}, Error);
}

}  // namespace
}  // namespace scrubjay

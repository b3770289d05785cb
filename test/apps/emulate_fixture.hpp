/// \file
/// `scrubjay emulate` as tests call it.
#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "command_line.hpp"

namespace scrubjay {

/// A robot in the middle of a room, behind LINK in a folder of its own; at many times real time.
class EmulateTest : public testing::Test {
 protected:
  static constexpr int kSpeed = 20;

  Call start(const Words& flags, const Surroundings& surroundings = {}) const {
    Words words{"emulate", own_world("room"), "--pty", link(), "--json", "--speed", std::to_string(kSpeed)};
    words.insert(words.end(), flags.begin(), flags.end());
    return Call(words, surroundings);
  }
  std::string link() const { return (folder_ / "robot").string(); }

  /// Ends it, and gives its account.
  static nlohmann::json end(Call& call, int signal = SIGTERM) {
    call.send(signal);
    const Outcome outcome = call.wait();
    EXPECT_EQ(outcome.code, 0) << outcome.signal << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }

  TemporaryFolder folder_;
};

}  // namespace scrubjay

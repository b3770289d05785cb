#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <io/temporary_folder.hpp>
#include <sstream>
#include <thread>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::size_t kWidth = 80;  // of a terminal

/// A robot, its floor, and what it is recorded into.
struct Way {
  std::string name;
  std::string model;
  std::string noise;
  std::string bag;
};

std::ostream& operator<<(std::ostream& out, const Way& way) {
  return out << way.name;
}

class BagRunTest : public testing::TestWithParam<Way> {
 protected:
  /// Explores an apartment for a while, and gives what it left but for the clock's figures.
  Contents explored(const Way& way, const std::string& out, const Words& more = {}) const {
    Words words{"explore", own_world("apartment"), "--model", way.model, "--noise",
                way.noise, "--max-time",           "60",      "--out",   out};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = scrubjay_in(folder_.path(), words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return repeatable(contents_of(folder_ / out));
  }

  void expect_same_map_again(const std::string& bag, const Contents& live) const {
    const Outcome outcome = scrubjay_in(folder_.path(), {"replay", bag, "--out", "again"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(broken_result(folder_ / "again"), "");
    const Contents again = contents_of(folder_ / "again");
    for (const char* name : {"map.pgm", "map.yaml"}) {
      EXPECT_TRUE(again.at(name) == live.at(name)) << name;
    }
  }

  std::string info(const std::string& bag) const {
    const Outcome outcome = scrubjay_in(folder_.path(), {"info", bag});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.out;
  }

  TemporaryFolder folder_;
};

TEST_P(BagRunTest, IsReplayedToTheSameMapToTheByte) {
  expect_same_map_again(GetParam().bag, explored(GetParam(), "live", {"--record", GetParam().bag}));
}

TEST_P(BagRunTest, MapsTheSameWhetherItIsRecordedOrNot) {
  const Contents plain = explored(GetParam(), "plain");
  EXPECT_EQ(explored(GetParam(), "recorded", {"--record", GetParam().bag}), plain);
}

TEST_P(BagRunTest, IsListedWithinATerminal) {
  explored(GetParam(), "live", {"--record", GetParam().bag});
  const std::string text = info(GetParam().bag);
  EXPECT_THAT(text, AllOf(HasSubstr("length: 60."), HasSubstr("whole: yes"), HasSubstr("nav_msgs/msg/Odometry"),
                          HasSubstr("nav_msgs/msg/OccupancyGrid, latched")));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), kWidth) << line;
}

/// Signals end it while it records, at many times real time.
TEST_P(BagRunTest, LeavesAWholeBagWhereItIsInterrupted) {
  const auto& [name, model, noise, bag] = GetParam();
  Call call({"explore", own_world("apartment"), "--model", model, "--noise", noise, "--max-time", "1e7", "--speed",
             "50", "--record", (folder_ / bag).string(), "--out", (folder_ / "live").string()});
  // The recording begins once the program listens to signals. A database grows by its log.
  const std::filesystem::path grows = folder_ / (bag.ends_with(".mcap") ? bag : bag + "/run_0.db3-wal");
  std::error_code none_yet;
  while (!std::filesystem::exists(grows) || std::filesystem::file_size(grows, none_yet) < 300'000) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  call.send(SIGINT);
  const Outcome outcome = call.wait();
  EXPECT_EQ(outcome.code, 0) << outcome.signal;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, testing::StartsWith("stopped after "));
  EXPECT_THAT(info(bag), HasSubstr("whole: yes"));
  expect_same_map_again(bag, contents_of(folder_ / "live"));
}

INSTANTIATE_TEST_SUITE_P(Ways, BagRunTest,
                         testing::Values(Way{"RoombaMcap", "roomba-600", "hard-floor", "run.mcap"},
                                         Way{"RoombaFolder", "create-2", "carpet", "run"},
                                         Way{"Create1Mcap", "create-1", "hard-floor", "run.mcap"},
                                         Way{"Roomba400Folder", "roomba-400", "none", "run"},
                                         Way{"BurgerMcap", "turtlebot3-burger", "hard-floor", "run.mcap"},
                                         Way{"BurgerFolder", "turtlebot3-burger", "uncalibrated", "run"}),
                         [](const auto& way) { return way.param.name; });

using McapRunTest = BagRunTest;

TEST_F(McapRunTest, IsTheSameToTheByteForTheSameSeed) {
  const Way way{"", "turtlebot3-burger", "hard-floor", ""};
  for (const Words& packing : {Words{}, Words{"--zstd"}}) {
    const auto recorded = [&](const std::string& seed) {
      Words more{"--seed", seed, "--record", "run.mcap"};
      more.insert(more.end(), packing.begin(), packing.end());
      explored(way, "out", more);
      return content_of(folder_ / "run.mcap");
    };
    const std::string first = recorded("1");
    EXPECT_TRUE(recorded("1") == first);
    EXPECT_FALSE(recorded("2") == first);
  }
}

TEST_F(McapRunTest, IsSmallerAndHoldsTheSameIfPacked) {
  const Way way{"", "roomba-600", "hard-floor", ""};
  const Contents live = explored(way, "live", {"--record", "plain.mcap"});
  explored(way, "live", {"--record", "packed.mcap", "--zstd"});
  EXPECT_LT(2 * std::filesystem::file_size(folder_ / "packed.mcap"),
            std::filesystem::file_size(folder_ / "plain.mcap"));
  const std::string plain = info("plain.mcap");
  const std::string packed = info("packed.mcap");
  EXPECT_EQ(packed.substr(packed.find('\n')), plain.substr(plain.find('\n')));
  expect_same_map_again("packed.mcap", live);
}

class WrongBagTest : public BagRunTest {
 protected:
  /// The call fails with `code` and one line that holds `what`, and leaves nothing.
  void expect_refusal(const Words& words, int code, const std::string& what) const {
    SCOPED_TRACE(testing::PrintToString(words));
    const Contents before = contents_of(folder_.path());
    Words call = words;
    call.insert(call.end(), {"--out", "refused/run"});
    const Outcome outcome = scrubjay_in(folder_.path(), call);
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, AllOf(testing::StartsWith("scrubjay: "), HasSubstr(what)));
    EXPECT_TRUE(contents_of(folder_.path()) == before) << "something was written or changed";
  }

  const std::string world_ = own_world("room");
};

TEST_F(WrongBagTest, IsNotRecorded) {
  std::filesystem::create_directory(folder_ / "other");
  folder_.write("other/thing", "hello\n");
  expect_refusal({"explore", world_, "--model", "turtlebot3-burger", "--record", "run.oilog"}, 2, "want an .mcap");
  expect_refusal({"explore", world_, "--record", "other"}, 2, "holds thing, which is no part of a bag");
  expect_refusal({"explore", world_, "--record", "other/thing"}, 2, "is a file");
  // The disc's fault, not the words': as with any other file that can't be written.
  expect_refusal({"explore", world_, "--record", "missing/run.mcap"}, 1, "missing/run.mcap: cannot write");
  expect_refusal({"explore", world_, "--record", "other/thing/run.mcap"}, 1, "other/thing/run.mcap: cannot write");
}

TEST_F(WrongBagTest, TakesNoOlderOnesPlaceIfTheRunCannotBegin) {
  for (const char* bag : {"run.mcap", "run"}) {
    explored({"", "roomba-600", "none", ""}, "live", {"--record", bag});
    expect_refusal({"explore", world_, "--record", bag, "--ros2", "--ros-distro", "noetic"}, 2, "--ros-distro");
    expect_refusal({"explore", "--robot", "serial:missing", "--record", bag}, 2, "missing");
  }
}

TEST_F(WrongBagTest, IsNotPackedUnlessItIsAnMcapFile) {
  expect_refusal({"explore", world_, "--zstd"}, 2, "want --record FILE.mcap");
  expect_refusal({"explore", world_, "--record", "run", "--zstd"}, 2, "want --record FILE.mcap");
  expect_refusal({"explore", world_, "--record", "run.oilog", "--zstd"}, 2, "want --record FILE.mcap");
}

TEST_F(WrongBagTest, IsNotReplayed) {
  std::filesystem::create_directory(folder_ / "other");
  folder_.write("other/thing", "hello\n");
  folder_.write("head.mcap", "\x89MCAP0\r\n");
  explored({"", "roomba-600", "none", ""}, "live", {"--record", "run.mcap"});
  expect_refusal({"replay", "other"}, 2, "other: is no bag; want a folder with metadata.yaml");
  expect_refusal({"replay", "missing.mcap"}, 2, "missing.mcap: cannot read");
  expect_refusal({"replay", "head.mcap"}, 2, "head.mcap");
  expect_refusal({"replay", "run.mcap", "--calibration", "robot.yaml"}, 2, "want no --calibration");
  expect_refusal({"replay", "run.mcap", "--forward-cone", "90"}, 2, "no CARMEN log");
  expect_refusal({"explore", "--robot", "log:run.mcap"}, 2, "not a recording (.oilog)");
}

}  // namespace
}  // namespace scrubjay

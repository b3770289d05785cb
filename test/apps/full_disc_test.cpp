#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <io/temporary_folder.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

Words explore(const std::filesystem::path& out, const std::string& seed, const Words& more = {}) {
  Words words{"explore", own_world("apartment"), "--strategy", "random-3", "--seed",
              seed,      "--max-time",           "60",         "--out",    out.string()};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

constexpr const char* kFigures = "time limit after 60 s: ";

/// `told`: the beginning of what it prints all the same.
void expect_failure(const Outcome& outcome, const std::string& reason, const std::string& told = "") {
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(outcome.out.empty(), told.empty());
  EXPECT_THAT(outcome.out, testing::StartsWith(told));
  EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr(reason));
}

/// Files that may not grow: what a disc that is full does, without one.
class LimitedFileTest : public testing::Test {
 protected:
  void SetUp() override {
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
    GTEST_SKIP() << "the thread sanitizer itself writes a file";
#endif
#endif
  }
  Outcome limited(const Words& words, std::size_t size) const {
    return scrubjay(words, {.folder = folder_.path(), .largest_file = size, .err_to = {}, .out_to = {}});
  }
  TemporaryFolder folder_;
};

TEST_F(LimitedFileTest, LeavesAnOlderRunAsItWas) {
  ASSERT_EQ(scrubjay(explore(folder_ / "out", "1")).code, 0);
  const Contents older = contents_of(folder_ / "out");
  for (const std::size_t size : {0U, 100U, 500U, 5000U, 20000U}) {
    SCOPED_TRACE(size);
    expect_failure(limited(explore(folder_ / "out", "2"), size), "File too large", kFigures);
    EXPECT_TRUE(contents_of(folder_ / "out") == older);
  }
}

TEST_F(LimitedFileTest, LeavesNoResultsBehindWhereThereWereNone) {
  expect_failure(limited(explore(folder_ / "out", "2"), 5000), "File too large", kFigures);
  EXPECT_TRUE(contents_of(folder_ / "out").empty());
}

TEST_F(LimitedFileTest, LeavesAnOlderRecordingAsItWas) {
  const Words record{"--record", (folder_ / "run.oilog").string()};
  ASSERT_EQ(scrubjay(explore(folder_ / "out", "1", record)).code, 0);
  const Contents older = contents_of(folder_.path());
  for (const std::size_t size : {0U, 50U, 5000U, 60000U}) {
    SCOPED_TRACE(size);
    expect_failure(limited(explore(folder_ / "out", "2", record), size), "run.oilog: cannot write the recording");
    EXPECT_TRUE(contents_of(folder_.path()) == older);
  }
}

TEST_F(LimitedFileTest, LeavesNoPartOfARecordingThatCannotBegin) {
  const Words record{"--record", (folder_ / "run.oilog").string()};
  expect_failure(limited(explore(folder_ / "out", "2", record), 50), "run.oilog");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "run.oilog"));
}

TEST_F(LimitedFileTest, LeavesAnOlderPictureAndTableAsTheyWere) {
  folder_.write("map.png", "old picture");
  folder_.write("table.csv", "old table");
  expect_failure(limited({"render", own_world("room")}, 100), "map.png");
  expect_failure(limited({"compare", own_world("room"), "--strategies", "reactive", "--seeds", "1", "--max-time", "5",
                          "--csv", "table.csv"},
                         20),
                 "table.csv");
  EXPECT_EQ(contents_of(folder_.path()), (Contents{{"map.png", "old picture"}, {"table.csv", "old table"}}));
}

TEST_F(LimitedFileTest, LosesNoFiguresOfACalibration) {
  folder_.write("hall.yaml", "name: hall\nwalls:\n  - [[0, 0], [7, 0], [7, 7], [0, 7], [0, 0]]\nstart: [3, 3, 0.3]\n");
  const Outcome outcome = limited({"calibrate", "hall.yaml", "--out", "wheels.yaml"}, 20);
  expect_failure(outcome, "wheels.yaml: cannot write", "  spin ");
  EXPECT_THAT(outcome.out, HasSubstr("axle"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "wheels.yaml"));
}

TEST(UnwritableResultTest, IsRefusedBeforeTheRun) {
  const TemporaryFolder folder;
  const auto refused = [&](const Words& words) {
    expect_failure(scrubjay_in(folder.path(), words), "no/such/file: cannot write into its folder");
  };
  refused({"explore", own_world("room"), "--max-time", "5", "--octomap", "no/such/file"});
  refused({"emulate", own_world("room"), "--pty", "robot", "--max-time", "0.1", "--truth", "no/such/file"});
  refused({"calibrate", own_world("room"), "--out", "no/such/file"});
}

TEST(FullOutputTest, IsAFailure) {
  const TemporaryFolder folder;
  const auto into_full = [&](const Words& words) {
    return scrubjay(words, {.folder = folder.path(), .largest_file = {}, .err_to = {}, .out_to = "/dev/full"});
  };
  expect_failure(into_full({"info", own_world("room")}), "No space left on device");
  expect_failure(into_full({"explore", own_world("room"), "--max-time", "5", "--json"}), "No space left on device");
}

/// A disc of half a megabyte that comes and goes with the test.
class FullDiscTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(disc_);
    mounted_ = ::mount("tmpfs", disc_.c_str(), "tmpfs", 0, "size=512k") == 0;
    if (!mounted_) GTEST_SKIP() << "may not mount a small disc";
  }
  void TearDown() override {
    if (mounted_) ::umount(disc_.c_str());
  }
  /// Fills the disc but for so many bytes.
  void leave(std::size_t room) const {
    std::filesystem::remove(disc_ / "filling");
    const std::size_t free = std::filesystem::space(disc_).free;
    std::ofstream(disc_ / "filling", std::ios::binary) << std::string(free > room ? free - room : 0, 'x');
  }

  TemporaryFolder folder_;
  std::filesystem::path disc_ = folder_ / "disc";
  bool mounted_ = false;
};

TEST_F(FullDiscTest, LeavesAnOlderRunAsItWasOrReplacesAllOfIt) {
  const auto out = disc_ / "out";
  ASSERT_EQ(scrubjay(explore(out, "1")).code, 0);
  const Contents older = contents_of(out);
  int failed = 0;
  for (const std::size_t room : {0U, 4096U, 12288U, 32768U, 65536U, 98304U, 131072U}) {
    SCOPED_TRACE(room);
    leave(room);
    const Outcome outcome = scrubjay(explore(out, "2"));
    if (outcome.code == 0) {
      EXPECT_EQ(broken_result(out), "");
      continue;
    }
    ++failed;
    expect_failure(outcome, "No space left on device", kFigures);
    EXPECT_TRUE(contents_of(out) == older);
  }
  EXPECT_GE(failed, 4);
}

TEST_F(FullDiscTest, LeavesAnOlderRecordingAsItWas) {
  const Words record{"--record", (disc_ / "run.oilog").string()};
  ASSERT_EQ(scrubjay(explore(folder_ / "out", "1", record)).code, 0);
  const std::string older = content_of(disc_ / "run.oilog");
  const Contents results = contents_of(folder_ / "out");
  for (const std::size_t room : {0U, 4096U, 40960U}) {
    SCOPED_TRACE(room);
    leave(room);
    expect_failure(scrubjay(explore(folder_ / "out", "2", record)),
                   "run.oilog: cannot write the recording: No space left");
    EXPECT_EQ(names_of(contents_of(disc_)), (std::set<std::string>{"filling", "run.oilog"}));
    EXPECT_TRUE(content_of(disc_ / "run.oilog") == older);
    EXPECT_TRUE(contents_of(folder_ / "out") == results);
  }
}

}  // namespace
}  // namespace scrubjay

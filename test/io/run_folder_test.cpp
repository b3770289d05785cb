#include <gmock/gmock.h>

#include <optional>
#include <scrubjay/error.hpp>
#include <scrubjay/io/run_folder.hpp>

#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

class RunFolderTest : public testing::Test {
 protected:
  bool exists(const char* name) const { return std::filesystem::exists(folder_ / name); }

  TemporaryFolder folder_;
};

TEST_F(RunFolderTest, IsMadeWithThoseAboveItAndGoesWithThemIfNothingCameIntoIt) {
  {
    const RunFolder made(folder_ / "a/b/c");
    EXPECT_EQ(made.path(), folder_ / "a/b/c");
    EXPECT_TRUE(exists("a/b/c"));
  }
  EXPECT_FALSE(exists("a"));
}

TEST_F(RunFolderTest, StaysWithWhatCameIntoIt) {
  {
    const RunFolder made(folder_ / "a/b/");
    folder_.write("a/b/map.yaml", "x");
  }
  EXPECT_TRUE(exists("a/b/map.yaml"));
}

TEST_F(RunFolderTest, StaysAsFarAsSomethingCameBesideIt) {
  {
    const RunFolder made(folder_ / "a/b/c");
    folder_.write("a/beside", "x");
  }
  EXPECT_FALSE(exists("a/b"));
  EXPECT_TRUE(exists("a/beside"));
}

TEST_F(RunFolderTest, StaysIfItWasThereBefore) {
  std::filesystem::create_directories(folder_ / "a/b");
  { const RunFolder made(folder_ / "a/b"); }
  { const RunFolder made(folder_ / "a/b/../b/."); }
  EXPECT_TRUE(exists("a/b"));
}

TEST_F(RunFolderTest, StaysAsLongAsTheOneItWasGivenTo) {
  std::optional<RunFolder> later;
  {
    RunFolder first(folder_ / "a");
    later.emplace(std::move(first));
  }
  EXPECT_TRUE(exists("a"));
  later.reset();
  EXPECT_FALSE(exists("a"));
}

TEST_F(RunFolderTest, IsRefusedBehindAFileAndLeavesNothing) {
  folder_.write("file", "x");
  EXPECT_THAT(message_of([&] { RunFolder(folder_ / "file"); }), HasSubstr("file: can't make this folder"));
  EXPECT_THAT(message_of([&] { RunFolder(folder_ / "file/a/b"); }), HasSubstr("file/a/b: can't make this folder"));
  EXPECT_THAT(message_of([&] { RunFolder(folder_ / "a" / std::string(300, 'x')); }), HasSubstr("can't make"));
  EXPECT_FALSE(exists("a"));
}

}  // namespace
}  // namespace scrubjay

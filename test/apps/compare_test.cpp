#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <io/temporary_folder.hpp>

#include "command_line.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Outcome compare(const TemporaryFolder& folder, const std::string& threads, const std::string& csv) {
  return scrubjay_in(folder.path(),
                     {"compare", own_world("reactive_trap"), "--strategies", "reactive,random-3", "--noise",
                      "hard-floor", "--seeds", "2", "--max-time", "60", "--threads", threads, "--csv", csv});
}

TEST(CompareTest, PrintsARowAStrategyAndWritesARowARun) {
  const TemporaryFolder folder;
  const Outcome outcome = compare(folder, "2", "table.csv");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, StartsWith("| world | noise | robot | strategy | coverage |"));
  EXPECT_THAT(outcome.out, HasSubstr("\n| reactive_trap | hard-floor | roomba-600 | reactive | "));
  EXPECT_THAT(outcome.out, HasSubstr("\n| reactive_trap | hard-floor | roomba-600 | random-3 | "));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 4);
  const std::string csv = content_of(folder / "table.csv");
  EXPECT_THAT(csv, StartsWith("world,noise,robot,strategy,seed,ended,coverage,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  for (const char* run : {",reactive,1,", ",reactive,2,", ",random-3,1,", ",random-3,2,"})
    EXPECT_THAT(csv, HasSubstr(run));
}

TEST(CompareTest, GivesTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const Outcome one = compare(folder, "1", "one.csv");
  const Outcome two = compare(folder, "2", "two.csv");
  const Outcome many = compare(folder, "1000", "many.csv");
  EXPECT_EQ(many.code, 0);
  EXPECT_EQ(one.out, two.out);
  EXPECT_EQ(one.out, many.out);
  EXPECT_EQ(content_of(folder / "one.csv"), content_of(folder / "two.csv"));
  EXPECT_EQ(content_of(folder / "one.csv"), content_of(folder / "many.csv"));
}

}  // namespace
}  // namespace scrubjay

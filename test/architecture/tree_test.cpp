/// \file
/// The tree as it is, held against the house.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "architecture/include_checker.hpp"

namespace scrubjay::architecture {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::IsEmpty;

const fs::path kTree = SCRUBJAY_SOURCE_DIR;

/// Paths of the regular files below `folder` that `wanted` holds for, relative to the tree, sorted.
template <typename Predicate>
std::vector<std::string> files_below(const std::string& folder, Predicate wanted) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(kTree / folder)) {
    if (entry.is_regular_file() && wanted(entry.path())) files.push_back(fs::relative(entry.path(), kTree).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const std::string& file) {
  std::ifstream stream(kTree / file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

bool is_source(const fs::path& path) {
  return path.extension() == ".hpp" || path.extension() == ".cpp" || path.extension() == ".h";
}

TEST(TreeTest, HoldsOnlySourcesThatTheCheckerReads) {
  for (const char* folder : {"include", "src", "apps"}) {
    EXPECT_THAT(files_below(folder,
                            [](const fs::path& path) {
                              return (path.extension() == ".h" && path.filename() != "scrubjay_c.h") ||
                                     path.extension() == ".cc" || path.extension() == ".cxx";
                            }),
                IsEmpty());
  }
}

TEST(TreeTest, EveryIncludeKeepsToTheHouse) {
  std::vector<std::string> files;
  for (const char* folder : {"include", "src", "apps"}) {
    const std::vector<std::string> found = files_below(folder, is_source);
    files.insert(files.end(), found.begin(), found.end());
  }
  ASSERT_THAT(files, Contains("include/scrubjay/geometry/pose2.hpp"));
  for (const std::string& file : files) EXPECT_THAT(check_source(file, text_of(file)), IsEmpty());
}

TEST(TreeTest, EveryLibraryKeepsToTheHouse) {
  const std::vector<std::string> files =
      files_below("src", [](const fs::path& path) { return path.filename() == "CMakeLists.txt"; });
  ASSERT_THAT(files, Contains("src/geometry/CMakeLists.txt"));
  for (const std::string& file : files) {
    if (file == "src/CMakeLists.txt") continue;
    EXPECT_THAT(check_cmake(file, text_of(file)), IsEmpty());
  }
}

}  // namespace
}  // namespace scrubjay::architecture

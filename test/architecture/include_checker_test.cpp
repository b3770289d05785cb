/// \file
/// The checker itself: it sees each kind of violation, and lets pass what is right.
#include "architecture/include_checker.hpp"

#include <gmock/gmock.h>

#include "architecture/rooms.hpp"

namespace scrubjay::architecture {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr const char* kHeader = "/// \\file\n/// An idea.\n#pragma once\n";

Violations check_header(const std::string& path, const std::string& includes) {
  return check_source(path, kHeader + includes);
}

TEST(HouseTest, ArrowsNeverPointUpwards) {
  for (const auto& [name, room] : house()) {
    for (const std::string& used : room.may_use) {
      ASSERT_TRUE(house().contains(used)) << name << " may use " << used;
      EXPECT_LE(house().at(used).floor, room.floor) << name << " may use " << used;
      EXPECT_FALSE(house().at(used).may_use.contains(name)) << name << " and " << used << " may use each other";
    }
  }
}

TEST(HouseTest, CoreUsesOnlyTheCore) {
  for (const auto& [name, room] : house()) {
    if (!is_core(room)) continue;
    for (const std::string& used : room.may_use) EXPECT_TRUE(is_core(house().at(used))) << name << " may use " << used;
  }
}

TEST(IncludeCheckerTest, KnowsTheRoomOfAFile) {
  EXPECT_EQ(room_of("include/scrubjay/oi/model.hpp"), "oi");
  EXPECT_EQ(room_of("src/io/pgm.cpp"), "io");
  EXPECT_EQ(room_of("apps/commands/explore.cpp"), "apps");
  EXPECT_EQ(room_of("include/scrubjay/error.hpp"), "");
}

TEST(IncludeCheckerTest, LetsPassWhatPointsDown) {
  EXPECT_THAT(check_header("include/scrubjay/robot/a.hpp",
                           "#include <Eigen/Core>\n#include <array>\n#include <scrubjay/oi/model.hpp>\n"),
              IsEmpty());
  EXPECT_THAT(
      check_source("src/simulation/a.cpp",
                   "#include <box2d/box2d.h>\n#include <fmt/format.h>\n#include <vector>\n"
                   "#include <scrubjay/world/world.hpp>\n#include <scrubjay/error.hpp>\n#include \"wheel.hpp\"\n"),
      IsEmpty());
}

TEST(IncludeCheckerTest, SeesAnArrowUpwards) {
  EXPECT_THAT(
      check_header("include/scrubjay/geometry/a.hpp", "#include <scrubjay/robot/frame.hpp>\n"),
      ElementsAre("include/scrubjay/geometry/a.hpp:4: geometry may not use robot (<scrubjay/robot/frame.hpp>)"));
  EXPECT_THAT(check_source("src/world/a.cpp", "#include <scrubjay/simulation/body.hpp>\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/mission/a.cpp", "#include \"scrubjay/io/pgm.hpp\"\n"), SizeIs(1));
  EXPECT_THAT(check_header("include/scrubjay/error.hpp", "#include <scrubjay/geometry/pose2.hpp>\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAnArrowAcrossAFloor) {
  EXPECT_THAT(check_source("src/odometry/a.cpp", "#include <scrubjay/oi/model.hpp>\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/mission/a.cpp", "#include <scrubjay/simulation/body.hpp>\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAPrivateHeaderOfAnotherRoom) {
  EXPECT_THAT(check_source("src/mapping/a.cpp", "#include \"../world/raster.hpp\"\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/mapping/a.cpp", "#include \"world/raster.hpp\"\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesARoomThatIsNotInTheHouse) {
  EXPECT_THAT(check_source("src/attic/a.cpp", ""), SizeIs(1));
  EXPECT_THAT(check_source("src/io/a.cpp", "#include <scrubjay/attic/a.hpp>\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAThirdPartyOutOfItsRoom) {
  EXPECT_THAT(check_source("src/world/a.cpp", "#include <box2d/box2d.h>\n"),
              ElementsAre("src/world/a.cpp:1: <box2d/box2d.h> may not be included in world"));
  for (const char* header : {"yaml-cpp/yaml.h", "urdf_parser/urdf_parser.h", "png.h", "octomap/OcTree.h", "sqlite3.h",
                             "CLI/CLI.hpp", "fastcdr/Cdr.h", "fastdds/dds/core.hpp", "nlohmann/json.hpp"}) {
    EXPECT_THAT(check_source("src/mission/a.cpp", "#include <" + std::string(header) + ">\n"), SizeIs(1)) << header;
  }
  EXPECT_THAT(check_source("src/grid/a.cpp", "#include <fmt/format.h>\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAThirdPartyInAPublicHeader) {
  EXPECT_THAT(check_header("include/scrubjay/simulation/a.hpp", "#include <box2d/box2d.h>\n"), SizeIs(1));
  EXPECT_THAT(check_header("include/scrubjay/mission/a.hpp", "#include <fmt/format.h>\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAThirdPartyThatNobodyKnows) {
  EXPECT_THAT(check_source("src/io/a.cpp", "#include <boost/any.hpp>\n"), ElementsAre(HasSubstr("boost/any.hpp")));
  EXPECT_THAT(check_source("src/io/a.cpp", "#include \"boost/any.hpp\"\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAHostedHeaderInTheCore) {
  for (const char* header : {"vector", "string", "thread", "chrono", "fstream", "iostream", "map", "memory",
                             "functional", "mutex", "unistd.h", "scrubjay/error.hpp"}) {
    EXPECT_THAT(check_source("src/behavior/a.cpp", "#include <" + std::string(header) + ">\n"), SizeIs(1)) << header;
  }
}

TEST(IncludeCheckerTest, KeepsTheHeaderForCToCAndToItsRoom) {
  EXPECT_THAT(check_header("include/scrubjay/scrubjay_c.h", "#include <stddef.h>\n#include <stdint.h>\n"), IsEmpty());
  EXPECT_THAT(check_header("include/scrubjay/scrubjay_c.h", "#include <cstdint>\n"), SizeIs(1));
  EXPECT_THAT(check_header("include/scrubjay/scrubjay_c.h", "#include <scrubjay/robot/motion.hpp>\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/embedded/scrubjay_c.cpp", "#include <scrubjay/scrubjay_c.h>\n"), IsEmpty());
  EXPECT_THAT(check_source("apps/main.cpp", "#include <scrubjay/scrubjay_c.h>\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesAHeaderWithoutItsForm) {
  EXPECT_THAT(check_source("include/scrubjay/oi/a.hpp", "/// \\file\n/// An idea.\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/io/a.hpp", "#pragma once\n"), SizeIs(1));
}

TEST(IncludeCheckerTest, SeesIncludesHoweverTheyAreSpaced) {
  EXPECT_THAT(check_source("src/oi/a.cpp", "  #  include<vector>  // why not\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/oi/a.cpp", "#include HEADER\n"), SizeIs(1));
  EXPECT_THAT(check_source("src/oi/a.cpp", "// #include <vector>\n"), IsEmpty());
}

TEST(CMakeCheckerTest, LetsPassWhatPointsDown) {
  EXPECT_THAT(check_cmake("src/robot/CMakeLists.txt",
                          "# Why.\nscrubjay_library(robot CORE\n  SOURCES world.cpp\n  USES oi odometry)\n"),
              IsEmpty());
  EXPECT_THAT(check_cmake("src/simulation/CMakeLists.txt",
                          "scrubjay_library(simulation SOURCES a.cpp USES world robot LINKS box2d::box2d)"),
              IsEmpty());
}

TEST(CMakeCheckerTest, SeesAnArrowUpwards) {
  EXPECT_THAT(check_cmake("src/oi/CMakeLists.txt", "scrubjay_library(oi CORE SOURCES a.cpp USES robot)"),
              ElementsAre("src/oi/CMakeLists.txt: oi may not use robot"));
}

TEST(CMakeCheckerTest, SeesTheCoreMisnamed) {
  EXPECT_THAT(check_cmake("src/grid/CMakeLists.txt", "scrubjay_library(grid SOURCES a.cpp USES geometry)"), SizeIs(1));
  EXPECT_THAT(check_cmake("src/io/CMakeLists.txt", "scrubjay_library(io CORE SOURCES a.cpp)"), SizeIs(1));
  EXPECT_THAT(check_cmake("src/io/CMakeLists.txt", "scrubjay_library(oi SOURCES a.cpp)"), SizeIs(1));
  EXPECT_THAT(check_cmake("src/io/CMakeLists.txt", "add_library(io a.cpp)"), SizeIs(1));
}

}  // namespace
}  // namespace scrubjay::architecture

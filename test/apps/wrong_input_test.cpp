#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;

constexpr int kFailed = 1;
constexpr int kWrong = 2;

/// A folder with good and bad files, in which nothing may change.
class WrongInputTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(folder_ / "folder");
    std::filesystem::create_directory(folder_ / "folder.oilog");
    folder_.write("empty", "");
    folder_.write("text", "hello\n");
    folder_.write("broken.yaml", "walls:\n  - [[0, 0], [1, 1\n");
    folder_.write("field.yaml", "walls:\n  - [[0, 0], [5, 0]]\n  - [[0, 0], [5, five]]\n");
    folder_.write("typo.yaml", "wals:\n  - [[0, 0], [5, 0]]\n");
    folder_.write("cut.json", R"({"verts": [[0, 0], [4, 0], [4,)");
    folder_.write("bad.json", R"({"verts": [[0, 0], [4, 0], "corner"]})");
    folder_.write("broken.urdf", "<robot name='r'><link></robot>");
    folder_.write("bare.urdf", "<?xml version='1.0'?><robot name='r'><link name='base_link'/></robot>");
    folder_.write("scenario.yaml", "world: \"" + own_world("room") + "\"\nstrategy: fly\n");
    folder_.write("sealed.yaml", "walls:\n  - [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2], [0, 0]]\n");
    folder_.write("head.oilog", "\x89OILOG\r\n");
    folder_.write("future.oilog", "\x89OILOG\r\n\x09 and more");
    folder_.write("gone.yaml",
                  "image: gone.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    folder_.write("short.pgm", "P5\n10 10\n255\nxyz");
    folder_.write("short.png", "\x89PNG\r\n\x1a\n");
    ASSERT_EQ(scrubjay_in(folder_.path(), {"explore", own_world("room"), "--max-time", "5", "--out", "run"}).code, 0);
    before_ = contents_of(folder_.path());
  }

  /// The call fails with `code` and one line that holds `what`, and leaves no trace.
  void expect_refusal(const Words& words, int code, const std::string& what) {
    std::string line;
    for (const std::string& word : words) line += " " + word;
    SCOPED_TRACE("scrubjay" + line);
    const Outcome outcome = scrubjay_in(folder_.path(), words);
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(is_one_line(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("scrubjay: "));
    EXPECT_THAT(outcome.err, HasSubstr(what));
    EXPECT_EQ(outcome.err.find('\033'), std::string::npos);
    const Contents after = contents_of(folder_.path());
    EXPECT_TRUE(after == before_) << "something was written or changed";
    before_ = after;
  }

  void expect_bad_world(const std::string& world, const std::string& what) {
    expect_refusal({"explore", world}, kWrong, what);
  }
  /// A flag of explore with a wrong value, in a good world.
  void expect_bad_flag(const std::string& flag, const std::string& value, const std::string& what) {
    expect_refusal({"explore", own_world("apartment"), flag, value}, kWrong, what);
  }

  TemporaryFolder folder_;
  Contents before_;
};

TEST_F(WrongInputTest, NamesTheWorldThatIsMissingOrBroken) {
  expect_bad_world("missing.yaml", "missing.yaml: cannot read: No such file");
  expect_bad_world("folder", "folder: cannot read: Is a directory");
  expect_bad_world("broken.yaml", "broken.yaml:");
  expect_bad_world("field.yaml", "field.yaml:3: walls[1][1][1] is five; want a number");
  expect_bad_world("typo.yaml", "did you mean 'walls'");
  expect_bad_world("empty", "empty:1: ");
  expect_bad_world("text", "text:1: ");
  expect_bad_world("cut.json", "cut.json:");
  expect_bad_world("bad.json", "bad.json:1: verts[2] is corner; want a point");
  expect_bad_world("gone.yaml", "gone.pgm");
  expect_bad_world("short.pgm", "short.pgm");
  expect_bad_world("run/map.pgm", "is a picture; want the YAML file of its map");
  expect_refusal({"explore"}, kWrong, "no world is given");
  expect_refusal({"explore", own_world("room"), "second"}, kWrong, "second");
}

TEST_F(WrongInputTest, NamesTheRobotThatIsMissingOrBroken) {
  expect_bad_flag("--model", "missing.urdf", "missing.urdf: cannot read: No such file");
  expect_bad_flag("--model", "broken.urdf", "broken.urdf: ");
  expect_bad_flag("--model", "bare.urdf", "bare.urdf: ");
  expect_bad_flag("--model", "empty", "there is no model 'empty'");
}

TEST_F(WrongInputTest, SuggestsTheWordThatWasMeant) {
  expect_bad_flag("--model", "create2", "did you mean 'create-2'? (known: roomba-600, create-2, create-1");
  expect_bad_flag(
      "--strategy", "edge-folow",
      "did you mean 'edge-follow'? (known: random-2, random-3, random-look, random-aware, reactive, wander");
  expect_bad_flag("--noise", "carpt", "did you mean 'carpet'? (known: none, hard-floor, carpet");
  expect_refusal({"exlpore", own_world("room")}, kWrong, "there is no command 'exlpore'; did you mean 'explore'?");
  expect_refusal({"explore", own_world("room"), "--stratgy", "reactive"}, kWrong,
                 "there is no flag '--stratgy'; did you mean '--strategy'?");
  expect_refusal({"--verion"}, kWrong, "there is no flag '--verion'; did you mean '--version'?");
}

TEST_F(WrongInputTest, NamesTheSensesThatAreMissing) {
  expect_bad_flag("--strategy", "frontiers", "strategy 'frontiers' wants a lidar");
  expect_bad_flag("--localizer", "scan-matching", "scan-matching wants a lidar");
  expect_bad_flag("--localizer", "gps", "there is no localizer 'gps'; want odometry or scan-matching");
  const std::string world = own_world("room");
  expect_refusal({"explore", world, "--model", "turtlebot3-burger", "--strategy", "reactive"}, kWrong,
                 "strategy 'reactive' wants a bumper");
  expect_refusal({"explore", world, "--model", "turtlebot3-burger", "--record", "run.oilog"}, kWrong,
                 "which turtlebot3-burger doesn't speak");
  expect_refusal({"compare", world, "--strategies", "tiles"}, kWrong, "strategy 'tiles' wants a lidar");
}

TEST_F(WrongInputTest, RefusesWhatWouldChangeNothing) {
  const std::string world = own_world("room");
  const auto refuse = [&](const Words& more, const std::string& what) {
    Words words{"explore", world};
    words.insert(words.end(), more.begin(), more.end());
    expect_refusal(words, kWrong, what);
  };
  refuse({"--strategy", "random-2", "--within", "-1,-1,1,1"}, "'random-2' plans nothing, and can't stay within bounds");
  refuse({"--strategy", "reactive", "--return-home"}, "'reactive' never ends, and can't return home");
  refuse({"--motion-distortion"}, "--motion-distortion wants a lidar, which roomba-600 hasn't");
  refuse({"--forward-cone", "30"}, "--forward-cone wants a lidar");
  refuse({"--robot-radius", "0.2"}, "--robot-radius wants a lidar");
}

TEST_F(WrongInputTest, RefusesTheCalibrationOfAnotherThanTheRunsRobot) {
  const std::string file = folder_.write("one.yaml", "model: create-1\nleft: 1\nright: 1\naxle: 1\n").string();
  before_ = contents_of(folder_.path());
  expect_bad_flag("--calibration", file, "one.yaml: the calibration of a create-1, but the robot is a roomba-600");
  const Outcome outcome = scrubjay_in(
      folder_.path(), {"explore", own_world("room"), "--model", "create-1", "--calibration", file, "--max-time", "1"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(WrongInputTest, RefusesNumbersThatAreNoneOrOutOfRange) {
  for (const char* text : {"x", "1x", "-1", "nan", ""}) expect_bad_flag("--speed", text, "--speed");
  for (const char* text : {"-1", "1.5", "x", "1e3", "18446744073709551616", "0x10"})
    expect_bad_flag("--seed", text, "--seed");
  for (const char* text : {"0", "-0.05", "nan", "inf", "1.5", "0.001", "x"})
    expect_bad_flag("--resolution", text, "--resolution");
  for (const char* text : {"0", "-1", "nan", "inf", "1e9", "x"}) expect_bad_flag("--max-time", text, "--max-time");
  for (const char* text : {"", "1,2,3", "1,2,3,4,5", "1,2,0,4", "a,b,c,d", "0,0,nan,1"})
    expect_bad_flag("--within", text, "want x0,y0,x1,y1");
  for (const char* text : {"0", "-5", "181", "nan", "x"}) expect_bad_flag("--forward-cone", text, "--forward-cone");
  for (const char* text : {"-0.1", "2", "nan", "x"}) expect_bad_flag("--robot-radius", text, "--robot-radius");
  for (const char* text : {"0", "-1", "11", "nan"}) expect_bad_flag("--height", text, "--height");
  expect_bad_flag("--resolution", "0.9", "resolution");  // a cell larger than the robot
  const std::string world = own_world("room");
  expect_refusal({"compare", world, "--seeds", "0"}, kWrong, "--seeds is 0");
  expect_refusal({"compare", world, "--seeds", "-1"}, kWrong, "--seeds");
  expect_refusal({"compare", world, "--threads", "-1"}, kWrong, "--threads");
  expect_refusal({"compare", world, "--resolution", "0"}, kWrong, "--resolution");
  expect_refusal({"compare", world, "--max-time", "nan"}, kWrong, "--max-time");
  expect_refusal({"compare", world, "--strategies", "fly"}, kWrong, "there is no strategy 'fly'");
  expect_refusal({"compare", world, "--noise", "loud"}, kWrong, "there is no noise profile 'loud'");
  expect_refusal({"compare", "missing.yaml"}, kWrong, "missing.yaml");
  expect_refusal({"compare", world, "--model", "tank"}, kWrong, "there is no model 'tank'");
}

TEST_F(WrongInputTest, RefusesAStartWhereTheRobotCannotBe) {
  expect_bad_flag("--start", "0,0,0", "from a wall");
  expect_bad_flag("--start", "-3,-3,0", "outside of all walls");
  expect_bad_flag("--start", "1e300,0,0", "outside of all walls");
  for (const char* text : {"", "1", "1,2", "1,2,3,4", "a,b,c", "1;2;3", "1,2,nan", "1,2,inf", "1,2,"}) {
    expect_bad_flag("--start", text, "want x,y,theta");
  }
  const std::string boxed = folder_
                                .write("boxed.yaml",
                                       "walls:\n  - [[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]\n"
                                       "furniture:\n  - {name: wardrobe, box: {center: [5, 5], size: [2, 2]}}\n")
                                .string();
  before_ = contents_of(folder_.path());
  expect_refusal({"explore", boxed, "--start", "5,5,0"}, kWrong, "within the wardrobe");
  expect_bad_world("sealed.yaml", "");
}

TEST_F(WrongInputTest, RefusesScenariosAndRecordingsThatCannotBeRun) {
  expect_refusal({"explore", "--scenario", "missing.yaml"}, kWrong, "missing.yaml: cannot read");
  expect_refusal({"explore", "--scenario", "broken.yaml"}, kWrong, "broken.yaml:");
  expect_refusal({"explore", "--scenario", "typo.yaml"}, kWrong, "typo.yaml:1: there is no field 'wals'");
  expect_refusal({"explore", "--scenario", "scenario.yaml"}, kWrong, "there is no strategy 'fly'");
  expect_refusal({"replay", "missing.oilog"}, kWrong, "missing.oilog: cannot read");
  expect_refusal({"replay", "folder"}, kWrong, "folder: is no bag");
  expect_refusal({"replay", "text"}, kWrong, "text: not a recording");
  expect_refusal({"replay", "run/map.png"}, kWrong, "not a recording");
  expect_refusal({"replay", "empty"}, kWrong, "nothing can be replayed");
  expect_refusal({"replay", "head.oilog"}, kWrong, "nothing can be replayed");
  expect_refusal({"replay", "future.oilog"}, kWrong, "version 9");
  expect_refusal({"replay"}, kWrong, "LOG is required");
  expect_refusal({"replay", "head.oilog", "--speed", "-1"}, kWrong, "--speed");
}

TEST_F(WrongInputTest, RefusesAPlaceThatCannotBeWrittenTo) {
  const Words explore{"explore", own_world("room"), "--max-time", "5"};
  const auto with = [&](const Words& more) {
    Words words = explore;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_refusal(with({"--out", "text"}), kFailed, "text: ");
  expect_refusal(with({"--out", "text/out"}), kFailed, "text/out: ");
  expect_refusal(with({"--out", ""}), kFailed, "folder");
  expect_refusal(with({"--out", "run", "--record", "folder.oilog"}), kFailed,
                 "folder.oilog: cannot write the recording: Is a directory");
  expect_refusal(with({"--out", "run", "--record", "nowhere/run.oilog"}), kFailed, "nowhere/run.oilog");
  expect_refusal({"render", own_world("room"), "--out", "folder"}, kFailed, "folder: not a regular file");
  expect_refusal({"render", own_world("room"), "--out", "nowhere/map.png"}, kFailed, "nowhere/map.png");
  expect_refusal(
      {"compare", own_world("room"), "--strategies", "reactive", "--max-time", "5", "--csv", "nowhere/table.csv"},
      kFailed, "nowhere/table.csv");
}

TEST_F(WrongInputTest, RefusesFilesOfAnotherKind) {
  const std::string world = own_world("room");
  for (const char* file : {"missing", "folder", "empty", "text", "field.yaml", "bad.json", "run/scenario.yaml"}) {
    expect_refusal({"render", file}, kWrong, file);
    expect_refusal({"score", file, world}, kWrong, file);
    expect_refusal({"score", "run/map.yaml", file}, kWrong, file);
  }
  expect_refusal({"render", world, "--trajectory", "text"}, kWrong, "text:1: want eight numbers");
  expect_refusal({"render", world, "--start", "here"}, kWrong, "--start is 'here'");
  expect_refusal({"render", "run/map.yaml", "--world", "missing"}, kWrong, "missing");
  expect_refusal({"score", "run/map.yaml", world, "--start", "0,0,0"}, kWrong, "from a wall");
  expect_refusal({"score", "run/map.yaml"}, kWrong, "WORLD is required");
  expect_refusal({"render"}, kWrong, "FILE is required");
  expect_refusal({"info"}, kWrong, "FILE is required");
  for (const char* file : {"missing", "folder", "empty", "text", "field.yaml", "broken.yaml", "bad.json", "cut.json",
                           "broken.urdf", "bare.urdf", "short.pgm", "short.png", "future.oilog"}) {
    expect_refusal({"info", file}, kWrong, file);
  }
  expect_refusal({"info", "gone.yaml"}, kWrong, "gone.pgm");
}

}  // namespace
}  // namespace scrubjay

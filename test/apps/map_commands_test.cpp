#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <nlohmann/json.hpp>
#include <scrubjay/io/image.hpp>

#include "command_line.hpp"
#include "run_folder.hpp"

namespace scrubjay {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A run whose files the commands can be shown.
class MapCommandsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(call({"explore", world_, "--max-time", "120", "--out", "run", "--record", "run.oilog"}).code, 0);
  }
  Outcome call(const Words& words) const { return scrubjay_in(folder_.path(), words); }
  std::string info(const std::string& file) const {
    const Outcome outcome = call({"info", file});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }

  TemporaryFolder folder_;
  std::string world_ = own_world("apartment");
};

TEST_F(MapCommandsTest, RenderDrawsMapsWorldsAndPlans) {
  for (const Words& more :
       {Words{"run/map.yaml"}, Words{world_},
        Words{"run/map.yaml", "--trajectory", "run/trajectory.tum", "--world", world_, "--start", "3.9,3,3.14"}}) {
    Words words{"render", "--out", "picture.png"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = call(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "picture: picture.png\n");
    const Image picture = read_image(folder_ / "picture.png");
    EXPECT_GT(picture.width, 100);
    EXPECT_GT(picture.height, 100);
    std::filesystem::remove(folder_ / "picture.png");
  }
}

TEST_F(MapCommandsTest, ScoreAgreesWithTheRun) {
  const nlohmann::json metrics = metrics_of(folder_ / "run");
  const Outcome outcome = call({"score", "run/map.yaml", world_, "--json"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const nlohmann::json score = nlohmann::json::parse(outcome.out);
  for (const char* figure : {"coverage", "iou", "wall_precision", "wall_recall"}) {
    EXPECT_NEAR(score.at(figure).get<double>(), metrics.at(figure).get<double>(), 1e-5) << figure;
  }
  EXPECT_THAT(call({"score", "run/map.yaml", world_}).out, HasSubstr("wall precision"));
}

TEST_F(MapCommandsTest, ScoreFindsAMapThatLiesElsewhereWorse) {
  const auto iou = [&](const std::string& start) -> double {
    return nlohmann::json::parse(call({"score", "run/map.yaml", world_, "--start", start, "--json"}).out).at("iou");
  };
  EXPECT_GT(iou("3.9,3.0,-3.141592"), iou("3.9,3.0,0"));
}

TEST_F(MapCommandsTest, InfoKnowsEveryFileOfARun) {
  EXPECT_THAT(info("run/map.yaml"), StartsWith("run/map.yaml: map\nsize: "));
  EXPECT_THAT(info("run/map.pgm"), StartsWith("run/map.pgm: image\nsize: "));
  EXPECT_THAT(info("run/map.png"), StartsWith("run/map.png: image\nsize: "));
  EXPECT_THAT(info("run/trajectory.tum"), StartsWith("run/trajectory.tum: trajectory\nposes: "));
  EXPECT_THAT(info("run/scenario.yaml"), StartsWith("run/scenario.yaml: scenario\nworld: "));
  EXPECT_THAT(info("run.oilog"), testing::AllOf(StartsWith("run.oilog: recording\nlength: "), HasSubstr("whole: yes")));
  EXPECT_THAT(info(world_), HasSubstr(": world\nname: "));
  EXPECT_THAT(info(SCRUBJAY_SOURCE_DIR "/urdf/roomba_600.urdf"), HasSubstr(": URDF robot\n"));
}

TEST_F(MapCommandsTest, InfoKnowsTreesAndCalibrations) {
  ASSERT_EQ(call({"explore", world_, "--max-time", "10", "--out", "run", "--octomap", "map.bt"}).code, 0);
  EXPECT_THAT(info("map.bt"), testing::MatchesRegex("map.bt: OctoMap tree\nvoxels: 0.05 m\nnodes: [1-9][0-9]+\n"));
  folder_.write("wheels.yaml",
                "model: create-1\nleft: 1.01\nright: 0.99\naxle: 1.02\n"
                "deviation: {left: 0.001, right: 0.002, axle: 0.003}\ndate: 2026-03-31\n");
  EXPECT_EQ(info("wheels.yaml"),
            "wheels.yaml: calibration\nmodel: create-1\nleft wheel: 1.0100 +- 0.0010\n"
            "right wheel: 0.9900 +- 0.0020\naxle: 1.0200 +- 0.0030\ndrives: 0\ndate: 2026-03-31\n");
}

TEST_F(MapCommandsTest, InfoTellsThatARecordingIsCut) {
  const std::string whole = content_of(folder_ / "run.oilog");
  folder_.write("cut.oilog", whole.substr(0, whole.size() / 2));
  EXPECT_THAT(info("cut.oilog"), HasSubstr("whole: no"));
}

}  // namespace
}  // namespace scrubjay

#include <gtest/gtest.h>

#include <filesystem>
#include <scrubjay/io/carmen_log.hpp>
#include <scrubjay/io/relations_file.hpp>

namespace scrubjay {
namespace {

/// A public log, and what is known of it.
struct RealLog {
  const char* log;
  const char* relations;
  std::size_t scans;
  double offset;         ///< of the relations' clock [s]
  double translation;    ///< mean error of the log's own poses: no more than this [m]
  double rotation;       ///< [rad]
  double wheels_off_by;  ///< at the end [m]
};

class RealLogsTest : public testing::TestWithParam<RealLog> {};

TEST_P(RealLogsTest, AgreeWithTheirRelationsAndNotWithTheirWheels) {
  const std::filesystem::path folder = SCRUBJAY_SHARED_DATA "/carmen";
  if (!std::filesystem::exists(folder / GetParam().log)) GTEST_SKIP() << "no " << GetParam().log << " here";
  const CarmenLog log = read_carmen_log(folder / GetParam().log);
  EXPECT_EQ(log.scans.size(), GetParam().scans);
  const std::vector<Relation> relations = read_relations(folder / GetParam().relations);
  const std::vector<StampedPose> poses = at_logged_stamps(log, logged_poses(log));
  const auto offset = relation_offset(poses, relations);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(*offset, GetParam().offset, 0.02);
  const RelationError error = relation_error(poses, relations, *offset);
  EXPECT_EQ(error.matched, relations.size());
  EXPECT_LT(error.translation.mean, GetParam().translation);
  EXPECT_LT(error.rotation.mean, GetParam().rotation);
  const CarmenRecord& first = log.records.front();
  const CarmenRecord& last = log.records.back();
  const Pose2 off = inverse(inverse(first.pose) * last.pose) * (inverse(first.odometry) * last.odometry);
  EXPECT_NEAR(off.position().norm(), GetParam().wheels_off_by, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Logs, RealLogsTest,
                         testing::Values(RealLog{"intel-corrected.log.gz", "intel.relations.gz", 910, 976052857.337,
                                                 0.065, radians(2.5), 62.05},
                                         RealLog{"freiburg-079-corrected.log.gz", "fr079.relations.gz", 4791, 1211.439,
                                                 0.062, radians(1.1), 45.6}));

}  // namespace
}  // namespace scrubjay

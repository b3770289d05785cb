#include <gmock/gmock.h>

#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_metadata.hpp>

#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

constexpr ros::Qos kBestEffort{ros::Reliability::BestEffort, ros::Durability::Volatile, 5};

BagMetadata metadata_of_a_run() {
  BagMetadata metadata{"sqlite3", "run_0.db3"};
  metadata.add({"/map", "nav_msgs/msg/OccupancyGrid", "", "RIHS01_8d34", ros::kLatched});
  metadata.add({"/scan", "sensor_msgs/msg/LaserScan", "", "", kBestEffort});
  metadata.count(1, 3'000'000'000);
  metadata.count(0, 2'000'000'000);
  metadata.count(1, 3'500'000'001);
  return metadata;
}

// Made by hand after what rosbag2 0.26 writes, its words in quotes.
const std::string kText = R"(version: 8
storage_identifier: sqlite3
duration:
  nanoseconds: 1500000001
starting_time:
  nanoseconds_since_epoch: 2000000000
message_count: 3
topics_with_message_count:
  - topic_metadata:
      name: "/map"
      type: "nav_msgs/msg/OccupancyGrid"
      serialization_format: cdr
      offered_qos_profiles: "- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  deadline:\n    sec: 9223372036\n    nsec: 854775807\n  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  liveliness: 1\n  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n  avoid_ros_namespace_conventions: false"
      type_description_hash: "RIHS01_8d34"
    message_count: 1
  - topic_metadata:
      name: "/scan"
      type: "sensor_msgs/msg/LaserScan"
      serialization_format: cdr
      offered_qos_profiles: "- history: 1\n  depth: 5\n  reliability: 2\n  durability: 2\n  deadline:\n    sec: 9223372036\n    nsec: 854775807\n  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  liveliness: 1\n  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n  avoid_ros_namespace_conventions: false"
      type_description_hash: ""
    message_count: 2
compression_format: ""
compression_mode: ""
relative_file_paths:
  - "run_0.db3"
files:
  - path: "run_0.db3"
    starting_time:
      nanoseconds_since_epoch: 2000000000
    duration:
      nanoseconds: 1500000001
    message_count: 3
custom_data: ~
ros_distro: scrubjay
)";

TEST(BagMetadataTest, IsWrittenAsRosbag2WritesIt) {
  EXPECT_EQ(bag_metadata_text(metadata_of_a_run()), kText);
}

TEST(BagMetadataTest, StandsUnderItsRootInItsFile) {
  const std::string file = bag_metadata_file(metadata_of_a_run());
  EXPECT_THAT(file, testing::StartsWith("rosbag2_bagfile_information:\n  version: 8\n  storage_identifier: sqlite3\n"));
  EXPECT_THAT(file, testing::EndsWith("\n  custom_data: ~\n  ros_distro: scrubjay\n"));
  EXPECT_THAT(file, testing::HasSubstr("\n    - topic_metadata:\n        name: \"/scan\"\n"));
}

TEST(BagMetadataTest, OfABagWithoutMessagesBeginsWhereRosbag2LetsItBegin) {
  BagMetadata metadata{"mcap", "run.mcap"};
  EXPECT_THAT(bag_metadata_text(metadata), testing::HasSubstr("duration:\n  nanoseconds: 0\n"));
  EXPECT_THAT(bag_metadata_text(metadata), testing::HasSubstr("nanoseconds_since_epoch: 9223372036854775807\n"));
  EXPECT_THAT(bag_metadata_text(metadata), testing::HasSubstr("topics_with_message_count: []\n"));
}

TEST(BagMetadataTest, TellsWhichFilesHoldTheBag) {
  const BagFolder folder = parse_bag_folder(bag_metadata_file(metadata_of_a_run()), "metadata.yaml");
  EXPECT_EQ(folder.storage, "sqlite3");
  EXPECT_EQ(folder.compression, "");
  EXPECT_THAT(folder.files, testing::ElementsAre("run_0.db3"));
}

TEST(BagMetadataTest, LeavesTheFolderAwayThatOldBagsNameWithTheirFiles) {
  const BagFolder folder = parse_bag_folder(
      "rosbag2_bagfile_information:\n  version: 3\n  storage_identifier: sqlite3\n"
      "  relative_file_paths: [old/old_0.db3.zstd, ../../old_1.db3.zstd]\n"
      "  compression_format: zstd\n  compression_mode: FILE\n",
      "metadata.yaml");
  EXPECT_THAT(folder.files, testing::ElementsAre("old_0.db3.zstd", "old_1.db3.zstd"));
  EXPECT_EQ(folder.compression, "zstd");
}

TEST(BagMetadataTest, SaysWhichFieldOfAFileIsMissing) {
  EXPECT_EQ(message_of([] { parse_bag_folder("walls: []\n", "metadata.yaml"); }),
            "metadata.yaml:1: rosbag2_bagfile_information is missing");
  EXPECT_EQ(message_of([] {
              parse_bag_folder("rosbag2_bagfile_information:\n  storage_identifier: mcap\n", "metadata.yaml");
            }),
            "metadata.yaml:2: rosbag2_bagfile_information.relative_file_paths is missing");
  EXPECT_EQ(message_of([] {
              parse_bag_folder(
                  "rosbag2_bagfile_information:\n  storage_identifier: mcap\n  relative_file_paths: [a/]\n", "m");
            }),
            "m:3: rosbag2_bagfile_information.relative_file_paths[0] is a/; want the name of a file");
}

TEST(QosTextTest, ReadsBackAsItWasWritten) {
  for (const ros::Qos& qos : {ros::Qos{}, ros::kLatched, kBestEffort}) EXPECT_EQ(parse_qos(qos_text(qos)), qos);
}

TEST(QosTextTest, MayBeInTheWordsOfLaterDistributions) {
  EXPECT_EQ(parse_qos("- history: keep_last\n  depth: 7\n  reliability: reliable\n  durability: transient_local\n"),
            (ros::Qos{ros::Reliability::Reliable, ros::Durability::TransientLocal, 7}));
  EXPECT_EQ(parse_qos("- depth: 5\n  reliability: best_effort\n  durability: volatile\n"), kBestEffort);
}

TEST(QosTextTest, OfSeveralWritersIsWhatAllOfThemOffer) {
  EXPECT_EQ(parse_qos("[{depth: 9, reliability: 1, durability: 1}, {depth: 5, reliability: 2, durability: 1}]"),
            (ros::Qos{ros::Reliability::BestEffort, ros::Durability::TransientLocal, 5}));
  EXPECT_EQ(parse_qos("[{depth: 9, reliability: 1, durability: 1}, {depth: 9, reliability: 1, durability: 2}]"),
            (ros::Qos{ros::Reliability::Reliable, ros::Durability::Volatile, 9}));
}

TEST(QosTextTest, IsTheDefaultWhereItSaysNothingOfUse) {
  for (const std::string text : {"", "[]", "7", "- 7", "{", "- depth: 0", "- depth: [1]\n  reliability: unknown",
                                 "- depth: 99999999999999999999", "a: [*nobody]"}) {
    EXPECT_EQ(parse_qos(text), ros::Qos{}) << text;
  }
}

}  // namespace
}  // namespace scrubjay

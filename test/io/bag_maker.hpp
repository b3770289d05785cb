/// \file
/// Bags of messages, for tests of those who read them.
#pragma once

#include <cmath>
#include <scrubjay/geometry/pose2.hpp>
#include <scrubjay/io/bag.hpp>
#include <scrubjay/messages/cdr.hpp>
#include <scrubjay/messages/conversions.hpp>
#include <string>
#include <utility>
#include <vector>

namespace scrubjay::test {

inline ros::Header header_at(double seconds, const std::string& frame = "") {
  return {ros::time_from_nanoseconds(std::llround(seconds * 1e9)), frame};
}

inline ros::Odometry odometry_at(double seconds, const Pose2& pose, const std::string& base = "base_footprint") {
  ros::Odometry odometry{header_at(seconds, "odom"), base, {}, {}};
  odometry.pose.pose = ros::pose_message(pose);
  return odometry;
}

inline ros::TransformStamped transform_at(double seconds, const std::string& parent, const std::string& child,
                                          const Pose2& pose) {
  return ros::transform_stamped(header_at(seconds, parent), child, pose);
}

/// Four beams, 90 degrees apart.
inline ros::LaserScan scan_at(double seconds, std::vector<float> ranges = {1.0F, 2.0F, 3.0F, 4.0F}) {
  ros::LaserScan scan;
  scan.header = header_at(seconds, "base_scan");
  scan.angle_increment = static_cast<float>(0.5 * kPi);
  scan.range_min = 0.125F;
  scan.range_max = 3.5F;
  scan.ranges = std::move(ranges);
  return scan;
}

/// Writes messages to topics that it adds as they come.
class BagMaker {
 public:
  explicit BagMaker(const std::filesystem::path& path) : writer_(make_bag_writer(path)) {}
  ~BagMaker() { writer_->close(); }

  /// Recorded at `seconds`.
  template <ros::Message M>
  void add(const std::string& topic, double seconds, const M& message) {
    add_bytes<M>(topic, seconds, ros::encode(message));
  }
  template <ros::Message M>
  void add_bytes(const std::string& topic, double seconds, const ros::Bytes& bytes) {
    writer_->write(writer_->add({topic, std::string(M::kType), ros::definition<M>(), std::string(M::kHash), {}}),
                   std::llround(seconds * 1e9), bytes);
  }

 private:
  std::unique_ptr<BagWriter> writer_;
};

}  // namespace scrubjay::test

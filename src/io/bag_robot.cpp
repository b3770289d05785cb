#include <scrubjay/io/bag_robot.hpp>
#include <utility>

#include "bag_messages.hpp"
#include "transform_tree.hpp"

namespace scrubjay {

class BagRobot::State {
 public:
  State(const std::filesystem::path& bag, const BagSenses& senses) : senses_(senses), bag_(open_bag(bag)) {}

  std::optional<Frame> next();
  bool cut() const { return bag_->cut(); }
  std::size_t left_out() const { return left_out_ + assembly_.left_out(); }

 private:
  bool take(const BagMessage& message);
  bool take_odometry(const BagMessage& message);
  bool take_transforms(const BagMessage& message);
  bool take_scan(const BagMessage& message);
  template <class M, class Made>
  bool take_touch(const BagMessage& message, Made made);

  BagSenses senses_;
  std::unique_ptr<BagReader> bag_;
  FrameAssembly assembly_;
  FrameAssembly::Made made_;  ///< the frame that is looked at
  bool ended_ = false;
  std::size_t left_out_ = 0;
};

std::optional<Frame> BagRobot::State::next() {
  auto made = assembly_.next();
  while (!made && !ended_) {
    if (const auto message = bag_->next()) {
      if (!take(*message)) ++left_out_;
    } else {
      ended_ = true;
      assembly_.finish();
    }
    made = assembly_.next();
  }
  if (!made) return std::nullopt;
  made_ = std::move(*made);
  if (made_.frame.scan) made_.frame.scan->ranges = made_.ranges;
  return made_.frame;
}

/// False if the message is of a topic that is wanted, and of no use.
bool BagRobot::State::take(const BagMessage& message) {
  const BagTopic& topic = bag_->topics()[message.topic];
  if (topic.name == senses_.odometry) {
    return topic.type == ros::Odometry::kType ? take_odometry(message) : take_transforms(message);
  }
  if (topic.name == senses_.scan) return take_scan(message);
  if (topic.name == senses_.bumper) return take_touch<ros::Bumper>(message, bumper_of);
  if (topic.name == senses_.cliff) return take_touch<ros::Cliff>(message, cliff_of);
  return true;
}

bool BagRobot::State::take_odometry(const BagMessage& message) {
  const auto odometry = ros::decode<ros::Odometry>(message.bytes);
  const auto pose = odometry ? pose_of(*odometry) : std::nullopt;
  if (pose) assembly_.add_odometry(stamp_of(odometry->header, message), *pose);
  return pose.has_value();
}

/// Others than the odometry's are nothing to count.
bool BagRobot::State::take_transforms(const BagMessage& message) {
  const auto transforms = ros::decode<ros::TFMessage>(message.bytes);
  if (!transforms) return false;
  bool good = true;
  for (const ros::TransformStamped& transform : transforms->transforms) {
    if (last_name(transform.header.frame_id) != "odom" || plain_frame(transform.child_frame_id) != senses_.base) {
      continue;
    }
    const auto pose = pose_of(transform);
    if (pose) assembly_.add_odometry(stamp_of(transform.header, message), *pose);
    good = good && pose;
  }
  return good;
}

bool BagRobot::State::take_scan(const BagMessage& message) {
  auto scan = ros::decode<ros::LaserScan>(message.bytes);
  if (!scan || !is_sound(*scan)) return false;
  const std::int64_t stamp = stamp_of(scan->header, message);
  assembly_.add_scan(scan_of(std::move(*scan), stamp, senses_.upside_down));
  return true;
}

template <class M, class Made>
bool BagRobot::State::take_touch(const BagMessage& message, Made made) {
  const auto touch = ros::decode<M>(message.bytes);
  if (touch) assembly_.add_touch(stamp_of(touch->header, message), made(*touch));
  return touch.has_value();
}

BagRobot::BagRobot(const std::filesystem::path& bag, const BagSenses& senses)
    : state_(std::make_unique<State>(bag, senses)) {}
BagRobot::~BagRobot() = default;

std::optional<Frame> BagRobot::next() {
  return state_->next();
}

bool BagRobot::cut() const {
  return state_->cut();
}

std::size_t BagRobot::left_out() const {
  return state_->left_out();
}

}  // namespace scrubjay

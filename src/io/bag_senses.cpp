#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <scrubjay/error.hpp>
#include <scrubjay/io/bag_robot.hpp>

#include "bag_messages.hpp"
#include "transform_tree.hpp"

namespace scrubjay {
namespace {

/// `/robot1` of `/robot1/scan`; empty for `/scan`.
std::string namespace_of(std::string_view topic) {
  return std::string(topic.substr(0, topic.find_last_of('/')));
}

bool is_within(std::string_view topic, std::string_view space) {
  return space.empty() || (topic.starts_with(space) && topic.substr(space.size()).starts_with('/'));
}

/// What find_senses looks through.
class Survey {
 public:
  Survey(const std::filesystem::path& path, std::string_view robot_namespace);
  BagSenses find();

 private:
  std::string choose(std::string_view type, std::string_view name, std::string_view space) const;
  std::string choose_beside_scan(std::string_view type, std::string_view name) const;
  std::string choose_named(std::string_view type, std::string_view name) const;
  void choose_topics();
  void look_at(const BagMessage& message);
  void take_transforms(const ros::TFMessage& message);
  bool complete() const;
  void check_found() const;
  void mount_lidar();
  [[noreturn]] void fail_for_lack_of(std::string_view types) const;
  bool by_transforms() const { return senses_.odometry.empty() || senses_.odometry == transforms_; }

  std::string name_;
  std::string space_;
  std::unique_ptr<BagReader> bag_;
  BagSenses senses_;
  std::string transforms_;        ///< topic tf
  std::string fixed_transforms_;  ///< topic tf_static
  std::string description_topic_;
  std::size_t chosen_among_ = 0;  ///< topics
  std::string scan_frame_;
  TransformTree tree_;
  bool has_odometry_ = false;
};

Survey::Survey(const std::filesystem::path& path, std::string_view robot_namespace)
    : name_(path.string()), space_(robot_namespace), bag_(open_bag(path)) {
  while (space_.ends_with('/')) space_.pop_back();
  if (!space_.empty() && !space_.starts_with('/')) space_ = fmt::format("/{}", space_);
}

BagSenses Survey::find() {
  choose_topics();
  while (!complete()) {
    const auto message = bag_->next();
    if (!message) break;
    if (bag_->topics().size() != chosen_among_) choose_topics();
    look_at(*message);
  }
  check_found();
  if (senses_.lidar) mount_lidar();
  return std::move(senses_);
}

void Survey::choose_topics() {
  chosen_among_ = bag_->topics().size();
  senses_.scan = choose(ros::LaserScan::kType, "scan", space_);
  senses_.odometry = choose_beside_scan(ros::Odometry::kType, "odom");
  senses_.bumper = choose_beside_scan(ros::Bumper::kType, "bumper");
  senses_.cliff = choose_beside_scan(ros::Cliff::kType, "cliff");
  transforms_ = choose_named(ros::TFMessage::kType, "tf");
  fixed_transforms_ = choose_named(ros::TFMessage::kType, "tf_static");
  description_topic_ = choose_named(ros::String::kType, "robot_description");
  if (senses_.odometry.empty()) senses_.odometry = transforms_;
}

/// The topic of a type that is called so, or the only one of that type; empty if there is none. Throws Error for
/// several.
std::string Survey::choose(std::string_view type, std::string_view name, std::string_view space) const {
  std::vector<std::string> topics;
  for (const BagTopic& topic : bag_->topics()) {
    if (topic.type == type && is_within(topic.name, space)) topics.push_back(topic.name);
  }
  std::vector<std::string> named;
  std::copy_if(topics.begin(), topics.end(), std::back_inserter(named),
               [name](const std::string& topic) { return last_name(topic) == name; });
  if (named.empty()) named = topics;
  if (named.empty()) return "";
  if (named.size() == 1) return named.front();
  throw Error(fmt::format("{}: has several topics of type {}: {}; want the namespace of one of them", name_, type,
                          fmt::join(named, ", ")));
}

/// What belongs to one robot is in one namespace, as a rule.
std::string Survey::choose_beside_scan(std::string_view type, std::string_view name) const {
  const std::string beside = senses_.scan.empty() ? "" : choose(type, name, namespace_of(senses_.scan));
  return beside.empty() ? choose(type, name, space_) : beside;
}

/// The topic of exactly that name beside the scan, in the robot's namespace or in none.
std::string Survey::choose_named(std::string_view type, std::string_view name) const {
  for (const std::string& space : {namespace_of(senses_.scan), space_, std::string()}) {
    for (const BagTopic& topic : bag_->topics()) {
      if (topic.type == type && topic.name == fmt::format("{}/{}", space, name)) return topic.name;
    }
  }
  return "";
}

void Survey::look_at(const BagMessage& message) {
  const std::string& topic = bag_->topics()[message.topic].name;
  if (topic == senses_.scan && !senses_.lidar) {
    const auto scan = ros::decode<ros::LaserScan>(message.bytes);
    if (!scan || !is_sound(*scan)) return;
    senses_.lidar = lidar_of(*scan);
    scan_frame_ = plain_frame(scan->header.frame_id);
  } else if (topic == transforms_ || topic == fixed_transforms_) {
    if (const auto transforms = ros::decode<ros::TFMessage>(message.bytes)) take_transforms(*transforms);
  } else if (topic == senses_.odometry && !has_odometry_) {
    const auto odometry = ros::decode<ros::Odometry>(message.bytes);
    if (!odometry) return;
    has_odometry_ = true;
    senses_.base = plain_frame(odometry->child_frame_id);
  } else if (topic == description_topic_) {
    if (auto description = ros::decode<ros::String>(message.bytes)) senses_.description = std::move(description->data);
  }
}

void Survey::take_transforms(const ros::TFMessage& message) {
  for (const ros::TransformStamped& transform : message.transforms) {
    const bool is_odometry = last_name(transform.header.frame_id) == "odom";
    if (!is_odometry) tree_.add(transform);
    if (!is_odometry || has_odometry_ || !by_transforms()) continue;
    has_odometry_ = true;
    senses_.base = plain_frame(transform.child_frame_id);
  }
}

/// Whether nothing that could still come would tell more.
bool Survey::complete() const {
  if (!has_odometry_ || (!description_topic_.empty() && senses_.description.empty())) return false;
  if (senses_.scan.empty()) return true;
  if (!senses_.lidar) return false;
  return (transforms_.empty() && fixed_transforms_.empty()) || tree_.on(senses_.base, scan_frame_);
}

void Survey::check_found() const {
  if (senses_.scan.empty() && senses_.bumper.empty()) {
    fail_for_lack_of(fmt::format("{} or {}", ros::LaserScan::kType, ros::Bumper::kType));
  }
  if (senses_.odometry.empty()) fail_for_lack_of(fmt::format("{} or {}", ros::Odometry::kType, ros::TFMessage::kType));
  if (!has_odometry_) {
    throw Error(fmt::format("{}: {} tells no odometry; want {}", name_, senses_.odometry,
                            by_transforms() ? "transforms from a frame odom" : "nav_msgs/msg/Odometry"));
  }
  if (!senses_.scan.empty() && !senses_.lidar) {
    throw Error(fmt::format("{}: {} has no message that is a scan", name_, senses_.scan));
  }
}

void Survey::fail_for_lack_of(std::string_view types) const {
  std::vector<std::string> topics;
  for (const BagTopic& topic : bag_->topics()) topics.push_back(fmt::format("{} ({})", topic.name, topic.type));
  throw Error(fmt::format("{}: has no topic of type {}{}; it has: {}", name_, types,
                          space_.empty() ? "" : fmt::format(" within {}", space_),
                          topics.empty() ? "none" : fmt::format("{}", fmt::join(topics, ", "))));
}

void Survey::mount_lidar() {
  const auto pose = tree_.on(senses_.base, scan_frame_);
  if (!pose) return;
  const Eigen::Matrix3d turn = pose->linear();
  constexpr double kLevel = 0.97;  // cosine of 14 degrees
  if (std::fabs(turn(2, 2)) < kLevel) {
    throw Error(fmt::format("{}: {} is no scan of the plane: its lidar is mounted aslant on {}", name_, senses_.scan,
                            senses_.base.empty() ? "the robot" : senses_.base));
  }
  senses_.mount_known = true;
  senses_.upside_down = turn(2, 2) < 0.0;
  senses_.lidar->mount = {pose->translation().x(), pose->translation().y(), atan2(turn(1, 0), turn(0, 0))};
  if (!senses_.upside_down) return;
  senses_.lidar->angle_min = -senses_.lidar->angle_min;
  senses_.lidar->angle_increment = -senses_.lidar->angle_increment;
}

}  // namespace

BagSenses find_senses(const std::filesystem::path& bag, std::string_view robot_namespace) {
  return Survey(bag, robot_namespace).find();
}

RobotModel robot_of(const BagSenses& senses, const RobotModel& body) {
  RobotModel model = body;
  if (senses.bumper.empty()) {
    model.open_interface = false;
    model.has_light_sensors = false;
  }
  model.lidar.reset();
  if (!senses.lidar) return model;
  const LidarModel& told = *senses.lidar;
  LidarModel lidar = body.lidar.value_or(told);
  if (senses.mount_known) lidar.mount = told.mount;
  lidar.beams = told.beams;
  lidar.angle_min = told.angle_min;
  lidar.angle_increment = told.angle_increment;
  if (told.scan_time > 0.0) lidar.scan_time = told.scan_time;
  lidar.min_range = told.min_range;
  lidar.max_range = told.max_range;
  model.lidar = lidar;
  return model;
}

}  // namespace scrubjay

#include <algorithm>
#include <scrubjay/io/robot_description.hpp>

#include "urdf_model.hpp"

namespace scrubjay {
namespace {

ros::FixedLink link_of(const urdf::Joint& joint) {
  const urdf::Pose& pose = joint.parent_to_joint_origin_transform;
  ros::FixedLink link{joint.parent_link_name, joint.child_link_name, {}};
  link.pose.translation = {pose.position.x, pose.position.y, pose.position.z};
  link.pose.rotation = {pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w};
  return link;
}

}  // namespace

RobotDescription read_robot_description(const std::filesystem::path& path) {
  const UrdfFile file = read_urdf(path);
  RobotDescription description{file.text, {}, {}, {}};
  std::vector<ros::WheelLink> wheels;
  for (const auto& [name, joint] : file.model->joints_) {  // a map: by name
    if (joint->type == urdf::Joint::FIXED) description.fixed.push_back(link_of(*joint));
    if (joint->type == urdf::Joint::CONTINUOUS) wheels.push_back({name, link_of(*joint)});
  }
  if (wheels.size() == 2) {
    const auto farther_left = [](const ros::WheelLink& a, const ros::WheelLink& b) {
      return a.link.pose.translation.y > b.link.pose.translation.y;
    };
    std::sort(wheels.begin(), wheels.end(), farther_left);
    description.left = wheels[0];
    description.right = wheels[1];
  }
  return description;
}

}  // namespace scrubjay

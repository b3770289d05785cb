#include "transform_tree.hpp"

#include <cmath>
#include <scrubjay/messages/conversions.hpp>

namespace scrubjay {
namespace {

std::optional<Eigen::Quaterniond> unit_rotation(const ros::Quaternion& q) {
  const Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
  const double norm = rotation.norm();
  // Those who rotate nothing sometimes leave all of it at 0.
  if (!std::isfinite(norm) || norm < 1e-3) return std::nullopt;
  return Eigen::Quaterniond(rotation.coeffs() / norm);
}

bool is_base(std::string_view frame) {
  const std::string_view name = last_name(frame);
  return name == "base_link" || name == "base_footprint";
}

}  // namespace

std::string plain_frame(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return std::string(name);
}

std::string_view last_name(std::string_view name) {
  return name.substr(name.find_last_of('/') + 1);
}

std::optional<Pose2> in_plane(const ros::Point& position, const ros::Quaternion& orientation) {
  const auto rotation = unit_rotation(orientation);
  if (!rotation || !std::isfinite(position.x) || !std::isfinite(position.y)) return std::nullopt;
  // To the last bit or so: what is read was written by a robot in the plane.
  if (orientation.x == 0.0 && orientation.y == 0.0) {
    return Pose2{position.x, position.y, wrap_angle(2.0 * atan2(orientation.z, orientation.w))};
  }
  return Pose2{position.x, position.y, ros::yaw_of({rotation->x(), rotation->y(), rotation->z(), rotation->w()})};
}

void TransformTree::add(const ros::TransformStamped& transform) {
  const auto rotation = unit_rotation(transform.transform.rotation);
  const ros::Vector3& t = transform.transform.translation;
  const Eigen::Vector3d translation(t.x, t.y, t.z);
  if (!rotation || !translation.allFinite()) return;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.rotate(*rotation).pretranslate(translation);
  links_.insert_or_assign(plain_frame(transform.child_frame_id), Link{plain_frame(transform.header.frame_id), pose});
}

std::optional<Eigen::Isometry3d> TransformTree::on(std::string_view base, std::string_view frame) const {
  constexpr int kDeepest = 100;  // and frames in a circle end there, too
  std::optional<Eigen::Isometry3d> on_any_base;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::string_view at = frame;
  for (int i = 0; i < kDeepest; ++i) {
    if (at == base) return pose;
    if (!on_any_base && is_base(at)) on_any_base = pose;
    const auto link = links_.find(at);
    if (link == links_.end()) break;
    pose = link->second.pose * pose;
    at = link->second.parent;
  }
  return on_any_base;
}

}  // namespace scrubjay

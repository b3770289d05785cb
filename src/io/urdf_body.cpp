#include "urdf_body.hpp"

#include <fmt/format.h>

#include <array>
#include <scrubjay/error.hpp>

#include "urdf_model.hpp"

namespace scrubjay {
namespace {

class Body {
 public:
  explicit Body(const std::filesystem::path& path) : name_(path.string()), model_(read_urdf(path).model) {}

  const std::string& robot_name() const { return model_->getName(); }

  const urdf::Cylinder& cylinder(const std::string& link_name) const {
    const auto link = model_->getLink(link_name);
    if (!link) fail(fmt::format("there is no link '{}'; want one with a cylinder", link_name));
    for (const urdf::GeometrySharedPtr& geometry :
         {link->collision ? link->collision->geometry : nullptr, link->visual ? link->visual->geometry : nullptr}) {
      if (!geometry || geometry->type != urdf::Geometry::CYLINDER) continue;
      const auto& found = dynamic_cast<const urdf::Cylinder&>(*geometry);
      if (!(found.radius > 0.0)) fail(fmt::format("link '{}' has a cylinder of radius {}", link_name, found.radius));
      return found;
    }
    fail(fmt::format("link '{}' has no cylinder in collision or visual; want one", link_name));
  }

  bool has(const std::string& link) const { return model_->getLink(link) != nullptr; }

  /// Where a link is, seen from base_link, in the plane.
  Pose2 place(const std::string& link_name) const {
    Pose2 pose;
    for (auto link = model_->getLink(link_name); link && link->name != "base_link"; link = link->getParent()) {
      if (!link->parent_joint) fail(fmt::format("link '{}' doesn't hang on base_link", link_name));
      const urdf::Pose& origin = link->parent_joint->parent_to_joint_origin_transform;
      double roll = 0.0;
      double pitch = 0.0;
      double yaw = 0.0;
      origin.rotation.getRPY(roll, pitch, yaw);
      pose = Pose2{origin.position.x, origin.position.y, yaw} * pose;
    }
    return pose;
  }

  double mass() const {
    const auto base = model_->getLink("base_link");
    return base->inertial ? base->inertial->mass : 0.0;
  }

  [[noreturn]] void fail(const std::string& what) const { throw Error(name_ + ": " + what); }

 private:
  std::string name_;
  urdf::ModelInterfaceSharedPtr model_;
};

template <typename Place>
bool read_row(const Body& body, std::initializer_list<const char*> links, Place&& place) {
  std::size_t found = 0;
  for (const char* link : links) found += body.has(link);
  if (found == 0) return false;
  if (found < links.size())
    body.fail(fmt::format("has {} of the {} links from {} to {}; want all or none", found, links.size(), *links.begin(),
                          *(links.end() - 1)));
  std::size_t i = 0;
  for (const char* link : links) place(i++, body.place(link));
  return true;
}

}  // namespace

void read_urdf_body(const std::filesystem::path& urdf, sim::RobotSpec& spec) {
  const Body body(urdf);
  RobotModel& model = spec.model;
  spec.name = body.robot_name();
  model.radius = body.cylinder("base_link").radius;
  if (body.mass() > 0.0) spec.mass = body.mass();
  model.drive.wheel_radius = body.cylinder("left_wheel").radius;
  const double left = body.place("left_wheel").y;
  const double right = body.place("right_wheel").y;
  if (!(left > right))
    body.fail(fmt::format("left_wheel is at y = {}, right_wheel at {}; want the left one left", left, right));
  model.drive.wheel_separation = left - right;
  spec.wheel_drop_offset = 0.5 * (left - right);

  model.has_light_sensors = read_row(
      body,
      {"light_left", "light_front_left", "light_center_left", "light_center_right", "light_front_right", "light_right"},
      [&](std::size_t i, const Pose2& pose) { model.light.mount[i] = pose; });
  read_row(body, {"cliff_left", "cliff_front_left", "cliff_front_right", "cliff_right"},
           [&](std::size_t i, const Pose2& pose) { model.cliff_sensors[i] = pose.position(); });
  if (body.has("wall_sensor")) spec.wall.mount = body.place("wall_sensor");
  if (body.has("base_scan")) model.lidar.emplace().mount = body.place("base_scan");
  if (body.has("infrared_receiver")) spec.infrared.receiver = body.place("infrared_receiver").position();
}

}  // namespace scrubjay

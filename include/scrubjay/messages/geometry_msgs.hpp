/// \file
/// geometry_msgs and tf2_msgs, as far as we use them. Lengths in metres, angles in radians.
#pragma once

#include <cstdint>
#include <scrubjay/messages/fields.hpp>
#include <scrubjay/messages/std_msgs.hpp>

namespace scrubjay::ros {

struct Point {
  static constexpr std::string_view kType = "geometry_msgs/msg/Point";
  static constexpr std::string_view kHash = "RIHS01_6963084842a9b04494d6b2941d11444708d892da2f4b09843b9c43f42a7f6881";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  static constexpr auto fields() {
    return std::tuple(field("x", &Point::x), field("y", &Point::y), field("z", &Point::z));
  }
  bool operator==(const Point&) const = default;
};

struct Vector3 {
  static constexpr std::string_view kType = "geometry_msgs/msg/Vector3";
  static constexpr std::string_view kHash = "RIHS01_cc12fe83e4c02719f1ce8070bfd14aecd40f75a96696a67a2a1f37f7dbb0765d";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  static constexpr auto fields() {
    return std::tuple(field("x", &Vector3::x), field("y", &Vector3::y), field("z", &Vector3::z));
  }
  bool operator==(const Vector3&) const = default;
};

struct Quaternion {
  static constexpr std::string_view kType = "geometry_msgs/msg/Quaternion";
  static constexpr std::string_view kHash = "RIHS01_8a765f66778c8ff7c8ab94afcc590a2ed5325a1d9a076ffff38fbce36f458684";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;

  static constexpr auto fields() {
    return std::tuple(field("x", &Quaternion::x), field("y", &Quaternion::y), field("z", &Quaternion::z),
                      field("w", &Quaternion::w));
  }
  bool operator==(const Quaternion&) const = default;
};

struct Pose {
  static constexpr std::string_view kType = "geometry_msgs/msg/Pose";
  static constexpr std::string_view kHash = "RIHS01_d501954e9476cea2996984e812054b68026ae0bfae789d9a10b23daf35cc90fa";
  Point position;
  Quaternion orientation;

  static constexpr auto fields() {
    return std::tuple(field("position", &Pose::position), field("orientation", &Pose::orientation));
  }
  bool operator==(const Pose&) const = default;
};

struct PoseStamped {
  static constexpr std::string_view kType = "geometry_msgs/msg/PoseStamped";
  static constexpr std::string_view kHash = "RIHS01_10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8";
  Header header;
  Pose pose;

  static constexpr auto fields() {
    return std::tuple(field("header", &PoseStamped::header), field("pose", &PoseStamped::pose));
  }
  bool operator==(const PoseStamped&) const = default;
};

/// Covariance: row-major, of x, y, z and the turns about them.
struct PoseWithCovariance {
  static constexpr std::string_view kType = "geometry_msgs/msg/PoseWithCovariance";
  static constexpr std::string_view kHash = "RIHS01_9a7c0fd234b7f45c6098745ecccd773ca1085670e64107135397aee31c02e1bb";
  Pose pose;
  std::array<double, 36> covariance{};

  static constexpr auto fields() {
    return std::tuple(field("pose", &PoseWithCovariance::pose), field("covariance", &PoseWithCovariance::covariance));
  }
  bool operator==(const PoseWithCovariance&) const = default;
};

struct PoseWithCovarianceStamped {
  static constexpr std::string_view kType = "geometry_msgs/msg/PoseWithCovarianceStamped";
  static constexpr std::string_view kHash = "RIHS01_26432f9803e43727d3c8f668d1fdb3c630f548af631e2f4e31382371bfea3b6e";
  Header header;
  PoseWithCovariance pose;

  static constexpr auto fields() {
    return std::tuple(field("header", &PoseWithCovarianceStamped::header),
                      field("pose", &PoseWithCovarianceStamped::pose));
  }
  bool operator==(const PoseWithCovarianceStamped&) const = default;
};

struct Twist {
  static constexpr std::string_view kType = "geometry_msgs/msg/Twist";
  static constexpr std::string_view kHash = "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a";
  Vector3 linear;
  Vector3 angular;

  static constexpr auto fields() {
    return std::tuple(field("linear", &Twist::linear), field("angular", &Twist::angular));
  }
  bool operator==(const Twist&) const = default;
};

struct TwistStamped {
  static constexpr std::string_view kType = "geometry_msgs/msg/TwistStamped";
  static constexpr std::string_view kHash = "RIHS01_5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64";
  Header header;
  Twist twist;

  static constexpr auto fields() {
    return std::tuple(field("header", &TwistStamped::header), field("twist", &TwistStamped::twist));
  }
  bool operator==(const TwistStamped&) const = default;
};

struct TwistWithCovariance {
  static constexpr std::string_view kType = "geometry_msgs/msg/TwistWithCovariance";
  static constexpr std::string_view kHash = "RIHS01_49f574f033f095d8b6cd1beaca5ca7925e296e84af1716d16c89d38b059c8c18";
  Twist twist;
  std::array<double, 36> covariance{};

  static constexpr auto fields() {
    return std::tuple(field("twist", &TwistWithCovariance::twist),
                      field("covariance", &TwistWithCovariance::covariance));
  }
  bool operator==(const TwistWithCovariance&) const = default;
};

struct Transform {
  static constexpr std::string_view kType = "geometry_msgs/msg/Transform";
  static constexpr std::string_view kHash = "RIHS01_beb83fbe698636351461f6f35d1abb20010c43d55374d81bd041f1ba2581fddc";
  Vector3 translation;
  Quaternion rotation;

  static constexpr auto fields() {
    return std::tuple(field("translation", &Transform::translation), field("rotation", &Transform::rotation));
  }
  bool operator==(const Transform&) const = default;
};

/// Takes points from child_frame_id to header.frame_id.
struct TransformStamped {
  static constexpr std::string_view kType = "geometry_msgs/msg/TransformStamped";
  static constexpr std::string_view kHash = "RIHS01_0a241f87d04668d94099cbb5ba11691d5ad32c2f29682e4eb5653424bd275206";
  Header header;
  std::string child_frame_id;
  Transform transform;

  static constexpr auto fields() {
    return std::tuple(field("header", &TransformStamped::header),
                      field("child_frame_id", &TransformStamped::child_frame_id),
                      field("transform", &TransformStamped::transform));
  }
  bool operator==(const TransformStamped&) const = default;
};

struct TFMessage {
  static constexpr std::string_view kType = "tf2_msgs/msg/TFMessage";
  static constexpr std::string_view kHash = "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087";
  std::vector<TransformStamped> transforms;

  static constexpr auto fields() { return std::tuple(field("transforms", &TFMessage::transforms)); }
  bool operator==(const TFMessage&) const = default;
};

}  // namespace scrubjay::ros

/// \file
/// All messages that there are, for tests that ask the same of each.
#pragma once

#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/messages/diagnostic_msgs.hpp>
#include <scrubjay/messages/nav_msgs.hpp>
#include <scrubjay/messages/rmw_dds_common.hpp>
#include <scrubjay/messages/sensor_msgs.hpp>
#include <scrubjay/messages/visualization_msgs.hpp>

namespace scrubjay::ros {

template <class... M>
struct Messages {
  template <template <class...> class List>
  using In = List<M...>;
};

using EveryMessage =
    Messages<Time, Duration, Header, Bool, Int16, UInt16, Float32, String, Empty, ColorRGBA, MultiArrayDimension,
             MultiArrayLayout, UInt8MultiArray, Clock, Point, Vector3, Quaternion, Pose, PoseStamped,
             PoseWithCovariance, PoseWithCovarianceStamped, Twist, TwistStamped, TwistWithCovariance, Transform,
             TransformStamped, TFMessage, MapMetaData, OccupancyGrid, Odometry, Path, OccupancyGridUpdate, LaserScan,
             JointState, BatteryState, CompressedImage, Bumper, Cliff, Mode, ChargingState, DefineSong, PlaySong,
             KeyValue, DiagnosticStatus, DiagnosticArray, Log, UVCoordinate, MeshFile, Marker, MarkerArray, Gid,
             NodeEntitiesInfo, ParticipantEntitiesInfo>;

/// The message's name, for the names of tests.
struct MessageName {
  template <Message M>
  static std::string GetName(int) {
    return std::string(M::kType.substr(M::kType.rfind('/') + 1));
  }
};

}  // namespace scrubjay::ros

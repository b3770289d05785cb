/// \file
/// The topics of a robot of ours: name, type and quality of service of each, in one table.
///
/// Names and types are those of nav2, of create_robot (AutonomyLab) and of turtlebot3; what is offered is what meets
/// the most readers of each.
#pragma once

#include <scrubjay/messages/create_msgs.hpp>
#include <scrubjay/messages/diagnostic_msgs.hpp>
#include <scrubjay/messages/message_type.hpp>
#include <scrubjay/messages/nav_msgs.hpp>
#include <scrubjay/messages/qos.hpp>
#include <scrubjay/messages/sensor_msgs.hpp>
#include <scrubjay/messages/visualization_msgs.hpp>
#include <span>

namespace scrubjay::ros {

struct TopicInfo {
  std::string_view name;  ///< relative to the robot's namespace, or absolute with a `/` before it
  MessageType type{};
  Qos qos{};
};

/// A topic whose messages are `M`.
template <Message M>
struct Topic : TopicInfo {
  constexpr Topic(std::string_view topic, const Qos& offered) : TopicInfo{topic, kTypeOf<M>, offered} {}
};

inline constexpr Qos kDefaultQos{};
inline constexpr Qos kTransforms{.depth = 100};
inline constexpr Qos kSensorData{.depth = 5};
inline constexpr Qos kLogging{Reliability::Reliable, Durability::TransientLocal, 1000};

inline constexpr Topic<OccupancyGrid> kMapTopic{"map", kLatched};
inline constexpr Topic<OccupancyGridUpdate> kMapUpdatesTopic{"map_updates", kDefaultQos};
inline constexpr Topic<Odometry> kOdomTopic{"odom", kDefaultQos};
inline constexpr Topic<TFMessage> kTfTopic{"/tf", kTransforms};
inline constexpr Topic<TFMessage> kTfStaticTopic{"/tf_static", kLatched};
inline constexpr Topic<LaserScan> kScanTopic{"scan", kSensorData};
inline constexpr Topic<Bumper> kBumperTopic{"bumper", kDefaultQos};
inline constexpr Topic<Cliff> kCliffTopic{"cliff", kDefaultQos};
inline constexpr Topic<UInt16> kIrOmniTopic{"ir_omni", kDefaultQos};
inline constexpr Topic<Empty> kWheeldropTopic{"wheeldrop", kDefaultQos};
inline constexpr Topic<Mode> kModeTopic{"mode", kDefaultQos};
inline constexpr Topic<Float32> kVoltageTopic{"battery/voltage", kDefaultQos};
inline constexpr Topic<Float32> kCurrentTopic{"battery/current", kDefaultQos};
inline constexpr Topic<Float32> kChargeTopic{"battery/charge", kDefaultQos};
inline constexpr Topic<Float32> kCapacityTopic{"battery/capacity", kDefaultQos};
inline constexpr Topic<Float32> kChargeRatioTopic{"battery/charge_ratio", kDefaultQos};
inline constexpr Topic<Int16> kTemperatureTopic{"battery/temperature", kDefaultQos};
inline constexpr Topic<ChargingState> kChargingStateTopic{"battery/charging_state", kDefaultQos};
inline constexpr Topic<BatteryState> kBatteryStateTopic{"battery_state", kDefaultQos};
inline constexpr Topic<JointState> kJointStatesTopic{"joint_states", kDefaultQos};
inline constexpr Topic<String> kRobotDescriptionTopic{"robot_description", kLatched};
/// All that is needed to repeat the run, as YAML.
inline constexpr Topic<String> kScenarioTopic{"scenario", kLatched};
inline constexpr Topic<Path> kPathTopic{"path", kDefaultQos};
inline constexpr Topic<Path> kPlanTopic{"plan", kDefaultQos};
inline constexpr Topic<MarkerArray> kFrontiersTopic{"frontiers", kDefaultQos};
inline constexpr Topic<MarkerArray> kRoomsTopic{"rooms", kLatched};
inline constexpr Topic<DiagnosticArray> kDiagnosticsTopic{"/diagnostics", kDefaultQos};
inline constexpr Topic<Log> kRosoutTopic{"/rosout", kLogging};
inline constexpr Topic<Clock> kClockTopic{"/clock", kDefaultQos};

/// All of them.
inline constexpr std::array kTopics{
    TopicInfo(kMapTopic),          TopicInfo(kMapUpdatesTopic),  TopicInfo(kOdomTopic),
    TopicInfo(kTfTopic),           TopicInfo(kTfStaticTopic),    TopicInfo(kScanTopic),
    TopicInfo(kBumperTopic),       TopicInfo(kCliffTopic),       TopicInfo(kIrOmniTopic),
    TopicInfo(kWheeldropTopic),    TopicInfo(kModeTopic),        TopicInfo(kVoltageTopic),
    TopicInfo(kCurrentTopic),      TopicInfo(kChargeTopic),      TopicInfo(kCapacityTopic),
    TopicInfo(kChargeRatioTopic),  TopicInfo(kTemperatureTopic), TopicInfo(kChargingStateTopic),
    TopicInfo(kBatteryStateTopic), TopicInfo(kJointStatesTopic), TopicInfo(kRobotDescriptionTopic),
    TopicInfo(kScenarioTopic),     TopicInfo(kPathTopic),        TopicInfo(kPlanTopic),
    TopicInfo(kFrontiersTopic),    TopicInfo(kRoomsTopic),       TopicInfo(kDiagnosticsTopic),
    TopicInfo(kRosoutTopic),       TopicInfo(kClockTopic)};

}  // namespace scrubjay::ros

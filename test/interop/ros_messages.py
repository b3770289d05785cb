"""Messages of ROS 2 for Cyclone DDS, made from what their .msg files say: types and names of members, in their order.

Each is a class here by its name without the package. What an object isn't given is zero, or empty.
"""

import re
import types
from dataclasses import dataclass, field

from cyclonedds.idl import IdlStruct
from cyclonedds.idl import types as t

DEFINITIONS = """
builtin_interfaces/Time: sec int32, nanosec uint32
builtin_interfaces/Duration: sec int32, nanosec uint32
std_msgs/Header: stamp Time, frame_id str
std_msgs/String: data str
std_msgs/Bool: data bool
std_msgs/Empty: structure_needs_at_least_one_member uint8
std_msgs/UInt16: data uint16
std_msgs/Int16: data int16
std_msgs/Float32: data float32
std_msgs/ColorRGBA: r float32, g float32, b float32, a float32
std_msgs/MultiArrayDimension: label str, size uint32, stride uint32
std_msgs/MultiArrayLayout: dim MultiArrayDimension[], data_offset uint32
std_msgs/UInt8MultiArray: layout MultiArrayLayout, data uint8[]
rosgraph_msgs/Clock: clock Time
geometry_msgs/Point: x float64, y float64, z float64
geometry_msgs/Vector3: x float64, y float64, z float64
geometry_msgs/Quaternion: x float64, y float64, z float64, w float64
geometry_msgs/Pose: position Point, orientation Quaternion
geometry_msgs/PoseStamped: header Header, pose Pose
geometry_msgs/PoseWithCovariance: pose Pose, covariance float64[36]
geometry_msgs/PoseWithCovarianceStamped: header Header, pose PoseWithCovariance
geometry_msgs/Twist: linear Vector3, angular Vector3
geometry_msgs/TwistStamped: header Header, twist Twist
geometry_msgs/TwistWithCovariance: twist Twist, covariance float64[36]
geometry_msgs/Transform: translation Vector3, rotation Quaternion
geometry_msgs/TransformStamped: header Header, child_frame_id str, transform Transform
tf2_msgs/TFMessage: transforms TransformStamped[]
nav_msgs/MapMetaData: map_load_time Time, resolution float32, width uint32, height uint32, origin Pose
nav_msgs/OccupancyGrid: header Header, info MapMetaData, data int8[]
nav_msgs/Odometry: header Header, child_frame_id str, pose PoseWithCovariance, twist TwistWithCovariance
nav_msgs/Path: header Header, poses PoseStamped[]
map_msgs/OccupancyGridUpdate: header Header, x int32, y int32, width uint32, height uint32, data int8[]
sensor_msgs/JointState: header Header, name str[], position float64[], velocity float64[], effort float64[]
sensor_msgs/BatteryState: header Header, voltage float32, temperature float32, current float32, charge float32,
  capacity float32, design_capacity float32, percentage float32, power_supply_status uint8, power_supply_health uint8,
  power_supply_technology uint8, present bool, cell_voltage float32[], cell_temperature float32[], location str,
  serial_number str
sensor_msgs/CompressedImage: header Header, format str, data uint8[]
create_msgs/Bumper: header Header, is_left_pressed bool, is_right_pressed bool, is_light_left bool,
  is_light_front_left bool, is_light_center_left bool, is_light_center_right bool, is_light_front_right bool,
  is_light_right bool, light_signal_left uint16, light_signal_front_left uint16, light_signal_center_left uint16,
  light_signal_center_right uint16, light_signal_front_right uint16, light_signal_right uint16
create_msgs/Cliff: header Header, is_cliff_left bool, is_cliff_front_left bool, is_cliff_right bool,
  is_cliff_front_right bool
create_msgs/Mode: header Header, mode uint8
create_msgs/ChargingState: header Header, state uint8
create_msgs/DefineSong: song uint8, length uint8, notes uint8[], durations float32[]
create_msgs/PlaySong: song uint8
diagnostic_msgs/KeyValue: key str, value str
diagnostic_msgs/DiagnosticStatus: level uint8, name str, message str, hardware_id str, values KeyValue[]
diagnostic_msgs/DiagnosticArray: header Header, status DiagnosticStatus[]
rcl_interfaces/Log: stamp Time, level uint8, name str, msg str, file str, function str, line uint32
visualization_msgs/UVCoordinate: u float32, v float32
visualization_msgs/MeshFile: filename str, data uint8[]
visualization_msgs/Marker: header Header, ns str, id int32, type int32, action int32, pose Pose, scale Vector3, color
  ColorRGBA, lifetime Duration, frame_locked bool, points Point[], colors ColorRGBA[], texture_resource str, texture
  CompressedImage, uv_coordinates UVCoordinate[], text str, mesh_resource str, mesh_file MeshFile,
  mesh_use_embedded_materials bool
visualization_msgs/MarkerArray: markers Marker[]
"""

PRIMITIVES = {"bool": bool, "str": str, "float32": t.float32, "float64": t.float64, "int8": t.int8, "int16": t.int16,
              "int32": t.int32, "uint8": t.uint8, "uint16": t.uint16, "uint32": t.uint32}
ZEROS = {"bool": bool, "str": str, "float32": float, "float64": float}


def member(word, known):
    """The type that a word means, and what makes its default."""
    single, array, count = re.fullmatch(r"(\w+)(\[(\d*)\])?", word).groups()
    one = PRIMITIVES.get(single) or known[single]
    if count:
        return t.array[one, int(count)], lambda: [ZEROS.get(single, int)()] * int(count)
    if array:
        return t.sequence[one], list
    return one, known.get(single) or ZEROS.get(single, int)


def define(name, words, known):
    """The class of `package/Name`, whose members are `name type, name type`; it goes into `known`, too."""
    package, short = name.split("/")
    body = {"__annotations__": {}, "ros_name": f"{package}/msg/{short}"}
    for called, word in (pair.split() for pair in words.split(",")):
        body["__annotations__"][called], default = member(word, known)
        body[called] = field(default_factory=default)
    typename = {"typename": f"{package}.msg.dds_.{short}_"}
    known[short] = dataclass(types.new_class(short, (IdlStruct,), typename, lambda space: space.update(body)))
    return known[short]


def define_all(text, known):
    """A definition begins where a line does; the next lines are its own if they are indented."""
    for line in re.sub(r"\n +", " ", text).strip().splitlines():
        define(*line.split(": "), known)


def discovery_info(gid_size):
    """rmw_dds_common/ParticipantEntitiesInfo, whose Gid has 24 bytes in Humble and 16 since Iron."""
    known = {}
    define_all(f"""
rmw_dds_common/Gid: data uint8[{gid_size}]
rmw_dds_common/NodeEntitiesInfo: node_namespace str, node_name str, reader_gid_seq Gid[], writer_gid_seq Gid[]
rmw_dds_common/ParticipantEntitiesInfo: gid Gid, node_entities_info_seq NodeEntitiesInfo[]
""", known)
    return known["ParticipantEntitiesInfo"]


define_all(DEFINITIONS, globals())

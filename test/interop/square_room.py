"""Somebody else's robot: it drives a circle in an empty square room, and tells what it sees in messages of ROS 2."""

import math

import numpy
from mcap.writer import Writer as McapWriter
from rosbags.rosbag2 import Writer as FolderWriter
from rosbags.typesys import Stores, get_typestore

HALF = 2.0  # of the room's side [m]
RADIUS, TURN_RATE = 0.5, 0.5  # of the circle [m], [rad/s]
LIDAR_AT = 0.1  # before the robot's middle [m]
BEAMS = 360
DURATION, ODOMETRY_RATE, SCAN_EVERY = 25.0, 20.0, 4  # [s], [Hz]; a scan with every fourth odometry
BEGIN = 1_700_000_000  # [s]

STORE = get_typestore(Stores.ROS2_JAZZY)


def made(name, *fields):
    package, message = name.split("/")
    return STORE.types[f"{package}/msg/{message}"](*fields)


def pose_at(t):
    """x, y and heading, in a frame whose origin is the room's middle."""
    turned = TURN_RATE * t
    return RADIUS * math.sin(turned) + 0.2, RADIUS * (1.0 - math.cos(turned)) - 0.7, turned


def ranges_at(t):
    x, y, heading = pose_at(t)
    x, y = x + LIDAR_AT * math.cos(heading), y + LIDAR_AT * math.sin(heading)
    bearings = heading + numpy.arange(BEAMS) * math.tau / BEAMS
    with numpy.errstate(divide="ignore"):
        to_x = (numpy.copysign(HALF, numpy.cos(bearings)) - x) / numpy.cos(bearings)
        to_y = (numpy.copysign(HALF, numpy.sin(bearings)) - y) / numpy.sin(bearings)
    return numpy.minimum(to_x, to_y).astype(numpy.float32)


def stamp_at(t):
    nanoseconds = round(t * 1e9)
    return made("builtin_interfaces/Time", BEGIN + nanoseconds // 10**9, nanoseconds % 10**9)


def header_at(t, frame):
    return made("std_msgs/Header", stamp_at(t), frame)


def transform(header, child, x, y, heading):
    rotation = made("geometry_msgs/Quaternion", 0.0, 0.0, math.sin(heading / 2.0), math.cos(heading / 2.0))
    place = made("geometry_msgs/Transform", made("geometry_msgs/Vector3", x, y, 0.0), rotation)
    return made("tf2_msgs/TFMessage", [made("geometry_msgs/TransformStamped", header, child, place)])


def odometry(t):
    x, y, heading = pose_at(t)
    rotation = made("geometry_msgs/Quaternion", 0.0, 0.0, math.sin(heading / 2.0), math.cos(heading / 2.0))
    pose = made("geometry_msgs/Pose", made("geometry_msgs/Point", x, y, 0.0), rotation)
    twist = made("geometry_msgs/Twist", made("geometry_msgs/Vector3", RADIUS * TURN_RATE, 0.0, 0.0),
                 made("geometry_msgs/Vector3", 0.0, 0.0, TURN_RATE))
    return made("nav_msgs/Odometry", header_at(t, "odom"), "base_footprint",
                made("geometry_msgs/PoseWithCovariance", pose, numpy.zeros(36)),
                made("geometry_msgs/TwistWithCovariance", twist, numpy.zeros(36)))


def scan(t):
    step = math.tau / BEAMS
    return made("sensor_msgs/LaserScan", header_at(t, "laser"), 0.0, math.tau - step, step, 0.0, 0.2, 0.1, 8.0,
                ranges_at(t), numpy.zeros(0, numpy.float32))


def messages(moves):
    """Time [ns], topic and message, in the order of time. `moves`: the topic that tells where it goes, /odom or /tf."""
    yield BEGIN * 10**9, "/tf_static", transform(header_at(0.0, "base_footprint"), "laser", LIDAR_AT, 0.0, 0.0)
    for i in range(round(DURATION * ODOMETRY_RATE)):
        t = i / ODOMETRY_RATE
        now = BEGIN * 10**9 + round(1e9 * t)
        yield now, moves, odometry(t) if moves == "/odom" else transform(header_at(t, "odom"), "base_footprint",
                                                                         *pose_at(t))
        if i % SCAN_EVERY == 0:
            yield now, "/scan", scan(t)


def write_folder(folder, moves, version, plugin, pack=None):
    """By rosbags. `pack`: arguments of its set_compression()."""
    writer = FolderWriter(folder, version=version, storage_plugin=plugin)
    if pack:
        writer.set_compression(*pack)
    with writer:
        connections = {}
        for now, topic, message in messages(moves):
            kind = message.__msgtype__
            if topic not in connections:
                connections[topic] = writer.add_connection(topic, kind, typestore=STORE)
            writer.write(connections[topic], now, STORE.serialize_cdr(message, kind))


def write_mcap(path, moves, **options):
    """By mcap, with options of its Writer."""
    with path.open("wb") as file:
        writer = McapWriter(file, **options)
        writer.start(profile="ros2", library="somebody else's")
        channels = {}
        for now, topic, message in messages(moves):
            kind = message.__msgtype__
            if topic not in channels:
                definition, _ = STORE.generate_msgdef(kind, ros_version=2)
                schema = writer.register_schema(kind, "ros2msg", definition.encode())
                channels[topic] = writer.register_channel(topic, "cdr", schema)
            data = bytes(STORE.serialize_cdr(message, kind))
            writer.add_message(channels[topic], log_time=now, publish_time=now, data=data)
        writer.finish()

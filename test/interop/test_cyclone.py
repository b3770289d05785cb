"""Eclipse Cyclone DDS, another vendor's, sees our node and hears all that it says."""

import math
import unittest

import ros_messages as ros
from cyclonedds.core import Policy
from emulator import eventually
from ros_peer import LATCHED, ROOM, Node, Peer, bridge, seconds, user_data, x_of
from rosbags.typesys import Stores, get_typestore

# Types of the topics that a Roomba has; the latched ones follow.
TOPICS = {
    "battery/capacity": ros.Float32, "battery/charge": ros.Float32, "battery/charge_ratio": ros.Float32,
    "battery/charging_state": ros.ChargingState, "battery/current": ros.Float32, "battery/temperature": ros.Int16,
    "battery/voltage": ros.Float32, "battery_state": ros.BatteryState, "bumper": ros.Bumper, "cliff": ros.Cliff,
    "clock": ros.Clock, "diagnostics": ros.DiagnosticArray, "frontiers": ros.MarkerArray, "ir_omni": ros.UInt16,
    "joint_states": ros.JointState, "map_updates": ros.OccupancyGridUpdate, "mode": ros.Mode, "odom": ros.Odometry,
    "path": ros.Path, "plan": ros.Path, "tf": ros.TFMessage, "wheeldrop": ros.Empty,
}
LATCHED_TOPICS = {"map": ros.OccupancyGrid, "robot_description": ros.String, "rooms": ros.MarkerArray,
                  "rosout": ros.Log, "scenario": ros.String, "tf_static": ros.TFMessage}
# Of types that rosbags doesn't bring, as the interface packages of Jazzy have them.
HASHES = {
    "create_msgs/msg/Bumper": "b81367ac534b55b9ef16618d14f7d8da71a5b30328bf5b60b35c8140d9510102",
    "create_msgs/msg/ChargingState": "6886dd061d51ed6f15dc83fef384ddb32d7aa9527b70051acb4f17c17c266c6a",
    "create_msgs/msg/Cliff": "2a1473d9f0c4ef3ef9a18a76fdf6e9323ebfe760afd0757a8f7ff004f25c5980",
    "create_msgs/msg/Mode": "eed2ef7aec4a3793b08babbc176eb6560d7d12e8810da38c4348717b883d70ce",
    "map_msgs/msg/OccupancyGridUpdate": "c4095b0be2e4363f8978a1570e0293ee093436f1e1c61d99b48502ac317025e8",
}


class GraphTest(unittest.TestCase):
    def check_graph(self, distro, gid_size):
        """What `ros2 node info /scrubjay` would be made from."""
        with bridge("--ros-distro", distro) as node:
            peer = Peer(node)
            info = peer.hear("ros_discovery_info", ros.discovery_info(gid_size), LATCHED)

            def whole():
                listed = {(entry.node_namespace, entry.node_name): (sample.gid, entry)
                          for sample in info.all() for entry in sample.node_entities_info_seq}
                found = listed.get(("/", "scrubjay"))
                gids = [*found[1].writer_gid_seq, *found[1].reader_gid_seq] if found else []
                seen = {**peer.writers(), **peer.readers()}
                # 29 topics to hear, 13 to be driven by; the second kind of cmd_vel is another participant's.
                return len(gids) >= 42 and all(bytes(gid.data[:16]) in seen for gid in gids) and found
            gid, entry = eventually(whole, "a node with all its topics")
            self.assertIn(bytes(gid.data[:16]), peer.participants())
            for listed in (gid, *entry.writer_gid_seq, *entry.reader_gid_seq):
                self.assertEqual(bytes(listed.data[16:]), bytes(gid_size - 16))
            readers = {peer.readers()[bytes(listed.data[:16])].topic_name for listed in entry.reader_gid_seq}
            self.assertEqual(readers, {f"rt/{name}" for name in (
                "cmd_vel", "goal_pose", "initialpose", "dock", "undock", "define_song", "play_song", "power_led",
                "set_ascii", "debris_led", "spot_led", "dock_led", "check_led")})
            enclaves = [user_data(sample) for sample in peer.participants().values()]
            self.assertEqual(enclaves.count(b"enclave=/;"), 2)
            return {sample.topic_name.removeprefix("rt/"): sample
                    for sample in (peer.writers()[bytes(listed.data[:16])] for listed in entry.writer_gid_seq)}

    def test_a_node_of_jazzy(self):
        writers = self.check_graph("jazzy", 16)
        store = get_typestore(Stores.ROS2_JAZZY)
        for topic, kind in {**TOPICS, **LATCHED_TOPICS}.items():
            with self.subTest(topic):
                sample = writers[topic]
                self.assertEqual(sample.type_name, kind.__idl_typename__.replace(".", "::"))
                known = HASHES.get(kind.ros_name)
                wanted = f"RIHS01_{known}" if known else store.hash_rihs01(kind.ros_name)
                self.assertEqual(user_data(sample), f"typehash={wanted};".encode())
                policies = list(sample.qos)
                self.assertTrue(any(isinstance(policy, Policy.Reliability.Reliable) for policy in policies))
                self.assertEqual(Policy.Durability.TransientLocal in policies, topic in LATCHED_TOPICS)

    def test_a_node_of_humble(self):
        writers = self.check_graph("humble", 24)
        self.assertEqual({topic for topic in (*TOPICS, *LATCHED_TOPICS) if topic not in writers}, set())


class RosoutTest(unittest.TestCase):
    def test_what_is_refused_is_logged(self):
        with Node("bridge", ROOM, "--ros-args", "-r", "__ns:=/robot1") as node:
            peer = Peer(node)
            lines = peer.hear("rt/rosout", ros.Log, LATCHED)
            lines.first()
            odom = peer.hear("rt/robot1/odom", ros.Odometry)
            told = peer.tell("rt/robot1/goal_pose", ros.PoseStamped)
            goal = ros.PoseStamped(header=ros.Header(frame_id="map"))
            goal.pose.position.x = math.nan
            told.write(goal)
            before = odom.first().header.stamp.sec
            eventually(lambda: odom.last().header.stamp.sec > before + 1, "a second later")
            node.end()
            self.assertEqual({line.name for line in lines.all()}, {"robot1.scrubjay"})
            self.assertIn((30, "refused 0 messages that nobody could read, and 1 that asked for what can't be"),
                          [(line.level, line.msg) for line in lines.all()])
            self.assertIn("refused 0 messages", node.said())


class ExploreTest(unittest.TestCase):
    """A Roomba explores a room, and every topic that it has is heard; then what was said is compared."""

    def explore(self):
        with Node("explore", ROOM, "--ros2", "--speed", "4", "--quiet", "--max-time", "60") as node:
            peer = Peer(node)
            heard = {topic: peer.hear(f"rt/{topic}", kind) for topic, kind in TOPICS.items()}
            heard |= {topic: peer.hear(f"rt/{topic}", kind, LATCHED) for topic, kind in LATCHED_TOPICS.items()}
            self.metrics = node.end(signalled=False)
            self.trajectory = node.trajectory()
            self.said = {topic: one.all() for topic, one in heard.items()}

    def last(self, topic):
        return self.said[topic][-1]

    def test_every_topic_of_a_roomba_has_right_values(self):
        self.explore()
        # These are told when something happens, which may be before anybody hears, or never in that room.
        rare = {"ir_omni", "map_updates", "plan", "wheeldrop"}
        self.assertEqual({topic for topic, said in self.said.items() if not said} - rare, set())
        self.check_ways()
        self.check_senses()
        self.check_battery()
        self.check_latched()
        self.check_words()

    def check_ways(self):
        odoms = {round(seconds(odom), 3): odom for odom in self.said["odom"]}
        self.assertGreater(len(odoms), 1000)
        # A perfect floor: dead reckoning is where the mission thought it was.
        together = [(odoms[round(stamp, 3)], x, y) for stamp, x, y in self.trajectory if round(stamp, 3) in odoms]
        self.assertGreater(len(together), 100)
        for odom, x, y in together:
            self.assertAlmostEqual(x_of(odom), x, delta=1e-5)
            self.assertAlmostEqual(odom.pose.pose.position.y, y, delta=1e-5)
        last = self.last("odom")
        self.assertEqual((last.header.frame_id, last.child_frame_id), ("odom", "base_link"))
        q = last.pose.pose.orientation
        yaw = 2.0 * math.atan2(q.z, q.w)
        self.assertAlmostEqual(math.remainder(yaw - self.metrics["pose"]["theta"], math.tau), 0.0, delta=1e-5)
        left, right = self.last("joint_states").position
        self.assertAlmostEqual(math.remainder((right - left) * 0.036 / 0.235 - yaw, math.tau), 0.0, delta=1e-5)
        for transforms in self.said["tf"]:
            for transform in transforms.transforms:
                stamp = round(seconds(transform), 3)
                if transform.child_frame_id == "base_link" and stamp in odoms:
                    self.assertEqual(transform.header.frame_id, "odom")
                    self.assertEqual(transform.transform.translation.x, x_of(odoms[stamp]))
        end = self.last("path").poses[-1].pose.position
        self.assertAlmostEqual(math.dist((end.x, end.y), (self.metrics["pose"]["x"], self.metrics["pose"]["y"])), 0.0,
                               delta=0.11)
        self.assertAlmostEqual(self.last("clock").clock.sec, self.metrics["simulated_time_s"], delta=1.0)

    def check_senses(self):
        self.assertGreater(self.metrics["bumps"], 0)
        self.assertTrue(any(said.is_left_pressed or said.is_right_pressed for said in self.said["bumper"]))
        self.assertTrue(any(not said.is_left_pressed and not said.is_right_pressed for said in self.said["bumper"]))
        self.assertFalse(any(said.is_cliff_left or said.is_cliff_front_left or said.is_cliff_front_right
                             or said.is_cliff_right for said in self.said["cliff"]))
        self.assertEqual(self.last("mode").mode, 2)

    def check_battery(self):
        state = self.last("battery_state")
        self.assertTrue(state.present)
        self.assertTrue(13.0 < state.voltage < 17.5)
        self.assertLess(state.current, 0.0)
        self.assertEqual(state.power_supply_status, 2, "discharging")
        self.assertTrue(2.0 < state.charge <= state.capacity < 4.0)
        self.assertAlmostEqual(state.percentage, state.charge / state.capacity, places=5)
        charges = [said.data for said in self.said["battery/charge"]]
        self.assertEqual(charges, sorted(charges, reverse=True))
        self.assertEqual(self.last("battery/charging_state").state, 0)
        for topic, value in (("voltage", state.voltage), ("current", state.current), ("charge", state.charge),
                             ("capacity", state.capacity), ("charge_ratio", state.percentage),
                             ("temperature", state.temperature)):
            self.assertAlmostEqual(self.last(f"battery/{topic}").data, value, delta=0.01)

    def check_words(self):
        lines = self.said["rosout"]
        self.assertEqual({line.name for line in lines}, {"scrubjay"})
        self.assertRegex(lines[-1].msg, r"^ends: time limit after \d+ s, ")
        self.assertEqual(lines[-1].level, 20)
        robot, battery, messages = self.last("diagnostics").status
        self.assertEqual([status.name for status in (robot, battery, messages)],
                         ["scrubjay: robot", "scrubjay: battery", "scrubjay: messages"])
        self.assertEqual([status.level for status in (robot, battery, messages)], [0, 0, 0])
        self.assertEqual({value.key: value.value for value in robot.values},
                         {"doing": robot.message, "mode": "safe", "dropped wheels": "none"})
        self.assertIn(("charging", "no"), [(value.key, value.value) for value in battery.values])
        self.assertGreater(int(messages.values[0].value), 1000)

    def check_latched(self):
        grid = self.last("map")
        self.assertEqual(len(grid.data), grid.info.width * grid.info.height)
        self.assertEqual(set(grid.data), {-1, 0, 100})
        # Free where it went: half a robot's width from the walls at least.
        _, x, y = self.trajectory[len(self.trajectory) // 2]
        column = int((x - grid.info.origin.position.x) / grid.info.resolution)
        row = int((y - grid.info.origin.position.y) / grid.info.resolution)
        self.assertEqual(grid.data[row * grid.info.width + column], 0)
        self.check_rooms(grid)
        self.assertIn("<robot", self.last("robot_description").data)
        self.assertIn("max_time: 60", self.last("scenario").data)
        children = [transform.child_frame_id for transform in self.last("tf_static").transforms]
        self.assertEqual(len(children), len(set(children)))
        self.assertIn("cliff_front_left", children)

    def check_rooms(self, grid):
        clear, *markers = self.last("rooms").markers
        self.assertEqual(clear.action, 3, "all that was shown is deleted")
        floors = [marker for marker in markers if marker.ns == "rooms"]
        labels = [marker for marker in markers if marker.ns == "room_labels"]
        self.assertEqual([floor.id for floor in floors], [label.id for label in labels])
        self.assertEqual({(floor.type, floor.header.frame_id) for floor in floors}, {(11, "map")})
        areas = []
        for floor, label in zip(floors, labels):
            corners = [(point.x, point.y) for point in floor.points]
            triangles = zip(corners[::3], corners[1::3], corners[2::3])
            areas.append(sum(0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
                             for a, b, c in triangles))
            number, area, _ = label.text.split()
            self.assertEqual(number, f"{floor.id}:")
            self.assertAlmostEqual(float(area), areas[-1], delta=0.051)
        free = sum(cell == 0 for cell in grid.data) * grid.info.resolution**2
        self.assertTrue(0.9 * free < sum(areas) < 1.2 * free, f"{areas} of {free} m2")

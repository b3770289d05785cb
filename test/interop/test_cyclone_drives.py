"""Eclipse Cyclone DDS, another vendor's, drives the robot of our node."""

import math
import random
import re
import unittest

import ros_messages as ros
from emulator import eventually
from ros_peer import BEST_EFFORT, LATCHED, Peer, bridge, seconds, x_of


def moving(odom):
    return abs(odom.twist.twist.linear.x) > 0.1


def twist(linear, angular=0.0):
    return ros.Twist(linear=ros.Vector3(x=linear), angular=ros.Vector3(z=angular))


def twist_stamped(linear, angular=0.0):
    return ros.TwistStamped(header=ros.Header(frame_id="base_link"), twist=twist(linear, angular))


class BridgeTest(unittest.TestCase):
    def test_updates_fit_into_the_map(self):
        with bridge() as node:
            peer = Peer(node)
            grid = peer.hear("rt/map", ros.OccupancyGrid, LATCHED)
            updates = peer.hear("rt/map_updates", ros.OccupancyGridUpdate)
            grid.first()
            told = peer.tell("rt/cmd_vel", ros.Twist)

            def turned():
                told.write(twist(0.0, 1.0))
                return updates.last()
            update = eventually(turned, "an update of the map")
            self.assertEqual(update.header.frame_id, "map")
            self.assertEqual(len(update.data), update.width * update.height)
            self.assertLessEqual(update.x + update.width, grid.last().info.width)
            self.assertLessEqual(update.y + update.height, grid.last().info.height)

    def stands(self, odom):
        """Waits until it has stood for a second of its own, from now on; where."""
        begin = seconds(odom.last())

        def rest():
            moved = [seconds(o) for o in odom.all() if moving(o)]
            return seconds(odom.last()) - max([begin, *moved[-1:]]) > 1.0
        eventually(rest, "it stands")
        return odom.last()

    def move(self, odom, told, sample):
        """Tells it until it moves: the first messages of a writer may find no reader yet."""
        odom.first()
        before = len(odom.all())

        def moves():
            told.write(sample)
            return any(map(moving, odom.all()[before:]))
        eventually(moves, "it moves")

    def drive_for(self, peer, told, sample, duration, namespace=""):
        """Tells it the same for a time of the robot's; how far it went, by its odometry."""
        odom = peer.hear(f"rt{namespace}/odom", ros.Odometry)
        begin = odom.first()

        def driven():
            told.write(sample)
            motions = [seconds(o) for o in odom.all() if moving(o)]
            return motions and motions[-1] - motions[0] >= duration
        eventually(driven, f"{duration} s of driving")
        end = self.stands(odom)
        motions = [seconds(o) for o in odom.all() if moving(o)]
        return x_of(end) - x_of(begin), motions[-1] - motions[0]

    def check_drive(self, kind, sample, qos):
        with bridge() as node:
            peer = Peer(node)
            way, time = self.drive_for(peer, peer.tell("rt/cmd_vel", kind, qos), sample, 2.0)
            # Speeding up takes from the way what braking adds; the twist is a mean of the last ticks.
            self.assertAlmostEqual(way, 0.2 * time, delta=0.02)
            self.assertGreaterEqual(way, 0.2 * 2.0 - 0.02)
            self.assertLessEqual(way, 0.2 * (2.0 + 0.5) + 0.1)  # it was told a little longer than was seen
            metrics = node.end()
            self.assertAlmostEqual(metrics["distance_m"], way, delta=0.02)
            self.assertLess(metrics["final_error_m"], 0.02)
            self.assertAlmostEqual(metrics["pose"]["x"], way, delta=0.02)

    def test_a_twist_drives_it_as_far_as_it_should(self):
        self.check_drive(ros.Twist, twist(0.2), BEST_EFFORT)

    def test_a_stamped_twist_drives_it_as_far_as_it_should(self):
        self.check_drive(ros.TwistStamped, twist_stamped(0.2), LATCHED)

    def test_a_velocity_is_over_after_half_a_second(self):
        with bridge() as node:
            peer = Peer(node)
            odom = peer.hear("rt/odom", ros.Odometry)
            told = peer.tell("rt/cmd_vel", ros.Twist)
            self.move(odom, told, twist(0.2))
            begin = x_of(self.stands(odom))
            told.write(twist(0.2))  # once
            eventually(lambda: x_of(odom.last()) > begin + 0.01, "it moves again")
            end = x_of(self.stands(odom))
            self.assertAlmostEqual(end - begin, 0.2 * 0.5, delta=0.02)
            self.assertAlmostEqual(node.end()["distance_m"], end, delta=0.02)

    def test_what_is_too_fast_is_slowed_down(self):
        with bridge() as node:
            peer = Peer(node)
            odom = peer.hear("rt/odom", ros.Odometry)
            told = peer.tell("rt/cmd_vel", ros.Twist)
            self.move(odom, told, twist(5.0))
            self.stands(odom)
            fastest = max(o.twist.twist.linear.x for o in odom.all())
            self.assertTrue(0.15 < fastest <= 0.501, fastest)

    def test_garbage_moves_nothing(self):
        with bridge() as node:
            peer = Peer(node)
            odom = peer.hear("rt/odom", ros.Odometry)
            told = peer.tell("rt/cmd_vel", ros.Twist)
            self.move(odom, told, twist(0.2))
            begin = self.stands(odom)
            for bad in (math.nan, math.inf, -math.inf, 1e9, -1e300):
                told.write(twist(bad))
                told.write(twist(0.1, bad))
            # The same topics and types by name, and bytes that are no such message: always seven, and any number.
            garbage = {"cmd_vel": ros.Twist, "goal_pose": ros.PoseStamped, "define_song": ros.DefineSong,
                       "initialpose": ros.PoseWithCovarianceStamped, "power_led": ros.UInt8MultiArray,
                       "set_ascii": ros.UInt8MultiArray, "play_song": ros.PlaySong, "debris_led": ros.Bool,
                       "spot_led": ros.Bool, "dock_led": ros.Bool, "check_led": ros.Bool}
            some = random.Random(2026)
            for members, size in (("data uint8[7]", lambda: 7), ("data uint8[]", lambda: some.randrange(16, 250))):
                other = Peer(node)
                for topic, kind in garbage.items():
                    package, _, short = kind.ros_name.split("/")
                    wrong = ros.define(f"{package}/{short}", members, {})
                    writer = other.tell(f"rt/{topic}", wrong)
                    for _ in range(300):
                        writer.write(wrong(data=[255] * size()))
            end = self.stands(odom)
            self.assertTrue(node.lives())
            self.assertEqual(x_of(begin), x_of(end))
            self.assertAlmostEqual(node.end()["distance_m"], x_of(end), delta=0.02)
            refused = re.search(r"refused (\d+) messages that nobody could read, and (\d+) that asked", node.said())
            self.assertTrue(refused, node.said())
            self.assertGreater(int(refused[1]), 10 * 300)
            self.assertGreaterEqual(int(refused[2]), 10)

    def test_a_late_joiner_gets_what_is_latched(self):
        with bridge() as node:
            Peer(node).hear("rt/odom", ros.Odometry).first(lambda odom: seconds(odom) > 0.0)
            early = Peer(node).hear("rt/map", ros.OccupancyGrid, LATCHED)
            early.first()
            late = Peer(node)
            heard = {topic: late.hear(f"rt/{topic}", kind, LATCHED)
                     for topic, kind in (("map", ros.OccupancyGrid), ("tf_static", ros.TFMessage),
                                         ("robot_description", ros.String), ("scenario", ros.String))}
            grid = heard["map"].first()
            self.assertEqual(grid.header.frame_id, "map")
            self.assertEqual(len(grid.data), grid.info.width * grid.info.height)
            self.assertAlmostEqual(grid.info.resolution, 0.05, places=6)
            self.assertTrue(set(grid.data) <= {-1, 0, 100})
            self.assertIn(0, grid.data)
            for transform in heard["tf_static"].first().transforms:
                q = transform.transform.rotation
                self.assertAlmostEqual(q.x**2 + q.y**2 + q.z**2 + q.w**2, 1.0, places=6)
            self.assertIn("<robot", heard["robot_description"].first().data)
            self.assertIn("room", heard["scenario"].first().data)

    def test_a_goal_is_driven_to(self):
        with bridge() as node:
            peer = Peer(node)
            odom = peer.hear("rt/odom", ros.Odometry)
            goal = ros.PoseStamped(header=ros.Header(frame_id="map"), pose=ros.Pose(
                position=ros.Point(x=0.5), orientation=ros.Quaternion(w=1.0)))
            odom.first(lambda o: seconds(o) > 1.0)
            plan = peer.hear("rt/plan", ros.Path)
            infrared = peer.hear("rt/ir_omni", ros.UInt16)
            self.move(odom, peer.tell("rt/goal_pose", ros.PoseStamped), goal)
            odom.first(lambda o: x_of(o) > 0.4)
            end = self.stands(odom).pose.pose.position
            self.assertAlmostEqual(math.dist((end.x, end.y), (0.5, 0.0)), 0.0, delta=0.06)
            way = next(path.poses for path in plan.all() if path.poses)
            self.assertEqual((way[-1].header.frame_id, way[-1].pose.position.y), ("map", 0.0))
            self.assertFalse(plan.last().poses, "there is none any more")
            self.assertEqual(infrared.last().data, 0, "it has left the dock's field")
            self.assertLess(node.end()["final_error_m"], 0.02)

    def test_a_namespace_is_before_its_topics(self):
        with bridge("--ros-args", "-r", "__ns:=/robot1", "-r", "__node:=jay", "--") as node:
            peer = Peer(node)
            info = peer.hear("ros_discovery_info", ros.discovery_info(16), LATCHED)
            # Not the first one that is heard: its participant for the second type of cmd_vel has a node, too.
            info.first(lambda i: ("/robot1", "jay") in {(n.node_namespace, n.node_name)
                                                        for n in i.node_entities_info_seq})
            self.assertIsNotNone(peer.hear("rt/tf", ros.TFMessage).first())
            told = peer.tell("rt/robot1/cmd_vel", ros.Twist)
            way, time = self.drive_for(peer, told, twist(0.2), 0.5, "/robot1")
            self.assertAlmostEqual(way, 0.2 * time, delta=0.02)

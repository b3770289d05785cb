"""Bags that `scrubjay explore --record` writes, read with rosbags (Python, Apache 2.0) and mcap (Python, MIT)."""

import collections
import math
import sqlite3
import unittest

from mcap.reader import NonSeekingReader, SeekingReader
from rosbags.highlevel import AnyReader
from rosbags.interfaces import QosDurability, QosHistory, QosReliability
from ruamel.yaml import YAML

from recorded_run import Pgm, RecordedRun, info, scrubjay

LATCHED = {"/map", "/rooms", "/tf_static", "/robot_description", "/scenario", "/rosout"}
ROUNDED = 2e-6  # trajectory.tum has six digits behind the point for metres


def seconds(stamp):
    return stamp.sec + 1e-9 * stamp.nanosec


def nanoseconds(stamp):
    return 10**9 * stamp.sec + stamp.nanosec


def parsed(yaml):
    return YAML(typ="safe", pure=True).load(yaml)


class BagTests:
    """A mixin for unittest.TestCase: what holds for every robot and both formats."""

    flags = ()

    def setUp(self):
        self.run_ = RecordedRun(self.bag, "--model", self.model, *self.flags)
        self.addCleanup(self.run_.end)
        self.run_.explore()

    def hashes(self):
        """Of the types, by topic, as the bag has them."""
        raise NotImplementedError

    def messages(self, *topics):
        """Of these topics, or of all: topic, stamp [ns] and message, by the types that the bag itself defines."""
        with AnyReader([self.run_.bag]) as reader:
            wanted = [c for c in reader.connections if not topics or c.topic in topics]
            return [(c.topic, stamp, reader.deserialize(data, c.msgtype))
                    for c, stamp, data in reader.messages(connections=wanted)]

    def test_every_message_decodes(self):
        messages = self.messages()
        counts = collections.Counter(topic for topic, _, _ in messages)
        types = {topic: message.__msgtype__ for topic, _, message in messages}
        listed = info(self.run_.bag)
        self.assertEqual({topic: (counts[topic], types[topic]) for topic in counts},
                         {topic: (count, kind) for topic, (count, kind, _) in listed.items()})
        with AnyReader([self.run_.bag]) as reader:
            self.assertEqual({c.topic: c.msgcount for c in reader.connections}, counts)
        self.assertEqual([stamp for _, stamp, _ in messages], sorted(stamp for _, stamp, _ in messages))

    def test_what_is_latched_says_so(self):
        with AnyReader([self.run_.bag]) as reader:
            offered = {c.topic: c.ext.offered_qos_profiles for c in reader.connections}
        for topic, profiles in offered.items():
            (qos,) = profiles
            self.assertEqual((qos.history, qos.reliability), (QosHistory.KEEP_LAST, QosReliability.RELIABLE), topic)
        self.assertEqual({t for t, (qos,) in offered.items() if qos.durability == QosDurability.TRANSIENT_LOCAL},
                         LATCHED)
        self.assertEqual({t for t, (_, _, latched) in info(self.run_.bag).items() if latched}, LATCHED)

    def test_hashes_are_those_of_the_definitions(self):
        with AnyReader([self.run_.bag]) as reader:
            computed = {c.topic: reader.typestore.hash_rihs01(c.msgtype) for c in reader.connections}
        self.assertEqual(self.hashes(), computed)

    def test_odometry_and_transforms_go_where_the_robot_went(self):
        odometry, corrections = {}, {}
        for topic, stamp, message in self.messages("/odom", "/tf"):
            if topic == "/odom":
                odometry[stamp] = message.pose.pose
            for transform in message.transforms if topic == "/tf" else ():
                if transform.child_frame_id == "odom":
                    corrections[stamp] = transform.transform
        trajectory = self.run_.trajectory()
        self.assertGreater(len(trajectory), 500)
        for t, x, y, z, w in trajectory:
            pose, by = odometry[round(1e9 * t)], corrections[round(1e9 * t)]
            turn = 2.0 * math.atan2(by.rotation.z, by.rotation.w)
            there = complex(by.translation.x, by.translation.y) + complex(pose.position.x, pose.position.y) * complex(
                math.cos(turn), math.sin(turn))
            self.assertLess(abs(there - complex(x, y)), ROUNDED)
            heading = turn + 2.0 * math.atan2(pose.orientation.z, pose.orientation.w) - 2.0 * math.atan2(z, w)
            self.assertLess(abs(math.remainder(heading, math.tau)), ROUNDED)

    def test_last_map_is_the_one_of_the_run(self):
        _, _, message = self.messages("/map")[-1]
        picture, told = self.run_.map(), message.info
        self.assertAlmostEqual(told.resolution, picture.resolution, delta=1e-6)
        column = round((told.origin.position.x - picture.x) / picture.resolution)
        row = round((told.origin.position.y - picture.y) / picture.resolution)
        known = 0
        for i, value in enumerate(message.data.tolist()):
            cell = Pgm.OCCUPIED if value >= 65 else Pgm.FREE if 0 <= value < 20 else Pgm.UNKNOWN
            self.assertEqual(picture.at(column + i % told.width, row + i // told.width), cell, (i, value))
            known += cell != Pgm.UNKNOWN
        self.assertEqual(known, sum(cell != Pgm.UNKNOWN for cell in picture.cells))
        self.assertGreater(known, 500)

    def test_clock_rises_and_no_stamp_is_ahead_of_it(self):
        clock = -1
        for topic, stamp, message in self.messages():
            if topic == "/clock":
                self.assertGreater(nanoseconds(message.clock), clock)
                clock = nanoseconds(message.clock)
            self.assertEqual(stamp, clock, topic)
            if hasattr(message, "header"):
                self.assertLessEqual(nanoseconds(message.header.stamp), clock, topic)
        self.assertAlmostEqual(1e-9 * clock, 60.0, delta=0.1)


class McapTests(BagTests):
    bag = "run.mcap"

    def hashes(self):
        with self.run_.bag.open("rb") as file:
            channels = SeekingReader(file).get_summary().channels
        return {c.topic: c.metadata["topic_type_hash"] for c in channels.values()}

    def test_mcap_finds_checksums_and_summary_right(self):
        with self.run_.bag.open("rb") as file:
            reader = SeekingReader(file, validate_crcs=True)
            messages = [(channel, message.log_time) for _, channel, message in reader.iter_messages()]
            summary = reader.get_summary()
            self.assertEqual(reader.get_header().profile, "ros2")
            inside = [m for m in reader.iter_metadata() if m.name == "rosbag2"]
            file.seek(0)
            in_one_go = NonSeekingReader(file, validate_crcs=True)
            self.assertEqual(sum(1 for _ in in_one_go.iter_messages(log_time_order=False)), len(messages))
        statistics = summary.statistics
        self.assertEqual(statistics.message_count, len(messages))
        self.assertEqual(statistics.message_start_time, messages[0][1])
        self.assertEqual(statistics.message_end_time, messages[-1][1])
        self.assertEqual(statistics.channel_message_counts, collections.Counter(c.id for c, _ in messages))
        self.assertEqual({c.message_encoding for c in summary.channels.values()}, {"cdr"})
        self.assertEqual({s.encoding for s in summary.schemas.values()}, {"ros2msg"})
        self.assertEqual({c.compression for c in summary.chunk_indexes}, {"zstd" if "--zstd" in self.flags else ""})
        # The YAML in the file is without the root that metadata.yaml has.
        metadata = parsed(inside[-1].metadata["serialized_metadata"])
        self.assertEqual((metadata["version"], metadata["storage_identifier"]), (8, "mcap"))
        self.assertEqual(metadata["message_count"], len(messages))


class FolderTests(BagTests):
    bag = "run"

    def hashes(self):
        with AnyReader([self.run_.bag]) as reader:
            return {c.topic: c.digest for c in reader.connections}

    def test_table_has_the_metadata_without_its_root(self):
        (file,) = self.run_.bag.glob("*.db3")
        database = sqlite3.connect(f"{file.as_uri()}?mode=ro", uri=True)
        rows = database.execute("SELECT metadata_version, metadata FROM metadata").fetchall()
        database.close()
        self.assertEqual([version for version, _ in rows], [8])
        outside = parsed((self.run_.bag / "metadata.yaml").read_text())
        self.assertEqual(outside, {"rosbag2_bagfile_information": parsed(rows[0][1])})
        self.assertEqual(sorted(path.name for path in self.run_.bag.iterdir()), ["metadata.yaml", "run_0.db3"])


class LidarTests:
    def test_ranges_are_within_the_lidars_limits(self):
        scans = [message for _, _, message in self.messages("/scan")]
        self.assertGreater(len(scans), 250)  # five a second
        for scan in scans:
            self.assertAlmostEqual(scan.angle_min + (len(scan.ranges) - 1) * scan.angle_increment, scan.angle_max, 4)
            seen = [distance for distance in scan.ranges.tolist() if not math.isinf(distance)]
            self.assertGreater(len(seen), 0)
            self.assertGreaterEqual(min(seen), scan.range_min)
            self.assertLessEqual(max(seen), scan.range_max)


class RoombaMcapTest(McapTests, unittest.TestCase):
    model = "roomba-600"


class RoombaFolderTest(FolderTests, unittest.TestCase):
    model = "roomba-600"


class BurgerMcapTest(McapTests, LidarTests, unittest.TestCase):
    model = "turtlebot3-burger"
    flags = ("--zstd",)


class BurgerFolderTest(FolderTests, LidarTests, unittest.TestCase):
    model = "turtlebot3-burger"


class KilledRunTest(unittest.TestCase):
    def killed(self, bag, size):
        run = RecordedRun(bag, "--model", "turtlebot3-burger")
        self.addCleanup(run.end)
        return run.explore_until_killed(size)

    def assert_opens_and_maps(self, run):
        with AnyReader([run.bag]) as reader:
            stamps = [stamp for c, stamp, data in reader.messages() if reader.deserialize(data, c.msgtype)]
        self.assertGreater(len(stamps), 2000)
        self.assertIn("whole: no", scrubjay("info", run.bag))
        picture = run.replayed_map()
        self.assertGreater(sum(cell == Pgm.FREE for cell in picture.cells), 500)
        return stamps

    def test_leaves_an_mcap_file_that_opens(self):
        run = self.killed("run.mcap", 1_000_000)
        stamps = self.assert_opens_and_maps(run)
        with run.bag.open("rb") as file:
            reader = SeekingReader(file, validate_crcs=True)
            self.assertEqual([message.log_time for _, _, message in reader.iter_messages()], stamps)

    def test_leaves_a_folder_that_opens(self):
        # rosbags doesn't look into the database's log, so there has to be more than that may take.
        self.assert_opens_and_maps(self.killed("run", 5_000_000))

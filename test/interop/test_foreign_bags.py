"""Bags of a robot that isn't ours, written with rosbags and mcap (Python): `scrubjay replay` maps from them."""

import tempfile
import unittest
from pathlib import Path

from mcap.writer import CompressionType, IndexType
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin

import square_room
from recorded_run import Pgm, info, scrubjay

SIDE = 2.0 * square_room.HALF


class ForeignBagTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="scrubjay-interop-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_mapped(self, bag):
        """The room as it is: as large, and walls on all sides, but for the cells in which they are."""
        out = self.folder / "out"
        scrubjay("replay", bag, "--out", out, "--quiet")
        picture = Pgm(out)
        cells = {(column, row): picture.at(column, row)
                 for column in range(picture.width) for row in range(picture.height)}
        free = picture.resolution**2 * sum(cell == Pgm.FREE for cell in cells.values())
        self.assertAlmostEqual(free, SIDE**2, delta=0.05 * SIDE**2)
        walls = [place for place, cell in cells.items() if cell == Pgm.OCCUPIED]
        for along in zip(*walls):
            self.assertAlmostEqual(picture.resolution * (max(along) - min(along)), SIDE, delta=0.11)
        self.assertGreater(picture.resolution * len(walls), 0.9 * 4.0 * SIDE)

    def map_folder(self, moves, *how):
        square_room.write_folder(self.folder / "run", moves, *how)
        self.assert_mapped(self.folder / "run")

    def map_mcap(self, moves, **options):
        square_room.write_mcap(self.folder / "run.mcap", moves, **options)
        self.assert_mapped(self.folder / "run.mcap")

    def test_database_of_version_8(self):
        self.map_folder("/odom", 8, StoragePlugin.SQLITE3)

    def test_database_of_version_9(self):
        self.map_folder("/tf", 9, StoragePlugin.SQLITE3)

    def test_folder_with_mcap_of_version_8(self):
        self.map_folder("/tf", 8, StoragePlugin.MCAP)

    def test_folder_with_mcap_of_version_9(self):
        self.map_folder("/odom", 9, StoragePlugin.MCAP)

    def test_folder_with_packed_mcap(self):
        self.map_folder("/odom", 9, StoragePlugin.MCAP, (CompressionMode.STORAGE, CompressionFormat.ZSTD))

    def test_mcap_that_is_packed_with_zstd(self):
        self.map_mcap("/odom", compression=CompressionType.ZSTD, chunk_size=50_000)

    def test_mcap_that_is_packed_with_lz4(self):
        self.map_mcap("/tf", compression=CompressionType.LZ4, chunk_size=50_000)

    def test_mcap_that_is_not_packed(self):
        self.map_mcap("/tf", compression=CompressionType.NONE)

    def test_mcap_without_chunks(self):
        self.map_mcap("/odom", use_chunking=False, enable_data_crcs=True)

    def test_mcap_without_a_summary(self):
        self.map_mcap("/odom", use_summary_offsets=False, use_statistics=False, index_types=IndexType.NONE,
                      repeat_channels=False, repeat_schemas=False)

    def test_info_lists_its_topics(self):
        square_room.write_folder(self.folder / "run", "/odom", 9, StoragePlugin.SQLITE3)
        self.assertEqual(info(self.folder / "run"),
                         {"/tf_static": (1, "tf2_msgs/msg/TFMessage", False),
                          "/odom": (500, "nav_msgs/msg/Odometry", False),
                          "/scan": (125, "sensor_msgs/msg/LaserScan", False)})

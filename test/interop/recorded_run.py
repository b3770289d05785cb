"""A `scrubjay explore` of a test's own that is recorded into a bag, and what it left."""

import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

from emulator import HERE, PROGRAM, eventually

ROOM = HERE.parent.parent / "worlds" / "room.yaml"


def scrubjay(*words):
    """What the command prints on stdout. Fails if it fails."""
    done = subprocess.run([PROGRAM, *map(str, words)], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"scrubjay {words[0]} ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def info(bag):
    """Each topic that `scrubjay info` lists: its name, count of messages, type, and whether it is latched."""
    topics = {}
    for line in scrubjay("info", bag).splitlines():
        if line.startswith("  "):
            name, count, kind, *latched = line.replace(",", "").split()
            topics[name] = (int(count), kind, bool(latched))
    return topics


class Pgm:
    """A map's picture: cells by row, the upmost first; and what its map.yaml says of it."""

    FREE, UNKNOWN, OCCUPIED = 254, 205, 0

    def __init__(self, folder):
        head, size, largest, self.cells = (folder / "map.pgm").read_bytes().split(b"\n", 3)
        self.width, self.height = map(int, size.split())
        if (head, largest, len(self.cells)) != (b"P5", b"255", self.width * self.height):
            raise AssertionError(f"{folder}/map.pgm isn't whole")
        said = dict(line.split(": ", 1) for line in (folder / "map.yaml").read_text().splitlines())
        self.resolution = float(said["resolution"])
        self.x, self.y, _ = map(float, said["origin"].strip("[]").split(","))  # of the lower left corner [m]

    def at(self, column, row):
        """The cell of that column and row, from the lower left corner; unknown outside."""
        inside = 0 <= column < self.width and 0 <= row < self.height
        return self.cells[(self.height - 1 - row) * self.width + column] if inside else self.UNKNOWN


class RecordedRun:
    """A run in the living room, on a perfect floor. Its folder is gone after `end()`."""

    def __init__(self, bag, *flags):
        self._folder = tempfile.TemporaryDirectory(prefix="scrubjay-interop-")
        folder = Path(self._folder.name)
        self.bag = folder / bag
        self.out = folder / "out"
        self._words = ["explore", ROOM, "--noise", "none", *flags, "--out", self.out, "--record", self.bag, "--quiet"]

    def end(self):
        self._folder.cleanup()

    def explore(self):
        scrubjay(*self._words, "--max-time", "60")
        return self

    def explore_until_killed(self, size):
        """Kills it once `size` bytes are recorded, not in the midst of what it hands to the system at a time."""
        # Fifty times real time: most of the time it waits.
        words = [PROGRAM, *map(str, self._words), "--max-time", "100000", "--speed", "50"]
        process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        try:
            eventually(lambda: self._recorded() > size, f"{size} bytes")
            eventually(lambda: self._halt(process), "a moment between two writes")
        finally:
            process.kill()
            process.wait()
        return self

    def _recorded(self):
        database = self.bag / f"{self.bag.name}_0.db3"
        files = (self.bag, database, database.with_name(database.name + "-wal"))
        return sum(file.stat().st_size for file in files if file.is_file())

    def _halt(self, process):
        """Stops the process; lets it go on if an MCAP file has no end at that moment."""
        process.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
        if self.bag.is_dir() or self.bag.read_bytes().endswith(b"\x89MCAP0\r\n"):
            return True
        process.send_signal(signal.SIGCONT)
        time.sleep(0.01)
        return False

    def trajectory(self):
        """Stamp, x, y, and the quaternion's z and w of each pose."""
        rows = [tuple(map(float, line.split())) for line in (self.out / "trajectory.tum").read_text().splitlines()]
        return [(t, x, y, z, w) for t, x, y, _, _, _, z, w in rows]

    def map(self):
        return Pgm(self.out)

    def replayed_map(self):
        folder = self.out.with_name("again")
        scrubjay("replay", self.bag, "--out", folder, "--quiet")
        return Pgm(folder)

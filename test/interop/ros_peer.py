"""A process of ours that is a node of ROS 2, and a peer of another vendor's (Eclipse Cyclone DDS) that meets it.

On the loopback only, in a domain that no other test is in.
"""

import functools
import json
import os
import signal
import socket
import subprocess
import tempfile
import unittest
from pathlib import Path

from emulator import HERE, PROGRAM, eventually

# As rmw_cyclonedds has it for ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST. It is read with the first participant.
os.environ["CYCLONEDDS_URI"] = """<CycloneDDS><Domain Id="any">
<General><AllowMulticast>false</AllowMulticast>
<Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces></General>
<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>
<Peers><Peer Address="127.0.0.1"/></Peers></Discovery>
<Internal><SocketReceiveBufferSize max="4MB"/></Internal></Domain></CycloneDDS>"""

from cyclonedds.builtin import (BuiltinDataReader, BuiltinTopicDcpsParticipant, BuiltinTopicDcpsPublication,
                                BuiltinTopicDcpsSubscription)
from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from cyclonedds.util import duration

ROOM = HERE.parent.parent / "worlds" / "room.yaml"
RELIABLE = Policy.Reliability.Reliable(duration(seconds=1))
VOLATILE = Qos(RELIABLE, Policy.History.KeepLast(20000))
LATCHED = Qos(RELIABLE, Policy.Durability.TransientLocal, Policy.History.KeepLast(10))
BEST_EFFORT = Qos(Policy.Reliability.BestEffort, Policy.History.KeepLast(20000))


def fresh_domain():
    """A domain's number, reserved as long as the socket lives that comes with it (see test/ros2/fresh_domain.hpp)."""
    for i in range(100):
        number = 1 + (os.getpid() + i) % 100
        reserved = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        try:
            reserved.bind(f"\0scrubjay-test-domain-{number}")
            return number, reserved
        except OSError:
            reserved.close()
    raise AssertionError("all domains are taken")


@functools.cache
def why_no_node():
    """What our program says if it was built with -DSCRUBJAY_ROS2=OFF, or where there was no Fast DDS; else nothing."""
    said = subprocess.run([PROGRAM, "--ros-args"], stdin=subprocess.DEVNULL, capture_output=True, text=True).stderr
    return said.strip() if "built without Fast DDS" in said else ""


def loopback_environment(domain, humble=False):
    """This process's, with what makes a `scrubjay` a node of that domain on this machine alone."""
    quiet = {name: value for name, value in os.environ.items() if not name.startswith(("ROS_", "FASTRTPS_"))}
    # Humble knows no other variable.
    loopback = {"ROS_LOCALHOST_ONLY": "1"} if humble else {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    return {**quiet, **loopback, "ROS_DOMAIN_ID": str(domain)}


class Node:
    """A `scrubjay` that is a node in a domain of its own, from entering a `with` to `end()`, or to leaving it. Skips the
    test if ours can be none."""

    def __init__(self, *words):
        if why_no_node():
            raise unittest.SkipTest(why_no_node())
        self.domain, self._reserved = fresh_domain()
        self._folder = tempfile.TemporaryDirectory(prefix="scrubjay-interop-")
        self.out = Path(self._folder.name) / "out"
        self._said = open(Path(self._folder.name) / "said", "w+", encoding="utf-8")
        self._words = [PROGRAM, *map(str, words)]
        self._environment = loopback_environment(self.domain, "humble" in self._words)
        # Before what belongs to ROS, if anything does.
        place = self._words.index("--ros-args") if "--ros-args" in self._words else len(self._words)
        self._words[place:place] = ["--noise", "none", "--out", str(self.out)]

    def __enter__(self):
        self._process = subprocess.Popen(self._words, env=self._environment, stdin=subprocess.DEVNULL,
                                         stdout=subprocess.DEVNULL, stderr=self._said)
        return self

    def __exit__(self, *_):
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        self._said.close()
        self._folder.cleanup()
        self._reserved.close()

    def said(self):
        self._said.seek(0)
        return self._said.read()

    def lives(self):
        return self._process.poll() is None

    def end(self, signalled=True):
        """Has it end as by Ctrl-C, or waits for its own end; what its metrics.json says."""
        if signalled:
            self._process.send_signal(signal.SIGINT)
        code = self._process.wait(100.0)
        if code not in (0, 130) or not (self.out / "metrics.json").exists():
            raise AssertionError(f"it ended with {code}: {self.said().strip()}")
        return json.loads((self.out / "metrics.json").read_text())

    def trajectory(self):
        """Stamp, x, y of each pose that it left."""
        lines = (self.out / "trajectory.tum").read_text().splitlines()
        return [tuple(map(float, line.split()[:3])) for line in lines]


class Heard:
    """A reader, and all that it has heard."""

    def __init__(self, participant, topic, kind, qos):
        self._kind = kind
        self._reader = DataReader(participant, Topic(participant, topic, kind), qos=qos)
        self._all = []

    def all(self):
        self._all += [sample for sample in self._reader.take(50000) if isinstance(sample, self._kind)]
        return self._all

    def last(self):
        return self.all()[-1] if self.all() else None

    def first(self, holds=lambda sample: True):
        """Waits for the first one of which that holds."""
        return eventually(lambda: next(filter(holds, self.all()), None), f"a {self._kind.__name__}")


class Told:
    """A writer that somebody reads."""

    def __init__(self, participant, topic, kind, qos):
        self._writer = DataWriter(participant, Topic(participant, topic, kind), qos=qos)
        eventually(self._writer.get_matched_subscriptions, f"a reader of {topic}")

    def write(self, sample):
        self._writer.write(sample)


class Peer:
    """A participant in a node's domain."""

    def __init__(self, node):
        self._participant = DomainParticipant(node.domain)
        self._built_in = {}

    def hear(self, topic, kind, qos=VOLATILE):
        return Heard(self._participant, topic, kind, qos)

    def tell(self, topic, kind, qos=VOLATILE):
        return Told(self._participant, topic, kind, qos)

    def _seen(self, what):
        if what not in self._built_in:
            self._built_in[what] = (BuiltinDataReader(self._participant, what), {})
        reader, seen = self._built_in[what]
        for sample in reader.take(1000):
            if getattr(sample, "qos", None) is not None:
                seen[bytes(sample.key.bytes)] = sample
        return seen

    def participants(self):
        return self._seen(BuiltinTopicDcpsParticipant)

    def writers(self):
        return self._seen(BuiltinTopicDcpsPublication)

    def readers(self):
        return self._seen(BuiltinTopicDcpsSubscription)


def user_data(sample):
    return next((bytes(policy.data) for policy in sample.qos if isinstance(policy, Policy.Userdata)), b"")


def bridge(*words):
    return Node("bridge", ROOM, *words)


def seconds(odom):
    return odom.header.stamp.sec + 1e-9 * odom.header.stamp.nanosec


def x_of(odom):
    return odom.pose.pose.position.x

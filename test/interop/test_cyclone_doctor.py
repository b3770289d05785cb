"""`scrubjay doctor --ros2` examines participants of Eclipse Cyclone DDS, another vendor's."""

import json
import subprocess
import unittest

import ros_messages as ros
from cyclonedds.core import Policy, Qos
from cyclonedds.domain import DomainParticipant
from cyclonedds.pub import DataWriter
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic
from emulator import PROGRAM, eventually
from ros_peer import BEST_EFFORT, LATCHED, RELIABLE, VOLATILE, fresh_domain, loopback_environment, why_no_node

ODOMETRY = "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"


def hashed(value):
    return Qos(RELIABLE, Policy.Userdata(f"typehash={value};".encode()))


class DoctorTest(unittest.TestCase):
    def setUp(self):
        if why_no_node():
            self.skipTest(why_no_node())
        self.domain, self._reserved = fresh_domain()
        self.addCleanup(self._reserved.close)
        self.entities = []

    def participant(self, enclave="/"):
        self.entities.append(DomainParticipant(self.domain, Qos(Policy.Userdata(f"enclave={enclave};".encode()))))
        return self.entities[-1]

    def hear(self, participant, topic, kind, qos=VOLATILE):
        self.entities.append(DataReader(participant, Topic(participant, topic, kind), qos=qos))

    def tell(self, participant, topic, kind, qos=VOLATILE):
        self.entities.append(DataWriter(participant, Topic(participant, topic, kind), qos=qos))
        return self.entities[-1]

    def examine(self, *flags):
        words = [PROGRAM, "doctor", "--ros2", "--json", "--listen", "1", *flags]
        done = subprocess.run(words, env=loopback_environment(self.domain, "humble" in flags), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
        report = json.loads(done.stdout)
        self.assertEqual(done.returncode, 0 if report["healthy"] else 1, done.stderr)
        return report

    def report_with(self, count, *flags):
        """... of so many endpoints."""
        def whole():
            report = self.examine(*flags)
            return report if sum(len(peer["endpoints"]) for peer in report["peers"]) == count else None
        return eventually(whole, f"{count} endpoints")

    def judged(self, healthy, *flags):
        report = self.report_with(2, *flags)
        return report if report["healthy"] == healthy else None

    def fits(self, report):
        return {(endpoint["topic"], endpoint["writes"]): (endpoint["hash_state"], endpoint["fit"])
                for peer in report["peers"] for endpoint in peer["endpoints"]}

    def problems(self, report):
        return [finding["what"] for finding in report["findings"] if finding["kind"] == "problem"]

    def test_what_fits_and_what_does_not(self):
        peer = self.participant("/nav")
        self.hear(peer, "rt/map", ros.OccupancyGrid, LATCHED)
        self.hear(peer, "rt/odom", ros.Odometry, Qos(*hashed(ODOMETRY), Policy.Durability.TransientLocal))
        self.hear(peer, "rt/path", ros.Path, hashed("RIHS01_00"))
        self.hear(peer, "rt/scan", ros.String)
        self.hear(peer, "rt/chatter", ros.String, BEST_EFFORT)
        self.tell(peer, "rt/cmd_vel", ros.TwistStamped, BEST_EFFORT)
        self.tell(peer, "rt/goal_pose", ros.PoseStamped, BEST_EFFORT)
        self.tell(peer, "rq/helpRequest", ros.String)
        report = self.report_with(8)
        self.assertEqual([(seen["vendor"], seen["enclave"], seen["address"], seen["nodes"]) for seen in report["peers"]],
                         [("Cyclone DDS", "/nav", "127.0.0.1", [])])
        self.assertEqual(self.fits(report), {
            ("/map", False): ("not told", "matched"), ("/odom", False): ("same", "refused"),
            ("/path", False): ("other", "matched"), ("/scan", False): ("not told", "refused"),
            ("/chatter", False): ("not told", "not ours"), ("/cmd_vel", True): ("not told", "matched"),
            ("/goal_pose", True): ("not told", "refused"), ("rq/helpRequest", True): ("not told", "not ours")})
        problems = self.problems(report)
        for words in ("/odom: somebody at 127.0.0.1 doesn't hear us: durability: transient_local is asked for",
                      "/path: somebody at 127.0.0.1 has another definition of nav_msgs/msg/Path",
                      "/scan: somebody at 127.0.0.1 doesn't hear us: written as sensor_msgs/msg/LaserScan",
                      "/goal_pose: somebody at 127.0.0.1 isn't heard: reliability: reliable is asked for"):
            self.assertEqual([words in problem for problem in problems].count(True), 1, problems)
        self.assertEqual(len(problems), 4)
        self.assertTrue(any("told of no node" in finding["what"] for finding in report["findings"]))

    def test_a_peer_that_fits_is_healthy(self):
        self.hear(self.participant(), "rt/map", ros.OccupancyGrid, LATCHED)
        self.assertEqual(self.problems(self.report_with(1)), [])

    def check_identifiers(self, gid_size, distro, healthy):
        kind = ros.discovery_info(gid_size)
        gid = type(kind().gid)(data=[0] * gid_size)
        peer = self.participant()
        self.tell(peer, "ros_discovery_info", kind, LATCHED).write(kind(gid=gid))
        self.hear(peer, "ros_discovery_info", kind, LATCHED)
        heard = self.entities[-1]
        # That its writer is known doesn't say that what it wrote has come.
        report = eventually(lambda: self.judged(healthy, "--ros-distro", distro), f"healthy: {healthy}")
        self.assertEqual(any("identifiers" in problem for problem in self.problems(report)), not healthy)
        # It tells nobody anything that might harm them.
        self.assertEqual([sample for sample in heard.take(10) if bytes(sample.gid.data) != bytes(gid_size)], [])

    def test_identifiers_of_humble_where_jazzy_is_expected(self):
        self.check_identifiers(24, "jazzy", False)

    def test_identifiers_of_jazzy_where_humble_is_expected(self):
        self.check_identifiers(16, "humble", False)

    def test_identifiers_that_fit(self):
        self.check_identifiers(16, "jazzy", True)

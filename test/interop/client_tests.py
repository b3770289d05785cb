"""What every client must be able to do with an emulated robot. How it does it, its own file says.

Tolerances: a robot sends distances in whole millimetres and angles in whole degrees, and keeps what is left over for
the next time. However often a client asks, what it has summed up is less than one unit off. The floor is perfect
(`--noise none`): what the wheels roll is what the robot drives.
"""

import math
import multiprocessing
import time

from emulator import Emulator, eventually

MILLIMETRE = 1.5  # one that isn't sent yet, and half a one for the wheels' last crawl
DEGREE = 1.5
WHILE_SPEEDS_CHANGE = 20.0  # off an arc [mm]: both wheels speed up and brake at one rate, not in proportion


class Journey:
    """What a client reads of its robot's way, summed up from when it begins."""

    def __init__(self, tests, client):
        self._tests, self._client = tests, client
        self.distance = 0.0  # [mm]
        self.angle = 0.0  # [deg]
        self.counts = []  # of the encoders, left and right: all that was read
        self.ask()

    def ask(self):
        distance, angle, left, right = self._tests.read(self._client)
        self.distance += distance
        self.angle += angle
        self.counts.append((left, right))
        return self

    def until(self, there, what):
        """Asks until `there(journey)`."""
        return eventually(lambda: there(self.ask()) and self, what)

    def rest(self):
        """Asks until the wheels stand."""
        return self.until(lambda _: self.counts[-8:].count(self.counts[-1]) == 8, "the wheels stand")


class ClientTests:
    """A mixin for unittest.TestCase. A client says how it does these: speeds in mm/s, angles in degrees."""

    def connect(self, link):
        """A client whose robot is in Safe mode."""
        raise NotImplementedError

    def drive(self, client, right, left):
        raise NotImplementedError

    def read(self, client):
        """Distance [mm] and angle [deg] since it read last; encoder counts, left and right."""
        raise NotImplementedError

    def mode(self, client):
        raise NotImplementedError

    def port(self, client):
        """The client's serial.Serial."""
        raise NotImplementedError

    def flood(self, client):
        """Asks for far more than fits into a terminal's buffers, and reads nothing."""
        raise NotImplementedError

    def end_flood(self, client):
        raise NotImplementedError

    # --- Tools --------------------------------------------------------------------------------------------------------

    def assert_agree(self, journey, robot):
        """What a client read of a journey without a turning point, and what happened."""
        self.assertAlmostEqual(abs(journey.distance), 1000.0 * robot["distance"], delta=MILLIMETRE)
        self.assertAlmostEqual(journey.angle, math.degrees(robot["turned"]), delta=DEGREE)

    def drive_until(self, emulator, there, what, move):
        """Connects, moves, stops when `there(journey)`, and compares with what happened."""
        client = self.connect(emulator.link)
        journey = Journey(self, client)
        move(client)
        journey.until(there, what)
        self.drive(client, 0, 0)
        journey.rest()
        self.assert_agree(journey, emulator.end()[0])
        return journey

    def is_quiet(self, client):
        self.port(client).reset_input_buffer()
        time.sleep(0.1)
        return self.port(client).in_waiting == 0

    # --- Tests --------------------------------------------------------------------------------------------------------

    def test_drives_straight(self):
        with Emulator() as emulator:
            journey = self.drive_until(emulator, lambda j: j.distance > 300.0, "300 mm",
                                       lambda client: self.drive(client, 250, 250))
            self.assertAlmostEqual(journey.angle, 0.0, delta=DEGREE)

    def test_drives_backwards(self):
        with Emulator() as emulator:
            self.drive_until(emulator, lambda j: j.distance < -200.0, "-200 mm",
                             lambda client: self.drive(client, -250, -250))

    def test_drives_an_arc(self):
        with Emulator() as emulator:
            journey = self.drive_until(emulator, lambda j: j.angle > 60.0, "60 degrees to the left",
                                       lambda client: self.drive(client, 300, 100))
            self.assertAlmostEqual(journey.distance, 235.0 * math.radians(journey.angle), delta=WHILE_SPEEDS_CHANGE)

    def test_spins(self):
        with Emulator() as emulator:
            journey = self.drive_until(emulator, lambda j: j.angle < -120.0, "120 degrees to the right",
                                       lambda client: self.drive(client, -200, 200))
            self.assertAlmostEqual(journey.distance, 0.0, delta=MILLIMETRE)

    def test_counts_what_its_wheels_rolled(self):
        with Emulator() as emulator:
            journey = self.drive_until(emulator, lambda j: j.distance > 150.0, "150 mm",
                                       lambda client: self.drive(client, 200, 100))
            left, right = (0.444565 * (now - then) for now, then in zip(journey.counts[-1], journey.counts[0]))
            self.assertAlmostEqual(0.5 * (left + right), journey.distance, delta=MILLIMETRE)
            self.assertAlmostEqual(math.degrees((right - left) / 235.0), journey.angle, delta=DEGREE)

    def test_one_that_is_killed_leaves_a_robot_to_the_next(self):
        with Emulator() as emulator:
            children = multiprocessing.get_context("fork")
            driving = children.Event()

            def drive_away():
                client = self.connect(emulator.link)
                self.drive(client, 150, 150)
                driving.set()
                time.sleep(60.0)

            child = children.Process(target=drive_away, daemon=True)
            child.start()
            self.assertTrue(driving.wait(20.0))
            child.kill()
            child.join()
            # Nobody told the robot to stop: it drives on until the next client takes it over.
            time.sleep(1.0)
            client = self.connect(emulator.link)
            journey = Journey(self, client).rest()
            self.assertGreater(journey.distance, 50.0)
            self.drive(client, 150, 150)
            journey.until(lambda j, there=journey.distance + 100.0: j.distance > there, "100 mm more")
            self.drive(client, 0, 0)
            self.assert_agree(journey.rest(), emulator.end()[0])

    def test_one_that_leaves_may_come_back(self):
        with Emulator() as emulator:
            for _ in range(2):
                client = self.connect(emulator.link)
                self.assertEqual(self.mode(client), 2)
                del client  # says goodbye, and closes
            self.assertIn(emulator.end()[0]["mode"], ("passive", "off"))

    def test_two_robots_at_once(self):
        with Emulator(count=2) as emulator:
            clients = [self.connect(link) for link in emulator.links]
            journeys = [Journey(self, client) for client in clients]
            self.drive(clients[0], 200, 200)
            self.drive(clients[1], 150, -150)
            journeys[0].until(lambda j: j.distance > 200.0, "200 mm")
            journeys[1].until(lambda j: j.angle > 60.0, "60 degrees")
            for client in clients:
                self.drive(client, 0, 0)
            for journey in journeys:
                journey.rest()
            for journey, robot in zip(journeys, emulator.end()):
                self.assert_agree(journey, robot)
            self.assertAlmostEqual(journeys[0].angle, 0.0, delta=DEGREE)
            self.assertAlmostEqual(journeys[1].distance, 0.0, delta=MILLIMETRE)

    def test_one_that_never_reads_holds_nobody_up(self):
        with Emulator("--speed", "10") as emulator:
            client = self.connect(emulator.link)
            self.drive(client, 100, 100)
            self.flood(client)
            time.sleep(1.0)  # of not reading: 10 s of the robot's
            self.end_flood(client)
            eventually(lambda: self.is_quiet(client), "no more bytes come")
            self.assertEqual(self.mode(client), 2)
            self.drive(client, 0, 0)
            Journey(self, client).rest()
            robot = emulator.end()[0]
            self.assertGreater(robot["bytes"]["unread"], 0)
            self.assertGreater(robot["distance"], 0.3)

    def test_ten_times_as_fast(self):
        with Emulator("--speed", "10") as emulator:
            self.drive_until(emulator, lambda j: j.distance > 2000.0, "2 m",
                             lambda client: self.drive(client, 200, 200))

"""pyroombaadapter (Python, MIT), unchanged.

Its move() knows no straight line: it takes the radius that means one, 32768, for too large, and drives 2000 mm.
"""

import math
import unittest

from pyroombaadapter import PyRoombaAdapter

from client_tests import DEGREE, MILLIMETRE, WHILE_SPEEDS_CHANGE, ClientTests, Journey
from emulator import Emulator, eventually

PASSIVE, SAFE, FULL = 1, 2, 3


class PyRoombaAdapterTest(ClientTests, unittest.TestCase):
    def connect(self, link):
        return PyRoombaAdapter(link)

    def drive(self, client, right, left):
        client.send_drive_direct(right, left)

    def read(self, client):
        travel = client.request_distance(), math.degrees(client.request_angle())
        return (*travel, *client.request_encoder_counts())

    def mode(self, client):
        return client.request_oi_mode()

    def port(self, client):
        return client.serial_con

    def flood(self, client):
        client.data_stream_start(list(client.SENSOR))

    def end_flood(self, client):
        client.data_stream_stop()

    # --- What is this client's alone ----------------------------------------------------------------------------------

    def move_until(self, emulator, there, what, velocity, yaw_rate):
        return self.drive_until(emulator, there, what, lambda adapter: adapter.move(velocity, yaw_rate))

    def test_goes_through_the_modes(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            self.assertEqual(self.mode(adapter), SAFE)
            adapter.change_mode_to_full()
            self.assertEqual(self.mode(adapter), FULL)
            adapter.change_mode_to_passive()
            self.assertEqual(self.mode(adapter), PASSIVE)
            adapter.change_mode_to_safe()
            self.assertEqual(self.mode(adapter), SAFE)

    def test_cleans_and_docks_passively(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            for command in (adapter.start_cleaning, adapter.start_max_cleaning, adapter.start_spot_cleaning,
                            adapter.start_seek_dock):
                adapter.change_mode_to_full()
                self.assertEqual(self.mode(adapter), FULL)
                command()
                self.assertEqual(self.mode(adapter), PASSIVE, command.__name__)

    def test_powers_off(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            adapter.data_stream_start(["OI Mode"])
            self.assertEqual(adapter.data_stream_read(), [SAFE])
            adapter.turn_off_power()
            eventually(lambda: self.is_quiet(adapter), "the stream ends")
            adapter.change_mode_to_safe()
            self.assertEqual(adapter.data_stream_read(), [])
            emulator.pulse_brc()
            adapter.change_mode_to_safe()
            self.assertEqual(self.mode(adapter), SAFE)

    def test_moves_on_its_widest_arc(self):
        with Emulator() as emulator:
            journey = self.move_until(emulator, lambda j: j.distance > 400.0, "400 mm", 0.25, 0.0)
            self.assertAlmostEqual(journey.angle, math.degrees(journey.distance / 2000.0), delta=DEGREE)

    def test_moves_on_an_arc_to_the_right(self):
        with Emulator() as emulator:
            journey = self.move_until(emulator, lambda j: j.angle < -60.0, "60 degrees to the right", 0.2, -0.8)
            self.assertAlmostEqual(journey.distance, 250.0 * math.radians(-journey.angle), delta=WHILE_SPEEDS_CHANGE)

    def test_moves_by_turning_in_place(self):
        with Emulator() as emulator:
            journey = self.move_until(emulator, lambda j: j.angle > 90.0, "90 degrees to the left", 0.0, 1.5)
            self.assertAlmostEqual(journey.distance, 0.0, delta=MILLIMETRE)

    def test_backs_up_on_an_arc(self):
        with Emulator() as emulator:
            self.drive_until(emulator, lambda j: j.distance < -200.0, "-200 mm",
                             lambda adapter: adapter.send_drive_cmd(-200, -1000))

    def test_drives_by_pwm(self):
        with Emulator() as emulator:
            self.drive_until(emulator, lambda j: j.distance < -200.0, "-200 mm",
                             lambda adapter: adapter.send_drive_pwm(-130, -150))

    def test_streams(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            names = ["OI Mode", "Distance", "Angle", "Voltage", "Temperature", "Number of Stream Packets"]
            adapter.data_stream_start(names)
            adapter.send_drive_direct(250, 150)
            distance = angle = 0.0
            while distance < 200.0:
                values = adapter.data_stream_read()
                self.assertEqual(len(values), len(names))
                self.assertEqual((values[0], values[5]), (SAFE, len(names)))
                distance += values[1]
                angle += values[2]
            adapter.send_drive_direct(0, 0)
            adapter.data_stream_stop()
            # Frames that are on their way yet.
            while values := adapter.data_stream_read():
                distance += values[1]
                angle += values[2]
            journey = Journey(self, adapter).rest()
            journey.distance += distance
            journey.angle += angle
            self.assert_agree(journey, emulator.end()[0])

    def test_streams_every_sensor(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            adapter.data_stream_start(list(adapter.SENSOR))
            for _ in range(50):
                self.assertEqual(len(adapter.data_stream_read()), len(adapter.SENSOR))

    def test_reads_its_battery(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            self.assertEqual(adapter.request_charging_state(), 0)
            self.assertGreater(adapter.request_voltage(), 10_000)
            self.assertLess(adapter.request_current(), 0)
            self.assertGreater(adapter.request_temperature(), 0)
            self.assertGreaterEqual(adapter.request_capacity(), adapter.request_charge())

    def test_plays_songs(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            adapter.send_song_cmd(3, 3, [69, 65, 72], [16, 8, 16])
            adapter.send_play_cmd(3)
            adapter.data_stream_start(["Song Number", "Song Playing"])
            eventually(lambda: adapter.data_stream_read() == [3, 1], "song 3 plays")
            eventually(lambda: adapter.data_stream_read() == [3, 0], "the song ends")
            self.assertEqual(emulator.end()[0]["songs_played"], 1)

    def test_presses_buttons(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            adapter.data_stream_start(["Buttons"])
            adapter.send_buttons_cmd(spot=True, dock=True)
            eventually(lambda: adapter.data_stream_read() == [0b0110], "two buttons are pressed")
            eventually(lambda: adapter.data_stream_read() == [0], "they are let go")

    def test_runs_brushes_and_vacuum(self):
        with Emulator() as emulator:
            adapter = self.connect(emulator.link)
            adapter.send_moters_cmd(True, True, True, True, False)
            self.assertEqual(self.mode(adapter), SAFE)
            adapter.send_pwm_moters(-55, 20, 60)
            self.assertEqual(self.mode(adapter), SAFE)
            robot = emulator.end()[0]
            self.assertEqual(robot["motors"], 0b10111)
            self.assertEqual(robot["rejected_commands"], 0)


if __name__ == "__main__":
    unittest.main()

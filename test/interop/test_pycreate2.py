"""pycreate2 (Python, MIT), unchanged.

Two of its calls are of no use on any robot here: getMode() names an opcode that it lacks, and wake() pulls a pin that a
pseudo-terminal doesn't have.
"""

import unittest

import pycreate2
from pycreate2.OI import OPCODES

from client_tests import ClientTests, Journey
from emulator import Emulator, eventually

PASSIVE, SAFE, FULL = 1, 2, 3


class PyCreate2Test(ClientTests, unittest.TestCase):
    def connect(self, link):
        bot = pycreate2.Create2(link)
        bot.start()
        bot.safe()
        return bot

    def drive(self, client, right, left):
        client.drive_direct(right, left)

    def read(self, client):
        sensors = client.get_sensors()
        return sensors.distance, sensors.angle, sensors.encoder_counts_left, sensors.encoder_counts_right

    def mode(self, client):
        return client.get_sensors().open_interface_mode

    def port(self, client):
        return client.SCI.ser

    def flood(self, client):
        for _ in range(2000):
            client.SCI.write(OPCODES.SENSORS, (100,))

    def end_flood(self, client):
        pass

    # --- What is this client's alone ----------------------------------------------------------------------------------

    def assert_silent(self, bot):
        with self.assertRaisesRegex(Exception, "it is: 0"):
            bot.get_sensors()

    def test_goes_through_the_modes(self):
        with Emulator() as emulator:
            bot = pycreate2.Create2(emulator.link)
            bot.start()
            self.assertEqual(self.mode(bot), PASSIVE)
            bot.safe()
            self.assertEqual(self.mode(bot), SAFE)
            bot.full()
            self.assertEqual(self.mode(bot), FULL)

    def test_powers_off(self):
        with Emulator() as emulator:
            bot = self.connect(emulator.link)
            bot.drive_direct(200, 200)
            bot.power()
            bot.start()
            self.assert_silent(bot)
            emulator.pulse_brc()
            bot.start()
            self.assertEqual(self.mode(bot), PASSIVE)

    def test_stops_the_interface(self):
        with Emulator() as emulator:
            bot = self.connect(emulator.link)
            bot.drive_direct(200, 200)
            bot.stop()
            self.assert_silent(bot)
            bot.start()
            Journey(self, bot).rest()
            self.assertEqual(self.mode(bot), PASSIVE)

    def test_resets(self):
        with Emulator("--speed", "10") as emulator:
            bot = self.connect(emulator.link)
            self.assertIn(b"bl-start", bot.reset())
            eventually(lambda: self.is_quiet(bot), "it has booted")
            bot.start()
            self.assertEqual(self.mode(bot), PASSIVE)

    def test_drives_by_pwm(self):
        with Emulator() as emulator:
            self.drive_until(emulator, lambda j: j.distance > 200.0, "200 mm", lambda bot: bot.drive_pwm(150, 120))

    def test_drives_no_faster_than_the_interface_allows(self):
        with Emulator() as emulator:
            bot = self.connect(emulator.link)
            bot.drive_direct(2000, -2000)
            sensors = bot.get_sensors()
            self.assertEqual((sensors.velocity_right, sensors.velocity_left), (500, -500))

    def test_reads_every_sensor(self):
        with Emulator() as emulator:
            sensors = self.connect(emulator.link).get_sensors()
            self.assertGreater(sensors.voltage, 10_000)
            self.assertGreater(sensors.battery_capacity, sensors.battery_charge - 1)
            self.assertLess(sensors.current, 0)
            self.assertGreater(sensors.temperature, 0)
            self.assertGreater(sensors.cliff_left_signal, 1000)
            self.assertEqual(sensors.light_bumper, (False,) * 6)
            self.assertFalse(any(sensors.bumps_wheeldrops))

    def test_bumps_into_a_wall(self):
        with Emulator(world="stall") as emulator:
            bot = self.connect(emulator.link)
            bot.drive_direct(200, 200)
            eventually(lambda: any(bot.get_sensors().light_bumper), "light from the wall")
            eventually(lambda: all(bot.get_sensors().bumps_wheeldrops[:2]), "both halves of the bumper")
            self.assertGreater(emulator.end()[0]["bumps"], 0)

    def test_plays_songs(self):
        with Emulator() as emulator:
            bot = self.connect(emulator.link)
            self.assertEqual(bot.createSong(2, [60, 16, 0, 8, 72, 16]), 40 / 64)
            self.assertEqual(bot.playSong(2), 40 / 64)
            sensors = bot.get_sensors()
            self.assertTrue(sensors.song_playing)
            self.assertEqual(sensors.song_number, 2)
            eventually(lambda: not bot.get_sensors().song_playing, "the song ends")
            self.assertEqual(emulator.end()[0]["songs_played"], 1)

    def test_shows_lights_and_digits(self):
        with Emulator() as emulator:
            bot = self.connect(emulator.link)
            bot.led(0b0101, 100, 200)
            bot.digit_led_ascii("jay!")
            self.assertEqual(self.mode(bot), SAFE)
            robot = emulator.end()[0]
            self.assertEqual(robot["leds"], [0b0101, 100, 200])
            self.assertEqual(robot["digits"], [ord(c) for c in "JAY!"])
            self.assertEqual(robot["rejected_commands"], 0)

    def test_drives_into_the_dock(self):
        with Emulator(world="dock") as emulator:
            bot = self.connect(emulator.link)
            self.assertFalse(bot.get_sensors().charger_available.home_base)
            bot.drive_direct(100, 100)
            sensors = eventually(lambda: (s := bot.get_sensors()).charger_available.home_base and s, "the dock")
            self.assertEqual(sensors.open_interface_mode, PASSIVE)
            eventually(lambda: bot.get_sensors().charger_state == 2, "it charges")
            self.assertGreater(bot.get_sensors().current, 0)


if __name__ == "__main__":
    unittest.main()

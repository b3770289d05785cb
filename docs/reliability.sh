#!/usr/bin/env bash
# Writes docs/reliability.md to stdout: reliability.sh <fault_campaign> <runs> (see ./dev reliability)
set -euo pipefail
campaign=$1
runs=$2
cat <<TEXT
# Reliability

What a bad wire does to a mission, and what it doesn't. \`./dev reliability\` drives $runs simulated Roombas 600 for two
simulated minutes each, with edge-follow and contact-frontier in three of our worlds, over wires that lose bytes, flip
bits, deliver late and fall silent, in both directions; and each once more over a perfect wire. Our own client, the codec
and the simulated firmware meet over bytes alone. The same seeds give the same figures on any machine and any number of
threads; the test suite runs the first 24.

Each wire's faults are drawn from its seed: a byte gets lost, and a bit of a byte flips, with a probability between 1 in
100,000 and 1 in 1,000 each (evenly on a scale of magnitudes); chunks come up to 20 ms late; the wire falls silent up to
six times a minute, for up to two seconds, and loses what is sent meanwhile.

What is promised of each run:

- **It ends** as it would have without faults, by its own time limit or when its strategy is done, and the robot then
  stands in Passive mode, where it may charge.
- **No motion outlasts its renewal by more than 200 ms.** Counted from the last time that the client sent just these
  wheel speeds (or, for speeds that it never sent, from when the robot took them up) to the end of the robot's obeying
  them, as long as the wire carries bytes. A wheel that rolls out under its brakes afterwards is the robot's own.
- **Every lost frame is counted**, whether the wire damaged it, swallowed it, or a damaged command had stopped the
  stream. A frame that was damaged so that its checksum still fits looks like any other; such *false frames* are listed.
  Three may be on their way when the account is closed.
- **The map's error stays within twice that without faults**: the mean distance of its occupied cells (5 cm) from the
  nearest true wall.

What can't be promised: while a wire carries nothing, nobody reaches the robot, and the Open Interface has no watchdog
of its own. It drives on until the wire is back, as the second line of the table shows; what stops it then are its own
cliff and wheel-drop sensors. A cable that is pulled out for good is in that case.

TEXT
"$campaign" --runs "$runs" --markdown
cat <<'TEXT'

How the client gets there:

- Motions are told again every other tick, so that a lost byte costs 30 ms.
- The robot echoes the speeds that it was asked for (packets 41 and 42). Where the echo shows none of those of the last
  60 ms, a damaged command is swallowing what follows: 256 zeros end it.
- A robot that says nothing for 75 ms is told to stand until it speaks; its session is started anew at once, and then
  with growing pauses. A robot that a damaged command has sent to sleep hears nothing but
  its BRC pin: the campaign pulls it, once, when a silence lasts for a second.
- The wheels' way comes from counters, not from speeds: a frame that is lost costs nothing but its moment. A count that
  no wheel can have reached is believed only once the next one agrees with it.
- When the session ends, the robot is told to stop until its frames say for 0.1 s that it is in Passive mode.

What runs here is the client's session with a robot (`OiRobot`: renewal, silence, deafness, the stop and its
confirmation) and the pauses between attempts (`Reconnection`), by the simulation's clock. `SerialRobot`, which joins
them to a real port, stops by the same confirmed stop after it has braked, and has a watchdog in a thread of its own;
that thread, the port and its reopening are tested on pseudo-terminals in real time (`test/io/serial_robot_test.cpp`),
not here. The campaign starts a session anew up to four times until the stop is confirmed, `SerialRobot` does not.
TEXT

#!/usr/bin/env bash
# Writes docs/strategies.md to stdout: strategies.sh <scrubjay> <plan>... (see ./dev strategies)
set -euo pipefail
scrubjay=$1
shift
cat <<TEXT
# Strategies

What exploration strategies are worth, each driven for at most two hours of simulated time, on maps of 5 cm cells. A
Roomba 600 maps by touch and infrared light and trusts its wheels; a TurtleBot3 Burger maps with its lidar and keeps its
pose by scan matching. Figures are means over seeds 1 to 3. Made by \`./dev strategies <folder of HouseExpo plans>\`.

- **coverage**: reachable floor known as free; **IoU**: known-free floor against reachable floor. What is reachable is
  by the robot's own size
- **recall**, **precision**: of all walls that the robot can touch; **followed**: of those boundaries along which it
  drove (it was beside half of their walls at least)
- **contacts**: how often it touched something
- **ATE**: root mean square error of the estimated position. With noise \`hard-floor\` a Roomba's heading drifts by
  degrees a metre, and a map made from it smears: that is what the noise is, not what the strategy does

| strategy | robot | what it does |
|---|---|---|
| random-2 | Roomba | forward, or turn left, by the toss of a coin |
| random-3 | Roomba | forward, left or right |
| random-look | Roomba | as random-2, but forward only if nothing is ahead |
| random-aware | Roomba | never towards what is blocked |
| reactive | Roomba | forward until something is ahead, then left until nothing is |
| wander | any | on and on, without touching anything that it senses |
| edge-follow | Roomba | along every edge, once around, then on over unknown floor |
| contact-frontier | Roomba | edges first, then the open floor in lanes; ends when nothing reachable is unknown |
| tiles | Burger | to tiles that are partly known, in sight or by way points in sight of each other |
| frontiers | Burger | to the frontier with the least way for its length, preferring those beside walls; ends when none can be reached |

The first five and edge-follow are Krapinec's phases (FER Zagreb, 2025), tiles are system B's (Bologna, 2023/24).

## Our worlds

TEXT
robots=roomba-600,turtlebot3-burger
"$scrubjay" compare worlds/*.yaml --model $robots --noise none,hard-floor --seeds 3 --means --quiet
cat <<TEXT

## $# HouseExpo plans

Unfurnished layouts of real houses (HouseExpo, MIT), from one room to sixteen; the first letters of each name. Here the
best two strategies of either robot.

TEXT
"$scrubjay" compare "$@" --model $robots --strategies edge-follow,contact-frontier,tiles,frontiers \
  --noise none,hard-floor --seeds 3 --means --quiet

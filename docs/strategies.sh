#!/usr/bin/env bash
# Writes docs/strategies.md to stdout: strategies.sh <scrubjay> <plan>... (see ./dev strategies)
set -euo pipefail
scrubjay=$1
shift
cat <<TEXT
# Strategies

What six exploration strategies of a bumper robot are worth: Krapinec's phases (FER Zagreb, 2025), each driven for at
most an hour of simulated time by a Roomba 600 at 0.1 m/s, mapping by touch and infrared light at 5 cm. Figures are
means over seeds 1 to 3. Made by \`./dev strategies <folder of HouseExpo plans>\`.

- **coverage**: reachable floor known as free; **IoU**: known-free floor against reachable floor
- **recall**, **precision**: of all walls that the robot can touch; **followed**: of those boundaries along which it
  drove (it was beside half of their walls at least)
- **ATE**: root mean square error of the estimated position, from the wheels alone. With noise \`hard-floor\` the heading
  drifts by degrees a metre, and a map made from it smears: that is what the noise is, not what the strategy does

| strategy | what it does |
|---|---|
| random-2 | forward, or turn left, by the toss of a coin |
| random-3 | forward, left or right |
| random-look | as random-2, but forward only if nothing is ahead |
| random-aware | never towards what is blocked |
| reactive | forward until something is ahead, then left until nothing is |
| edge-follow | along every edge, once around, then on over unknown floor |

## Our worlds

TEXT
"$scrubjay" compare worlds/*.yaml --noise none,hard-floor --seeds 3 --max-time 3600 --quiet
cat <<TEXT

## $# HouseExpo plans

Unfurnished layouts of real houses (HouseExpo, MIT), from one room to sixteen; the first letters of each name.

TEXT
"$scrubjay" compare "$@" --noise none,hard-floor --seeds 3 --max-time 3600 --means --quiet

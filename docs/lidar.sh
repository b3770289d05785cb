#!/usr/bin/env bash
# Writes docs/lidar.md to stdout: lidar.sh <scrubjay> <folder of CARMEN logs> (see ./dev lidar)
set -euo pipefail
scrubjay=$1
logs=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# replay <log> <relations> <poses>: a row of the table.
replay() {
  local metrics
  "$scrubjay" replay "$logs/$1.log.gz" --relations "$logs/$2.relations.gz" --poses "$3" --out "$work/$1-$3" --quiet
  metrics=$(tr -d '\n' <"$work/$1-$3/metrics.json")
  # figure <block> <field>: "block": { ... "field": <number>.
  figure() { sed -E "s/.*\"$1\": *\{[^}]*\"$2\": *([-0-9.e]+).*/\1/" <<<"$metrics"; }
  plain() { sed -E "s/.*\"$1\": *([-0-9.e]+).*/\1/" <<<"$metrics"; }
  LC_ALL=C awk -v log_name="$1" -v poses="$3" -v ate="$(plain ate_m)" -v end="$(plain final_error_m)" \
    -v matched="$(plain matched)" -v all="$(figure relations relations)" \
    -v t="$(figure translation_m mean)" -v ts="$(figure translation_m std)" -v tm="$(figure translation_m max)" \
    -v r="$(figure rotation_rad mean)" -v rs="$(figure rotation_rad std)" -v rm="$(figure rotation_rad max)" 'BEGIN {
      degree = 180 / 3.14159265358979
      printf "| %s | %s | %.3f | %.3f | %d / %d | %.3f ± %.3f | %.2f | %.2f ± %.2f | %.1f |\n",
        log_name, poses, ate, end, matched, all, t, ts, tm, r * degree, rs * degree, rm * degree }'
}

cat <<TEXT
# Maps from a lidar

\`scrubjay replay LOG\` maps from a CARMEN log, plain or packed with gzip: what a robot with a laser measured in a real
building. It leaves the same folder as a run does (\`map.pgm\`, \`map.yaml\`, \`map.png\`, \`trajectory.tum\`,
\`metrics.json\`), with \`reference.tum\`, the log's own poses, in place of a scenario: nobody knows the truth there.

\`\`\`
build/scrubjay info intel-corrected.log.gz
build/scrubjay replay intel-corrected.log.gz --relations intel.relations.gz --out out/intel
build/scrubjay replay intel-corrected.log.gz --poses log --resolution 0.1 --octomap intel.bt --height 2.5
\`\`\`

| flag | |
|---|---|
| \`--poses log\` | the poses in the log: of the SLAM that corrected it, or whatever the robot believed |
| \`--poses odometry\` | the wheels alone |
| \`--poses scan-matching\` | each scan laid over the map of those before, starting from the wheels' guess (the default) |
| \`--resolution\`, \`--forward-cone\`, \`--robot-radius\`, \`--max-range\` | what the mapper makes of a scan |
| \`--relations FILE\` | judge the trajectory by verified relative poses |
| \`--octomap FILE\` | the map as an OctoMap tree, too: walls from the floor up to \`--height\`, free floor in the lowest layer |

The map's frame begins at the first scan's pose.

## What a log tells

- **Beams.** A \`FLASER\` record doesn't say where its beams point. n of them span 180 degrees from -90 on: 180 beams a
  degree apart without the last bearing, 181 with it; 360 and 361 half a degree apart. GMapping reads them so, and the
  two logs below agree: of all ways to lay them out this one gives the crispest maps, half a beam's turn or 4 cm of
  offset either way is worse.
- **Wheels.** A *corrected* log holds the poses of a SLAM; each scan is followed by an \`ODOM\` record that puts the
  odometry back to the scan's pose. The way from one scan to the next is then from that pose to the last \`ODOM\` record
  before the next. Raw logs have the odometry in columns of its own.
- **Stamps.** A record that stands before another in the file was measured before it. In the log of the Intel Research
  Lab 987 of 13,462 have a stamp later than that of a record behind them; they are given that one's.

## Errors

Means ± standard deviations, and the greatest, over relations: relative poses between scans that people verified
(R. Kümmerle et al., *On Measuring the Accuracy of SLAM Algorithms*, 2009; our figures are its absolute errors). Their
times are another clock's. Its offset is found by trying all, and taking the one at which most of the relations agree
with the log's own poses. **RMS** and **end** are distances from the log's poses, the first of which is the start of
both. Made by \`./dev lidar <folder of CARMEN logs>\`; the logs and relations are public (Radish; University of Freiburg).

| log | poses | RMS [m] | end [m] | relations | translation [m] | max | rotation [deg] | max |
|---|---|---:|---:|---:|---:|---:|---:|---:|
TEXT
for poses in log odometry scan-matching; do
  replay intel-corrected intel "$poses"
done
for poses in log odometry scan-matching; do
  replay freiburg-079-corrected fr079 "$poses"
done
cat <<TEXT

The rows of \`log\` are the check of all this: the paper finds errors of the same size for the SLAM that made these poses.
Scan matching closes no loops: what it is off by when it comes back to a place, it stays off.
TEXT

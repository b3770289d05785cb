#!/usr/bin/env bash
# Writes docs/firmware.md to stdout, from what ./dev firmware built in a folder: firmware.sh <build folder>
set -euo pipefail
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export LC_ALL=C

image() { echo "$build/firmware-$1/test/firmware"; }
# parts <cpu>: a line for each part of the image: name, bytes of flash, bytes of RAM.
parts() { awk -f "$here/firmware.awk" "$(image "$1")/firmware_image.map"; }
# of <cpu> <part> <column>: bytes of a part of the image.
of() { parts "$1" | awk -v part="$2" -v column="$3" '$1 == part { bytes = $column } END { print bytes + 0 }'; }
total() { parts "$1" | awk -v column="$2" '{ bytes += $column } END { print bytes }'; }
# section <cpu> <name>: bytes of a section of the image.
section() { arm-none-eabi-size -A "$(image "$1")/firmware_image.elf" | awk -v name="$2" '$1 == name { print $2 }'; }
# size_of <cpu> <type>: what a part of a mission takes.
size_of() {
  arm-none-eabi-nm -S -t d -C "$(image "$1")/libfirmware_part_sizes.a" |
    awk -v name="scrubjay::size_of_$2" '$4 == name { print $2 + 0 }'
}
# printed <cpu> <line> <field>: a word of a line that the image printed.
printed() { sed -n "s/^$2: //p" "$(image "$1")/printed.txt" | tr -d , | cut -d ' ' -f "$3"; }

# both <row's name> <function> [argument]...: a row with the figure of each processor.
both() {
  local name=$1 function=$2
  shift 2
  printf '| %s | %s | %s |\n' "$name" "$("$function" m3 "$@")" "$("$function" m4f "$@")"
}

cat <<TEXT
# The core in firmware

\`scrubjay::core\` runs on a microcontroller between a UART and a Roomba: bytes in, a map and a motion out. It compiles
without exceptions and RTTI, allocates nothing, and knows no clock, file or thread. \`./dev firmware\` builds it for a
Cortex-M3 and a Cortex-M4F, with an image that QEMU runs, and writes this page.

## In C

\`scrubjay_c.h\` opens the core to C: everything is in one block of the caller's memory.

\`\`\`c
#include <scrubjay/scrubjay_c.h>

static _Alignas(SCRUBJAY_ALIGNMENT) uint8_t memory[SCRUBJAY_MEMORY_SIZE(100, 100)];

static int to_uart(void* user, const uint8_t* bytes, size_t count) { return uart_write(bytes, count); }

void follow_edges(void) {
  scrubjay_config config = scrubjay_default_config();
  config.send = to_uart;
  scrubjay_mission* mission;
  if (scrubjay_create(memory, sizeof memory, &config, &mission) != SCRUBJAY_OK) return;
  while (!scrubjay_is_done(mission)) {
    uint8_t bytes[64];
    const size_t count = uart_read(bytes, sizeof bytes);  // what is there; may be none
    scrubjay_feed(mission, bytes, count, milliseconds() * 1e-3);
  }
  const scrubjay_map map = scrubjay_get_map(mission);
}
\`\`\`

\`scrubjay_feed\` takes bytes in any pieces, and through \`send\` tells the robot what to do after each frame. It wants to
be called every 15 ms or more often, bytes or not: that is how a silent robot is noticed, and told to stand. One that
was reset, or had its battery out, is started anew as soon as it hears, and goes on with its map from the pose that it
had. Every function, status and unit is documented in the header.

## In C++

\`EmbeddedMission\` (\`scrubjay/embedded/embedded_mission.hpp\`) is the same loop over a \`ByteChannel\`, the cells and the
\`Behavior\` that the caller brings. Each room below it can be used alone: the stream parser needs \`oi\` and nothing else.

\`\`\`cmake
set(SCRUBJAY_HOSTED OFF)
add_subdirectory(scrubjay)
target_link_libraries(my_firmware PRIVATE scrubjay::core)
\`\`\`

\`cmake/arm-none-eabi.cmake\` is the toolchain file of this page's figures, \`test/firmware\` a whole image: start, linker
script, output. Two things to copy from there:
- \`no_heap.cpp\`. Virtual destructors name \`operator delete\`, though nothing is ever deleted; the C++ library's own
  would bring \`free\` with it.
- The assertions at the end of \`mps2.ld\`: with them an image that links \`malloc\`, \`free\` or \`operator new\` fails to
  link. Tests in \`test/firmware\` try each of these, and see the build fail.

Arithmetic is in double precision, in software on both processors (the M4F's unit is of single precision). Elementary
functions are the core's own, and fused multiply-add is off, so a microcontroller gets the same bits as a computer.

## Figures

Made by \`./dev firmware\` with GCC $(arm-none-eabi-g++ -dumpversion), \`-Os\`, on QEMU $(qemu-system-arm --version | sed -n '1s/.*version \([0-9.]*\).*/\1/p')'s mps2-an385 (Cortex-M3) and mps2-an386
(Cortex-M4F). The image replays $(printed m3 frames 1) frames of a simulated Roomba that follows edges in \`worlds/room.yaml\`, through the
C header in pieces of 16 bytes: stream parser, odometry, contact map of 100 x 100 cells, edge following. The recording
is made by the build; it lies in a section of its own and isn't counted.

|  | budget | Cortex-M3 | Cortex-M4F |
|---|---:|---:|---:|
| flash [bytes] | 49152 | $(total m3 2) | $(total m4f 2) |
| RAM without stack [bytes] | | $(($(section m3 .data) + $(section m3 .bss))) | $(($(section m4f .data) + $(section m4f .bss))) |
| stack used, by its paint [bytes] | | $(printed m3 stack 2) | $(printed m4f stack 2) |
| RAM with the stack used [bytes] | 24576 | $(($(section m3 .data) + $(section m3 .bss) + $(printed m3 stack 2))) | $(($(section m4f .data) + $(section m4f .bss) + $(printed m4f stack 2))) |
| instructions a frame, mean | | $(printed m3 work 2) | $(printed m4f work 2) |
| instructions a frame, at most | | $(printed m3 work 4) | $(printed m4f work 4) |

The linker script has the budget as the size of its memories: what exceeds it doesn't link. Instructions are QEMU's
count and no cycles; a frame comes every 15 ms.

### Sections [bytes]

| section | Cortex-M3 | Cortex-M4F |
|---|---:|---:|
TEXT
both "\`.text\`, with constants" section .text
both "\`.ARM.exidx\`" section .ARM.exidx
both "\`.data\`, in flash and RAM" section .data
both "\`.bss\`" section .bss
both "\`.recording\`, not counted" section .recording
cat <<TEXT

### Flash by part [bytes]

| part | Cortex-M3 | Cortex-M4F |
|---|---:|---:|
TEXT
for room in oi robot geometry odometry grid behavior embedded; do both "\`$room\`" of "$room" 2; done
both "double arithmetic (libgcc)" of libgcc 2
both "square root, floor, ceiling (libm)" of libm 2
both "memory functions (libc)" of libc 2
both "the image: start, replay, output" of image 2
both "alignment" of filling 2
cat <<TEXT

What firmware doesn't call isn't linked: of \`oi\` the command decoder, of \`behavior\` all other strategies.

### RAM by part [bytes]

| part | Cortex-M3 | Cortex-M4F |
|---|---:|---:|
TEXT
for type in OiRobot Odometry ContactModel EdgeFollow; do both "\`$type\`" size_of "$type"; done
cat <<TEXT
| map of 100 x 100 cells | 10000 | 10000 |

The first four are within the $(sed -n 's/^#define SCRUBJAY_MISSION_SIZE //p' "$here/../include/scrubjay/scrubjay_c.h") bytes that a mission takes besides its map.

### What it computes

The host's program, the Cortex-M3 and the Cortex-M4F print the same, to the last digit; otherwise \`./dev firmware\` and
\`./dev test\` fail. Hashes are over the bits of every motion, of every byte sent and of every cell.

\`\`\`
$(cat "$build/test/firmware/printed.txt")
\`\`\`
TEXT

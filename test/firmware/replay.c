#include "replay.h"

#include <stdbool.h>

#include "platform.h"

// recording.S. Records, one after another: milliseconds (4 bytes, little endian), count (2 bytes), so many bytes.
extern const uint8_t recording_begin[];
extern const uint8_t recording_end[];

enum {
  kWidth = 100,
  kHeight = 100,
  kPiece = 16,          // bytes that a UART's queue holds
  kFramesApart = 1000,  // between two motions printed in clear
};

static _Alignas(SCRUBJAY_ALIGNMENT) uint8_t memory[SCRUBJAY_MEMORY_SIZE(kWidth, kHeight)];

// --- Hashes: FNV-1a, 64 bits -----------------------------------------------------------------------------------------

static const uint64_t kNothing = 0xcbf29ce484222325U;

static uint64_t hash_bytes(uint64_t hash, const void* data, size_t count) {
  const uint8_t* bytes = data;
  for (size_t i = 0; i < count; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3U;
  return hash;
}

// --- Printing --------------------------------------------------------------------------------------------------------

static void print_digits(uint64_t value, unsigned base, unsigned least) {
  char text[21];
  char* front = text + sizeof text - 1;
  *front = '\0';
  for (unsigned digits = 0; value != 0 || digits < least; ++digits) {
    *--front = "0123456789abcdef"[value % base];
    value /= base;
  }
  platform_print(front);
}

static void print_count(const char* name, uint64_t value) {
  platform_print(name);
  print_digits(value, 10, 1);
}

static void print_hash(uint64_t hash) {
  platform_print(" fnv1a ");
  print_digits(hash, 16, 16);
}

/// A length in metres, or an angle in radians, in thousandths.
static void print_thousandths(const char* name, double value) {
  platform_print(name);
  if (value < 0.0) platform_print("-");
  print_digits((uint64_t)((value < 0.0 ? -value : value) * 1000.0 + 0.5), 10, 1);
}

// --- The run ---------------------------------------------------------------------------------------------------------

struct Totals {
  uint64_t sent_bytes;
  uint64_t sent_hash;
  uint64_t frames;
  uint64_t changes;  // of the motion
  uint64_t motion_hash;
  scrubjay_motion motion;
};

static int count_sent(void* user, const uint8_t* bytes, size_t count) {
  struct Totals* totals = user;
  totals->sent_bytes += count;
  totals->sent_hash = hash_bytes(totals->sent_hash, bytes, count);
  return 1;
}

static void show_motion(scrubjay_motion motion, uint32_t milliseconds) {
  print_count("  ", milliseconds);
  print_thousandths(" ms: ", motion.linear);
  print_thousandths(" mm/s, ", motion.angular);
  platform_print(" mrad/s\n");
}

static void note_motion(struct Totals* totals, scrubjay_motion motion, uint32_t milliseconds) {
  if (totals->frames % kFramesApart == 0) show_motion(motion, milliseconds);
  totals->motion_hash = hash_bytes(totals->motion_hash, &motion.linear, sizeof motion.linear);
  totals->motion_hash = hash_bytes(totals->motion_hash, &motion.angular, sizeof motion.angular);
  totals->changes += motion.linear != totals->motion.linear || motion.angular != totals->motion.angular;
  totals->motion = motion;
}

/// Feeds the bytes of one record piece by piece, as interrupts would.
static void feed(scrubjay_mission* mission, struct Totals* totals, const uint8_t* bytes, size_t count,
                 uint32_t milliseconds) {
  while (count > 0) {
    const size_t piece = count < kPiece ? count : kPiece;
    scrubjay_feed(mission, bytes, piece, milliseconds / 1000.0);
    bytes += piece;
    count -= piece;
    const uint64_t frames = scrubjay_get_counters(mission).frames;
    if (frames == totals->frames) continue;
    totals->frames = frames;
    note_motion(totals, scrubjay_get_motion(mission), milliseconds);
  }
}

static uint32_t number_at(const uint8_t* bytes, int count) {
  uint32_t value = 0;
  while (count > 0) value = value << 8 | bytes[--count];
  return value;
}

/// Where the recording ends well, that is where this stops.
static const uint8_t* feed_all(scrubjay_mission* mission, struct Totals* totals) {
  const uint8_t* at = recording_begin;
  while (recording_end - at >= 6) {
    const uint32_t milliseconds = number_at(at, 4);
    const uint32_t count = number_at(at + 4, 2);
    if (recording_end - at - 6 < (ptrdiff_t)count) break;
    platform_begin_work();
    feed(mission, totals, at + 6, count, milliseconds);
    platform_end_work();
    at += 6 + count;
  }
  return at;
}

static void print_map(const scrubjay_map* map) {
  const size_t size = (size_t)map->width * (size_t)map->height;
  uint32_t unknown = 0;
  uint32_t occupied = 0;
  for (size_t i = 0; i < size; ++i) {
    const int8_t occupancy = scrubjay_occupancy(map->cells[i]);
    unknown += occupancy < 0;
    occupied += occupancy > 0;
  }
  print_count("map: occupied ", occupied);
  print_count(", free ", size - unknown - occupied);
  print_count(", unknown ", unknown);
  print_hash(hash_bytes(kNothing, map->cells, size));
  platform_print("\n");
}

static void print_results(const scrubjay_mission* mission, const struct Totals* totals) {
  const scrubjay_counters counters = scrubjay_get_counters(mission);
  print_count("frames: ", counters.frames);
  print_count(", lost ", counters.lost_frames);
  print_count(", bytes skipped ", counters.skipped_bytes);
  print_count("\nmotions: changes ", totals->changes);
  print_hash(totals->motion_hash);
  print_count("\nsent: bytes ", totals->sent_bytes);
  print_hash(totals->sent_hash);
  const scrubjay_pose pose = scrubjay_get_pose(mission);
  print_thousandths("\npose: ", pose.x);
  print_thousandths(" mm, ", pose.y);
  print_thousandths(" mm, ", pose.yaw);
  platform_print(" mrad\n");
  const scrubjay_map map = scrubjay_get_map(mission);
  print_map(&map);
}

int replay(void) {
  struct Totals totals = {.sent_hash = kNothing, .motion_hash = kNothing};
  scrubjay_config config = replay_config();
  config.map_width = kWidth;
  config.map_height = kHeight;
  config.send = count_sent;
  config.user = &totals;
  scrubjay_mission* mission = NULL;
  const scrubjay_status status = scrubjay_create(memory, sizeof memory, &config, &mission);
  if (status != SCRUBJAY_OK) {
    print_count("scrubjay_create said ", status);
    platform_print("\n");
    return 1;
  }
  platform_print("a motion every 1000 frames:\n");
  const bool whole = feed_all(mission, &totals) == recording_end;
  print_results(mission, &totals);
  if (!whole) platform_print("the recording breaks off\n");
  return whole ? 0 : 1;
}

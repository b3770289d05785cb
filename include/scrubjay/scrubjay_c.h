/// \file
/// The core for firmware in C: a Roomba's bytes in, a map and a motion out.
///
/// Everything lives in one block of the caller's memory: no heap, no clock, no waiting, no global state. One mission is
/// for one thread at a time. Units are metres, seconds and radians; x is ahead and y is left of where the robot began,
/// angles grow counter-clockwise. docs/firmware.md has an example.
#pragma once

#include <stddef.h>
#include <stdint.h>

// Names, types and casts as C has them.
// NOLINTBEGIN(readability-identifier-naming,modernize-*)

#ifdef __cplusplus
extern "C" {
#endif

/// Alignment of the memory that a mission lives in [bytes].
#define SCRUBJAY_ALIGNMENT 16
/// Memory of a mission without its map [bytes], an upper bound for 32-bit and 64-bit machines.
#define SCRUBJAY_MISSION_SIZE 9216
/// Memory of a mission whose map has `width` x `height` cells [bytes]; a constant expression for constants.
#define SCRUBJAY_MEMORY_SIZE(width, height) (SCRUBJAY_MISSION_SIZE + (width) * (height))

/// A robot that follows edges and maps what it meets.
typedef struct scrubjay_mission scrubjay_mission;

typedef enum scrubjay_status {
  SCRUBJAY_OK = 0,
  SCRUBJAY_NULL = 1,        ///< a pointer that must not be null is
  SCRUBJAY_MISALIGNED = 2,  ///< the memory doesn't begin at a multiple of SCRUBJAY_ALIGNMENT
  SCRUBJAY_TOO_SMALL = 3,   ///< the memory holds less than SCRUBJAY_MEMORY_SIZE(width, height)
  SCRUBJAY_BAD_MAP = 4,     ///< width or height outside of 1 to SCRUBJAY_MAX_SIDE, or lengths that make no sense
  SCRUBJAY_BAD_ROBOT = 5,   ///< a length of the robot's isn't positive
  SCRUBJAY_BAD_STAMP = 6    ///< not finite, or before the stamp of the bytes before
} scrubjay_status;

/// Cells along a side of the map, at most.
#define SCRUBJAY_MAX_SIDE 4096

typedef enum scrubjay_link {
  SCRUBJAY_LINK_ALIVE = 0,
  SCRUBJAY_LINK_SILENT = 1,  ///< no frame came for about a tenth of a second: the motion is zero, and the session is
                             ///< started anew, at least every 2 s, until frames come
  SCRUBJAY_LINK_CLOSED = 2   ///< `send` said that bytes can't be sent; tried again as often
} scrubjay_link;

/// Sends `count` bytes to the robot, all of them. Returns 0 if the line is gone, anything else if they are on their
/// way. Called from within scrubjay_create, scrubjay_feed and scrubjay_stop.
typedef int (*scrubjay_send)(void* user, const uint8_t* bytes, size_t count);

typedef struct scrubjay_config {
  int32_t map_width;        ///< [cells]
  int32_t map_height;       ///< [cells]
  double resolution;        ///< side of a cell [m]
  double origin_x;          ///< lower left corner of the map, seen from where the robot begins [m]
  double origin_y;          ///< [m]
  double robot_radius;      ///< of the robot's disc [m]
  double wheel_separation;  ///< between the wheels' contact points [m]
  double wheel_radius;      ///< [m]
  uint64_t seed;            ///< decides what is left to chance; the same bytes and seed give the same mission
  scrubjay_send send;       ///< null: nothing is sent; drive the robot by scrubjay_get_motion
  void* user;               ///< handed to `send`
} scrubjay_config;

typedef struct scrubjay_motion {
  double linear;   ///< forward [m/s]
  double angular;  ///< counter-clockwise [rad/s]
} scrubjay_motion;

typedef struct scrubjay_pose {
  double x;    ///< [m]
  double y;    ///< [m]
  double yaw;  ///< -pi to pi [rad]
} scrubjay_pose;

typedef struct scrubjay_map {
  int32_t width;        ///< [cells]
  int32_t height;       ///< [cells]
  double resolution;    ///< side of a cell [m]
  double origin_x;      ///< lower left corner of the first cell [m]
  double origin_y;      ///< [m]
  const int8_t* cells;  ///< width * height evidences, row by row along x, from the origin upwards
} scrubjay_map;

typedef struct scrubjay_counters {
  uint64_t frames;           ///< sensor frames taken
  uint64_t lost_frames;      ///< that began, and broke off or had a wrong sum
  uint64_t skipped_bytes;    ///< that belong to no frame
  uint64_t rejected_values;  ///< out of their packet's range, and not taken
} scrubjay_counters;

/// A Roomba 500 or 600 or a Create 2 in the middle of a map of 100 x 100 cells of 5 cm; seed 1; nothing is sent.
scrubjay_config scrubjay_default_config(void);

/// Makes a mission at the front of `memory`, wakes the robot, takes control of it and starts its stream. Nothing has to
/// be released: once the robot was told to stop, the memory is the caller's again. Unless it returns SCRUBJAY_OK,
/// nothing was sent and `*mission` is null.
scrubjay_status scrubjay_create(void* memory, size_t size, const scrubjay_config* config, scrubjay_mission** mission);

/// Takes bytes from the robot, in whatever pieces they come, that arrived at `stamp` [s] by any clock that only goes
/// forward. Maps and decides for each frame that they complete. Call it at least every 15 ms, with no bytes if there
/// are none (`bytes` may be null then): that is how a robot that fell silent is noticed.
scrubjay_status scrubjay_feed(scrubjay_mission* mission, const uint8_t* bytes, size_t count, double stamp);

/// Stands still, and leaves the robot in a mode that charges. Bytes fed from now on move the pose, but nothing else.
scrubjay_status scrubjay_stop(scrubjay_mission* mission);

/// What the robot is to do now. This function and those below want a mission that was created.
scrubjay_motion scrubjay_get_motion(const scrubjay_mission* mission);
/// Where the robot is, by its wheels.
scrubjay_pose scrubjay_get_pose(const scrubjay_mission* mission);
/// The map, over the mission's own cells: they change with the next bytes fed.
scrubjay_map scrubjay_get_map(const scrubjay_mission* mission);
scrubjay_link scrubjay_get_link(const scrubjay_mission* mission);
scrubjay_counters scrubjay_get_counters(const scrubjay_mission* mission);
/// 1 once every edge was followed or the mission was stopped, else 0.
int scrubjay_is_done(const scrubjay_mission* mission);

/// What a cell's evidence says, as in nav_msgs/OccupancyGrid: -1 unknown, 0 free, 100 occupied.
int8_t scrubjay_occupancy(int8_t cell);

#ifdef __cplusplus
}
#endif

// NOLINTEND(readability-identifier-naming,modernize-*)

/// \file
/// The program that runs on the microcontroller and on the host alike.
#pragma once

#include <scrubjay/scrubjay_c.h>

#ifdef __cplusplus
extern "C" {
#endif

/// The mission that is recorded, and replayed: the room of worlds/room.yaml around where the robot starts.
scrubjay_config replay_config(void);

/// Feeds the recording to a mission, and prints what came out. 0 if every byte of it was taken.
int replay(void);

#ifdef __cplusplus
}
#endif

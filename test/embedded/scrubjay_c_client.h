/// \file
/// A user of scrubjay_c.h who writes C.
#pragma once

#include <scrubjay/scrubjay_c.h>

#ifdef __cplusplus
extern "C" {
#endif

/// What was sent, as far as it fits.
struct ClientWire {
  uint8_t sent[2048];
  size_t count;
  int gone;  ///< not 0: nothing can be sent
};

int client_keep_sent(void* user, const uint8_t* bytes, size_t count);

/// A mission of the default configuration in memory that wasn't zero; null if there is none.
scrubjay_mission* client_create(struct ClientWire* wire);
/// What scrubjay_create says of memory of `size` that begins `offset` behind an aligned place; -1 if the mission that
/// it gives doesn't go with that.
scrubjay_status client_try(const scrubjay_config* config, size_t offset, size_t size);
int client_free_cells(const scrubjay_mission* mission);

#ifdef __cplusplus
}
#endif

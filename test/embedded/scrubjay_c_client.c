#include "scrubjay_c_client.h"

#include <string.h>

static _Alignas(SCRUBJAY_ALIGNMENT) unsigned char memory[SCRUBJAY_MEMORY_SIZE(100, 100)];

int client_keep_sent(void* user, const uint8_t* bytes, size_t count) {
  struct ClientWire* wire = user;
  if (wire->gone) return 0;
  for (size_t i = 0; i < count && wire->count < sizeof wire->sent; ++i) wire->sent[wire->count++] = bytes[i];
  return 1;
}

scrubjay_mission* client_create(struct ClientWire* wire) {
  scrubjay_config config = scrubjay_default_config();
  config.send = client_keep_sent;
  config.user = wire;
  memset(memory, 0xa5, sizeof memory);
  scrubjay_mission* mission = NULL;
  return scrubjay_create(memory, sizeof memory, &config, &mission) == SCRUBJAY_OK ? mission : NULL;
}

scrubjay_status client_try(const scrubjay_config* config, size_t offset, size_t size) {
  scrubjay_mission* mission = (scrubjay_mission*)memory;
  const scrubjay_status status = scrubjay_create(memory + offset, size, config, &mission);
  return (status == SCRUBJAY_OK) == (mission != NULL) ? status : (scrubjay_status)-1;
}

int client_free_cells(const scrubjay_mission* mission) {
  const scrubjay_map map = scrubjay_get_map(mission);
  int count = 0;
  for (int32_t i = 0; i < map.width * map.height; ++i) count += scrubjay_occupancy(map.cells[i]) == 0;
  return count;
}

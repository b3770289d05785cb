#include "replay.h"

scrubjay_config replay_config(void) {
  scrubjay_config config = scrubjay_default_config();
  config.origin_x = -0.85;
  config.origin_y = -3.2;
  return config;
}

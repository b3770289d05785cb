#include <stdio.h>

#include "platform.h"
#include "replay.h"

void platform_print(const char* text) {
  fputs(text, stdout);
}

void platform_begin_work(void) {}

void platform_end_work(void) {}

int main(void) {
  return replay();
}

/// \file
/// Start, stack and output on QEMU's MPS2 boards, which load the image and give it a console by semihosting.
#include <stddef.h>
#include <stdint.h>

#include "platform.h"
#include "replay.h"

// mps2.ld
extern uint32_t data_begin[], data_end[], data_image[], bss_begin[], bss_end[], stack_limit[], stack_top[];

// --- Semihosting (Arm, *Semihosting for AArch32 and AArch64*) --------------------------------------------------------

enum { kWrite0 = 0x04, kExitExtended = 0x20, kApplicationExit = 0x20026 };

static void semihost(uint32_t operation, const void* argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void platform_print(const char* text) {
  semihost(kWrite0, text);
}

static _Noreturn void leave(uint32_t code) {
  const uint32_t block[] = {kApplicationExit, code};
  for (;;) semihost(kExitExtended, block);
}

// --- Stack -----------------------------------------------------------------------------------------------------------

static const uint32_t kPaint = 0x5afe5afeU;

static void print_number(uint32_t value) {
  char text[11];
  char* front = text + sizeof text - 1;
  *front = '\0';
  do {
    *--front = (char)('0' + value % 10);
    value /= 10;
  } while (value != 0);
  platform_print(front);
}

static void print_stack(void) {
  const uint32_t* deepest = stack_limit;
  while (deepest != stack_top && *deepest == kPaint) ++deepest;
  platform_print("stack: used ");
  print_number((uint32_t)((const uint8_t*)stack_top - (const uint8_t*)deepest));
  platform_print(" of ");
  print_number((uint32_t)((const uint8_t*)stack_top - (const uint8_t*)stack_limit));
  platform_print("\n");
}

// --- Work
// -------------------------------------------------------------------------------------------------------------

// With -icount shift=0 QEMU's time is a nanosecond an instruction, and this timer counts at 25 MHz.
static volatile uint32_t* const kTimer = (volatile uint32_t*)0xe000e010;  // SysTick: control, reload, value
enum { kTimerBits = 0xffffff, kInstructionsPerTick = 40 };

static uint32_t work_began;
static uint64_t work_ticks;
static uint32_t work_count;
static uint32_t work_most;  // ticks

static void start_timer(void) {
  kTimer[1] = kTimerBits;
  kTimer[2] = 0;
  kTimer[0] = 5;  // on, processor's clock, no interrupt
}

void platform_begin_work(void) {
  work_began = kTimer[2];
}

void platform_end_work(void) {
  const uint32_t ticks = (work_began - kTimer[2]) & kTimerBits;  // it counts down
  work_ticks += ticks;
  ++work_count;
  if (ticks > work_most) work_most = ticks;
}

static void print_work(void) {
  platform_print("work: mean ");
  print_number((uint32_t)(work_ticks * kInstructionsPerTick / (work_count > 0 ? work_count : 1)));
  platform_print(", most ");
  print_number(work_most * kInstructionsPerTick);
  platform_print(" instructions\n");
}

// --- Start and faults ------------------------------------------------------------------------------------------------

_Noreturn void fault(void) {
  platform_print("fault\n");
  leave(2);
}

static void enable_floating_point(void) {
#ifdef __ARM_FP
  volatile uint32_t* const coprocessor_access = (volatile uint32_t*)0xe000ed88;  // CPACR
  *coprocessor_access |= 0xfU << 20;
  __asm__ volatile("dsb\n\tisb");
#endif
}

_Noreturn void reset(void) {
  // The stack below here is free; what lies above is this function's.
  uint32_t* here;
  __asm__ volatile("mov %0, sp" : "=r"(here));
  for (uint32_t* word = stack_limit; word < here; ++word) *word = kPaint;
  const uint32_t* image = data_image;
  for (uint32_t* word = data_begin; word < data_end; ++word) *word = *image++;
  for (uint32_t* word = bss_begin; word < bss_end; ++word) *word = 0;
  enable_floating_point();
  start_timer();
  const int status = replay();
  print_stack();
  print_work();
  leave((uint32_t)status);
}

typedef void (*Handler)(void);

/// Stack pointer, reset, and the fourteen exceptions of the processor; no interrupt is ever enabled.
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t* stack;
  Handler handlers[15];
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault, fault}};

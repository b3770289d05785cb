#include "modem_lines.hpp"

#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cstdarg>
#include <utility>

namespace scrubjay {
namespace {

std::atomic<ModemLines*> present = nullptr;

}  // namespace

ModemLines::ModemLines(std::function<void()> pulled) : pulled_(std::move(pulled)) {
  present = this;
}

ModemLines::~ModemLines() {
  present = nullptr;
}

int ModemLines::pulses() const {
  const std::scoped_lock lock(mutex_);
  return pulses_;
}

void ModemLines::set(bool asserted) {
  const std::scoped_lock lock(mutex_);
  if (asserted && !asserted_) {
    ++pulses_;
    pulled_();
  }
  asserted_ = asserted;
}

}  // namespace scrubjay

/// Stands before the C library's in this program.
extern "C" int ioctl(int file, unsigned long request, ...) noexcept {
  va_list rest;
  va_start(rest, request);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  scrubjay::ModemLines* const lines = scrubjay::present;
  if (lines != nullptr && (request == TIOCMBIS || request == TIOCMBIC)) {
    lines->set(request == TIOCMBIS);
    return 0;
  }
  return static_cast<int>(::syscall(SYS_ioctl, file, request, argument));
}

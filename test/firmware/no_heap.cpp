/// \file
/// What C++ wants of a program without a heap. Virtual destructors name `operator delete`, though nothing is ever
/// deleted; the library's own would bring `free` with it.
#include <cstddef>
#include <new>

void operator delete(void* /*object*/) noexcept {
  __builtin_trap();
}

void operator delete(void* /*object*/, std::size_t /*size*/) noexcept {
  __builtin_trap();
}

void operator delete(void* /*object*/, std::align_val_t /*alignment*/) noexcept {
  __builtin_trap();
}

void operator delete(void* /*object*/, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
  __builtin_trap();
}

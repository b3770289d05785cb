/// \file
/// Uses the heap in the one way that USE names: no image can be made of it.
#include <cstdlib>
#include <new>

extern "C" void* use_heap(void* block);

void* use_heap(void* block) {
#if defined(USE_malloc)
  return std::malloc(reinterpret_cast<std::size_t>(block));
#elif defined(USE_free)
  std::free(block);
  return nullptr;
#elif defined(USE_new)
  return new char[reinterpret_cast<std::size_t>(block)];
#endif
}

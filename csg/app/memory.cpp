// No exception may pass through GMP, which is C; so the program ends at the place where memory ran out. The
// allocators are malloc's, as GMP's own are: numbers made before the change stay valid.
#include "csg/app/memory.h"

#include <gmp.h>

#include <cstdio>
#include <cstdlib>

#include "csg/app/exit_status.h"

namespace cnrg::app {
namespace {

void* checked(void* memory) {
  if (memory) return memory;
  std::fprintf(stderr, "cnrg: error: %s\n", kMemoryRanOut);
  std::_Exit(kNoAccess);
}

void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* memory, std::size_t, std::size_t size) { return checked(std::realloc(memory, size)); }
void release(void* memory, std::size_t) { std::free(memory); }

}  // namespace

void guard_gmp_memory() { mp_set_memory_functions(allocate, reallocate, release); }

}  // namespace cnrg::app

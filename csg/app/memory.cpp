// No exception may pass through GMP, which is C; so the program ends at the place where memory ran out. The
// allocators are malloc's, as GMP's own are: numbers made before the change stay valid.
//
// Messages are written by the system's `write`: streams and strings may need memory.
#include "csg/app/memory.h"

#include <gmp.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "csg/app/exit_status.h"

#ifdef __GLIBC__
#include <execinfo.h>
#include <malloc.h>
#endif

namespace cnrg::app {
namespace {

void say(const char* text) noexcept {
  for (std::size_t left = std::strlen(text); left > 0;) {
    const ssize_t n = ::write(STDERR_FILENO, text, left);
    if (n < 0) return;
    text += n, left -= static_cast<std::size_t>(n);
  }
}

const char* program = "cnrg";
void say_error(const char* text) noexcept {
  for (const char* part : {program, ": error: ", text}) say(part);
}

/// Threads that run out of memory together say it once: the first ends the program, the others wait for that.
[[noreturn]] void end_without_memory() {
  static std::atomic_flag ending;
  while (ending.test_and_set()) pause();
  std::_Exit(memory_ran_out());
}

void* checked(void* memory) {
  if (memory == nullptr) end_without_memory();
  return memory;
}

void* allocate(std::size_t size) { return checked(std::malloc(size)); }
void* reallocate(void* memory, std::size_t, std::size_t size) { return checked(std::realloc(memory, size)); }
void release(void* memory, std::size_t) { std::free(memory); }

/// The same as for an exception that reaches `main`, as far as it can be told.
[[noreturn]] void end_uncaught() {
  try {
    const std::exception_ptr thrown = std::current_exception();
    if (thrown == nullptr) end_without_memory();  // a library's function that may not throw found no memory
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (const std::runtime_error& e) {
    say_error("the system refused: ");
    say(e.what());
    say("; free memory or use --threads 1\n");
    std::_Exit(kNoAccess);
  } catch (const std::exception& e) {
    say_error("nothing caught this: ");
    say(e.what());
    say("\n");
  } catch (...) {
    say_error("nothing caught an exception of an unknown kind\n");
  }
  std::_Exit(kBug);
}

}  // namespace

int memory_ran_out() noexcept {
  say_error("memory ran out; use fewer segments or a smaller tree, or --threads 1\n");
  return kNoAccess;
}

void guard_ends(const char* name) {
  program = name;
#ifdef __GLIBC__
  // Where an exception leaves a function of the C library (std::call_once), the C library looks for the unwinder,
  // for which it needs memory; here it finds it while there is some.
  void* frame;
  backtrace(&frame, 1);
  // Pages that are given back to the system come again as zeros, which it writes: what is freed is kept for the
  // next stage, but for the largest blocks.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 512 << 20);
#endif
  mp_set_memory_functions(allocate, reallocate, release);
  std::set_terminate(end_uncaught);
}

}  // namespace cnrg::app

// The bounds that the library gives to a child are for people with large models. Those of a process that are lower
// already stay; so a child is bounded the moment it begins.
#include <pthread.h>
#include <sys/resource.h>

#include <stdexcept>

#include "tests/campaign/fuzz/targets.h"

// Of the sanitizers' run time; nothing in a build without them.
extern "C" [[gnu::weak]] void __sanitizer_set_death_callback(void (*callback)());

namespace cnrg::fuzz {
namespace {

void limit_this_child() {
  const rlimit seconds{1, 2};
  setrlimit(RLIMIT_CPU, &seconds);
  // libFuzzer's writes the input to a file of finds.
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(nullptr);
}

}  // namespace

void limit_children() {
  if (pthread_atfork(nullptr, nullptr, limit_this_child) != 0) throw std::runtime_error("no handler at forks");
}

}  // namespace cnrg::fuzz

// Objects of threads: one each, and handed on.
#include "kernel/base/per_thread.h"

#include <atomic>
#include <set>
#include <thread>

#include "tests/catch.h"

namespace cnrg {
namespace {

struct Counter {
  int calls = 0;
};

std::size_t counters() {
  std::size_t n = 0;
  PerThread<Counter>::each([&](const Counter&) { ++n; });
  return n;
}

TEST_CASE("threads have objects of their own, and those that end leave them to others", "[per_thread]") {
  for (int i = 0; i < 500; ++i) std::thread([] { ++PerThread<Counter>::own().calls; }).join();
  CHECK(counters() == 1);
  std::atomic<int> here{0};
  std::set<Counter*> seen;
  std::mutex mutex;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      Counter& mine = PerThread<Counter>::own();
      ++mine.calls;
      ++here;
      while (here < 8) std::this_thread::yield();
      if (&mine != &PerThread<Counter>::own()) return;  // assertions are for one thread
      const std::lock_guard lock(mutex);
      seen.insert(&mine);
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(seen.size() == 8);
  CHECK(counters() == 8);
  int calls = 0;
  PerThread<Counter>::each([&](const Counter& c) { calls += c.calls; });
  CHECK(calls == 508);
}

}  // namespace
}  // namespace cnrg

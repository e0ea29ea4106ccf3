// Threads for loops that are worth them: a loop of a few thousand steps is over before a second thread has begun.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <cstddef>

namespace cnrg {

#ifndef CNRG_GRAIN
#define CNRG_GRAIN 2048
#endif
/// Steps that are worth a thread, each a few reads of memory. A build that looks for races sets one.
inline constexpr std::size_t kGrain = CNRG_GRAIN;

/// body(i) for each i below n, in any order; `grain` steps are worth a thread.
template <class Body>
void for_each_index(std::size_t n, const Body& body, std::size_t grain = kGrain) {
  const auto run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  };
  if (n <= 4 * grain) return run(0, n);  // over before a second thread has begun
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                    [&](const tbb::blocked_range<std::size_t>& r) { run(r.begin(), r.end()); });
}

/// body(item) for each item of a list, in any order.
template <class List, class Body>
void for_each_of(List&& list, const Body& body) {
  for_each_index(list.size(), [&](std::size_t i) { body(list[i]); });
}

/// Two steps that do not need each other, of about n loop steps each.
template <class First, class Second>
void do_both(std::size_t n, const First& first, const Second& second) {
  if (n > kGrain) return tbb::parallel_invoke(first, second);
  first();
  second();
}

}  // namespace cnrg

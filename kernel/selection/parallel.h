// Loops over cells on all threads.
#pragma once

#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace cnrg {

/// Calls `body(i)` for all i below n, in any order. Few cells are cheaper on one thread.
template <class Body>
void for_each_index(std::size_t n, const Body& body) {
  constexpr std::size_t kGrain = 2048, kFew = 8192;
  const auto run = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  };
  if (n <= kFew) return run(0, n);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, kGrain),
                    [&](const tbb::blocked_range<std::size_t>& range) { run(range.begin(), range.end()); });
}

/// Calls `body(item)` for the items of a list, in any order.
template <class List, class Body>
void for_each_of(List&& list, const Body& body) {
  for_each_index(list.size(), [&](std::size_t i) { body(list[i]); });
}

}  // namespace cnrg

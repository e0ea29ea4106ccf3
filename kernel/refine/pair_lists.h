// What many threads found, made into sets: their pairs come in an order of chance and more than once.
#pragma once

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/parallel.h"

namespace cnrg {

/// As `sort_unique` of kernel/base/sorted.h, for long lists.
template <class T>
void sort_unique_in_parallel(std::vector<T>& list) {
  tbb::parallel_sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// For each first id below n the second ids of the pairs, ascending and unique. The pairs are not sorted: each
/// list is, by itself.
template <class A, class B>
Csr<Id<A>, Id<B>> lists_of(std::size_t n, const std::vector<std::pair<Id<A>, Id<B>>>& pairs) {
  using Lists = Csr<Id<A>, Id<B>>;
  Lists lists = Lists::counted(n, [&](const auto& add) {
    for (const auto& [first, second] : pairs) add(first, second);
  });
  std::vector<std::uint32_t> offsets(n + 1, 0);
  for_each_index(n, [&](std::size_t i) {
    const auto list = lists[Id<A>(i)];
    std::sort(list.begin(), list.end());
    offsets[i + 1] = static_cast<std::uint32_t>(std::unique(list.begin(), list.end()) - list.begin());
  });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  if (offsets[n] == lists.value_count()) return lists;
  std::vector<Id<B>> values(offsets[n]);
  for_each_index(n, [&](std::size_t i) {
    std::copy_n(lists[Id<A>(i)].begin(), offsets[i + 1] - offsets[i], values.begin() + offsets[i]);
  });
  return Lists::from_parts(std::move(offsets), std::move(values));
}

}  // namespace cnrg

// Disjoint sets over 0..n-1; the representative of a set is its smallest member, so that results do not
// depend on the order of the unions.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include "kernel/base/counts.h"

namespace cnrg {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n = 0) : parent_(place32(n, kPlural)) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::size_t size() const { return parent_.size(); }
  std::uint32_t add() {
    parent_.push_back(next_number(parent_.size(), kPlural));
    return parent_.back();
  }
  std::uint32_t find(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  /// Joins two sets; true if they were different.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (a < b) parent_[b] = a;
    else parent_[a] = b;
    return true;
  }

 private:
  static constexpr const char* kPlural = "things to join";
  std::vector<std::uint32_t> parent_;
};

}  // namespace cnrg

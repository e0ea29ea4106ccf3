// A zeroed array over all cells of one kind, whose cost is that of the cells touched.
//
// A node of a tree touches few cells of a large complex; filling an array of the complex' size per node would
// cost more than the node. Large blocks are untouched pages of the system. They are not asked of calloc, which
// hands out freed memory again and then clears all of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

#include "kernel/base/ids.h"

namespace cnrg {

/// Zeroed bytes; throws std::bad_alloc. Above some 100 kB only the pages that are touched cost anything.
class ZeroedBlock {
 public:
  explicit ZeroedBlock(std::size_t bytes);
  ~ZeroedBlock();
  ZeroedBlock(ZeroedBlock&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), bytes_(std::exchange(other.bytes_, 0)) {}
  ZeroedBlock& operator=(ZeroedBlock&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  void* data() const { return data_; }

 private:
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

template <class IdT, class T>
class Scratch {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Zeros for the ids 0 .. n-1.
  explicit Scratch(std::size_t n) : block_(n * sizeof(T)), data_(static_cast<T*>(block_.data())) {}
  T& operator[](IdT id) { return data_[id.index()]; }
  const T& operator[](IdT id) const { return data_[id.index()]; }

 private:
  ZeroedBlock block_;
  T* data_;
};

/// One byte of flags per cell.
template <class IdT>
using Marks = Scratch<IdT, std::uint8_t>;

/// Disjoint sets of ids 0 .. n-1 at the cost of the ids that are asked for; as in `UnionFind`, the representative
/// is the smallest member.
template <class IdT>
class SparseSets {
 public:
  explicit SparseSets(std::size_t n) : parent_(n) {}
  IdT find(IdT x) {
    while (parent_[x] != 0) {
      const IdT up(parent_[x] - 1);
      if (parent_[up] != 0) parent_[x] = parent_[up];
      x = up;
    }
    return x;
  }
  /// Joins two sets; true if they were different.
  bool unite(IdT a, IdT b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (a < b) parent_[b] = a.value() + 1;
    else parent_[a] = b.value() + 1;
    return true;
  }

 private:
  Scratch<IdT, std::uint32_t> parent_;  // 1 + the parent; 0: none
};

}  // namespace cnrg

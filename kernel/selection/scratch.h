// A zeroed array over all cells of one kind, whose cost is that of the cells touched.
//
// A node of a tree touches few cells of a large complex; clearing an array of the complex' size per node, or
// asking the system for its pages, would cost more than the node. So a block notes which of its pages were
// touched, clears these when it is released, and is used again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "kernel/base/ids.h"

namespace cnrg {

/// Zeroed bytes that are handed on within a thread. Whoever writes calls `touch` first.
class ZeroedBlock {
 public:
  static constexpr std::size_t kPage = 4096;

  /// Throws std::bad_alloc.
  explicit ZeroedBlock(std::size_t bytes);
  ~ZeroedBlock();
  ZeroedBlock(ZeroedBlock&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), pages_(std::exchange(other.pages_, 0)) {}
  ZeroedBlock& operator=(ZeroedBlock&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(pages_, other.pages_);
    return *this;
  }
  std::byte* data() const { return data_; }
  /// The bytes of the page at `offset` may be written from now on.
  void touch(std::size_t offset) { data_[pages_ * kPage + offset / kPage] = std::byte{1}; }

 private:
  std::byte* data_ = nullptr;  // pages_ pages, then a byte for each that says if it was touched
  std::size_t pages_ = 0;
};

template <class IdT, class T>
class Scratch {
  static_assert(std::is_trivially_copyable_v<T> && ZeroedBlock::kPage % sizeof(T) == 0);

 public:
  /// Zeros for the ids 0 .. n-1.
  explicit Scratch(std::size_t n) : block_(n * sizeof(T)) {}
  T& operator[](IdT id) {
    block_.touch(id.index() * sizeof(T));
    return data()[id.index()];
  }
  const T& operator[](IdT id) const { return data()[id.index()]; }

 private:
  T* data() const { return reinterpret_cast<T*>(block_.data()); }
  ZeroedBlock block_;
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

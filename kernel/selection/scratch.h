// A zeroed array over all cells of one kind, whose cost is that of the cells touched.
//
// A node of a tree touches few cells of a large complex; clearing an array of the complex' size per node, or
// asking the system for its pages, would cost more than the node. So a block notes which of its pages were
// touched, clears these when it is released, and is used again.
//
// Threads may write different entries at a time, or the same one by `Marks::set`.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"

namespace cnrg {

/// Zeroed bytes; once released they serve the next block of the same thread. Whoever writes calls `touch` first.
class ZeroedBlock {
 public:
  static constexpr std::size_t kPage = 512;

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
  void touch(std::size_t offset) {
    // Nearly always it was touched before; then a read alone leaves the cache line to other threads, too.
    const std::atomic_ref touched(data_[pages_ * kPage + offset / kPage]);
    if (touched.load(std::memory_order_relaxed) != std::byte{0}) return;
    touched.store(std::byte{1}, std::memory_order_relaxed);
  }
  bool touched(std::size_t page) const { return data_[pages_ * kPage + page] != std::byte{0}; }
  std::size_t pages() const { return pages_; }

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
  const T& get(IdT id) const { return data()[id.index()]; }

  /// For entries of one byte: writes one that other threads may write, too.
  void set(IdT id, T value) {
    static_assert(sizeof(T) == 1);
    block_.touch(id.index());
    std::atomic_ref(data()[id.index()]).store(value, std::memory_order_relaxed);
  }
  /// For entries of one byte: the ids whose entry is not zero, ascending, at the cost of the pages touched.
  std::vector<IdT> ids() const;

 private:
  T* data() const { return reinterpret_cast<T*>(block_.data()); }
  ZeroedBlock block_;
};

template <class IdT, class T>
std::vector<IdT> Scratch<IdT, T>::ids() const {
  static_assert(sizeof(T) == 1);
  const auto each = [&](auto visit) {
    for (std::size_t page = 0; page < block_.pages(); ++page) {
      if (!block_.touched(page)) continue;
      for (std::size_t at = page * ZeroedBlock::kPage, end = at + ZeroedBlock::kPage; at < end; at += 64) {
        std::uint64_t words[8], any = 0;
        std::memcpy(words, block_.data() + at, sizeof words);
        for (const std::uint64_t word : words) any |= word;
        if (any == 0) continue;
        for (std::size_t i = at; i < at + 64; ++i) {
          if (block_.data()[i] != std::byte{0}) visit(i);
        }
      }
    }
  };
  std::size_t count = 0;
  each([&](std::size_t) { ++count; });
  std::vector<IdT> out;
  out.reserve(count);
  each([&](std::size_t i) { out.push_back(IdT(i)); });
  return out;
}

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
    while (parent_.get(x) != 0) {
      const IdT up(parent_.get(x) - 1);
      if (parent_.get(up) != 0) parent_[x] = parent_.get(up);
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

  /// Takes x out. The other members of its set must be taken out, too.
  void reset(IdT x) { parent_[x] = 0; }

 private:
  Scratch<IdT, std::uint32_t> parent_;  // 1 + the parent; 0: none
};

}  // namespace cnrg

// Lists that are mostly short: what fits lies inside of the object, only longer ones ask for memory.
//
// A simplified complex has a list or two per cell, nearly all of one to four ids. As vectors they would cost an
// allocation each and five times the memory.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <span>
#include <type_traits>

#include "kernel/base/counts.h"

namespace cnrg {

/// A list that holds up to N elements in itself. N is a power of two, and N elements take at least the bytes of a
/// pointer. Pointers into a short list do not survive a move.
template <class T, std::size_t N>
class ShortList {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  static_assert(alignof(T) <= 4 && std::has_single_bit(N) && N * sizeof(T) >= sizeof(T*));

 public:
  ShortList() = default;
  template <class Iterator>
  ShortList(Iterator first, Iterator last) {
    append(first, last);
  }
  ShortList(std::initializer_list<T> list) : ShortList(list.begin(), list.end()) {}
  ShortList(const ShortList& other) : ShortList(other.begin(), other.end()) {}
  ShortList(ShortList&& other) noexcept { swap(other); }
  ShortList& operator=(ShortList other) noexcept {
    swap(other);
    return *this;
  }
  ~ShortList() {
    if (size_ > N) std::allocator<T>().deallocate(far(), capacity());
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T* begin() { return size_ > N ? far() : reinterpret_cast<T*>(near_.data()); }
  T* end() { return begin() + size_; }
  const T* begin() const { return size_ > N ? far() : reinterpret_cast<const T*>(near_.data()); }
  const T* end() const { return begin() + size_; }
  T& operator[](std::size_t i) { return begin()[i]; }
  const T& operator[](std::size_t i) const { return begin()[i]; }
  const T& front() const { return *begin(); }
  const T& back() const { return *(end() - 1); }
  auto rbegin() const { return std::make_reverse_iterator(end()); }
  auto rend() const { return std::make_reverse_iterator(begin()); }

  void push_back(T value) { append(&value, &value + 1); }
  /// Adds a range that is not part of this list.
  template <class Iterator>
  void append(Iterator first, Iterator last) {
    const std::size_t size = size_ + static_cast<std::size_t>(std::distance(first, last));
    if (size > capacity()) grow(place32(size, "entries of one list"));
    else size_ = static_cast<std::uint32_t>(size);
    std::copy(first, last, end() - std::distance(first, last));
  }
  friend bool operator==(const ShortList& a, const ShortList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }
  friend auto operator<=>(const ShortList& a, const ShortList& b) {
    return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  std::size_t capacity() const { return std::max(N, std::bit_ceil(std::size_t{size_})); }
  T* far() const {
    T* data;
    std::memcpy(&data, near_.data(), sizeof data);
    return data;
  }
  // The elements move to memory of their own, with room for `size`.
  void grow(std::uint32_t size) {
    T* data = std::allocator<T>().allocate(std::bit_ceil(std::size_t{size}));
    std::copy(begin(), end(), data);
    if (size_ > N) std::allocator<T>().deallocate(far(), capacity());
    std::memcpy(near_.data(), &data, sizeof data);
    size_ = size;
  }
  void swap(ShortList& other) noexcept {
    std::swap(size_, other.size_);
    const std::array near = near_;  // as a whole: std::swap would take byte after byte
    near_ = other.near_;
    other.near_ = near;
  }

  std::uint32_t size_ = 0;
  alignas(4) std::array<std::byte, N * sizeof(T)> near_{};  // the elements, or the address of more than N
};

/// A list of lists of T, in one piece.
template <class T>
class ShortLists {
 public:
  using List = std::span<const T>;
  class Iterator {
   public:
    using value_type = List;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    Iterator(const ShortLists* lists, std::size_t at) : lists_(lists), at_(at) {}
    List operator*() const { return (*lists_)[at_]; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return {lists_, at_++}; }
    friend bool operator==(const Iterator&, const Iterator&) = default;

   private:
    const ShortLists* lists_ = nullptr;
    std::size_t at_ = 0;
  };

  std::size_t size() const { return ends_.size(); }
  bool empty() const { return ends_.empty(); }
  List operator[](std::size_t i) const {
    const std::uint32_t first = i == 0 ? 0 : ends_[i - 1];
    return {values_.begin() + first, values_.begin() + ends_[i]};
  }
  List front() const { return (*this)[0]; }
  Iterator begin() const { return {this, 0}; }
  Iterator end() const { return {this, size()}; }
  /// Appends a list, given in one part or two.
  void push_back(List list, List rest = {}) {
    values_.append(list.begin(), list.end());
    values_.append(rest.begin(), rest.end());
    ends_.push_back(static_cast<std::uint32_t>(values_.size()));
  }

 private:
  ShortList<T, 4> values_;  // of all lists, one after the other
  ShortList<std::uint32_t, 2> ends_;
};

}  // namespace cnrg

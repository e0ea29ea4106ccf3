// Lists and values that only few ids have, as isolated vertices and wires do: memory for those alone.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/counts.h"
#include "kernel/base/sorted.h"

namespace cnrg {

/// A list of T for every id, empty for nearly all: `lists[id]` is a span, found by bisection.
template <class IdT, class T>
class SparseLists {
 public:
  SparseLists() = default;
  /// From (id, value) pairs that are sorted by id.
  explicit SparseLists(const std::vector<std::pair<IdT, T>>& pairs) {
    for (const auto& [id, value] : pairs) {
      if (ids_.empty() || ids_.back() != id) {
        ids_.push_back(id);
        ends_.push_back(0);
      }
      values_.push_back(value);
      ends_.back() = place32(values_.size(), "entries of lists");
    }
  }
  std::span<const T> operator[](IdT id) const {
    if (ids_.empty()) return {};
    const auto it = std::lower_bound(ids_.begin(), ids_.end(), id);
    if (it == ids_.end() || *it != id) return {};
    const auto i = static_cast<std::size_t>(it - ids_.begin());
    return {values_.data() + (i == 0 ? 0 : ends_[i - 1]), values_.data() + ends_[i]};
  }
  /// see(id, value) for all values, by id.
  template <class See>
  void for_each(const See& see) const {
    for (std::size_t i = 0, k = 0; i < ids_.size(); ++i) {
      for (; k < ends_[i]; ++k) see(ids_[i], values_[k]);
    }
  }
  /// All values of all lists.
  const std::vector<T>& values() const { return values_; }
  friend bool operator==(const SparseLists&, const SparseLists&) = default;

 private:
  std::vector<IdT> ids_;  // ascending
  std::vector<std::uint32_t> ends_;
  std::vector<T> values_;
};

/// A value for every id, T() for nearly all; found by bisection.
template <class IdT, class T>
class SparseVector {
 public:
  SparseVector() = default;
  /// From (id, value) pairs that are sorted by id, one for an id.
  explicit SparseVector(std::vector<std::pair<IdT, T>> pairs) : pairs_(std::move(pairs)) {}
  T operator[](IdT id) const {
    const T* const value = value_of_key(pairs_, id);
    return value != nullptr ? *value : T();
  }
  friend bool operator==(const SparseVector&, const SparseVector&) = default;

 private:
  std::vector<std::pair<IdT, T>> pairs_;
};

}  // namespace cnrg

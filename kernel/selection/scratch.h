// A zeroed array over all cells of one kind, whose cost is that of the cells touched.
//
// A node of a tree touches few cells of a large complex; filling an array of the complex' size per node would
// cost more than the node. Large zeroed blocks come from the system as untouched pages.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#include "kernel/base/ids.h"

namespace cnrg {

template <class IdT, class T>
class Scratch {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Zeros for the ids 0 .. n-1.
  explicit Scratch(std::size_t n) : data_(static_cast<T*>(std::calloc(n == 0 ? 1 : n, sizeof(T)))) {
    if (!data_) throw std::bad_alloc();
  }
  T& operator[](IdT id) { return data_.get()[id.index()]; }
  const T& operator[](IdT id) const { return data_.get()[id.index()]; }

 private:
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T, Free> data_;
};

/// One byte of flags per cell.
template <class IdT>
using Marks = Scratch<IdT, std::uint8_t>;

}  // namespace cnrg

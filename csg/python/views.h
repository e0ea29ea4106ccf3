// Arrays of the library as arrays of numpy, without a copy.
//
// A numpy array that knows its *base* lives on it: the base here is a capsule with a shared pointer to what holds
// the numbers. So a result, an evaluation and a module may go in any order, and what is left reads what it always
// read. Views cannot be written to: many may look at the same numbers.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <string>
#include <vector>

#include "bind.h"

namespace cnrg::python {

/// What keeps the numbers alive.
using Owner = std::shared_ptr<const void>;

inline py::capsule capsule_of(const Owner& owner) {
  auto held = std::make_unique<Owner>(owner);
  py::capsule capsule(held.get(), [](void* p) { delete static_cast<Owner*>(p); });
  held.release();
  return capsule;
}

/// `columns` > 0: rows of so many.
template <class T>
py::array view(const Owner& owner, const std::vector<T>& values, const py::dtype& type, py::ssize_t columns = 0) {
  const auto size = static_cast<py::ssize_t>(values.size());
  std::vector<py::ssize_t> shape{size};
  if (columns > 0) shape = {size / columns, columns};
  py::array array(type, std::move(shape), values.data(), capsule_of(owner));
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}
template <class T>
py::array view(const Owner& owner, const std::vector<T>& values, py::ssize_t columns = 0) {
  return view(owner, values, py::dtype::of<T>(), columns);
}
/// 0 and 1 as bools.
inline py::array flags(const Owner& owner, const std::vector<std::uint8_t>& values) {
  return view(owner, values, py::dtype::of<bool>());
}
/// A vector that nothing else holds.
template <class T>
py::array owned(std::vector<T> values, py::ssize_t columns = 0) {
  const auto held = std::make_shared<const std::vector<T>>(std::move(values));
  return view(held, *held, columns);
}

/// A text of a name, which may be any bytes.
inline py::str text_of(const std::string& name) {
  PyObject* const text =
      PyUnicode_DecodeUTF8(name.data(), static_cast<Py_ssize_t>(name.size()), "backslashreplace");
  if (text == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

}  // namespace cnrg::python

// The parts of what Python sees of a result.
#pragma once

#include "bind.h"

namespace cnrg::python {

/// Cells as arrays.
void bind_result_arrays(py::module_& module);
/// Where points lie, why cells are there, topology, comparison.
void bind_result_questions(py::module_& module);
/// Pictures and pages.
void bind_result_pictures(py::module_& module);
/// Tetrahedra.
void bind_tetrahedra(py::module_& module);

}  // namespace cnrg::python

// The attributes of cells, for Python.
#pragma once

#include "views.h"

namespace cnrg::python {

/// By key: a Fraction or a text.
py::dict to_dict(const Properties& properties);
/// A tuple: what is said, each as (name, material, properties), and the columns, each as (array, texts, values):
/// of numbers as doubles, of texts as their places from 1.
py::tuple said_of(const Owner& owner, const SaidTable& table);

}  // namespace cnrg::python

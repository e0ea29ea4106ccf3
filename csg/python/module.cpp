// The extension behind the Python package: trees as texts go in, evaluations and results come out. What users call
// is in cnrg/*.py; names here are private to it.
#include "bind.h"
#include "watched.h"

PYBIND11_MODULE(_cnrg, module) {
  using namespace cnrg::python;
  module.doc() = "The C++ library behind the package cnrg; use that.";
  module.attr("__version__") = CNRG_VERSION;
  bind_errors(module);
  bind_watched(module);
  bind_numbers(module);
  bind_tree(module);
  bind_result(module);
  bind_evaluation(module);
}

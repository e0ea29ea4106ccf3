// One node's value, as files show it.
#include <pybind11/stl.h>

#include "bind.h"
#include "numbers.h"
#include "watched.h"

namespace cnrg::python {

void bind_result(py::module_& module) {
  py::class_<OneResult>(module, "Result")
      .def_property_readonly("name", [](const OneResult& r) { return r.result.name(); })
      .def_property_readonly("component_count", [](const OneResult& r) { return r.result.component_count(); })
      .def("volume_of", [](const OneResult& r, Component i) { return to_fraction(r.result.volume(i)); })
      .def("write", [](const OneResult& r, const std::string& path, bool parameters) {
        FileOptions options;
        options.parameters = parameters;
        watched(py::none(), [&](const Watch&) { return write(path, r.result, options).moved; });
      });
}

}  // namespace cnrg::python

// The result of one node, with the numbers that files use.
#include <pybind11/stl.h>

#include "csg/certify/certificate.h"
#include "csg/formats/formats.h"
#include "csg/formats/writer.h"
#include "csg/result/join.h"
#include "csg/result/result_data.h"
#include "csg/transfer/stored_value.h"
#include "numbers.h"
#include "results.h"
#include "watched.h"

namespace cnrg::python {

namespace {

using Materials = std::vector<std::pair<std::string, std::string>>;

/// What a .json of it holds; InputError for what cannot be read back.
py::bytes json_of(const Result& result) {
  return apart(py::none(), [held = result](const Watch&) {
    leaf_of(held);
    return json_text(held.data().view()).text;
  });
}

OneResult of_json(const py::bytes& bytes, const std::string& name, const Materials& materials) {
  const std::string json = bytes;
  ResultNames names{.result = name, .leaves = {name}};
  for (const auto& [material, color] : materials) names.materials.push_back({material, color});
  return {watched(py::none(), [&](const Watch&) { return result_of_text(json, std::move(names)); }), nullptr, {}};
}

}  // namespace

void bind_result(py::module_& module) {
  py::class_<ResultLeaf>(module, "ResultLeaf")
      .def(py::init([](const OneResult& r) {
        return ResultLeaf{r.result, watched(py::none(), [&](const Watch&) { return leaf_of(r.result); })};
      }))
      .def("json", [](const ResultLeaf& leaf) { return json_of(leaf.result); });
  module.def("result_of_json", &of_json);
  py::class_<OneResult>(module, "Result")
      .def_property_readonly("name", [](const OneResult& r) { return r.result.name(); })
      .def_property_readonly("component_count", [](const OneResult& r) { return r.result.component_count(); })
      .def_property_readonly("has_tree", [](const OneResult& r) { return r.from != nullptr; })
      .def_property_readonly(
          "file", [](const OneResult& r) { return r.from == nullptr ? std::string() : r.from->tree->file; })
      .def("volume_of",
           [](const OneResult& r, Component i) {
             if (i < 1 || i > r.result.component_count())
               throw py::index_error("components are numbered from 1 to " +
                                     std::to_string(r.result.component_count()));
             return to_fraction(watched(py::none(), [&](const Watch&) { return r.result.volume(i); }));
           })
      .def_property_readonly("volume_bound",
                             [](const OneResult& r) {
                               const auto& bound = r.result.data().volume_bound;
                               return bound ? bound() : std::nullopt;
                             })
      .def("write",
           [](const OneResult& r, const std::string& path, bool parameters, bool snap, bool binary) {
             const FileReport report = apart(py::none(), [=, held = r.result](const Watch& watch) {
               return write(path, held,
                            {.parameters = parameters, .snap = snap, .binary = binary, .stop = watch.stop});
             });
             std::vector<std::string> notices = report.notices;
             if (is_cad_file(path) && r.from != nullptr) {
               const std::string doubt = certificate_of(r.from->evaluation, r.node).doubt(*r.from->tree);
               if (!doubt.empty()) notices.push_back(doubt);
             }
             if (report.snapped.rounds > 0) notices.push_back(report.snapped.text());
             return py::make_tuple(report.moved, report.embedded, notices, report.snapped.warnings());
           })
      .def("json", [](const OneResult& r) { return json_of(r.result); })
      .def("join",
           [](const OneResult& r, const py::handle& distance, const py::object& progress) {
             const Rational within = to_rational(distance, "a distance");
             auto [joined, report] = apart(progress, [held = r.result, within](const Watch& watch) {
               JoinReport report;
               Result joined = join(held, within, &report, watch);
               return std::pair(std::move(joined), std::move(report));
             });
             return py::make_tuple(OneResult{std::move(joined), nullptr, r.node}, report.rounds,
                                   report.displacement, report.merged, report.warnings(within));
           })
      .def("snap", [](const OneResult& r, const py::object& progress) {
        auto [snapped, report] = apart(progress, [held = r.result](const Watch& watch) {
          SnapReport report;
          Result snapped = snap(held, &report, watch);
          return std::pair(std::move(snapped), std::move(report));
        });
        return py::make_tuple(OneResult{std::move(snapped), nullptr, r.node}, report.rounds, report.displacement,
                              report.text(), report.warnings());
      });
  bind_result_arrays(module);
  bind_result_questions(module);
  bind_result_pictures(module);
  bind_tetrahedra(module);
}

}  // namespace cnrg::python

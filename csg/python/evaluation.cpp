// A tree evaluated: rows, diagnostics, results.
#include <pybind11/stl.h>

#include "bind.h"
#include "csg/certify/certificate.h"
#include "csg/topology/features.h"
#include "numbers.h"
#include "watched.h"

namespace cnrg::python {
namespace {

std::shared_ptr<const EvaluatedTree> evaluate_tree(const TreeObject& tree, const std::vector<std::size_t>& nodes,
                                                   int threads, bool rows, bool raw, bool validate,
                                                   std::optional<bool> certify, const py::object& progress) {
  EvaluateOptions options;
  options.threads = threads;
  options.rows = rows ? Rows::all : Rows::kept;
  options.raw = raw;
  options.validate = validate;
  if (certify) options.proof = *certify ? AskedProof::to_the_end : AskedProof::none;
  for (const std::size_t node : nodes) options.nodes.emplace_back(node);
  return apart(progress, [shared = tree.tree, options](const Watch& watch) mutable {
    options.watch = watch;
    return std::make_shared<const EvaluatedTree>(EvaluatedTree{shared, evaluate(*shared, options)});
  });
}

py::dict certificate_data(const Tree& tree, const Certificate& certificate) {
  py::dict data;
  data["asked"] = certificate.asked;
  data["apart"] = certificate.apart;
  data["crossing"] = certificate.crossing;
  data["contacts"] = certificate.contacts;
  data["left"] = certificate.left;
  py::list places, unknown;
  for (const UncertainPlace& place : certificate.places) {
    py::dict one;
    one["names"] = py::tuple(py::cast(place.names));
    one["at"] = py::tuple(py::cast(place.at));
    one["size"] = place.size;
    one["why"] = std::array{"near", "facets", "budget"}[static_cast<std::size_t>(place.why)];
    places.append(one);
  }
  for (const NodeId node : certificate.unknown) unknown.append(tree.nodes[node].name);
  data["places"] = places;
  data["unknown"] = py::tuple(unknown);
  return data;
}

py::dict row_data(const NodeRow& row) {
  py::dict data;
  data["name"] = row.name;
  data["operator"] = row.operator_name;
  data["cells"] = py::tuple(py::cast(row.cells));
  data["removed"] = row.removed();
  data["regions"] = row.regions;
  data["components"] = row.components;
  data["is_group"] = row.is_group;
  data["volume"] = to_fraction(row.volume());
  data["volume_bound"] = row.volume() ? py::cast(row.volume_bound()) : py::none();
  data["seconds"] = row.seconds;
  return data;
}

}  // namespace

void bind_evaluation(py::module_& module) {
  py::class_<EvaluatedTree, std::shared_ptr<EvaluatedTree>>(module, "Evaluation")
      .def("rows",
           [](const EvaluatedTree& e) {
             py::list rows;
             for (const NodeRow* const row : e.evaluation.all_rows()) rows.append(row_data(*row));
             return rows;
           })
      .def("diagnostics",
           [](const EvaluatedTree& e, const std::vector<std::size_t>& kept) {
             const std::vector<NodeId> roots(kept.begin(), kept.end());
             std::vector<Diagnostic> all = reading_warnings(*e.tree, roots);
             all.insert(all.end(), e.evaluation.diagnostics.begin(), e.evaluation.diagnostics.end());
             for (Diagnostic& d : certificate_of(e.evaluation).told(*e.tree)) all.push_back(std::move(d));
             for (const NodeId node : roots) {
               for (Diagnostic& d : near_and_lost(*e.tree, e.evaluation, node)) all.push_back(std::move(d));
             }
             py::list list;
             for (const Diagnostic& d : all) {
               list.append(py::make_tuple(d.level == Diagnostic::Level::warning ? "warning" : "notice", d.file,
                                          d.at.line, d.at.column, d.message));
             }
             return list;
           })
      .def("certificate",
           [](const EvaluatedTree& e) -> std::optional<py::dict> {
             if (!e.evaluation.certificate) return std::nullopt;
             return certificate_data(*e.tree, certificate_of(e.evaluation));
           })
      .def_property_readonly("refine_seconds", [](const EvaluatedTree& e) { return e.evaluation.refine_seconds; })
      .def("result", [](const std::shared_ptr<EvaluatedTree>& e, std::size_t node) {
        return OneResult{e->evaluation.result(NodeId(node)), e, NodeId(node)};
      });
  module.def(
      "evaluate",
      [](const TreeObject& tree, const std::vector<std::size_t>& nodes, int threads, bool rows, bool raw,
         bool validate, std::optional<bool> certify, const py::object& progress) {
        return std::const_pointer_cast<EvaluatedTree>(
            evaluate_tree(tree, nodes, threads, rows, raw, validate, certify, progress));
      },
      py::arg("tree"), py::arg("nodes"), py::arg("threads"), py::arg("rows"), py::arg("raw"), py::arg("validate"),
      py::arg("certify"), py::arg("progress"));
}

}  // namespace cnrg::python

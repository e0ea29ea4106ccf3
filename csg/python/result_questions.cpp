// Questions to a result that take the exact cells: where points lie, why a cell is there, what its shape is, in
// what two results differ. Facts come as JSON, which Python reads.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>

#include "csg/tree/tree_of_file.h"
#include "numbers.h"
#include "results.h"
#include "views.h"
#include "watched.h"

namespace cnrg::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style>;

/// Where points lie, with what is built for that once.
struct PlacesObject {
  std::shared_ptr<const Places> places;
  Result result;
};

PlacesObject places_of(const OneResult& r) {
  auto tree = r.from == nullptr ? nullptr : r.from->tree;
  auto places =
      watched(py::none(), [&](const Watch&) { return std::make_shared<const Places>(r.result, tree, r.node); });
  return {std::move(places), r.result};
}

std::vector<RationalPoint> points_of(const Doubles& points) {
  if (points.ndim() != 2 || points.shape(1) != 3)
    throw py::value_error("points must have the shape (n, 3), three coordinates for each");
  std::vector<RationalPoint> out(static_cast<std::size_t>(points.shape(0)));
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = points.data()[3 * i + k];
      if (!std::isfinite(x)) {
        throw InputError("point " + std::to_string(i) +
                         " has a coordinate that is not finite; remove the point or mend it");
      }
      out[i][k] = from_double(x);
    }
  }
  return out;
}

std::vector<RationalPoint> points_of(const py::sequence& points) {
  std::vector<RationalPoint> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    out.push_back(to_rational_point(points[i], "point " + std::to_string(i)));
  }
  return out;
}

/// Arrays of dimension, cell (-1: none is listed) and component.
py::tuple locate(const PlacesObject& object, const std::vector<RationalPoint>& points,
                 const py::object& progress) {
  const std::vector<Places::Place> places =
      apart(progress, [held = object.places, points](const Watch& watch) { return held->of(points, watch); });
  std::vector<std::int8_t> dimension;
  std::vector<std::int32_t> cell, component;
  for (const Places::Place& place : places) {
    dimension.push_back(static_cast<std::int8_t>(place.dimension));
    cell.push_back(place.index == SimplifiedComplex::kNowhere ? -1 : static_cast<std::int32_t>(place.index));
    component.push_back(static_cast<std::int32_t>(object.result.component(place)));
  }
  return py::make_tuple(owned(std::move(dimension)), owned(std::move(cell)), owned(std::move(component)));
}

/// The tree of a result, or a fault that says what was asked for.
const EvaluatedTree& tree_of(const OneResult& r, const char* what) {
  if (r.from == nullptr) {
    throw InputError(std::string(what) +
                     " needs the tree that a result comes from, and this one was snapped or read "
                     "from a file; ask the result of the tree itself");
  }
  return *r.from;
}

/// The node of a result evaluated with the values of all nodes.
std::shared_ptr<const EvaluatedTree> evaluate_all(const OneResult& r, const std::vector<RationalPoint>& reach,
                                                  int threads, const py::object& progress) {
  const std::shared_ptr<const Tree> tree = tree_of(r, "an explanation").tree;
  EvaluateOptions options;
  options.threads = threads;
  options.rows = Rows::none;
  options.keep_all = true;
  options.result = r.node;
  options.reach = reach;
  return apart(progress, [tree, options](const Watch& watch) mutable {
    options.watch = watch;
    return std::make_shared<const EvaluatedTree>(EvaluatedTree{tree, evaluate(*tree, options)});
  });
}

py::tuple told(const std::function<Story()>& tell) {
  const Story story = watched(py::none(), [&](const Watch&) { return tell(); });
  return py::make_tuple(text_of(story.text), text_of(story.json));
}

struct Side {
  std::shared_ptr<const Tree> tree;
  NodeId node;
};

/// A result, or the path of a file that holds one.
Side side_of(const py::object& given) {
  if (py::isinstance<OneResult>(given)) {
    const auto& r = given.cast<const OneResult&>();
    return {tree_of(r, "a comparison").tree, r.node};
  }
  auto tree = std::make_shared<const Tree>(tree_of_file(given.cast<std::string>()));
  const NodeId node = tree->result;
  return {std::move(tree), node};
}

py::tuple compare_sides(const py::object& a, const py::object& b, const std::vector<std::string>& ignored,
                        int threads, const py::object& progress) {
  CompareOptions options;
  options.threads = threads;
  for (const std::string& what : ignored) {
    if (what == "components") options.components = false;
    else if (what == "materials") options.materials = false;
    else if (what == "names") options.names = false;
    else if (what == "attributes") options.attributes = false;
    else if (what == "features") options.features = false;
    else throw InputError("ignore: `" + what + "` is none of components, materials, names, attributes, features");
  }
  const Side first = side_of(a), second = side_of(b);
  const Difference found = apart(progress, [first, second, options](const Watch& watch) mutable {
    options.watch = watch;
    return difference(*first.tree, first.node, *second.tree, second.node, options);
  });
  return py::make_tuple(found.same, text_of(found.text), text_of(found.json));
}

}  // namespace

void bind_result_questions(py::module_& module) {
  py::class_<PlacesObject>(module, "Places")
      .def("locate", [](const PlacesObject& object, const Doubles& points,
                        const py::object& progress) { return locate(object, points_of(points), progress); })
      .def("locate_exact", [](const PlacesObject& object, const py::sequence& points, const py::object& progress) {
        return locate(object, points_of(points), progress);
      });
  module.def("places", &places_of);

  module.def("has_frame", [](const OneResult& r) { return r.result.complex().frame.valid(); });
  module.def(
      "evaluate_all",
      [](const OneResult& r, const py::object& reach, int threads, const py::object& progress) {
        std::vector<RationalPoint> points;
        if (!reach.is_none()) points = {to_rational_point(reach, "the point")};
        return std::const_pointer_cast<EvaluatedTree>(evaluate_all(r, points, threads, progress));
      },
      py::arg("result"), py::arg("reach"), py::arg("threads"), py::arg("progress"));
  module.def("explain_cell", [](const OneResult& r, const EvaluatedTree& all, const std::string& cell) {
    return told([&] { return story(*all.tree, all.evaluation, r.node, cell); });
  });
  module.def("explain_point", [](const OneResult& r, const EvaluatedTree& all, const py::object& point) {
    const RationalPoint p = to_rational_point(point, "the point");
    return told([&] { return story(*all.tree, all.evaluation, r.node, p); });
  });

  module.def("topology", [](const OneResult& r) {
    const TopologyReport report =
        apart(py::none(), [held = r.result](const Watch&) { return topology_report(held); });
    return py::make_tuple(text_of(report.text), text_of(report.json));
  });
  module.def("selectables", [](const OneResult& r) {
    const std::vector<Selectable> list =
        apart(py::none(), [held = r.result](const Watch&) { return selectables(held); });
    py::list out;
    for (const Selectable& s : list) {
      const auto& [vertices, edges, faces, regions] = s.cells;
      out.append(py::make_tuple(s.key, text_of(s.value), regions, faces, edges, vertices, s.source_faces));
    }
    return out;
  });
  module.def("compare", &compare_sides, py::arg("a"), py::arg("b"), py::arg("ignored"), py::arg("threads"),
             py::arg("progress"));
}

}  // namespace cnrg::python

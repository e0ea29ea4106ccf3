// The cells of a result as arrays of numpy, their exact coordinates and sizes.
#include <pybind11/stl.h>

#include "numbers.h"
#include "results.h"
#include "said.h"
#include "views.h"
#include "watched.h"

namespace cnrg::python {
namespace {

/// Arrays of a result, made once.
struct ArraysObject {
  Result result;
  std::shared_ptr<const ResultArrays> arrays;
  Measures measures() const { return Measures(result, *arrays); }
};

using Arrays = ResultArrays;

py::tuple lists(const Owner& owner, const NumberLists& lists, py::ssize_t columns = 0) {
  return py::make_tuple(view(owner, lists.offsets), view(owner, lists.values, columns));
}

py::dict common(const Owner& owner, const Arrays::Common& cells) {
  py::dict out;
  out["component"] = view(owner, cells.component);
  out["entity"] = flags(owner, cells.entity);
  out["holder"] = view(owner, cells.holder);
  out["material"] = view(owner, cells.material);
  out["said"] = view(owner, cells.said);
  out["leaf"] = view(owner, cells.leaf);
  out["leaf_face"] = view(owner, cells.leaf_face);
  out["origin_leaves"] = lists(owner, cells.origin.leaves);
  out["origin_cells"] = lists(owner, cells.origin.cells, 3);
  return out;
}

py::dict vertices(const Owner& owner, const Arrays::Vertices& cells) {
  py::dict out = common(owner, cells);
  out["point"] = view(owner, cells.point);
  out["feature"] = flags(owner, cells.feature);
  out["free"] = flags(owner, cells.free);
  out["region"] = view(owner, cells.region);
  out["edges"] = lists(owner, cells.edges);
  return out;
}

py::dict edges(const Owner& owner, const Arrays::Edges& cells) {
  py::dict out = common(owner, cells);
  out["points"] = lists(owner, cells.points);
  out["vertices"] = view(owner, cells.vertices, 2);
  out["closed"] = flags(owner, cells.closed);
  out["feature"] = flags(owner, cells.feature);
  out["wire"] = flags(owner, cells.wire);
  out["slit"] = flags(owner, cells.slit);
  out["region"] = view(owner, cells.region);
  out["around"] = lists(owner, cells.around);
  return out;
}

py::dict faces(const Owner& owner, const Arrays::Faces& cells) {
  py::dict out = common(owner, cells);
  const auto offsets = [&](const ListOffsets& lists) { return view(owner, lists.offsets); };
  out["loops"] = py::make_tuple(offsets(cells.loops), lists(owner, cells.loop_points));
  out["loop_edges"] = py::make_tuple(offsets(cells.loops), lists(owner, cells.loop_edges));
  out["isolated"] = lists(owner, cells.isolated);
  out["regions"] = view(owner, cells.regions, 2);
  out["patch"] = view(owner, cells.patch);
  out["flat"] = flags(owner, cells.flat);
  out["triangles"] = lists(owner, cells.triangles, 3);
  out["facets"] = py::make_tuple(offsets(cells.facets),
                                 py::make_tuple(offsets(cells.facet_loops), lists(owner, cells.facet_points)));
  out["facet_isolated"] = py::make_tuple(offsets(cells.facets), lists(owner, cells.facet_isolated));
  out["facet_triangles"] = py::make_tuple(offsets(cells.facets), view(owner, cells.facet_triangles));
  return out;
}

py::dict regions(const Owner& owner, const Arrays::Regions& cells) {
  py::dict out = common(owner, cells);
  out["bounded"] = flags(owner, cells.bounded);
  out["shells"] = py::make_tuple(view(owner, cells.shells.offsets), lists(owner, cells.shell_sides));
  return out;
}

py::dict arrays_data(const ArraysObject& object) {
  const Owner owner = object.arrays;
  const Arrays& a = *object.arrays;
  py::dict out;
  out["points"] = view(owner, a.points, 3);
  out["frame_points"] = view(owner, a.frame_points);
  out["point_vertices"] = view(owner, a.point_vertices);
  out["vertices"] = vertices(owner, a.vertices);
  out["edges"] = edges(owner, a.edges);
  out["faces"] = faces(owner, a.faces);
  out["regions"] = regions(owner, a.regions);
  py::list leaves, components, materials;
  for (const std::string& leaf : a.leaves) leaves.append(text_of(leaf));
  for (const Arrays::Component& c : a.components) {
    py::list of;
    for (const std::int32_t leaf : c.leaves) of.append(leaf);
    components.append(py::make_tuple(text_of(c.name), text_of(c.material), of, to_dict(c.properties)));
  }
  for (const ResultNames::Material& m : a.materials)
    materials.append(py::make_tuple(text_of(m.name), text_of(m.color)));
  out["leaves"] = leaves;
  out["components"] = components;
  out["materials"] = materials;
  out["said"] = said_of(owner, a.said);
  out["group"] = a.group;
  return out;
}

/// Of all cells, by a function of Measures.
template <class T>
T measured(const ArraysObject& object, T (Measures::*of)(const Watch&) const) {
  return watched(py::none(), [&](const Watch& watch) { return (object.measures().*of)(watch); });
}

/// A number that a caller gave, below `count`.
std::size_t checked(std::size_t i, std::size_t count) {
  if (i >= count) throw py::index_error("there is no cell of this number");
  return i;
}

}  // namespace

void bind_result_arrays(py::module_& module) {
  using Object = ArraysObject;
  const auto edge = [](const Object& o, std::size_t i) { return checked(i, o.arrays->edges.component.size()); };
  const auto face = [](const Object& o, std::size_t i) { return checked(i, o.arrays->faces.component.size()); };
  const auto region = [](const Object& o, std::size_t i) {
    return checked(i, o.arrays->regions.component.size());
  };
  py::class_<Object>(module, "ResultArrays")
      .def("data", &arrays_data)
      .def("exact_point",
           [](const Object& o, std::size_t i) {
             return to_fractions(
                 o.result.complex().points.rational(o.arrays->ids[checked(i, o.arrays->ids.size())]));
           })
      .def("lengths", [](const Object& o) { return owned(measured(o, &Measures::lengths)); })
      .def("areas", [](const Object& o) { return owned(measured(o, &Measures::areas)); })
      .def("area_vectors", [](const Object& o) { return owned(measured(o, &Measures::area_vectors), 3); })
      .def("volumes",
           [](const Object& o) {
             py::list out;
             for (const auto& volume : measured(o, &Measures::volumes)) out.append(to_fraction(volume));
             return out;
           })
      .def("centroids",
           [](const Object& o) {
             py::list out;
             for (const auto& centroid : measured(o, &Measures::centroids)) out.append(to_fractions(centroid));
             return out;
           })
      .def("squared_length",
           [edge](const Object& o, std::size_t i) { return to_fraction(o.measures().squared_length(edge(o, i))); })
      .def("squared_area",
           [face](const Object& o, std::size_t i) { return to_fraction(o.measures().squared_area(face(o, i))); })
      .def("area_vector",
           [face](const Object& o, std::size_t i) { return to_fractions(o.measures().area_vector(face(o, i))); })
      .def("volume",
           [region](const Object& o, std::size_t i) { return to_fraction(o.measures().volume(region(o, i))); });
  module.def("result_arrays", [](const OneResult& r) {
    auto arrays =
        watched(py::none(), [&](const Watch&) { return std::make_shared<const Arrays>(result_arrays(r.result)); });
    return Object{r.result, std::move(arrays)};
  });
  module.def("cell_groups", [](const OneResult& r) {
    const auto groups = watched(py::none(), [&](const Watch&) {
      return std::make_shared<const std::array<std::vector<CellGroup>, 4>>(cell_groups(r.result));
    });
    py::list out;
    for (const std::vector<CellGroup>& of : *groups) {
      py::dict names;
      for (const CellGroup& group : of) names[text_of(group.name)] = view(groups, group.cells);
      out.append(names);
    }
    return out;
  });
}

}  // namespace cnrg::python

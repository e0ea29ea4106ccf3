// Tetrahedra and surface meshes of a result as arrays of numpy.
#include <pybind11/stl.h>

#include "numbers.h"
#include "results.h"
#include "said.h"
#include "views.h"
#include "watched.h"

namespace cnrg::python {
namespace {

/// A mesh, and its arrays.
template <class Mesh, class Arrays>
struct MeshObject {
  Mesh mesh;
  std::shared_ptr<const Arrays> arrays;
};
using TetrahedraObject = MeshObject<TetrahedralResult, TetrahedraArrays>;
using SurfaceObject = MeshObject<SurfaceMeshResult, SurfaceArrays>;

template <class Mesh, class Arrays, class Options>
MeshObject<Mesh, Arrays> made(const OneResult& r, const Options& asked, const py::object& progress) {
  return apart(progress, [held = r.result, options = asked](const Watch& watch) mutable {
    options.watch = watch;
    Mesh mesh(held, options);
    auto arrays = std::make_shared<const Arrays>(mesh.arrays());
    return MeshObject<Mesh, Arrays>{std::move(mesh), std::move(arrays)};
  });
}

PeriodicAxes axes_of(const std::string& letters) {
  PeriodicAxes axes{};
  for (std::size_t k = 0; k < 3; ++k) axes[k] = letters.find(char('x' + k)) != std::string::npos;
  return axes;
}

TetrahedraObject tetrahedralize(const OneResult& r, double max_volume, double quality, bool keep_boundary,
                                const std::optional<int>& seconds, bool curved, int order, double size,
                                double growth, bool surface_first, const std::string& periodic,
                                const py::object& progress) {
  TetrahedraOptions options;
  options.max_volume = max_volume;
  options.quality = quality;
  options.keep_boundary = keep_boundary;
  options.seconds = seconds;
  options.order = order;
  options.size = size;
  options.growth = growth;
  options.surface_first = surface_first;
  options.periodic = axes_of(periodic);
  options.curved = curved;
  return made<TetrahedralResult, TetrahedraArrays>(r, options, progress);
}

SurfaceObject mesh_surface(const OneResult& r, double size, double growth, std::size_t max_points, int seconds,
                           int order, bool quads, const std::string& periodic, const py::object& progress) {
  SurfaceOptions options{.overall = size,
                         .growth = growth,
                         .max_points = max_points,
                         .seconds = seconds,
                         .order = order,
                         .quads = quads,
                         .periodic = axes_of(periodic)};
  return made<SurfaceMeshResult, SurfaceArrays>(r, options, progress);
}

py::dict simplices(const Owner& owner, const MeshArrays::Simplices& of, py::ssize_t nodes) {
  py::dict out;
  out["points"] = view(owner, of.points, nodes);
  out["cell"] = view(owner, of.cell);
  out["component"] = view(owner, of.component);
  out["region_front"] = view(owner, of.front);
  out["region_back"] = view(owner, of.back);
  out["region"] = view(owner, of.region);
  out["material"] = view(owner, of.material);
  out["said"] = view(owner, of.said);
  out["source_leaf"] = view(owner, of.leaf);
  out["source_face"] = view(owner, of.face);
  return out;
}

py::dict mesh_data(const Owner& owner, const MeshArrays& a) {
  py::dict out;
  out["points"] = view(owner, a.points, 3);
  constexpr py::ssize_t kNodes[2][4] = {{1, 2, 3, 4}, {1, 3, 6, 10}};
  py::list of, groups;
  for (std::size_t d = 0; d < 4; ++d) {
    of.append(simplices(owner, a.of[d], kNodes[a.curved ? 1 : 0][d]));
    py::dict names;
    for (const CellGroup& group : a.groups[d]) names[text_of(group.name)] = view(owner, group.cells);
    groups.append(names);
  }
  out["simplices"] = of;
  out["groups"] = groups;
  py::list leaves, materials;
  for (const std::string& leaf : a.leaves) leaves.append(text_of(leaf));
  for (const std::string& material : a.materials) materials.append(text_of(material));
  out["leaves"] = leaves;
  out["materials"] = materials;
  out["said"] = said_of(owner, a.said);
  out["moved"] = a.rounding.moved;
  out["curved"] = a.curved;
  return out;
}

py::dict mesh_data(const TetrahedraObject& object) {
  const Owner owner = object.arrays;
  const TetrahedraArrays& a = *object.arrays;
  py::dict out = mesh_data(owner, a);
  py::list regions;
  for (const RegionTetrahedra& region : a.regions) {
    regions.append(py::make_tuple(text_of(region.name), region.tetrahedra, to_fraction(region.volume)));
  }
  out["regions"] = regions;
  py::dict fields;
  for (const auto& [name, values] : a.fields) fields[text_of(name)] = view(owner, values, 4);
  out["fields"] = fields;
  return out;
}

py::dict mesh_data(const SurfaceObject& object) {
  const Owner owner = object.arrays;
  const SurfaceArrays& a = *object.arrays;
  py::dict out = mesh_data(owner, a);
  out["quads"] = simplices(owner, a.quads, 4);
  py::list faces;
  for (const FaceTriangles& of : a.faces) {
    faces.append(py::make_tuple(text_of(of.name), of.triangles, of.quads, of.area, of.least_angle, of.least_quad));
  }
  out["faces"] = faces;
  out["kept"] = object.mesh.kept();
  return out;
}

template <class Object>
py::class_<Object> bind_mesh(py::module_& module, const char* name) {
  return py::class_<Object>(module, name)
      .def("data", [](const Object& object) { return mesh_data(object); })
      .def("write", [](const Object& object, const std::string& path) {
        run_apart(py::none(), [mesh = object.mesh, path](const Watch& watch) { mesh.write(path, watch.stop); });
      });
}

}  // namespace

void bind_tetrahedra(py::module_& module) {
  bind_mesh<TetrahedraObject>(module, "Tetrahedra")
      .def("notice", [](const TetrahedraObject& object) { return text_of(object.mesh.notice()); })
      .def("expected", [](const TetrahedraObject& object) { return object.mesh.expected(); });
  bind_mesh<SurfaceObject>(module, "SurfaceMesh");
  module.def("mesh_surface", &mesh_surface, py::arg("result"), py::arg("size"), py::arg("growth"),
             py::arg("max_points"), py::arg("seconds"), py::arg("order"), py::arg("quads"), py::arg("periodic"),
             py::arg("progress"));
  module.def("tetrahedralize", &tetrahedralize, py::arg("result"), py::arg("max_volume"), py::arg("quality"),
             py::arg("keep_boundary"), py::arg("seconds"), py::arg("curved"), py::arg("order"), py::arg("size"),
             py::arg("growth"), py::arg("surface_first"), py::arg("periodic"), py::arg("progress"));
}

}  // namespace cnrg::python

// A mesh in VTK's XML: tetrahedra, and the triangles, quadrilaterals, segments and vertices of the result. Their
// tags are explained in vtu.cpp.
#include <numeric>

#include "csg/formats/formats.h"
#include "csg/formats/vtu_grid.h"
#include "csg/mesh/periodic.h"

namespace cnrg {

std::string vtu_text(const ResultView& view, const Mesh& mesh) {
  VtuGrid grid;
  using enum VtuCell;
  static constexpr std::array kFirstOrder{vertex, line, triangle, quad, tetrahedron, wedge};
  static constexpr std::array kSecondOrder{vertex, quadratic_edge,        quadratic_triangle,
                                           quad,   quadratic_tetrahedron, wedge};
  const auto& cells = mesh.middles.empty() ? kFirstOrder : kSecondOrder;
  mesh.for_each_kind([&](std::size_t kind, std::size_t dimension, const auto& simplices, const auto& edges) {
    for (const auto& s : simplices)
      grid.add(cells[kind], mesh.nodes(s, edges), mesh.entities[dimension][s.entity].tags);
  });
  std::vector<Mesh::Index> twins = mesh.twins;
  if (mesh.periodic != PeriodicAxes{}) {
    twins.resize(mesh.points.size());
    std::iota(twins.begin(), twins.end(), Mesh::Index(0));
    for (const PeriodicNode& node : periodic_nodes(mesh)) twins[node.far] = node.near;
  }
  return grid.text(view, mesh.points, nullptr, twins);
}

}  // namespace cnrg

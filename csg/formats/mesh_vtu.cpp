// A mesh in VTK's XML: tetrahedra, and the triangles, quadrilaterals, segments and vertices of the result. Their
// tags are explained in vtu.cpp.
#include "csg/formats/formats.h"
#include "csg/formats/vtu_grid.h"
#include "csg/mesh/mesh.h"

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
  return grid.text(view, mesh.points, nullptr, mesh.twins);
}

}  // namespace cnrg

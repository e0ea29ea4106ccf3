// A mesh in VTK's XML: tetrahedra, and the triangles, quadrilaterals, segments and vertices of the result. Their
// tags are explained in vtu.cpp.
#include "csg/formats/formats.h"
#include "csg/formats/vtu_grid.h"
#include "csg/mesh/mesh.h"
#include "csg/mesh/second_order.h"

namespace cnrg {

std::string vtu_text(const ResultView& view, const Mesh& mesh) {
  VtuGrid grid;
  const auto add = [&](VtuCell kind, std::size_t dimension, const auto& simplices, const auto& edges) {
    for (const auto& s : simplices) {
      grid.add(kind, mesh.nodes(s, edges), mesh.entities[dimension][s.entity].tags);
    }
  };
  const bool straight = mesh.middles.empty();
  add(VtuCell::vertex, 0, mesh.vertices, kSecondOrderPoint);
  add(straight ? VtuCell::line : VtuCell::quadratic_edge, 1, mesh.segments, kSecondOrderLine);
  add(straight ? VtuCell::triangle : VtuCell::quadratic_triangle, 2, mesh.triangles, kSecondOrderTriangle);
  add(VtuCell::quad, 2, mesh.quads, kSecondOrderPoint);
  add(straight ? VtuCell::tetrahedron : VtuCell::quadratic_tetrahedron, 3, mesh.tetrahedra, kSecondOrderEdges);
  add(VtuCell::wedge, 3, mesh.wedges, kSecondOrderPoint);
  return grid.text(view, mesh.points, nullptr, mesh.twins);
}

}  // namespace cnrg

// A mesh in VTK's XML: tetrahedra, and the triangles, segments and vertices of the result. Their tags are
// explained in vtu.cpp.
#include "csg/formats/formats.h"
#include "csg/formats/vtu_grid.h"
#include "csg/mesh/mesh.h"

namespace cnrg {

std::string vtu_text(const ResultView& view, const Mesh& mesh) {
  VtuGrid grid;
  const auto add = [&](VtuCell kind, std::size_t dimension, const auto& simplices) {
    for (const auto& s : simplices) grid.add(kind, s.points, mesh.entities[dimension][s.entity].tags);
  };
  add(VtuCell::vertex, 0, mesh.vertices);
  add(VtuCell::polyline, 1, mesh.segments);
  add(VtuCell::triangle, 2, mesh.triangles);
  add(VtuCell::tetrahedron, 3, mesh.tetrahedra);
  return grid.text(view, mesh.points);
}

}  // namespace cnrg

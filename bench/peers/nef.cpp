#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include "bench/peers/peer.h"

namespace cnrg::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh mesh_of(const TriangleMesh& in) {
  Mesh mesh;
  for (const auto& p : in.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& t : in.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

}  // namespace

Outcome unite_nef(const TriangleMesh& a, const TriangleMesh& b) {
  const Mesh first = mesh_of(a), second = mesh_of(b);
  Outcome outcome;
  Stopwatch watch;
  const Nef p(first), q(second);
  outcome.stages.emplace_back("conversion", watch.lap());
  const Nef result = p + q;
  outcome.stages.emplace_back("union", watch.lap());
  outcome.vertices = result.number_of_vertices();
  outcome.faces = result.number_of_facets();
  Mesh surface;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(result, surface, true);
  outcome.volume = CGAL::to_double(CGAL::exact(CGAL::Polygon_mesh_processing::volume(surface)));
  outcome.note = "exact";
  return outcome;
}

}  // namespace cnrg::bench

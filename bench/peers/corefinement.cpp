#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

#include "bench/peers/peer.h"

namespace cnrg::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh mesh_of(const TriangleMesh& in) {
  Mesh mesh;
  for (const auto& p : in.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& t : in.triangles)
    if (mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2])) ==
        Mesh::null_face())
      throw std::runtime_error("the mesh is no 2-manifold");
  return mesh;
}

}  // namespace

Outcome unite_corefinement(const TriangleMesh& a, const TriangleMesh& b, bool check) {
  Mesh first = mesh_of(a), second = mesh_of(b), result;
  Outcome outcome;
  Stopwatch watch;
  const bool ok = CGAL::Polygon_mesh_processing::corefine_and_compute_union(first, second, result);
  outcome.stages.emplace_back("union", watch.lap());
  if (!ok) {
    outcome.note = "the result is no 2-manifold: none";
    return outcome;
  }
  outcome.vertices = result.number_of_vertices();
  outcome.faces = result.number_of_faces();
  if (check) outcome.volume = CGAL::Polygon_mesh_processing::volume(result);
  outcome.note = "constructed points rounded to doubles";
  return outcome;
}

}  // namespace cnrg::bench

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <stdexcept>

#include "bench/peers/cgal_mesh.h"
#include "bench/peers/peer.h"

namespace cnrg::bench {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using InexactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using InexactMesh = CGAL::Surface_mesh<InexactKernel::Point_3>;

InexactMesh inexact_mesh(const TriangleMesh& in) {
  InexactMesh mesh;
  for (const auto& p : in.points) mesh.add_vertex(InexactKernel::Point_3(p[0], p[1], p[2]));
  if (!add_polygons(mesh, in.triangles)) throw std::runtime_error("a mesh is no 2-manifold");
  return mesh;
}

}  // namespace

Outcome evaluate_corefinement(const Case& c, const Checks& checks, int) {
  std::vector<InexactMesh> meshes;
  for (const TriangleMesh& leaf : c.leaves) meshes.push_back(inexact_mesh(leaf));
  Measurement measurement;
  InexactMesh& result = meshes[0];
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    const bool done = c.operation == Operation::unite
                          ? processing::corefine_and_compute_union(result, meshes[i], result)
                          : processing::corefine_and_compute_difference(result, meshes[i], result);
    if (!done)
      throw std::runtime_error("refused: the result with operand " + std::to_string(i + 1) + " is no 2-manifold");
  }
  measurement.lap("Boolean");

  Outcome outcome;
  outcome.measures = measurement.stop();
  outcome.vertices = result.number_of_vertices();
  outcome.faces = result.number_of_faces();
  if (checks.volume) outcome.volume = processing::volume(result);
  outcome.note = "constructed points rounded to doubles";
  return outcome;
}

}  // namespace cnrg::bench

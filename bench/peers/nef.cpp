#include <CGAL/Nef_nary_union_3.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <stdexcept>

#include "bench/peers/cgal_mesh.h"
#include "bench/peers/nef_algebra.h"
#include "bench/peers/peer.h"

namespace cnrg::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = nef::Set;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh mesh_of(const TriangleMesh& in) {
  Mesh mesh;
  for (const auto& p : in.points) mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  if (!(in.polygons.empty() ? add_polygons(mesh, in.triangles) : add_polygons(mesh, in.polygons)))
    throw std::runtime_error("a mesh is no 2-manifold");
  return mesh;
}

Nef united(std::vector<Nef>& operands, std::size_t first) {
  if (operands.size() == first + 2) return operands[first] + operands[first + 1];
  CGAL::Nef_nary_union_3<Nef> all;
  for (std::size_t i = first; i < operands.size(); ++i) all.add_polyhedron(operands[i]);
  return all.get_union();
}

/// The sum of cones from the origin over the sides of the marked volumes. A side is the fan of its loops from one
/// of its points; holes run the other way round.
Rational volume_of(const Nef& nef) {
  std::vector<Rational> six_times;
  for (auto f = nef.halffacets_begin(); f != nef.halffacets_end(); ++f) {
    if (!f->incident_volume()->mark()) continue;
    std::optional<Kernel::Point_3> apex;
    for (auto loop = f->facet_cycles_begin(); loop != f->facet_cycles_end(); ++loop) {
      if (!loop.is_shalfedge()) continue;
      Nef::SHalfedge_around_facet_const_circulator at{Nef::SHalfedge_const_handle(loop)}, end(at);
      do {
        const Kernel::Point_3 p = at->source()->source()->point(), q = at->next()->source()->source()->point();
        if (!apex) apex = p;
        six_times.push_back(
            rational_of(CGAL::exact(CGAL::determinant(*apex - CGAL::ORIGIN, p - CGAL::ORIGIN, q - CGAL::ORIGIN))));
      } while (++at != end);
    }
  }
  return abs(sum(std::move(six_times))) / 6;
}

Nef at_once(const Case& c, std::vector<Nef>& operands) {
  if (c.operation == Operation::unite) return united(operands, 0);
  return operands.size() == 2 ? operands[0] - operands[1] : operands[0] - united(operands, 1);
}

Nef one_by_one(const Case& c, std::vector<Nef>& operands) {
  Nef result = operands[0];
  for (std::size_t i = 1; i < operands.size(); ++i) {
    if (c.operation == Operation::unite) result += operands[i];
    else result -= operands[i];
  }
  return result;
}

Outcome evaluate_by(const Case& c, const Checks& checks, Nef (*combine)(const Case&, std::vector<Nef>&)) {
  std::vector<Mesh> meshes;
  for (const TriangleMesh& leaf : c.leaves) meshes.push_back(mesh_of(leaf));
  Measurement measurement;
  std::vector<Nef> operands;
  for (const Mesh& mesh : meshes) operands.emplace_back(mesh);
  measurement.lap("conversion");
  const Nef result = combine(c, operands);
  measurement.lap("Boolean");

  Outcome outcome;
  outcome.measures = measurement.stop();
  outcome.vertices = result.number_of_vertices();
  outcome.faces = result.number_of_facets();
  outcome.note = "exact";
  if (checks.volume) {
    const Rational volume = volume_of(result);
    outcome.volume = to_double(volume);
    outcome.exact_volume = cnrg::to_string(volume);
  }
  return outcome;
}

}  // namespace

Outcome evaluate_nef(const Case& c, const Checks& checks, int) { return evaluate_by(c, checks, at_once); }
Outcome evaluate_nef_one_by_one(const Case& c, const Checks& checks, int) {
  return evaluate_by(c, checks, one_by_one);
}

}  // namespace cnrg::bench

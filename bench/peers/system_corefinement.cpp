// CGAL's corefinement of triangle meshes: exact predicates, points rounded to doubles after each step.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include "bench/peers/built_in.h"
#include "bench/peers/closed_surface.h"

namespace cnrg::bench {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using InexactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using InexactMesh = CGAL::Surface_mesh<InexactKernel::Point_3>;

InexactMesh checked_mesh(const Model& model) {
  if (!model.solid()) throw Refusal("input", "an operand is no solid");
  const auto rounded = [](const RationalPoint& p) {
    return InexactKernel::Point_3(to_double(p[0]), to_double(p[1]), to_double(p[2]));
  };
  InexactMesh mesh = triangulated(closed_surface<InexactMesh>(model, rounded));
  for (const auto f : mesh.faces())
    if (processing::is_degenerate_triangle_face(f, mesh))
      throw Refusal("input", "an operand has a face without area");
  if (processing::does_self_intersect(mesh)) throw Refusal("input", "an operand intersects or touches itself");
  if (!processing::does_bound_a_volume(mesh)) throw Refusal("input", "an operand bounds no volume");
  return mesh;
}

Model model_of_mesh(const InexactMesh& mesh) {
  Model model;
  std::vector<std::uint32_t> number(mesh.num_vertices());
  for (const auto v : mesh.vertices()) {
    number[v] = static_cast<std::uint32_t>(model.points.size());
    const InexactKernel::Point_3& p = mesh.point(v);
    model.points.push_back({from_double(p.x()), from_double(p.y()), from_double(p.z())});
  }
  for (const auto f : mesh.faces()) {
    PointLoop loop;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) loop.push_back(number[v]);
    model.faces.push_back({{std::move(loop)}, true});
  }
  return model;
}

bool combine(Operation operation, InexactMesh& a, InexactMesh& b) {
  const auto check = CGAL::parameters::throw_on_self_intersection(true);
  switch (operation) {
    case Operation::unite: return processing::corefine_and_compute_union(a, b, a, check, check);
    case Operation::intersect: return processing::corefine_and_compute_intersection(a, b, a, check, check);
    default: return processing::corefine_and_compute_difference(a, b, a, check, check);
  }
}

Answer answer_of_corefinement(const Problem& problem) {
  std::vector<InexactMesh> meshes;
  try {
    for (const Model& operand : problem.operands) meshes.push_back(checked_mesh(operand));
  } catch (const CGAL::Failure_exception& error) {
    throw Refusal("input", words_of(error));
  }
  Measurement measurement;
  InexactMesh& result = meshes[0];
  for (std::size_t i = 0; i < problem.steps.size(); ++i) {
    const std::string step = "step " + std::to_string(i + 1) + ": ";
    try {
      if (!combine(problem.steps[i], result, meshes[i + 1]))
        throw Refusal("output", step + "the result is no 2-manifold");
    } catch (const processing::Corefinement::Self_intersection_exception&) {
      throw Refusal("refinement", step + "an operand intersects itself");
    } catch (const CGAL::Failure_exception& error) {
      throw Refusal("refinement", step + words_of(error));
    }
  }
  measurement.lap("Boolean");
  Answer answer;
  answer.measures = measurement.stop();
  // It may say that it is done and leave faces in the mesh whose sides do not fit to each other.
  if (!CGAL::is_valid_polygon_mesh(result)) throw Refusal("output", "done, but the result is no valid mesh");
  answer.model = model_of_mesh(result);
  return answer;
}

}  // namespace

System corefinement_system() {
  return {.name = "corefinement",
          .title = "CGAL corefinement",
          .guarantee =
              "closed 2-manifolds that do not intersect themselves; exact predicates, points rounded to "
              "doubles; refuses what is no 2-manifold",
          .version = [] { return std::string("CGAL ") + CGAL_VERSION_STR; },
          .rounding = 0x1p-50,
          .regularized = true,
          .absent = "",
          .evaluate = answer_of_corefinement,
          .asserted = true};
}

}  // namespace cnrg::bench

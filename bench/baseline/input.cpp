// Operands into half-edge structures: what is no planar, orientable, closed 2-manifold stops here.
#include <algorithm>
#include <cmath>

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

template <class N>
N number(const Rational& x) {
  if constexpr (std::is_floating_point_v<N>) return to_double(x);
  else return x;
}

[[noreturn]] void refuse(int solid, const std::string& what) {
  throw Failure(Stage::input, std::string("operand ") + (solid == 0 ? "A: " : "B: ") + what);
}

template <class N>
Plane<N> plane_of(const Metric<N>& metric, const std::vector<std::vector<Vec<N>>>& loops, int solid, bool checks) {
  Plane<N> plane;
  plane.normal = polygon_normal(loops[0]);
  if constexpr (std::is_floating_point_v<N>) {
    const N size = std::sqrt(dot(plane.normal, plane.normal));
    if (!(size > metric.length * metric.length)) refuse(solid, "a face without area");
    plane.normal = plane.normal * N(1 / size);
    plane.offset = 0;
    for (const Vec<N>& p : loops[0]) plane.offset += dot(plane.normal, p) / N(loops[0].size());
  } else {
    if (metric.null_length(plane.normal)) refuse(solid, "a face without area");
    plane.offset = dot(plane.normal, loops[0][0]);
  }
  for (const auto& loop : loops)
    for (const Vec<N>& p : loop)
      if (checks && metric.side(plane, p) != 0) refuse(solid, "a face that is not planar");
  return plane;
}

template <class N>
void read_operand(Scene<N>& scene, const Model& model, int solid) {
  if (!model.solid()) refuse(solid, "surfaces, wires or points by themselves: no closed 2-manifold");
  std::vector<Vec<N>> points;
  for (const RationalPoint& p : model.points)
    points.push_back({number<N>(p[0]), number<N>(p[1]), number<N>(p[2])});
  std::vector<std::vector<std::vector<std::uint32_t>>> faces;
  for (const Model::Face& face : model.faces) faces.push_back(face.loops);
  const auto first_surface = static_cast<std::uint32_t>(scene.surfaces.size());
  std::vector<VertexId> vertices;
  try {
    vertices = scene.topology.assemble(faces, points.size(), first_surface, static_cast<std::uint32_t>(solid));
    scene.topology.validate();
  } catch (const TopologyError& error) {
    refuse(solid, error.what());
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (vertices[k] != kNo<VertexId>) scene.place(vertices[k], points[k]);
  Boundary<N>& boundary = scene.boundaries[solid];
  N volume = 0;
  for (const auto& face : faces) {
    boundary.loops.emplace_back();
    for (const auto& loop : face) {
      boundary.loops.back().emplace_back();
      for (const std::uint32_t p : loop) boundary.loops.back().back().push_back(points[p]);
      const auto& polygon = boundary.loops.back().back();
      volume += dot(polygon_normal(polygon), polygon[0]);
    }
    boundary.planes.push_back(plane_of(scene.metric, boundary.loops.back(), solid, scene.departures.checks));
    scene.surfaces.push_back(boundary.planes.back());
  }
  if (scene.departures.checks && !faces.empty() && !(volume > 0))
    refuse(solid, "encloses no volume: its faces look inward");
}

}  // namespace

template <class N>
Scene<N> read_operands(const Model& a, const Model& b, Operation operation, const N& epsilon,
                       const Departures& departures) {
  Scene<N> scene;
  scene.operation = operation;
  scene.departures = departures;
  scene.extent = 1e-300;
  for (const Model* model : {&a, &b})
    for (const RationalPoint& p : model->points)
      for (const Rational& x : p) scene.extent = std::max(scene.extent, std::fabs(to_double(x)));
  // Products of three coordinates have to be finite.
  if (!(scene.extent < 1e100)) throw Failure(Stage::input, "a coordinate above 1e100");
  scene.metric.unit = epsilon;
  if constexpr (std::is_floating_point_v<N>) scene.metric.length = epsilon * scene.extent;
  else scene.metric.length = 0;
  read_operand(scene, a, 0);
  read_operand(scene, b, 1);
  return scene;
}

template Scene<double> read_operands(const Model&, const Model&, Operation, const double&, const Departures&);
template Scene<Rational> read_operands(const Model&, const Model&, Operation, const Rational&, const Departures&);

}  // namespace cnrg::bench::mantyla

// Points against a boundary, for shells that the intersection curve does not reach: the book leaves them to the
// reader (problem 15.1). The parity of a ray's crossings decides; a ray that meets an edge, a vertex or runs in a
// face is given up for the next of a fixed list of directions.

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

enum class RayResult : std::uint8_t { in, out, on, undecided };

template <class N>
std::vector<Segment<N>> segments_of(const std::vector<std::vector<Vec<N>>>& loops) {
  std::vector<Segment<N>> segments;
  for (const auto& loop : loops)
    for (std::size_t k = 0; k < loop.size(); ++k) segments.push_back({&loop[k], &loop[(k + 1) % loop.size()]});
  return segments;
}

template <class N>
RayResult shoot(const Metric<N>& metric, const Boundary<N>& boundary, const Vec<N>& p, const Vec<N>& direction,
                Vec<N>& normal) {
  bool inside = false;
  for (std::size_t f = 0; f < boundary.planes.size(); ++f) {
    const Plane<N>& plane = boundary.planes[f];
    const N height = metric.distance(plane, p), slope = dot(plane.normal, direction);
    const int side = metric.length_sign(height);
    if (side == 0) {
      const Where where = locate(metric, plane.normal, segments_of(boundary.loops[f]), p).where;
      if (where == Where::outside) {
        if (metric.unit_sign(slope) == 0) return RayResult::undecided;
        continue;
      }
      normal = plane.normal;
      return RayResult::on;
    }
    if (metric.unit_sign(slope) == 0 || (slope > 0) == (side > 0)) continue;
    const Vec<N> hit = p - direction * N(height / slope);
    const Where where = locate(metric, plane.normal, segments_of(boundary.loops[f]), hit).where;
    if (where == Where::on_edge || where == Where::on_vertex) return RayResult::undecided;
    if (where == Where::inside) inside = !inside;
  }
  return inside ? RayResult::in : RayResult::out;
}

/// A corner that sticks out of the polygon: the least in the order of the two coordinates that are seen.
template <class N>
std::size_t least_corner(const std::vector<Vec<N>>& polygon, int x, int y) {
  std::size_t least = 0;
  for (std::size_t k = 1; k < polygon.size(); ++k)
    if (polygon[k][x] < polygon[least][x] ||
        (polygon[k][x] == polygon[least][x] && polygon[k][y] < polygon[least][y]))
      least = k;
  return least;
}

}  // namespace

template <class N>
Vec<N> inner_point(const Vec<N>& normal, const std::vector<std::vector<Vec<N>>>& loops) {
  const int axis = dominant_axis(normal), x = (axis + 1) % 3, y = (axis + 2) % 3;
  const auto turn = [&](const Vec<N>& a, const Vec<N>& b, const Vec<N>& c) {
    return N((b[x] - a[x]) * (c[y] - a[y]) - (b[y] - a[y]) * (c[x] - a[x]));
  };
  const auto& outer = loops.front();
  const std::size_t k = least_corner(outer, x, y);
  const Vec<N>&p = outer[(k + outer.size() - 1) % outer.size()], &v = outer[k], &q = outer[(k + 1) % outer.size()];
  const N whole = turn(p, v, q);
  const auto within = [&](const N& t) { return whole > 0 ? t >= 0 : t <= 0; };
  const Vec<N>* deepest = nullptr;  // of the corners in the triangle, the one farthest from p q
  N depth = 0;
  for (const auto& loop : loops)
    for (const Vec<N>& c : loop) {
      if (c == p || c == v || c == q) continue;
      if (!within(turn(p, v, c)) || !within(turn(v, q, c)) || !within(turn(q, p, c))) continue;
      N d = turn(q, p, c);
      if (d < 0) d = -d;
      if (deepest == nullptr || d > depth) {
        deepest = &c;
        depth = d;
      }
    }
  if (deepest != nullptr) return (v + *deepest) * N(N(1) / N(2));
  return (p + v + q) * N(N(1) / N(3));
}

template <class N>
Side locate_point(const Metric<N>& metric, const Boundary<N>& boundary, const Vec<N>& p, Vec<N>& normal) {
  std::uint64_t state = 1;
  const auto component = [&state] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return N(static_cast<long>((state >> 40) % 20011) - 10005);
  };
  for (int tries = 0; tries < 64; ++tries) {
    const Vec<N> direction = {component(), component(), component()};
    switch (shoot(metric, boundary, p, Metric<N>::direction(direction), normal)) {
      case RayResult::in: return Side::in;
      case RayResult::out: return Side::out;
      case RayResult::on: return Side::on;
      case RayResult::undecided: break;
    }
  }
  throw Failure(Stage::finishing, "no ray says on which side a shell lies");
}

template Vec<double> inner_point(const Vec<double>&, const std::vector<std::vector<Vec<double>>>&);
template Vec<Rational> inner_point(const Vec<Rational>&, const std::vector<std::vector<Vec<Rational>>>&);
template Side locate_point(const Metric<double>&, const Boundary<double>&, const Vec<double>&, Vec<double>&);
template Side locate_point(const Metric<Rational>&, const Boundary<Rational>&, const Vec<Rational>&,
                           Vec<Rational>&);

}  // namespace cnrg::bench::mantyla

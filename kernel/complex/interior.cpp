// A face's interior point is exact; from there one goes into the region, by less and less until the region holds
// the point.
#include "kernel/complex/interior.h"

#include <algorithm>
#include <cmath>

namespace cnrg {
namespace {

/// A multiple of 10^-k nearest to `value`, 10^-k the largest power that is at most `step` > 0.
Rational rounded(double value, double step) {
  Rational power = 1;
  while (to_double(power) > step) power /= 10;
  while (to_double(power * 10) <= step) power *= 10;
  const Rational scaled = from_double(value) / power + Rational(1, 2);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return Rational(whole) * power;
}

}  // namespace

std::array<Integer, 3> shortest_normal(const Complex& complex, HalfFace side) {
  const ExactPlane& plane = complex.points.exact_plane(complex.plane(side.face()));
  Integer divisor = gcd(gcd(plane.a, plane.b), plane.c);
  if (side.side() != 0) divisor = -divisor;
  return {plane.a / divisor, plane.b / divisor, plane.c / divisor};
}

RationalPoint interior_point(const Complex& complex, const Locator& locator, RegionId r) {
  if (complex.region_faces[r].empty()) {  // space with nothing but wires and points in it
    Rational beyond = 0;
    for (const VertexId v : complex.vertices) beyond = std::max(beyond, complex.points.rational(v)[0]);
    return {beyond + 1, 0, 0};
  }
  const HalfFace h = complex.region_faces[r].front();
  const RationalPoint base = interior_point(complex, h.face()).rational();
  const std::array<Integer, 3> n = shortest_normal(complex, h);
  std::array<double, 3> direction;
  const Integer size = abs(n[0]) + abs(n[1]) + abs(n[2]);
  double norm = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    direction[k] = to_double(Rational(n[k], size));
    norm += direction[k] * direction[k];
  }
  double reach = 1;
  for (const HalfEdge e : complex.loop[complex.face_loops[h.face()].front()]) {
    const auto p = complex.points.approx(complex.origin(e));
    for (std::size_t k = 0; k < 3; ++k) reach = std::max(reach, std::abs(p[k] - to_double(base[k])));
  }
  constexpr int kShort = 50;  // halvings, after which doubles do not tell the point from the face
  for (int attempt = 0; attempt < kShort; ++attempt, reach /= 2) {
    RationalPoint p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = rounded(to_double(base[k]) + direction[k] / std::sqrt(norm) * reach, reach / 2);
    }
    const Location at = locator.locate(p);
    if (at.dimension == 3 && at.region == r) return p;
  }
  // A thin region: exactly along the normal, by steps that shrink faster and faster. `base` is in the open face,
  // so all points near enough are in the region.
  Rational step(1, size);
  for (Rational shrink(1, 2);; shrink *= shrink) {
    step *= shrink;
    RationalPoint p{base[0] + step * n[0], base[1] + step * n[1], base[2] + step * n[2]};
    const Location at = locator.locate(p);
    if (at.dimension == 3 && at.region == r) return p;
  }
}

bool beyond_frame(const Complex& complex, const Location& at) {
  switch (at.dimension) {
    case 0: return complex.on_frame(at.vertex);
    case 1: return complex.on_frame(at.edge);
    case 2: return complex.on_frame(at.face);
    default: return complex.outside_frame(at.region);
  }
}

}  // namespace cnrg

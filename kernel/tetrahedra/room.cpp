#include "kernel/tetrahedra/room.h"

#include <cmath>

#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

/// Places on a line that are looked at for a double, on both sides of the middle.
constexpr int kPlaces = 40;

}  // namespace

Rational rounded(const Rational& x, unsigned bits) {
  const Integer scale = Integer(1) << bits;
  Integer n;
  const Rational scaled = x * scale + Rational(1, 2);
  mpz_fdiv_q(n.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  Rational out(n, scale);
  out.canonicalize();
  return out;
}

std::array<std::array<double, 3>, 7> with_neighbours(const std::array<double, 3>& p) {
  std::array<std::array<double, 3>, 7> out;
  out.fill(p);
  for (std::size_t k = 0; k < 3; ++k) {
    out[2 * k + 1][k] = std::nextafter(p[k], -HUGE_VAL);
    out[2 * k + 2][k] = std::nextafter(p[k], HUGE_VAL);
  }
  return out;
}

VertexId Room::near_double(VertexId v) {
  if (points_.is_double(v)) return v;
  const auto [x, y, z] = points_.nearest(v);
  const VertexId w = points_.add(x, y, z);
  tetrahedra_.around(v, star_);
  return tetrahedra_.sees(w, star_) ? w : VertexId::none();
}

/// From where to where, as parts of `way`.
std::optional<std::array<Rational, 2>> Room::free_part(VertexId v, const RationalPoint& way) {
  tetrahedra_.around(v, star_);
  const RationalPoint at = points_.rational(v);
  std::optional<Rational> low, high;
  for (const Tetrahedra::Index t : star_) {
    const auto [a, b, c] = tetrahedra_.face({t, tetrahedra_.place(t, v)});
    const RationalPoint p = points_.rational(a), normal = cross(points_.rational(b) - p, points_.rational(c) - p);
    const Rational slope = dot(normal, way);
    if (slope == 0) continue;
    const Rational end = -dot(normal, at - p) / slope;
    if (slope > 0 && (!low || end > *low)) low = end;
    if (slope < 0 && (!high || end < *high)) high = end;
  }
  if (!low || !high) return std::nullopt;
  return std::array{*low, *high};
}

VertexId Room::middle(VertexId v, const RationalPoint& way) {
  const auto part = free_part(v, way);
  if (!part) return VertexId::none();
  const auto& [low, high] = *part;
  const Rational middle = (low + high) / 2, near = (high - low) / 8;
  if (abs(middle) < near) return VertexId::none();
  for (const unsigned bits : kPlaceBits) {
    const Rational step = rounded(middle, bits);
    if (abs(Rational(step - middle)) < near) return points_.add(points_.rational(v) + step * way);
  }
  return VertexId::none();
}

/// Between faces that are one plane but for the last digits there is room for one double and not for the next.
VertexId Room::far_double(VertexId v, std::span<const RationalPoint> ways) {
  const RationalPoint at = points_.rational(v);
  for (const RationalPoint& way : ways) {
    const auto part = free_part(v, way);
    if (!part) continue;
    const auto& [low, high] = *part;
    for (int i = 1; i <= kPlaces; ++i) {
      const int place = i % 2 == 0 ? kPlaces + i : kPlaces - i;  // from the middle on
      const RationalPoint exact = at + Rational(low + (high - low) * place / (2 * kPlaces + 1)) * way;
      for (const auto& q : with_neighbours(to_doubles(exact))) {
        const VertexId w = points_.add(q[0], q[1], q[2]);
        if (tetrahedra_.sees(w, star_)) return w;
      }
    }
  }
  return VertexId::none();
}

}  // namespace cnrg

// The frame: how far planes and half-spaces are drawn.
#include "csg/leaves/unbounded.h"

#include <algorithm>

#include "csg/leaves/prepare_shapes.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

void extend(ExactBox& box, bool& empty, const RationalPoint& p) {
  if (empty) box = {p, p};
  empty = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] < box.low[k]) box.low[k] = p[k];
    if (p[k] > box.high[k]) box.high[k] = p[k];
  }
}

/// Primitive integer coefficients, the first one that is not zero positive: equal for equal planes.
std::array<Integer, 4> canonical(const ExactHalfspace& plane) {
  Integer denominator = plane.offset.get_den();
  for (const Rational& x : plane.normal) denominator = lcm(denominator, x.get_den());
  std::array<Integer, 4> c;
  Integer common = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Rational x = (k < 3 ? plane.normal[k] : plane.offset) * denominator;
    c[k] = x.get_num();
    common = gcd(common, c[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (c[k] == 0) continue;
    if (c[k] < 0) common = -common;
    break;
  }
  for (Integer& x : c) x /= common;
  return c;
}

/// The point of plane ∩ plane' that is nearest to the origin; the normals are not parallel.
RationalPoint nearest_of_line(const ExactHalfspace& p, const ExactHalfspace& q, const RationalPoint& direction) {
  const RationalPoint sum = p.offset * cross(q.normal, direction) + q.offset * cross(direction, p.normal);
  return Rational(1 / dot(direction, direction)) * sum;
}

Rational power_of_two(int exponent) {
  const Rational one = 1;
  return exponent >= 0 ? Rational(one << static_cast<mp_bitcnt_t>(exponent))
                       : Rational(one >> static_cast<mp_bitcnt_t>(-exponent));
}

/// The largest multiple of `unit` (a power of two) not above `value`: corners of the frame are short doubles so.
Rational floor_to(const Rational& value, const Rational& unit) {
  const Rational scaled = value / unit;
  Integer q;
  mpz_fdiv_q(q.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
  return q * unit;
}

}  // namespace

UnboundedLeaf::UnboundedLeaf(const RationalPoint& point, const RationalPoint& normal, bool solid)
    : point_(point), normal_(normal), solid_(solid) {}

LeafId UnboundedLeaf::add_to(Soup& soup, const Transform&) const {
  return soup.add_leaf(solid_ ? Fill::sides : Fill::none);
}

std::vector<Attributes> UnboundedLeaf::regions() const { return std::vector<Attributes>(solid_ ? 1 : 0); }

ExactHalfspace UnboundedLeaf::image(const Transform& transform) const {
  // Normals go with the matrix of cofactors, which is the inverse transpose times the determinant.
  const auto& m = transform.linear;
  const std::array<RationalPoint, 3> cofactors{cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  RationalPoint normal{dot(cofactors[0], normal_), dot(cofactors[1], normal_), dot(cofactors[2], normal_)};
  if (transform.determinant() < 0) normal = Rational(-1) * normal;
  const std::array<Integer, 3> primitive = primitive_direction(normal);
  ExactHalfspace plane{{primitive[0], primitive[1], primitive[2]}, 0};
  plane.offset = dot(plane.normal, transform.apply(point_));
  return plane;
}

ExactBox frame_box(const ExactBox* points, const std::vector<ExactHalfspace>& given) {
  std::vector<ExactHalfspace> planes;
  std::vector<std::array<Integer, 4>> keys;
  for (const ExactHalfspace& plane : given) {
    const std::array<Integer, 4> key = canonical(plane);
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
    keys.push_back(key);
    planes.push_back(plane);
  }
  ExactBox box;
  bool empty = true;
  if (points) {
    extend(box, empty, points->low);
    extend(box, empty, points->high);
  }
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const ExactHalfspace& p = planes[i];
    extend(box, empty, Rational(p.offset / dot(p.normal, p.normal)) * p.normal);
    for (std::size_t j = 0; j < i; ++j) {
      const ExactHalfspace& q = planes[j];
      const RationalPoint line = cross(p.normal, q.normal);
      if (is_zero(line)) continue;
      extend(box, empty, nearest_of_line(p, q, line));
      for (std::size_t k = 0; k < j; ++k) {
        const ExactHalfspace& r = planes[k];
        const Rational determinant = dot(line, r.normal);
        if (determinant == 0) continue;
        const RationalPoint sum =
            r.offset * line + p.offset * cross(q.normal, r.normal) + q.offset * cross(r.normal, p.normal);
        extend(box, empty, Rational(1 / determinant) * sum);
      }
    }
  }
  require(!empty, "frame_box: nothing to frame");
  // A margin of about the extent (at least 1), on a grid of a 64th of it.
  Rational extent = 1;
  for (std::size_t k = 0; k < 3; ++k) extent = std::max(extent, Rational(box.high[k] - box.low[k]));
  const Rational margin = power_of_two(exponent_of_root(extent * extent) + 1);
  const Rational unit = margin / 64;
  for (std::size_t k = 0; k < 3; ++k) {
    box.low[k] = floor_to(box.low[k] - margin, unit);
    box.high[k] = -floor_to(-box.high[k] - margin, unit);
  }
  // The corner moves along t -> (t, t^2, t^3), which meets any plane at most three times: this ends.
  const RationalPoint corner = box.high;
  for (Rational t = 1;; ++t) {
    const bool clear = std::none_of(planes.begin(), planes.end(),
                                    [&](const ExactHalfspace& p) { return dot(p.normal, box.high) == p.offset; });
    if (clear) return box;
    box.high = corner + Rational(unit) * RationalPoint{t, t * t, t * t * t};
  }
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const PlaneShape& shape) {
  if (is_zero(shape.normal)) throw LeafKeyError("normal", "plane: the normal is [0, 0, 0]: give a direction");
  return std::make_unique<UnboundedLeaf>(shape.point, shape.normal, false);
}

std::unique_ptr<PreparedLeaf> prepare_leaf(const HalfspaceShape& shape) {
  if (is_zero(shape.normal)) throw LeafKeyError("normal", "halfspace: the normal is [0, 0, 0]: give a direction");
  return std::make_unique<UnboundedLeaf>(shape.point, shape.normal, true);
}

}  // namespace cnrg

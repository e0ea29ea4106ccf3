// Orthogonal integer frames and circles in them.
#include "csg/geometry/circle.h"

#include <cstdint>

#include "csg/geometry/transform.h"
#include "kernel/base/parallel.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/trigonometry.h"

namespace cnrg {
namespace {

RationalPoint primitive(const RationalPoint& v) {
  const std::array<Integer, 3> p = primitive_direction(v);
  return {p[0], p[1], p[2]};
}

}  // namespace

std::optional<Rational> rational_root(const Rational& square) {
  if (mpz_perfect_square_p(square.get_num_mpz_t()) == 0 || mpz_perfect_square_p(square.get_den_mpz_t()) == 0)
    return std::nullopt;
  return Rational(sqrt(square.get_num()), sqrt(square.get_den()));
}

Rational root(const Rational& square) {
  if (const std::optional<Rational> exact = rational_root(square)) return *exact;
  return round_cosine(0, square, exponent_of_root(square) - 60);
}

Rational scaled_cosine(const Rational& degrees, const Rational& square) {
  if (const std::optional<Rational> exact = rational_root(square)) return *exact * round_cosine(degrees, 1, -52);
  return round_cosine(degrees, square, exponent_of_root(square) - 51);
}

CircleFrame::CircleFrame(const RationalPoint& axis) : axis_(primitive(axis)) {
  // The unit vector that is farthest from the axis gives e1, except that the z axis starts at x, x at y, y at z.
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(axis_[i]) < abs(axis_[k])) k = i;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (axis_[(i + 1) % 3] == 0 && axis_[(i + 2) % 3] == 0) parallel_ = i;
  }
  RationalPoint unit{0, 0, 0};
  if (parallel_ < 3) {
    unit[(parallel_ + 1) % 3] = 1;
    e1_ = unit;
  } else {
    unit[k] = 1;
    e1_ = primitive(cross(unit, axis_));
  }
  e2_ = primitive(cross(axis_, e1_));
}

std::pair<RationalPoint, RationalPoint> CircleFrame::components(const Rational& radius,
                                                                const Rational& degrees) const {
  const Rational square1 = radius * radius / dot(e1_, e1_), square2 = radius * radius / dot(e2_, e2_);
  const int grid1 = exponent_of_root(square1) - 51, grid2 = exponent_of_root(square2) - 51;
  return {round_cosine(degrees, square1, grid1) * e1_, round_cosine(90 - degrees, square2, grid2) * e2_};
}

RationalPoint CircleFrame::offset(const Rational& radius, const Rational& degrees) const {
  const auto [first, second] = components(radius, degrees);
  return first + second;
}

RationalPoint CircleFrame::turned(const Rational& degrees) const {
  return Transform::rotation(axis_, degrees, {0, 0, 0}).apply_to_vector(offset(1, 0));
}

std::vector<RationalPoint> CircleFrame::offsets(const Rational& radius, int segments) const {
  const auto n = static_cast<std::size_t>(segments);
  std::vector<RationalPoint> result(n);
  // The second half mirrors the first: cosines agree, sines change sign.
  for_each_index(
      n / 2 + 1,
      [&](std::size_t i) {
        const auto [first, second] = components(radius, fraction(360 * static_cast<std::int64_t>(i), segments));
        if (i < n) result[i] = first + second;
        if (i > 0) result[n - i] = first - second;
      },
      64);
  return result;
}

Rational rounded_for(const Rational& value, const Rational& size) {
  if (abs(value) > 65536 * size) return value;
  return from_double(to_double(value));
}

}  // namespace cnrg

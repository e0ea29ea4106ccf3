#include "bench/cases/touching.h"

namespace cnrg::bench {
namespace {

Rational sixteenths(int low, int high, Random& random) { return Rational(random.integer(low, high)) / 16; }

/// Never 1: what moves by 1 meets no other end.
Rational height(Side side, Random& random) {
  return side == Side::below ? sixteenths(20, 26, random) : sixteenths(28, 34, random);
}

AffineMap own_shear(Side side, Random& random) {
  const int least = side == Side::below ? 2 : 9;
  const auto part = [&]() -> Rational {
    return Rational((random.integer(0, 1) == 0 ? 1 : -1) * random.integer(least, least + 5)) / 128;
  };
  const Rational a = part(), b = part();
  return shear(a, b);
}

}  // namespace

Model slab(const Polygon& end, Side side, Random& random) {
  const Rational flare = random.integer(0, 1) == 0 ? sixteenths(10, 14, random) : sixteenths(18, 22, random);
  const Rational reach = height(side, random);
  const Polygon other = scaled(end, flare);
  const AffineMap map = own_shear(side, random);
  if (side == Side::below) return mapped(frustum(other, -reach, end, 0), map);
  return mapped(frustum(end, 0, other, reach), map);
}

Model ridge(std::size_t corners, const Rational& low, const Rational& high, Side side, Random& random) {
  // The section in coordinates (z, x): the first corner at the origin, the others below.
  const Polygon section = scaled(random_polygon(corners, random), 1, {-1, 0});
  const Polygon other = scaled(section, sixteenths(10, 14, random));
  AffineMap upright;
  upright.rows = {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
  Model model = mapped(frustum(section, low, other, high), upright);
  if (side == Side::above) model = mapped(std::move(model), rotation({0, 0, 1, 0}));
  return mapped(std::move(model), own_shear(side, random));
}

Model spike(std::size_t corners, Side side, Random& random) {
  const Rational reach = height(side, random);
  const Rational base = side == Side::below ? Rational(-reach) : reach;
  return mapped(pyramid(random_polygon(corners, random), base, {0, 0, 0}), own_shear(side, random));
}

Polygon part_inside(std::size_t corners, Random& random) {
  const Rational x = Rational(random.integer(-8, 8)) / 128, y = Rational(random.integer(-8, 8)) / 128;
  return scaled(random_polygon(corners, random), Rational(1, 4), {x, y});
}

Polygon part_across(std::size_t corners, Random& random) {
  const Rational x = Rational(random.integer(80, 96)) / 128, y = Rational(random.integer(16, 32)) / 128;
  return scaled(random_polygon(corners, random), Rational(3, 4), {x, y});
}

Polygon part_at_edge(const Polygon& polygon) {
  const auto& [a, b] = polygon[0];
  const auto& [c, d] = polygon[1];
  return scaled(polygon, Rational(1, 2), {(a + c) / 4, (b + d) / 4});
}

}  // namespace cnrg::bench

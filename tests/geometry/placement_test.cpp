// Products of integer matrices against products of fractions.
#include "csg/geometry/placement.h"

#include <random>

#include "tests/catch.h"

namespace cnrg {
namespace {

Rational random_fraction(std::mt19937& random) {
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  Rational value(number(-9, 9), number(1, 9));
  value.canonicalize();
  return value;
}

Transform random_step(std::mt19937& random) {
  const auto point = [&] {
    return RationalPoint{random_fraction(random), random_fraction(random), random_fraction(random)};
  };
  const RationalPoint a = point();
  const bool has_direction = a != RationalPoint{0, 0, 0};
  switch (random() % 4) {
    case 0: return Transform::translation(a);
    case 1: return a[0] != 0 && a[1] != 0 && a[2] != 0 ? Transform::scaling(a) : Transform();
    case 2: return has_direction ? Transform::rotation(a, random_fraction(random), point()) : Transform();
    default: return has_direction ? Transform::reflection(a, point()) : Transform();
  }
}

TEST_CASE("a product of placements is the product of their transforms", "[placement][random]") {
  std::mt19937 random(1);
  for (int scene = 0; scene < 50; ++scene) {
    Transform expected;
    Placement product;
    for (int i = 0; i < 6; ++i) {
      const Transform step = random_step(random);
      expected = expected * step;
      product = product * Placement(step);
      REQUIRE(product.transform() == expected);
      // Equal maps are equal placements, whichever way they came about.
      const Placement other(expected);
      CHECK_FALSE((product < other || other < product));
    }
  }
}

TEST_CASE("what cancels in a product of placements is gone", "[placement]") {
  const Transform turn = Transform::rotation({1, 2, 3}, 17, {1, 1, 1});
  Placement product;
  for (int i = 0; i < 20; ++i) product = product * Placement(turn);
  CHECK(product.bits() > 20 * Placement(turn).bits() / 2);
  for (int i = 0; i < 20; ++i) product = product * Placement(turn.inverse());
  CHECK(product.bits() == 1);
  CHECK(product.transform().identity());
}

}  // namespace
}  // namespace cnrg

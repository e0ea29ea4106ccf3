// Transforms are exact; orientation survives reflections.
#include <random>

#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

Rational r(const char* text) { return *parse_rational(text); }

bool orthogonal(const Transform& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (dot(t.linear[i], t.linear[j]) != (i == j ? 1 : 0)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("rotations are exactly orthogonal and keep their axis and centre") {
  std::mt19937 random(11);
  for (int i = 0; i < 100; ++i) {
    const auto number = [&] { return Rational(static_cast<long>(random() % 2001) - 1000, 100); };
    RationalPoint axis{number(), number(), number()};
    for (Rational& x : axis) x.canonicalize();
    axis[0] += r("1/1000");
    Rational degrees = number() * 50;
    degrees.canonicalize();
    const RationalPoint center{1, r("-2/7"), 3};
    const Transform t = Transform::rotation(axis, degrees, center);
    REQUIRE(orthogonal(t));
    REQUIRE(t.determinant() == 1);
    REQUIRE(t.apply(center) == center);
    REQUIRE(t.apply(center + axis) == center + axis);
    REQUIRE((Transform::rotation(axis, -degrees, center) * t).identity());
    // trace = 1 + 2 cos
    const Rational trace = t.linear[0][0] + t.linear[1][1] + t.linear[2][2];
    REQUIRE(std::abs(to_double(trace) - 1 - 2 * std::cos(to_double(degrees) * 3.14159265358979323846 / 180)) <
            1e-13);
  }
}

TEST_CASE("right angles are exact and turn by the right-hand rule") {
  const Transform z = Transform::rotation({0, 0, r("0.1")}, 90, {0, 0, 0});
  CHECK(z.apply({1, 0, 0}) == RationalPoint{0, 1, 0});
  CHECK(z.apply({0, 1, 5}) == RationalPoint{-1, 0, 5});
  CHECK(Transform::rotation({1, 0, 0}, 90, {0, 0, 0}).apply({0, 1, 0}) == RationalPoint{0, 0, 1});
  CHECK(Transform::rotation({0, 1, 0}, -270, {0, 0, 0}).apply({0, 0, 1}) == RationalPoint{1, 0, 0});
  CHECK(Transform::rotation({0, 0, 1}, 180, {1, 0, 0}).apply({0, 0, 0}) == RationalPoint{2, 0, 0});
  CHECK(Transform::rotation({1, 2, 3}, 720, {1, 0, 0}).identity());
  CHECK_THROWS_AS(Transform::rotation({0, 0, 0}, 30, {0, 0, 0}), InputError);
}

TEST_CASE("composition, scaling, reflection") {
  const Transform scale = Transform::scaling({2, r("1/3"), -1});
  const Transform move = Transform::translation({1, 2, 3});
  const RationalPoint p{3, 3, r("0.7")};
  CHECK((move * scale).apply(p) == move.apply(scale.apply(p)));
  CHECK((scale * move).apply(p) == scale.apply(move.apply(p)));
  CHECK(scale.determinant() == r("-2/3"));
  CHECK_THROWS_AS(Transform::scaling({1, 0, 1}), InputError);
  const Transform mirror = Transform::reflection({1, 2, -2}, {1, 1, 1});
  CHECK(orthogonal(mirror));
  CHECK(mirror.determinant() == -1);
  CHECK((mirror * mirror).identity());
  CHECK(mirror.apply({1, 1, 1}) == RationalPoint{1, 1, 1});
  CHECK(Transform::reflection({0, 0, 5}, {0, 0, 1}).apply({4, 5, 3}) == RationalPoint{4, 5, -1});
  CHECK_THROWS_AS(Transform::reflection({0, 0, 0}, {1, 1, 1}), InputError);
}

TEST_CASE("solids under transforms keep planes, closedness and orientation") {
  const Shape shapes[] = {
      BoxShape{{0, 0, 0}, {1, 2, 3}}, CylinderShape{{0, 0, 0}, {0, 1, 2}, 1, 9},
      PrismShape{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}}, {0, 0, 1}},
      SphereShape{{0, 0, 0}, 2, 6, 0}};
  const Transform transforms[] = {Transform::translation({r("1/3"), 5, r("0.1")}),
                                  Transform::rotation({1, 1, 0}, 33, {2, 0, 0}),
                                  Transform::reflection({1, 0, 1}, {0, 0, 3}),
                                  Transform::scaling({-1, 2, r("0.3")}), Transform::scaling({-2, -2, -2})};
  for (const Shape& shape : shapes) {
    const Rational plain = volume(soup_of(shape));
    for (const Transform& t : transforms) {
      const Soup soup = soup_of(shape, t);
      CHECK(planar(soup));
      CHECK(closed(soup));
      CHECK(volume(soup) == plain * abs(t.determinant()));
    }
  }
}

TEST_CASE("images of doubles are exact in either way of computing") {
  std::mt19937_64 random(2);
  std::vector<RationalPoint> points;
  for (int i = 0; i < 200; ++i) {
    const auto number = [&] {
      return from_double(
          std::ldexp(static_cast<double>(random() >> (random() % 60)), static_cast<int>(random() % 40) - 60));
    };
    points.push_back({number(), number(), number()});
  }
  points.push_back({from_double(5e-324), from_double(1e-300), 0});
  const Transform transforms[] = {
      Transform::translation({1, r("0.5"), 0}), Transform::scaling({2, from_double(0.1), -4}),
      Transform::rotation({0, 0, 1}, 90, {1, 1, 1}), Transform::rotation({0, 0, 1}, 45, {1, 1, 1}),
      Transform::scaling({from_double(1e-300), 3, 1})};
  for (const Transform& t : transforms) {
    const Soup soup = soup_of(PointsShape{points}, t);
    for (std::size_t i = 0; i < points.size(); ++i) REQUIRE(value(soup, PointId(i)) == t.apply(points[i]));
  }
}

TEST_CASE("sides keep their meaning under a reflection") {
  GroupShape group;
  group.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  group.faces.push_back({{{0, 1, 2}}, {1, 2}, 0, 0});
  const Soup soup = soup_of(group, Transform::scaling({1, 1, -1}));
  const auto loop = loops(soup, SourceId(0))[0];
  CHECK(soup.face(SourceId(0)).front == 1);
  CHECK(soup.face(SourceId(0)).back == 2);
  // The front looked along +z; its image looks along -z.
  CHECK(cross(loop[1] - loop[0], loop[2] - loop[0])[2] < 0);
}

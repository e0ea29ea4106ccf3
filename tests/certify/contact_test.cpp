// Planes, quadrics and tori that touch and do not cross.
#include "csg/certify/contact.h"

#include <random>

#include "csg/geometry/transform.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Kind = Contact::Kind;

/// |x - c|^2 - (a . (x - c))^2 / a.a - r^2; with a = 0 a ball.
Quadric tube(const RationalPoint& c, const RationalPoint& a, const Rational& r) {
  Quadric q{};
  const Rational square = dot(a, a);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      q[i][j] = (i == j ? 1 : 0) - (square == 0 ? Rational(0) : a[i] * a[j] / square);
  }
  RationalPoint moved{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) moved[i] = q[i][0] * c[0] + q[i][1] * c[1] + q[i][2] * c[2];
  for (std::size_t i = 0; i < 3; ++i) q[i][3] = q[3][i] = -moved[i];
  q[3][3] = dot(c, moved) - r * r;
  return q;
}
Quadric ball(const RationalPoint& c, const Rational& r) { return tube(c, {0, 0, 0}, r); }

/// The image of a quadric.
Quadric image(const Quadric& q, const Transform& transform) {
  const Transform back = transform.inverse();
  std::array<std::array<Rational, 4>, 4> m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) m[i][j] = back.linear[i][j];
    m[i][3] = back.offset[i];
  }
  m[3][3] = 1;
  Quadric result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < 4; ++l) result[i][j] += m[k][i] * q[k][l] * m[l][j];
      }
    }
  }
  return result;
}

Rational fraction_of(std::mt19937_64& random) {
  return Rational(static_cast<long>(random() % 41) - 20, static_cast<long>(random() % 9) + 1);
}
Transform frame(std::mt19937_64& random) {
  for (;;) {
    Transform t;
    for (auto& row : t.linear) {
      for (Rational& x : row) x = fraction_of(random), x.canonicalize();
    }
    for (Rational& x : t.offset) x = fraction_of(random), x.canonicalize();
    if (t.determinant() != 0) return t;
  }
}

struct Pair {
  const char* what;
  Quadric a, b;
  std::optional<Kind> kind;  ///< nothing: they cross
};

std::vector<Pair> pairs() {
  const Rational little(1, 1'000'000'000);
  return {
      {"balls beside each other", ball({0, 0, 0}, 1), ball({Rational(6, 5), Rational(8, 5), 0}, 1), Kind::point},
      {"a ball in a ball", ball({0, 0, 0}, 2), ball({Rational(3, 5), Rational(4, 5), 0}, 1), Kind::point},
      {"balls about one centre", ball({1, 2, 3}, 2), ball({1, 2, 3}, 1), Kind::none},
      {"balls that are nearly apart", ball({0, 0, 0}, 1), ball({2 - little, 0, 0}, 1), std::nullopt},
      {"balls that are just apart", ball({0, 0, 0}, 1), ball({2 + little, 0, 0}, 1), Kind::none},
      {"balls that cross", ball({0, 0, 0}, 1), ball({1, 0, 0}, 1), std::nullopt},
      {"tubes side by side", tube({0, 0, 0}, {0, 0, 1}, 1), tube({3, 0, 5}, {0, 0, 2}, 2), Kind::line},
      {"a tube in a tube", tube({0, 0, 0}, {0, 0, 1}, 2), tube({1, 0, 0}, {0, 0, 1}, 1), Kind::line},
      {"parallel tubes that cross", tube({0, 0, 0}, {0, 0, 1}, 1), tube({1, 0, 0}, {0, 0, 1}, 1), std::nullopt},
      {"parallel tubes apart", tube({0, 0, 0}, {0, 0, 1}, 1), tube({2 + little, 0, 0}, {0, 0, 1}, 1), Kind::none},
      {"crossed tubes", tube({0, 0, 0}, {0, 0, 1}, 1), tube({0, 3, 0}, {1, 0, 0}, 2), Kind::point},
      {"equal tubes whose axes meet", tube({0, 0, 0}, {0, 0, 1}, 1), tube({0, 0, 0}, {1, 0, 0}, 1), std::nullopt},
      {"a ball that fills a tube", tube({0, 0, 0}, {0, 0, 1}, 1), ball({0, 0, 2}, 1), Kind::conic},
      {"a ball in a tube", tube({0, 0, 0}, {0, 0, 1}, 2), ball({1, 0, 2}, 1), Kind::point},
      // Viviani's curve passes through itself where they touch.
      {"a tube in a ball", ball({0, 0, 0}, 2), tube({1, 0, 0}, {0, 0, 1}, 1), std::nullopt},
      {"one surface", ball({0, 0, 0}, 2), ball({0, 0, 0}, 2), std::nullopt},
  };
}

TEST_CASE("quadrics that touch are told from those that cross, however near, in every frame", "[certify]") {
  std::mt19937_64 random(45);
  for (const Pair& pair : pairs()) {
    for (int i = 0; i < 6; ++i) {
      const Transform t = i == 0 ? Transform() : frame(random);
      const Quadric a = image(pair.a, t), b = image(pair.b, t);
      INFO(pair.what << ", frame " << i);
      for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        const std::optional<Contact> found = contact(one, other);
        REQUIRE(found.has_value() == pair.kind.has_value());
        if (found) CHECK(found->kind == *pair.kind);
      }
    }
  }
}

TEST_CASE("the places of a contact are known", "[certify]") {
  std::mt19937_64 random(46);
  for (int i = 0; i < 10; ++i) {
    const Transform t = i == 0 ? Transform() : frame(random);
    const auto of = [&](const Quadric& a, const Quadric& b) { return contact(image(a, t), image(b, t)).value(); };
    const Contact point = of(ball({0, 0, 0}, 1), ball({Rational(6, 5), Rational(8, 5), 0}, 1));
    CHECK(point.has(t.apply({Rational(3, 5), Rational(4, 5), 0})));
    CHECK(!point.has(t.apply({1, 0, 0})));
    const Contact line = of(tube({0, 0, 0}, {0, 0, 1}, 1), tube({3, 0, 5}, {0, 0, 2}, 2));
    CHECK(line.has(t.apply({1, 0, 7})));
    CHECK(!line.has(t.apply({0, 1, 7})));
    const Contact conic = of(tube({0, 0, 0}, {0, 0, 1}, 1), ball({0, 0, 2}, 1));
    CHECK(conic.has(t.apply({Rational(3, 5), Rational(4, 5), 2})));
    CHECK(!conic.has(t.apply({1, 0, 3})));
  }
}

TEST_CASE("a plane touches a quadric, cuts it or misses it", "[certify]") {
  const Quadric one = ball({0, 0, 0}, 1), pipe = tube({0, 0, 1}, {1, 0, 0}, 1);
  const Rational little(1, 1'000'000'000);
  CHECK(contact(PlaneEquation{3, 4, 0, -5}, one)->kind == Kind::point);
  CHECK(contact(PlaneEquation{3, 4, 0, -5}, one)->point == RationalPoint{Rational(3, 5), Rational(4, 5), 0});
  CHECK(!contact(PlaneEquation{3, 4, 0, -5 + little}, one));
  CHECK(contact(PlaneEquation{3, 4, 0, -5 - little}, one)->kind == Kind::none);
  CHECK(contact(PlaneEquation{0, 0, 1, 0}, pipe)->kind == Kind::line);
  CHECK(contact(PlaneEquation{0, 0, 1, little}, pipe)->kind == Kind::none);
  CHECK(!contact(PlaneEquation{0, 0, 1, -little}, pipe));
  CHECK(!contact(PlaneEquation{1, 0, 0, 0}, pipe));
}

TEST_CASE("a torus touches planes, balls, cylinders and tori, or not, however near", "[certify]") {
  const Torus ring{{0, 0, 0}, {0, 0, 2}, 3, 1};
  const auto moved = [](Torus torus, const RationalPoint& to) {
    torus.center = to;
    return torus;
  };
  for (const int sign : {-1, 0, 1}) {
    const Rational by = Rational(sign) / 1'000'000'000;
    INFO(sign);
    const auto check = [&](const std::optional<Contact>& found, Kind kind, const RationalPoint& on) {
      CHECK(found.has_value() == (sign >= 0));
      if (!found) return;
      CHECK(found->kind == (sign > 0 ? Kind::none : kind));
      if (sign == 0) CHECK(found->has(on));
    };
    // Along (4, 0, 3)/5: the circle reaches 12/5, the tube 1 more.
    check(contact(PlaneEquation{4, 0, 3, Rational(-17 - by)}, ring), Kind::point,
          {Rational(19, 5), 0, Rational(3, 5)});
    check(contact(PlaneEquation{0, 0, 3, Rational(3 + by)}, ring), Kind::circle,
          {Rational(9, 5), Rational(12, 5), -1});
    check(contact(ball({0, 5 + by, 0}, 1), ring), Kind::point, {0, 4, 0});
    check(contact(ball({0, 0, 4 + by}, 4), ring), Kind::circle, {Rational(12, 5), 0, Rational(4, 5)});
    check(contact(ball({0, Rational(13, 4) - by, 0}, Rational(3, 4)), moved(ring, {0, 0, 0})), Kind::point,
          {0, 4, 0});
    check(contact(ball({1, 0, 0}, 5 + by), ring), Kind::point, {-4, 0, 0});
    check(contact(tube({0, 6 + by, 0}, {0, 0, 1}, 2), ring), Kind::point, {0, 4, 0});
    check(contact(tube({0, 1 - by, 3}, {0, 0, 1}, 1), ring), Kind::point, {0, 2, 0});
    check(contact(tube({0, 1, 3}, {0, 0, 3}, 5 + by), ring), Kind::point, {0, -4, 0});
    check(contact(tube({0, 0, 0}, {0, 0, 1}, 2 - by), ring), Kind::circle, {0, 2, 0});
    check(contact(tube({7, 6 + by, 0}, {1, 0, 0}, 2), ring), Kind::point, {0, 4, 0});
    check(contact(tube({7, 1, 0}, {1, 0, 0}, 5 + by), ring), Kind::point, {0, -4, 0});
    check(contact(ring, moved(ring, {0, 8 + by, 0})), Kind::point, {0, 4, 0});
    check(contact(ring, moved(ring, {0, 0, 2 + by})), Kind::circle, {3, 0, 1});
    check(contact(ring, Torus{{0, 0, Rational(1, 2) - by}, {0, 0, 1}, 3, Rational(1, 2)}), Kind::circle,
          {0, 3, 1});
  }
  CHECK(!contact(PlaneEquation{0, 0, 1, 0}, ring));
  CHECK(!contact(tube({4, 0, 0}, {0, 0, 1}, Rational(5, 2)), ring));
}

}  // namespace
}  // namespace cnrg

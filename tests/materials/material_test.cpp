// Graded materials at points: stops, placements, and distances against a search over all simplices.
#include <cmath>
#include <optional>
#include <random>

#include "csg/materials/sampler.h"
#include "kernel/exact/distance.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

RegionMaterial graded(Grade grade, Transform placement = {}) {
  return {"blend", std::make_shared<const PlacedGrade>(PlacedGrade{std::move(grade), std::move(placement)})};
}

Mixture one(const std::string& name) { return {{name, 1}}; }

const std::vector<Grade::Stop> kStops{{0, one("steel")}, {1, one("ceramic")}};

TEST_CASE("a linear grade is exact and constant beyond its stops", "[material]") {
  const RegionMaterial material = graded({LinearGrade{{0, 0, 0}, {0, 3, 4}}, kStops});
  const MaterialSampler sampler(material);
  CHECK(sampler.at({0, 0, 0}) == one("steel"));
  CHECK(sampler.at({7, 3, 4}) == one("ceramic"));
  CHECK(sampler.at({0, -1, 0}) == one("steel"));
  CHECK(sampler.at({0, 0, 100}) == one("ceramic"));
  CHECK(sampler.at({9, 0, 1}) == Mixture{{"ceramic", Rational(4, 25)}, {"steel", Rational(21, 25)}});
  CHECK(sampler.names() == std::vector<std::string>{"ceramic", "steel"});
}

TEST_CASE("mixtures at stops are blended material by material", "[material]") {
  const Grade grade{
      LinearGrade{{0, 0, 0}, {1, 0, 0}},
      {{0, one("a")}, {Rational(1, 2), {{"a", Rational(1, 4)}, {"b", Rational(3, 4)}}}, {2, one("c")}}};
  const RegionMaterial material = graded(grade);
  const MaterialSampler sampler(material);
  CHECK(sampler.at({Rational(1, 4), 0, 0}) == Mixture{{"a", Rational(5, 8)}, {"b", Rational(3, 8)}});
  CHECK(sampler.at({Rational(5, 4), 0, 0}) ==
        Mixture{{"a", Rational(1, 8)}, {"b", Rational(3, 8)}, {"c", Rational(1, 2)}});
}

TEST_CASE("a grade moves with its placement", "[material]") {
  const Transform turn = Transform::rotation({0, 0, 1}, 90, {0, 0, 0});
  const Transform place = Transform::translation({10, 0, 0}) * turn * Transform::scaling({2, 1, 1});
  const RegionMaterial material = graded({LinearGrade{{0, 0, 0}, {1, 0, 0}}, kStops}, place);
  const MaterialSampler sampler(material);
  for (const Rational& t : {Rational(0), Rational(1, 3), Rational(1)}) {
    const Mixture mixture = sampler.at(place.apply({t, 5, 6}));
    CHECK(mixture == MaterialSampler(graded({LinearGrade{{0, 0, 0}, {1, 0, 0}}, kStops})).at({t, 0, 0}));
  }
  CHECK((place * place.inverse()).identity());
  CHECK((place.inverse() * place).identity());
}

TEST_CASE("a material by itself is itself everywhere, and none is none", "[material]") {
  const RegionMaterial steel("steel"), none;
  CHECK(MaterialSampler(steel).at({1, 2, 3}) == one("steel"));
  CHECK(MaterialSampler(none).at({1, 2, 3}).empty());
  CHECK(MaterialSampler(none).names().empty());
  CHECK(to_text(one("steel")) == "steel");
  CHECK(to_text({{"a", Rational(1, 4)}, {"b", Rational(3, 4)}}) == "b 3/4, a 1/4");
}

TEST_CASE("equal functions of position are one material, others are not", "[material]") {
  const Grade grade{LinearGrade{{0, 0, 0}, {1, 0, 0}}, kStops};
  CHECK(graded(grade) == graded(grade));
  CHECK_FALSE(graded(grade) == graded(grade, Transform::translation({1, 0, 0})));
  CHECK_FALSE(graded(grade) == RegionMaterial("blend"));
  const auto target = [](long x) {
    return std::make_shared<const DistanceTarget>(DistanceTarget{{{x, 0, 0}}, {{{0}}}, {}, {}});
  };
  CHECK(graded({DistanceGrade{"p", target(1)}, kStops}) == graded({DistanceGrade{"p", target(1)}, kStops}));
  CHECK_FALSE(graded({DistanceGrade{"p", target(1)}, kStops}) == graded({DistanceGrade{"p", target(2)}, kStops}));
}

TEST_CASE("roots are rounded to the nearest double", "[material]") {
  CHECK(nearest_root(0) == 0);
  CHECK(nearest_root(Rational(9, 16)) == 0.75);
  CHECK(nearest_root(2) == std::sqrt(2.0));
  // Half-way between 1 and the next double: to even; a hair above: up.
  const Rational half = 1 + Rational(1, Integer(1) << 53), hair(1, Integer(1) << 400);
  CHECK(nearest_root(half * half) == 1);
  CHECK(nearest_root(half * half + hair) == std::nextafter(1.0, 2));
  CHECK(nearest_root(half * half - hair) == 1);
}

// --- an oracle that knows no tree: the least over corners, feet on edges and feet on triangles

Rational square(const RationalPoint& v) { return dot(v, v); }

Rational to_segment(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b) {
  Rational least = std::min(square(p - a), square(p - b));
  const RationalPoint ab = b - a;
  if (is_zero(ab)) return least;
  const Rational t = dot(p - a, ab) / square(ab);
  if (t > 0 && t < 1) least = std::min(least, square(p - (a + t * ab)));
  return least;
}

Rational to_triangle(const RationalPoint& p, const RationalPoint& a, const RationalPoint& b,
                     const RationalPoint& c) {
  Rational least = std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
  const RationalPoint n = cross(b - a, c - a);
  const RationalPoint foot = p - Rational(dot(p - a, n) / square(n)) * n;
  const bool inside = dot(cross(b - a, foot - a), n) >= 0 && dot(cross(c - b, foot - b), n) >= 0 &&
                      dot(cross(a - c, foot - c), n) >= 0;
  return inside ? std::min(least, square(p - foot)) : least;
}

TEST_CASE("distances are those of a search over all simplices", "[material]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto number = [&] { return Rational(long(random() % 41) - 20, 1 + long(random() % 3)); };
    const auto point = [&] {
      RationalPoint p{number(), number(), number()};
      for (Rational& x : p) x.canonicalize();
      return p;
    };
    DistanceTarget t;
    for (int i = 0; i < 12; ++i) t.points.push_back(point());
    const auto pick = [&] { return std::uint32_t(random() % t.points.size()); };
    for (int i = 0; i < int(random() % 4); ++i) t.vertices.push_back({pick()});
    for (int i = 0; i < int(random() % 4); ++i) t.segments.push_back({pick(), pick()});
    for (int i = 0; i < 8; ++i) {
      const std::array<std::uint32_t, 3> c{pick(), pick(), pick()};
      if (!collinear(t.points[c[0]], t.points[c[1]], t.points[c[2]])) t.triangles.push_back(c);
    }
    if (t.empty()) continue;
    const DistanceTo distance(t.points, t.vertices, t.segments, t.triangles);
    for (int i = 0; i < 20; ++i) {
      const RationalPoint p = i % 4 == 0 ? t.points[pick()] : point();
      std::optional<Rational> least;
      const auto see = [&](const Rational& d) { least = least ? std::min(*least, d) : d; };
      for (const auto& [a] : t.vertices) see(square(p - t.points[a]));
      for (const auto& [a, b] : t.segments) see(to_segment(p, t.points[a], t.points[b]));
      for (const auto& [a, b, c] : t.triangles) see(to_triangle(p, t.points[a], t.points[b], t.points[c]));
      CHECK(distance.squared(p) == *least);
    }
  }
}

TEST_CASE("a distance grade is measured before its placement", "[material]") {
  const auto target =
      std::make_shared<const DistanceTarget>(DistanceTarget{{{0, 0, 0}, {0, 0, 10}}, {}, {{{0, 1}}}, {}});
  const Grade grade{DistanceGrade{"bolt", target}, {{1, one("steel")}, {6, one("ceramic")}}};
  const RegionMaterial plain = graded(grade), twice = graded(grade, Transform::scaling({2, 2, 2}));
  CHECK(MaterialSampler(plain).at({3, 4, 5}) == Mixture{{"ceramic", Rational(4, 5)}, {"steel", Rational(1, 5)}});
  CHECK(MaterialSampler(twice).at({6, 8, 5}) == Mixture{{"ceramic", Rational(4, 5)}, {"steel", Rational(1, 5)}});
  CHECK(MaterialSampler(plain).at({0, 0, 5}) == one("steel"));
}

}  // namespace
}  // namespace cnrg

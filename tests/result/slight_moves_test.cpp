// The proof that rounding is harmless, beside the refinement of the rounded drawing.
#include "csg/result/slight_moves.h"

#include <random>

#include "tests/catch.h"

namespace cnrg {
namespace {

using ExactPoints = std::vector<RationalPoint>;

bool is_embedded(const ExactPoints& points, const Drawing& drawing) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  std::vector<PointId> ids(points.size());
  std::size_t used = 0;
  const auto id = [&](std::uint32_t p) {
    if (!ids[p].valid()) ids[p] = soup.add_point(points[p]), ++used;
    return ids[p];
  };
  std::uint32_t number = 0;
  for (const auto& t : drawing.triangles) soup.add_triangle(leaf, id(t[0]), id(t[1]), id(t[2]), number++, 0);
  for (const auto& s : drawing.segments) soup.add_wire(leaf, id(s[0]), id(s[1]), number++);
  for (const auto p : drawing.points) soup.add_isolated(leaf, id(p));
  return is_as_drawn(*build_complex(soup), used, drawing.triangles.size());
}

RationalPoint exact_points(const std::array<double, 3>& x) {
  return {from_double(x[0]), from_double(x[1]), from_double(x[2])};
}

TEST_CASE("what is said to move slightly stays as it is", "[slight_moves]") {
  std::size_t embedded = 0, proven = 0, spoilt = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return static_cast<std::uint32_t>(random() % n); };
    RoundedPoints points;
    ExactPoints before;
    const std::uint32_t count = 5 + below(5);
    const double reach = std::ldexp(1.0, -static_cast<int>(below(6)));
    for (std::uint32_t p = 0; p < count; ++p) {
      points.xyz.push_back({1.0 * below(4), 1.0 * below(4), 1.0 * below(4)});
      points.reach.push_back(below(3) == 0 ? reach : 0);
      before.push_back(exact_points(points.xyz.back()));
      if (points.reach.back() == 0) continue;
      for (Rational& x : before.back()) x += from_double(reach) * (static_cast<int>(below(13)) - 6) / 6;
    }
    Drawing drawing;
    const auto distinct = [&](std::size_t n) {
      std::vector<std::uint32_t> list;
      while (list.size() < n) {
        const std::uint32_t p = below(count);
        if (std::find(list.begin(), list.end(), p) == list.end()) list.push_back(p);
      }
      return list;
    };
    for (std::uint32_t t = 2 + below(3); t > 0; --t) {
      const auto p = distinct(3);
      drawing.triangles.push_back({p[0], p[1], p[2]});
    }
    if (below(2) == 0) {
      const auto p = distinct(2);
      drawing.segments.push_back({p[0], p[1]});
    }
    if (below(2) == 0) drawing.points.push_back(below(count));
    if (!is_embedded(before, drawing)) continue;
    ++embedded;
    CAPTURE(seed);
    const bool faithful = is_faithful(points, drawing);
    if (!faithful) ++spoilt;
    if (!is_surely_faithful(points, drawing)) continue;
    ++proven;
    REQUIRE(faithful);
    // And at any other place within reach.
    ExactPoints other;
    for (std::size_t p = 0; p < count; ++p) {
      other.push_back(exact_points(points.xyz[p]));
      for (Rational& x : other.back()) x += from_double(points.reach[p]) * (static_cast<int>(below(13)) - 6) / 6;
    }
    REQUIRE(is_embedded(other, drawing));
  }
  INFO(embedded << " embedded, " << proven << " proven, " << spoilt << " spoilt");
  CHECK(embedded > 300);
  CHECK(proven > 100);
  CHECK(spoilt > 20);
}

TEST_CASE("a point that passes through a wall is not called slight", "[slight_moves]") {
  RoundedPoints points;
  points.xyz = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1e-17}};
  points.reach = {0, 0, 0, 1e-16};
  const Drawing drawing{{{0, 1, 2}}, {}, {3}, {}, {}, {}};
  CHECK_FALSE(is_surely_faithful(points, drawing));
  points.xyz[3][2] = 1e-12;
  CHECK(is_surely_faithful(points, drawing));
  // Two triangles of one plane that share a side, and one that folds back onto the other.
  points.xyz = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
  points.reach = {1e-12, 1e-12, 1e-12, 1e-12};
  CHECK(is_surely_faithful(points, {{{0, 1, 2}, {3, 2, 1}}}));
  CHECK_FALSE(is_surely_faithful(points, {{{0, 1, 2}, {3, 0, 1}}}));
  CHECK_FALSE(is_surely_faithful(points, {{{0, 1, 2}, {2, 1, 0}}}));
}

}  // namespace
}  // namespace cnrg

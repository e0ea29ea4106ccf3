// The rule itself, on points and facets: what is joined, how far it moves, what is left.
#include "csg/weld/weld.h"

#include <algorithm>
#include <random>

#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Index = WeldModel::Index;

/// Facets by their corners; each is a face.
WeldModel model_of(const std::vector<std::vector<RationalPoint>>& polygons) {
  WeldModel model;
  for (const auto& polygon : polygons) {
    auto& facet = model.facets.emplace_back();
    facet.face = static_cast<Index>(model.faces.size());
    auto& loop = facet.loops.emplace_back();
    for (const RationalPoint& p : polygon) {
      loop.push_back(static_cast<Index>(model.points.size()));
      model.points.push_back(p);
    }
    model.faces.emplace_back();
  }
  model.face_name = [](Index f) { return "face " + std::to_string(f); };
  return model;
}

std::vector<RationalPoint> square(const Rational& x, const Rational& y, const Rational& side, const Rational& z) {
  return {{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}};
}

Rational farthest(const WeldModel& model, const Weld& made) {
  Rational most = 0;
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    const RationalPoint by = made.points[i] - model.points[i];
    most = std::max(most, Rational(dot(by, by)));
  }
  return most;
}

TEST_CASE("faces that lie on each other get one plane, and corners follow", "[weld]") {
  const Rational d(1, 1000);
  const WeldModel model = model_of({square(0, 0, 4, 0), square(1, 1, 1, Rational(1, 2000))});
  const Weld made = weld(model, d);
  CHECK(made.joined_planes == 1);
  CHECK(made.joined_points == 0);
  CHECK(made.moved > 0);
  for (const RationalPoint& p : made.points) CHECK(p[2] == made.points[0][2]);
  CHECK(farthest(model, made) <= d * d);
  CHECK(made.farthest >= 0.00024);
  CHECK(made.farthest <= 0.0005);
}

TEST_CASE("what lies at the length exactly is joined, and beyond it is not", "[weld]") {
  const Rational d(1, 1024);
  CHECK(weld(model_of({square(0, 0, 4, 0), square(1, 1, 1, d)}), d).joined_planes == 1);
  const WeldModel beyond = model_of({square(0, 0, 4, 0), square(1, 1, 1, d + Rational(1, 1000000))});
  const Weld made = weld(beyond, d);
  CHECK_FALSE(made.changed());
  CHECK(made.points == beyond.points);
  CHECK(made.notice(d).empty());
}

TEST_CASE("neighbours on a surface are near nothing; numbers stay to the last bit", "[weld]") {
  // A quadrilateral that is bent along its diagonal by less than the length, and a face far from it.
  const Rational bend(1, 1000000);
  const WeldModel model =
      model_of({{{0, 0, 0}, {1, 0, 0}, {1, 1, bend}}, {{0, 0, 0}, {1, 1, bend}, {0, 1, 0}}, square(5, 5, 1, 3)});
  const Weld made = weld(model, Rational(1, 1000));
  CHECK_FALSE(made.changed());
  CHECK(made.points == model.points);
}

TEST_CASE("points in a chain are joined from the nearest pair on", "[weld]") {
  // On a line at 0, 4, 9, 15 with the length 10: 0-4 is nearest, 9 joins them, 15 is too far from 0.
  WeldModel model;
  model.face_name = [](Index) { return std::string(); };
  for (const int x : {15, 0, 9, 4}) model.points.push_back({x, 0, 0});
  const Weld made = weld(model, 10);
  CHECK(made.points[1] == made.points[2]);
  CHECK(made.points[1] == made.points[3]);
  CHECK(made.points[0] == RationalPoint{15, 0, 0});
  CHECK(made.left == 1);
  CHECK_THAT(made.notice(10).text(),
             Contains("1 pair is near but not joined") && Contains("(9, 0, 0) and (15, 0, 0)"));
}

TEST_CASE("many faces at an edge are all planes through it", "[weld]") {
  // Pages of a book: squares about the z axis, each with its own slightly wrong copy of the spine.
  std::mt19937_64 random(7);
  const auto error = [&] { return from_double(static_cast<double>(random() % 1000) * 1e-13); };
  std::vector<std::vector<RationalPoint>> pages;
  for (int i = 0; i < 9; ++i) {
    const double angle = 0.1 + i * 0.65;
    const Rational x = from_double(std::cos(angle)), y = from_double(std::sin(angle));
    std::vector<RationalPoint> page{{0, 0, 0}, {x, y, 0}, {x, y, 1}, {0, 0, 1}};
    if (i % 2 == 0) page.push_back({0, 0, Rational(1, 2)});  // a corner that others lack
    for (RationalPoint& p : page) p = p + RationalPoint{error(), error(), error()};
    pages.push_back(page);
  }
  const WeldModel model = model_of(pages);
  const Rational d(1, 1000000);
  const Weld made = weld(model, d);
  CHECK(made.off == 0);
  CHECK(farthest(model, made) <= d * d);
  for (const WeldModel::Facet& facet : model.facets) {
    const auto& loop = facet.loops[0];
    for (const Index p : loop)
      CHECK(volume6(made.points[loop[0]], made.points[loop[1]], made.points[loop[2]], made.points[p]) == 0);
    CHECK(made.points[loop[0]] == made.points[0]);
    CHECK(made.points[loop[3]] == made.points[3]);
    if (loop.size() == 5) {
      CHECK(made.points[loop[4]] == made.points[4]);
      CHECK(collinear(made.points[loop[4]], made.points[0], made.points[3]));
    }
  }
}

TEST_CASE("nothing moves farther than the length, whatever it is", "[weld][random]") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    const auto number = [&] { return Rational(static_cast<long>(random() % 64), 16); };
    std::vector<std::vector<RationalPoint>> triangles;
    for (int i = 0; i < 12; ++i) {
      triangles.push_back(
          {{number(), number(), number()}, {number(), number(), number()}, {number(), number(), number()}});
    }
    WeldModel model = model_of(triangles);
    for (auto& face : model.faces) face.may_vanish = true;
    for (const Rational& d : {Rational(1, 20), Rational(1, 3), Rational(1)}) {
      CAPTURE(seed, d.get_str());
      const Weld made = weld(model, d);
      CHECK(farthest(model, made) <= d * d);
      // The same facets in another order: the same places.
      std::vector<std::size_t> order(triangles.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
      std::shuffle(order.begin(), order.end(), random);
      std::vector<std::vector<RationalPoint>> shuffled;
      for (const std::size_t i : order) shuffled.push_back(triangles[i]);
      WeldModel other = model_of(shuffled);
      for (auto& face : other.faces) face.may_vanish = true;
      const Weld again = weld(other, d);
      for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) CHECK(again.points[3 * i + k] == made.points[3 * order[i] + k]);
      }
      CHECK(again.left == made.left);
      CHECK(again.off == made.off);
    }
  }
}

TEST_CASE("faces and solids that would vanish or turn over are refused", "[weld]") {
  const Rational d(1, 10);
  CHECK_THROWS_WITH(weld(model_of({square(0, 0, Rational(1, 100), 0), square(3, 3, 3, 0)}), d),
                    Contains("weld: face 0 would vanish if all that is within 0.1"));
  // A flat tetrahedron.
  WeldModel model = model_of({{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                              {{0, 0, 0}, {1, 0, 0}, {0, 0, Rational(1, 100)}},
                              {{0, 0, 0}, {0, 0, Rational(1, 100)}, {0, 1, 0}},
                              {{1, 0, 0}, {0, 1, 0}, {0, 0, Rational(1, 100)}}});
  for (auto& face : model.faces) face.may_vanish = true;
  model.solids.push_back({"the tent", {{0, true}, {1, true}, {2, true}, {3, true}}});
  CHECK_THROWS_WITH(weld(model, d), Contains("weld: the tent would have no volume"));
}

}  // namespace
}  // namespace cnrg

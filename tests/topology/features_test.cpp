// The list of small features: distances and lengths as they were typed, angles against all pairs of faces and
// corners.
#include "csg/topology/features.h"

#include <cmath>

#include "csg/result/result_data.h"
#include "kernel/base/error.h"
#include "kernel/exact/exact_vectors.h"
#include "tests/catch.h"
#include "tests/result/near_scenes.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Kind = Feature::Kind;

Result result_of(const Case& c) {
  ResultNames names;
  for (const LeafInfo& info : c.infos) names.leaves.push_back(info.name);
  return Result(c.complex, c.group, names);
}

std::vector<Feature> of_kind(const std::vector<Feature>& all, Kind kind) {
  std::vector<Feature> out;
  std::copy_if(all.begin(), all.end(), std::back_inserter(out), [&](const Feature& f) { return f.kind == kind; });
  return out;
}

double angle(const std::array<double, 3>& u, const std::array<double, 3>& v) {
  const auto dot = [](const auto& a, const auto& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  return std::acos(std::clamp(dot(u, v) / std::sqrt(dot(u, u) * dot(v, v)), -1.0, 1.0)) * 180 / std::acos(-1.0);
}

}  // namespace

TEST_CASE("features: a bolt that ends before a fault", "[features]") {
  Soup soup;
  add_wire(soup, {2, 2, 1}, {2, 2, 2 - Rational(1, 100000)});
  add_sheet(soup, {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  Case c(soup);
  c.show(c.unite());
  const Result result = result_of(c);
  const auto all = features(result, Rational(1, 1000));
  const auto near = of_kind(all, Kind::distance);
  REQUIRE(near.size() == 1);
  CHECK(near[0].value == 1e-5);
  CHECK(near[0].squared == Rational(1, 100000) * Rational(1, 100000));
  CHECK(near[0].cells[0].dimension == 0);
  CHECK(near[0].cells[1] == Parts::Cell{2, 0});
  CHECK(near[0].at == std::vector<RationalPoint>{{2, 2, 2 - Rational(1, 100000)}, {2, 2, 2}});
  CHECK(of_kind(all, Kind::length).empty());
  CHECK(of_kind(all, Kind::face_angle).empty());  // right ones
  const std::string text = features_text(result, all);
  CHECK_THAT(text, Catch::Contains("vertex-face") && Catch::Contains("1e-05") &&
                       Catch::Contains("(2, 2, 1.99999) (2, 2, 2)") && Catch::Contains("leaf0 | leaf1"));
  // Without a distance the smallest of each sort.
  const auto few = features(result);
  CHECK(of_kind(few, Kind::distance).front().value == 1e-5);
  CHECK(of_kind(few, Kind::length).size() == 5);
  CHECK(of_kind(few, Kind::length).front().value == Approx(0.99999));
}

TEST_CASE("features: what nearly touches is told once for two cells, if they touch nowhere", "[features]") {
  const Rational small(1, 1'000'000);
  const auto text_of = [](const Soup& soup) {
    Case c(soup);
    c.show(c.unite());
    return nearly_touching_text(result_of(c));
  };
  Soup bolt;
  add_sheet(bolt, {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  add_wire(bolt, {2, 2, 1}, {2, 2, 2 - small});
  CHECK(text_of(bolt) ==
        "1 pair of cells does not touch and is nearer than a millionth of the model, 1e-06 apart; `cnrg check "
        "--features` lists what is near, and --join 6e-06 joins it");
  add_wire(bolt, {1, 1, 1}, {1, 1, 2 - 2 * small});
  CHECK_THAT(text_of(bolt),
             Catch::StartsWith("2 pairs of cells do not touch and are nearer than a millionth of the "
                               "model, the nearest 1e-06 apart; "));
  // As far as a model is drawn.
  Soup far;
  add_sheet(far, {{0, 0, 2}, {4, 0, 2}, {4, 4, 2}, {0, 4, 2}});
  add_wire(far, {2, 2, 1}, {2, 2, 2 - 8 * small});
  CHECK(text_of(far).empty());
  // A drum beside what is a hundred million times as long: parts of cells that touch are no pairs, its rims are
  // one.
  Soup drum;
  add_drum(drum, 48, 0, 3);
  add_wire(drum, {2000, 0, 0}, {1'000'000'000, 0, 0});
  CHECK_THAT(
      text_of(drum),
      Catch::StartsWith("1 pair of cells does not touch and is nearer than a millionth of the model, 3 apart; "));
  // Many are not counted.
  Soup mat;
  for (int i = 1; i <= 101; ++i) {
    add_wire(mat, {i, 0, 0}, {i, 102, 0});
    add_wire(mat, {0, i, small}, {102, i, small});
  }
  CHECK_THAT(text_of(mat), Catch::StartsWith("more than 10000 pairs of parts do not touch and are nearer than a "
                                             "millionth of the model; `cnrg check"));
}

TEST_CASE("features: ends of one edge are a length and no distance", "[features]") {
  Soup soup;
  add_wire(soup, {0, 0, 0}, {0, 0, Rational(1, 1000)});
  add_wire(soup, {0, 0, Rational(1, 1000)}, {0, 0, 5});
  Case c(soup);
  c.show(c.unite());
  const auto all = features(result_of(c), Rational(1, 100));
  CHECK(of_kind(all, Kind::distance).empty());
  const auto lengths = of_kind(all, Kind::length);
  REQUIRE(lengths.size() == 1);
  CHECK(lengths[0].value == 0.001);
}

TEST_CASE("features: bad distances, and results without bounds", "[features]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  const Case c(soup);
  CHECK_THROWS_WITH(features(result_of(c), Rational(0)), Catch::Contains("must be positive, and is 0"));
  CHECK_THROWS_WITH(features(result_of(c), Rational(-2)), Catch::Contains("must be positive, and is -2"));
  CHECK(of_kind(features(result_of(c), Rational(1000)), Kind::length).size() == 12);
}

TEST_CASE("features: faces of curved patches, rims without a vertex, slits", "[features]") {
  Soup soup;
  add_drum(soup, 48, 0, 3);
  add_sheet(soup, {{-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1}});
  add_sheet(soup, {{0, 0, -5}, {0, 0, 9}, {9, 0, 9}, {9, 0, -5}});  // ends inside
  Case c(soup);
  c.show(c.unite(Dominance::right));
  const auto all = features(result_of(c), Rational(1, 2));
  CHECK(of_kind(all, Kind::dihedral_angle).empty());  // right ones, and two of half a turn
  CHECK(!of_kind(all, Kind::length).empty());         // chords of the drum's rims
  for (const Feature& f : of_kind(all, Kind::length)) CHECK(f.value < 0.5);
}

TEST_CASE("features: angles against all pairs", "[features][random]") {
  const auto [first, last] = scenes::seeds(15);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    Dice dice(seed + 9'000'000);
    const Case c = lattice_case(lattice_scene(dice, 4, true), dice, 0);
    const Result result = result_of(c);
    const FlatComplex flat = flatten(result.data().view());
    const PointTable& table = result.complex().points;
    const auto x = [&](FlatComplex::Index p) { return table.rational(flat.points[p]); };
    const auto doubles = [](const RationalPoint& p) { return to_doubles(p); };
    const auto all = features(result);
    // Of each edge the least angle between two half-planes of triangles at a piece of it.
    std::vector<double> least;
    for (const auto& edge : flat.edges) {
      double smallest = 400;
      for (std::size_t k = 0; k + 1 < edge.points.size(); ++k) {
        const RationalPoint p = x(edge.points[k]), axis = x(edge.points[k + 1]) - p;
        std::vector<RationalPoint> directions;
        for (const auto& face : flat.faces) {
          for (const auto& t : face.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
              const std::array<FlatComplex::Index, 2> side{t[i], t[(i + 1) % 3]};
              if (std::minmax(side[0], side[1]) != std::minmax(edge.points[k], edge.points[k + 1])) continue;
              const RationalPoint u = x(t[(i + 2) % 3]) - p;
              directions.push_back(dot(axis, axis) * u - dot(u, axis) * axis);
            }
          }
        }
        for (std::size_t i = 0; i < directions.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            smallest = std::min(smallest, angle(doubles(directions[i]), doubles(directions[j])));
      }
      if (smallest < kSharp - 1e-5) least.push_back(smallest);
    }
    std::sort(least.begin(), least.end());
    const auto told = of_kind(all, Kind::dihedral_angle);
    REQUIRE(told.size() >= std::min(kTold, least.size()));
    for (std::size_t i = 0; i < std::min(told.size(), least.size()); ++i)
      CHECK(told[i].value == Approx(least[i]).margin(1e-5));
    // Corners of flat faces: the sum of the angles of triangles there, where the face has one corner at the point.
    std::vector<double> corners;
    for (const auto& face : flat.faces) {
      for (const auto& loop : face.loops) {
        for (const auto p : loop) {
          double sum = 0;
          std::size_t times = 0;
          for (const auto& other : face.loops) times += std::size_t(std::count(other.begin(), other.end(), p));
          if (times > 1) continue;
          for (const auto& t : face.triangles) {
            for (std::size_t i = 0; i < 3; ++i) {
              if (t[i] == p) sum += angle(doubles(x(t[(i + 1) % 3]) - x(p)), doubles(x(t[(i + 2) % 3]) - x(p)));
            }
          }
          if (sum < kSharp - 1e-5) corners.push_back(sum);
        }
      }
    }
    std::sort(corners.begin(), corners.end());
    const auto angles = of_kind(all, Kind::face_angle);
    for (const double corner : corners) {
      if (angles.size() == kTold && corner > angles.back().value - 1e-5) break;
      CHECK(std::any_of(angles.begin(), angles.end(),
                        [&](const Feature& f) { return std::abs(f.value - corner) < 1e-5; }));
    }
    CHECK(std::is_sorted(angles.begin(), angles.end(),
                         [](const Feature& a, const Feature& b) { return a.value < b.value; }));
  }
}

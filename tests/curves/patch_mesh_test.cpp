// Facets of patches: they cover the patch once, lie within the chord, and meet at shared curves.
#include "csg/curves/patch_mesh.h"

#include <algorithm>

#include "csg/curves/control_nets.h"
#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

Rational ratio(std::size_t a, std::size_t b) { return Rational(a) / Rational(b); }

/// A net over the unit square whose x and y are the parameters themselves: z alone is curved.
PatchNet graph(const std::vector<std::vector<Rational>>& heights) {
  PatchNet net;
  for (std::size_t j = 0; j < heights.size(); ++j) {
    net.points.emplace_back();
    for (std::size_t i = 0; i < heights[j].size(); ++i) {
      net.points[j].push_back({ratio(i, heights[j].size() - 1), ratio(j, heights.size() - 1), heights[j][i]});
    }
  }
  return net;
}

std::vector<std::vector<std::vector<Rational>>> many_heights() {
  std::vector<std::vector<std::vector<Rational>>> result{
      {{0, 0}, {0, 1}},                   // bilinear, straight sides
      {{0, 0, 0}, {0, 4, 0}, {0, 0, 0}},  // a bulge between straight sides
      {{0, 9, 0}, {0, 0, 0}},             // one curved side against a straight one
      {{0, 0, 0, 0}, {0, 7, -7, 0}, {0, 1, 2, 0}, {0, 20, 0, 1}}};
  std::mt19937 random(3);
  for (int k = 0; k < 6; ++k) {
    auto& net = result.emplace_back();
    for (int j = 0; j < 3 + k % 3; ++j) {
      net.emplace_back();
      for (int i = 0; i < 4; ++i) net.back().push_back(std::uniform_int_distribution<int>(-4, 4)(random));
    }
  }
  return result;
}

using Sides = std::map<std::pair<RationalPoint, RationalPoint>, int>;

Sides sides(const PatchMesh& mesh) {
  Sides result;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const RationalPoint &a = mesh.points[t[k]], &b = mesh.points[t[(k + 1) % 3]];
      a < b ? ++result[{a, b}] : --result[{b, a}];
    }
  }
  std::erase_if(result, [](const auto& s) { return s.second == 0; });
  return result;
}

std::vector<std::array<RationalPoint, 3>> facets(const PatchMesh& mesh, bool turned) {
  std::vector<std::array<RationalPoint, 3>> result;
  for (const auto& t : mesh.triangles) {
    std::array<RationalPoint, 3> f{mesh.points[t[0]], mesh.points[t[turned ? 2 : 1]],
                                   mesh.points[t[turned ? 1 : 2]]};
    std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
    result.push_back(f);
  }
  std::sort(result.begin(), result.end());
  return result;
}

PatchMesh mesh_of(const BezierPatch& patch, const Tessellation& tessellation) {
  const Fineness fineness("test", tessellation);
  BoundaryCurves boundary(fineness);
  return mesh_patch(patch, fineness, boundary);
}

}  // namespace

TEST_CASE("facets cover a patch once and lie within the chord") {
  for (const auto& heights : many_heights()) {
    const BezierPatch patch = patch_pieces(graph(heights), "test")[0];
    for (const char* text : {"0.3", "0.04"}) {
      const Rational chord = r(text);
      const Fineness fineness("test", {chord, std::nullopt});
      BoundaryCurves boundary(fineness);
      const PatchMesh mesh = mesh_patch(patch, fineness, boundary);
      Rational area = 0, farthest = 0;
      for (const auto& t : mesh.triangles) {
        const RationalPoint &a = mesh.points[t[0]], &b = mesh.points[t[1]], &c = mesh.points[t[2]];
        const Rational twice = cross(b - a, c - a)[2];
        REQUIRE(twice > 0);  // none is turned over
        area += twice / 2;
        for (const std::array<std::size_t, 3>& part :
             {std::array<std::size_t, 3>{1, 1, 1}, {2, 2, 0}, {0, 2, 2}, {2, 0, 2}}) {
          const std::size_t all = part[0] + part[1] + part[2];
          const RationalPoint p = ratio(part[0], all) * a + ratio(part[1], all) * b + ratio(part[2], all) * c;
          farthest = std::max(farthest, Rational(abs(Rational(patch.at(p[0], p[1])[2] - p[2]))));
        }
      }
      CHECK(farthest <= chord);
      CHECK(area == 1);
      // What has one facet is on the sides, in the steps of the sides' own curves.
      std::size_t steps = 0;
      for (std::size_t k = 0; k < 4; ++k) steps += static_cast<std::size_t>(boundary.steps(patch.side(k)));
      CHECK(sides(mesh).size() == steps);
    }
  }
}

TEST_CASE("chords of rational patches are bounded too") {
  // A quarter of a cylinder and an eighth of a sphere, one side of which is a point.
  const PatchNet wall{
      {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 0, 2}, {1, 1, 2}, {0, 1, 2}}}, {{1, 1, 2}, {1, 1, 2}}, {0, 0}, {}};
  const PatchNet eighth{
      {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}},
      {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}},
      {0, 0},
      {}};
  for (const char* text : {"0.1", "0.01", "0.001"}) {
    const Rational chord = r(text);
    for (const bool round : {false, true}) {
      const PatchMesh mesh = mesh_of(patch_pieces(round ? eighth : wall, "test")[0], {chord, std::nullopt});
      const auto radius2 = [&](const RationalPoint& p) {
        return Rational(p[0] * p[0] + p[1] * p[1] + (round ? Rational(p[2] * p[2]) : Rational(0)));
      };
      for (const RationalPoint& p : mesh.points) REQUIRE(radius2(p) == 1);
      for (const auto& t : mesh.triangles) {
        const RationalPoint middle = Rational(1, 3) * (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]);
        REQUIRE(radius2(middle) >= (1 - chord) * (1 - chord));
      }
      // Not much finer than it has to be: a circle needs about 1 / sqrt(8 chord / r) steps per radian.
      CHECK(mesh.triangles.size() * chord < (round ? 13 : 6));
    }
  }
}

TEST_CASE("a patch has the same facets however its net is written") {
  for (const auto& heights : many_heights()) {
    const BezierPatch patch = patch_pieces(graph(heights), "test")[0];
    const auto expected = facets(mesh_of(patch, {r("0.1"), std::nullopt}), false);
    for (int way = 1; way < 8; ++way) {
      BezierPatch other = patch;
      if (way & 1) std::reverse(other.net.begin(), other.net.end());
      if (way & 2) {
        for (ControlRow& row : other.net) std::reverse(row.begin(), row.end());
      }
      if (way & 4) {
        BezierPatch transposed;
        transposed.net.resize(other.net[0].size());
        for (const ControlRow& row : other.net) {
          for (std::size_t i = 0; i < row.size(); ++i) transposed.net[i].push_back(row[i]);
        }
        other = transposed;
      }
      for (ControlRow& row : other.net) {
        for (Homogeneous& h : row) {
          for (Rational& x : h) x *= 3;
        }
      }
      const bool turned = ((way & 1) + (way >> 1 & 1) + (way >> 2)) % 2 == 1;
      CHECK(facets(mesh_of(other, {r("0.1"), std::nullopt}), turned) == expected);
    }
  }
}

TEST_CASE("patches of different curvature meet in one curve's vertices") {
  // The common side y = 1 is given as a quadratic curve on one side, run backward as a cubic on the other.
  const PatchNet flat = graph({{0, 0, 0}, {0, 2, 0}});
  PatchNet wild;
  wild.points = {{{1, 1, 0}, {Rational(2, 3), 1, Rational(4, 3)}, {Rational(1, 3), 1, Rational(4, 3)}, {0, 1, 0}},
                 {{1, 2, 9}, {Rational(2, 3), 2, 30}, {Rational(1, 3), 2, -30}, {0, 2, 0}}};
  for (const Tessellation& t : {Tessellation{r("0.05"), {}}, Tessellation{{}, 5}, Tessellation{}}) {
    const PatchMesh a = mesh_of(patch_pieces(flat, "test")[0], t), b = mesh_of(patch_pieces(wild, "test")[0], t);
    const auto on_side = [](const PatchMesh& mesh) {
      std::vector<std::pair<RationalPoint, RationalPoint>> result;
      for (const auto& [side, count] : sides(mesh)) {
        if (side.first[1] == 1 && side.second[1] == 1) result.push_back(side);
      }
      return result;
    };
    CHECK(on_side(a).size() >= 4);
    CHECK(on_side(a) == on_side(b));
  }
}

TEST_CASE("chords and segments that cannot be are refused") {
  const PatchNet net = graph({{0, 1, 0}, {0, 3, 0}, {0, 0, 0}});
  const auto error = [&](const Tessellation& t) {
    return error_of([&] { mesh_of(patch_pieces(net, "test")[0], t); });
  };
  CHECK_THAT(error({r("1e-30"), {}}), Catch::Contains("the chord is too small"));
  CHECK_THAT(error({r("1e-9999"), {}}), Catch::Contains("the chord is too small"));
  CHECK_THAT(error({r("-1"), {}}), Catch::Contains("chord is -1: give a positive length"));
  CHECK_THAT(error({{}, 100000}), Catch::Contains("more than 10000000 facets: give fewer segments"));
  PatchNet steep = net;
  steep.weights = {{1, r("1e40"), 1}, {1, 1, 1}, {1, 1, 1}};
  CHECK_THAT(error_of([&] {
               mesh_of(patch_pieces(steep, "test")[0], {r("0.1"), {}});
             }),
             Catch::Contains("the chord is too small"));
  CHECK_THAT(error({{}, 0}), Catch::Contains("segments is 0"));
  CHECK_THAT(error({r("1"), 4}), Catch::Contains("both chord and segments"));
}

TEST_CASE("solids of patches: an eighth of a ball, closed by its planes") {
  // Planes through the centre as patches with a side that is a point; all that meets is shared.
  const std::vector<RationalPoint> x{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, y{{0, 1, 0}, {0, 1, 1}, {0, 0, 1}},
      z{{1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
  BezierShape shape;
  shape.patches.push_back(
      {{{x[0], x[1], x[2]}, {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}},
       {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}},
       {0, 0},
       {}});
  const std::vector<RationalPoint> centre(3, {0, 0, 0});
  for (const auto& arc : {x, y}) shape.patches.push_back({{centre, arc}, {{1, 1, 2}, {1, 1, 2}}, {0, 0}, {}});
  shape.patches.push_back({{z, centre}, {{1, 1, 2}, {1, 1, 2}}, {0, 0}, {}});
  shape.fill = Fill::winding;
  for (const char* text : {"0.1", "0.01", "0.002"}) {
    shape.tessellation.chord = r(text);
    const Soup soup = soup_of(shape);
    CHECK(planar(soup));
    CHECK(closed(soup));
    CHECK(leaf_faces(soup) == 4);
    const double pi = 3.14159265358979;
    CHECK(to_double(volume(soup)) <= pi / 6);
    CHECK(to_double(volume(soup)) >= pi / 6 - to_double(r(text)) * (pi / 2 + 3 * pi / 4));  // chord times surface
  }
  SECTION("turned inward it is turned round; mixed it is refused") {
    shape.tessellation = {r("0.1"), {}};
    const Rational expected = volume(soup_of(shape));
    for (PatchNet& net : shape.patches) {
      std::reverse(net.points.begin(), net.points.end());
      std::reverse(net.weights.begin(), net.weights.end());
    }
    CHECK(volume(soup_of(shape)) == expected);
    std::reverse(shape.patches[1].points.begin(), shape.patches[1].points.end());
    std::reverse(shape.patches[1].weights.begin(), shape.patches[1].weights.end());
    CHECK_THAT(error_of(shape),
               Catch::Contains("not oriented alike along 3 curves") && Catch::Contains("side u = 1 of patch 2"));
    shape.fill = Fill::parity;
    CHECK(error_of(shape) == "");
    shape.patches.pop_back();
    CHECK_THAT(error_of(shape), Catch::Contains("not closed along 3 curves, such as side"));
    shape.fill = Fill::none;
    CHECK(error_of(shape) == "");
  }
}

TEST_CASE("curves are wires, one per curve") {
  BezierShape shape;
  shape.curves.push_back({{{0, 0, 0}, {1, 2, 0}, {2, 0, 1}}, {}, 0, {}});
  shape.curves.push_back({{{2, 0, 1}, {3, 0, 1}}, {}, 0, {}});
  shape.tessellation.chord = r("0.01");
  const Soup soup = soup_of(shape);
  std::map<std::uint32_t, int> count;
  for (const Soup::Wire& w : soup.wires()) ++count[w.leaf_edge];
  CHECK(count.size() == 2);
  CHECK(count[0] == 16);
  CHECK(count[1] == 1);
  shape.is_spline = true;
  shape.curves = {{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}, {0, 2, 2}}, {}, 2, {}}};
  const Soup spline = soup_of(shape);
  for (const Soup::Wire& w : spline.wires()) CHECK(w.leaf_edge == 0);
  shape.curves = {{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {}, 2, {}}};
  CHECK_THAT(error_of(shape), Catch::Contains("bspline: the curve is one point"));
  CHECK_THAT(error_of(BezierShape{}), Catch::Contains("no patches or curves"));
  BezierShape flat;
  flat.patches.push_back({{{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}}, {}, {0, 0}, {}});
  CHECK_THAT(error_of(flat), Catch::Contains("the patch has no area"));
}

TEST_CASE("Coons patches close with the curves' own neighbours") {
  // A bent quadrilateral and its mirror image share all four curves: together they enclose a cushion.
  const auto line = [](const RationalPoint& a, const RationalPoint& b) { return CurveNet{{a, b}, {}, 0, {}}; };
  const RationalPoint a{0, 0, 0}, b{2, 0, 0}, c{2, 2, 0}, d{0, 2, 0};
  CoonsShape shape;
  shape.tessellation.chord = r("0.02");
  shape.fill = Fill::winding;
  const CurveNet over{{a, {1, 0, 1}, b}, {}, 0, {}}, under{{a, {1, 0, -1}, b}, {}, 0, {}};
  shape.patches.push_back({over, line(b, c), line(c, d), line(d, a)});
  shape.patches.push_back({CurveNet{{b, {1, 0, -1}, a}, {}, 0, {}}, line(a, d), line(d, c), line(c, b)});
  CHECK_THAT(error_of(shape), Catch::Contains("not closed along 2 curves"));
  shape.patches.push_back({under, line(b, b), CurveNet{{b, {1, 0, 1}, a}, {}, 0, {}}, line(a, a)});
  const Soup soup = soup_of(shape);
  CHECK(closed(soup));
  CHECK(leaf_faces(soup) == 3);
  // The sum of heights: z = v-linear from the arc 2 u (1 - u) at y = 0 to 0, above and below.
  CHECK(abs(Rational(volume(soup) - Rational(4, 3))) < r("0.02") * 10);
  shape.patches[0][1] = line(b, d);
  CHECK_THAT(error_of(shape),
             Catch::Contains("curve 2 of patch 1 ends in (0, 2, 0), but the next one begins in (2, 2, 0)"));
}

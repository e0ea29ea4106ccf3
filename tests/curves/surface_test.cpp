// True surfaces: they are where the corners of facets are, their intervals hold what they are at points, and their
// normals are those of the forms that people know.
#include "csg/curves/surface.h"

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "csg/curves/surface_math.h"
#include "csg/curves/surface_placed.h"
#include "csg/leaves/leaf.h"
#include "csg/leaves/parameters.h"
#include "tests/catch.h"
#include "tests/exact/rational_text.h"

using namespace cnrg;

namespace {

struct Made {
  Soup soup;
  std::shared_ptr<const LeafParameters> parameters;
  std::shared_ptr<const LeafSurfaces> surfaces;
  explicit Made(const Shape& shape) {
    const auto leaf = prepare(shape);
    leaf->add_to(soup, {});
    REQUIRE(leaf->surfaces());
    parameters = leaf->parameters()();
    surfaces = leaf->surfaces()();
  }
};

double norm(const Vector3<double>& v) { return std::hypot(v[0], v[1], v[2]); }

bool encloses(const Interval& x, double value, double slack) {
  return x.inf() <= value + slack && value - slack <= x.sup();
}

/// The cross product points the way of `normal`, or one of them is zero as far as can be told.
void check_direction(const Vector3<double>& normal, const Vector3<double>& u, const Vector3<double>& v) {
  const Vector3<double> n = surface_math::cross(u, v);
  const double a = norm(n), b = norm(normal);
  if (a < 1e-9 * (norm(u) * norm(v) + 1e-30) || norm(u) < 1e-9 || norm(v) < 1e-9 || b < 1e-9) return;
  for (std::size_t k = 0; k < 3; ++k) CHECK(n[k] / a == Approx(normal[k] / b).margin(1e-7));
}

/// Corners of facets are on the surface; over the box of each cell the intervals hold samples. `size` is of the
/// leaf, `flat_patches` are those that lie in a plane. Returns how many cells the others have.
std::size_t check(const Shape& shape, double size, const std::set<std::uint32_t>& flat_patches = {}) {
  const Made made(shape);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0, 1);
  std::size_t count = 0;
  std::set<std::uint32_t> flat;
  for (const SourceId f : IdRange<SourceId>(made.soup.face_count())) {
    const Surface* const surface = made.surfaces->patch(made.soup.face(f).patch);
    const auto cells = made.parameters->cells(f.index());
    if (cells.empty()) CHECK(surface == nullptr);
    if (surface == nullptr) {
      flat.insert(made.soup.face(f).patch);
      continue;
    }
    for (const auto& cell : cells) {
      ++count;
      double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
      for (const PatchCorner& corner : cell) {
        const double u = to_double(corner.at[0]), v = to_double(corner.at[1]);
        const Vector3<double> p = surface->at(u, v).point;
        for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(p[k] - to_double(corner.point[k])) < 1e-12 * size);
        for (std::size_t d = 0; d < 2; ++d) {
          low[d] = std::min(low[d], d == 0 ? u : v), high[d] = std::max(high[d], d == 0 ? u : v);
        }
      }
      const SurfaceJet<Interval> box = surface->over({low[0], high[0]}, {low[1], high[1]});
      for (int i = 0; i < 5; ++i) {
        const double u = i == 0 ? low[0] : low[0] + any(random) * (high[0] - low[0]);
        const double v = i == 0 ? high[1] : low[1] + any(random) * (high[1] - low[1]);
        const SurfaceJet<double> at = surface->at(u, v);
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(encloses(box.point[k], at.point[k], 1e-12 * size));
          CHECK(encloses(box.along_u[k], at.along_u[k], 1e-11 * size));
          CHECK(encloses(box.along_v[k], at.along_v[k], 1e-11 * size));
        }
        check_direction(at.normal, at.along_u, at.along_v);
        // The direction is in the cone of the box: at a point it is a box of almost no width.
        const SurfaceJet<Interval> point = surface->over(u, v);
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(point.point[k].sup() - point.point[k].inf() < 1e-12 * size);
          CHECK(encloses(point.point[k], at.point[k], 1e-12 * size));
          CHECK(encloses(box.normal[k], at.normal[k], 1e-9 * norm(at.normal) + 1e-12 * size * size));
        }
      }
    }
  }
  CHECK(flat == flat_patches);
  return count;
}

bool holds_zero(const Vector3<Interval>& n) {
  return std::all_of(n.begin(), n.end(), [](const Interval& x) { return x.inf() <= 0 && x.sup() >= 0; });
}

const CurveNet kBend{{{1, 0, 0}, {2, 0, 1}, {1, 0, 2}}, {1, 2, 1}, 0, {}};

}  // namespace

TEST_CASE("cosines of intervals hold those of their points, and no more than they must") {
  const enclosure::RoundOutward outward;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-2, 2);
  for (int i = 0; i < 20000; ++i) {
    double a = any(random), b = i % 3 == 0 ? a : any(random);
    if (i % 7 == 0) a = std::round(4 * a) / 4;
    if (a > b) std::swap(a, b);
    const Interval c = surface_math::cosine(Interval(a, b));
    const double middle = a + 0.37 * (b - a);
    for (const double t : {a, b, middle}) {
      const double exact = std::cos(2 * std::numbers::pi * t);
      CHECK(c.inf() <= exact + 3e-15);
      CHECK(exact - 3e-15 <= c.sup());
    }
    if (a == b) CHECK(c.sup() - c.inf() < 1e-15);
    CHECK((c.sup() == 1) == (std::floor(b) >= std::ceil(a) || c.sup() == 1));
    if (std::floor(b) >= std::ceil(a)) CHECK(c.sup() == 1);
    if (std::floor(b - 0.5) >= std::ceil(a - 0.5)) CHECK(c.inf() == -1);
  }
  CHECK(surface_math::cosine(Interval(0.125)).inf() <= std::sqrt(0.5));
  CHECK(surface_math::cosine(Interval(0.25)).sup() >= 0);
  CHECK(surface_math::cosine(Interval(0, 5)).inf() == -1);
}

TEST_CASE("cosines of doubles are as near to the truth as those of the library, in eighths of a turn and beyond") {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> any(-2, 2);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const double t = any(random);
    const long double exact = cosl(2 * std::numbers::pi_v<long double> * static_cast<long double>(t));
    worst = std::max(worst, static_cast<double>(std::abs(surface_math::cosine(t) - exact)));
  }
  CHECK(worst < 4e-16);
  for (const auto& [turns, cosine] : {std::pair(0.0, 1.0), {0.25, 0.0}, {0.5, -1.0}, {0.75, 0.0}, {-3.0, 1.0}})
    CHECK(surface_math::cosine(turns) == cosine);
}

TEST_CASE("the axis of a surface is the same within the scope that rounds outward") {
  const Made cone(ConeShape{{1, 0, r("0.1")}, {2, -2, 3}, 3, 1, 10});
  const PlacedSurface placed(cone.surfaces, 2, Transform::rotation({1, 2, 3}, 77, {0, 0, 0}));
  const Revolution before = *placed.revolution();
  const enclosure::RoundOutward outward;
  const Revolution within = *placed.revolution();
  CHECK(before.center == within.center);
  CHECK(before.axis == within.axis);
}

TEST_CASE("surfaces of solids of revolution are where their facets' corners are") {
  CHECK(check(SphereShape{{1, 2, 3}, r("0.7"), 14, 9}, 1) >= 14 * 9);
  CHECK(check(SphereShape{{0, 0, 1000}, 5, 8, 6}, 1000) > 0);
  CHECK(check(CylinderShape{{1, 0, 0}, {2, -2, 3}, 3, 10}, 3, {0, 1}) == 10);
  CHECK(check(ConeShape{{1, 0, 0}, {2, -2, 3}, 3, 1, 10}, 3, {0, 1}) > 0);
  CHECK(check(ConeShape{{1, 0, 0}, {1, 0, 4}, 0, 2, 10}, 4, {1}) > 0);
  CHECK(check(TorusShape{{0, 1, 1}, {1, 2, 3}, 3, r("0.8"), 9, 7}, 4) > 60);
  const std::vector<CurveNet> area{{{{0, 0, 0}, {1, 0, 0}}, {}, 0, {}},
                                   kBend,
                                   {{{1, 0, 2}, {0, 0, 2}}, {}, 0, {}},
                                   {{{0, 0, 2}, {0, 0, 0}}, {}, 0, {}}};
  for (const char* degrees : {"360", "100"}) {
    const bool full = r(degrees) == 360;
    CHECK(check(RevolveShape{{{{area}}, true}, {0, 0, 5}, {1, 0, 2}, r(degrees), {r("0.1"), {}}}, 5,
                full ? std::set<std::uint32_t>{0, 2} : std::set<std::uint32_t>{0, 1, 2, 4}) > 5);
  }
}

TEST_CASE("surfaces of sweeps and nets are where their facets' corners are") {
  const std::vector<CurveNet> area{{{{0, 0, 0}, {1, 0, 0}}, {}, 0, {}},
                                   kBend,
                                   {{{1, 0, 2}, {0, 0, 2}}, {}, 0, {}},
                                   {{{0, 0, 2}, {0, 0, 0}}, {}, 0, {}}};
  CHECK(check(ExtrudeShape{{{{area}}, true}, {0, 3, 1}, 0, 1, {}, {r("0.1"), {}}}, 4, {0, 1, 2, 4, 5}) > 3);
  CHECK(check(ExtrudeShape{{{{area}}, true}, {0, 3, 0}, 0, 0, RationalPoint{r("1/2"), 0, 1}, {r("0.1"), {}}}, 4,
              {0, 2, 4, 5}) > 3);
  CHECK(check(ExtrudeShape{{{{area}}, true}, {0, 3, 0}, 80, 2, RationalPoint{r("1/2"), 0, 1}, {r("0.1"), {}}}, 4,
              {0, 1}) > 5);
  // Mitred, then with a round bend; the flat walls and ends have the last numbers.
  const std::vector<RationalPoint> path{{0, 0, 0}, {0, 6, 0}, {-6, 6, 3}};
  CHECK(check(SweepShape{{{{area}}, true}, path, {}, {r("0.1"), {}}}, 9, {2, 3, 4, 5, 6, 7, 8, 9}) > 6);
  CHECK(check(SweepShape{{{{area}}, true}, path, 2, {r("0.1"), {}}}, 9, {6, 7, 8, 9, 10, 11, 12, 13}) > 20);
  std::vector<CurveNet> larger = area;
  for (CurveNet& net : larger) {
    for (RationalPoint& p : net.points) p = {2 * p[0], 3 + p[0], 2 * p[2] - 1};
  }
  CHECK(check(LoftShape{{{{{area}}, true}, {{{larger}}, true}}, {r("0.1"), {}}}, 5, {3, 4, 5}) > 3);
  const CurveNet spline{
      {{0, 0, 0}, {1, 2, 0}, {2, 0, 1}, {5, 1, 0}}, {1, 3, 1, 1}, 2, {0, 0, 0, r("1/3"), 2, 2, 2}};
  CHECK(check(ExtrudeShape{{{{{spline}}}, false}, {0, 0, 3}, 0, 1, {}, {{}, 5}}, 5) > 9);

  const PatchNet wild{{{{0, 0, 0}, {1, 0, 3}, {2, 0, 0}, {3, 0, 1}},
                       {{0, 1, 2}, {1, 1, -4}, {2, 1, 0}, {3, 2, 0}},
                       {{0, 3, 0}, {1, 2, 1}, {2, 2, 5}, {4, 4, 0}}},
                      {{1, 2, 1, 3}, {1, 1, 1, 1}, {2, 1, 1, 1}},
                      {0, 0},
                      {}};
  CHECK(check(BezierShape{{wild}, {}, Fill::none, {r("0.05"), {}}}, 4) > 10);
  PatchNet net;
  for (int j = 0; j < 5; ++j) {
    net.points.emplace_back();
    for (int i = 0; i < 6; ++i) net.points[std::size_t(j)].push_back({i, j, (i * j) % 4});
  }
  net.degree = {3, 2};
  net.knots = {std::vector<Rational>{0, 0, 1, 2, 4, 5, 6, 6, 7, 8}, std::vector<Rational>{0, 0, 0, 1, 1, 3, 3, 3}};
  CHECK(check(BezierShape{{net}, {}, Fill::none, {{}, 5}, true}, 6) > 100);
  const CurveNet c0{{{0, 0, 0}, {1, 0, 2}, {2, 0, 0}}, {}, 0, {}}, c1{{{2, 0, 0}, {2, 2, 0}}, {}, 0, {}},
      c2{{{2, 2, 0}, {1, 3, 1}, {0, 2, 0}}, {1, 2, 1}, 0, {}}, c3{{{0, 2, 0}, {0, 0, 0}}, {}, 0, {}};
  CHECK(check(CoonsShape{{{c0, c1, c2, c3}}, Fill::none, {r("0.02"), {}}}, 2) > 10);
}

TEST_CASE("curves of wires are where their ends are") {
  const CurveNet spline{
      {{0, 0, 9}, {1, 2, 9}, {2, 0, 9}, {5, 1, 9}}, {1, 1, 2, 1}, 2, {0, 0, 0, r("1/3"), 2, 2, 2}};
  const Made made(BezierShape{{}, {spline}, Fill::none, {{}, 6}, true});
  const Curve* const curve = made.surfaces->curve(0);
  REQUIRE(curve != nullptr);
  CHECK(made.surfaces->patch(0) == nullptr);
  REQUIRE(made.parameters->wire_count() == 12);
  for (std::size_t w = 0; w < made.parameters->wire_count(); ++w) {
    const LeafParameters::Wire wire = made.parameters->wire(w);
    const double a = to_double(wire.at[0]), b = to_double(wire.at[1]), m = a + 0.3 * (b - a), h = 1e-6;
    const CurveJet<Interval> box = curve->over({a, b});
    const CurveJet<double> middle = curve->at(m);
    const Vector3<double> before = curve->at(m - h).point, after = curve->at(m + h).point;
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(std::abs(curve->at(a).point[k] - to_double(wire.ends[0][k])) < 1e-12);
      CHECK(encloses(box.point[k], middle.point[k], 1e-13));
      CHECK(encloses(box.along[k], middle.along[k], 1e-12));
      CHECK(middle.along[k] == Approx((after[k] - before[k]) / (2 * h)).margin(1e-7));
    }
  }
}

TEST_CASE("normals are those of the forms that people know") {
  const Made ball(SphereShape{{1, 2, 3}, 2, 8, 4});
  for (const double u : {0.0, 0.1, 0.6}) {
    for (const double v : {0.0, 0.2, 0.5, 1.0}) {
      const SurfaceJet<double> at = ball.surfaces->patch(0)->at(u, v);
      const Vector3<double> out{at.point[0] - 1, at.point[1] - 2, at.point[2] - 3};
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(at.normal[k] / norm(at.normal) == Approx(out[k] / 2).margin(1e-12));
    }
  }
  // Around the pole of a sphere there is one normal, at the apex of a cone those of its rulings.
  CHECK(ball.surfaces->patch(0)->over({0, 1}, {0.875, 1}).normal[2].inf() > 0);
  const Made cone(ConeShape{{0, 0, 0}, {0, 0, 4}, 3, 0, 8});
  CHECK(cone.surfaces->patch(2)->over({0, 1}, {0.9, 1}).normal[2].inf() > 0);
  CHECK(!holds_zero(cone.surfaces->patch(2)->over({0, 0.125}, {0, 0.875}).normal));
  const Vector3<double> slope = cone.surfaces->patch(2)->at(0.25, 0.5).normal;
  CHECK(slope[1] / slope[2] == Approx(4.0 / 3));
  CHECK(slope[0] == Approx(0).margin(1e-12));
  // A net with a pole.
  const PatchNet eighth{
      {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{1, 0, 1}, {1, 1, 1}, {0, 1, 1}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}},
      {{1, 1, 2}, {1, 1, 2}, {2, 2, 4}},
      {0, 0},
      {}};
  const Made net(BezierShape{{eighth}, {}, Fill::none, {{}, 4}});
  CHECK(holds_zero(net.surfaces->patch(0)->over({0, 1}, {0.75, 1}).normal));
  const SurfaceJet<double> at = net.surfaces->patch(0)->at(0.4, 0.3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(at.normal[k] / norm(at.normal) == Approx(at.point[k]));
  CHECK(!holds_zero(net.surfaces->patch(0)->over({0.25, 0.5}, {0.25, 0.5}).normal));
  // So has what any line sweeps that leaves the axis, at a right angle or not.
  const auto bowl = [](const char* z) {
    const CurveNet line{{{0, 0, 0}, {1, 0, r(z)}, {2, 0, 1}}, {}, 0, {}};
    return Made(RevolveShape{{{{{line}}}, false}, {0, 0, 0}, {0, 0, 1}, 360, {{}, 8}});
  };
  CHECK(!holds_zero(bowl("0").surfaces->patch(0)->over({0, 0.125}, {0, 0.125}).normal));
  CHECK(!holds_zero(bowl("1/9").surfaces->patch(0)->over({0, 0.125}, {0, 0.125}).normal));
}

TEST_CASE("what is flat has no true surface beside its facets") {
  CHECK(!prepare(BoxShape{{0, 0, 0}, {1, 1, 1}})->surfaces());
  const Made cylinder(CylinderShape{{0, 0, 0}, {0, 0, 1}, 1, 8});
  CHECK(cylinder.surfaces->patch(0) == nullptr);
  CHECK(cylinder.surfaces->patch(2) != nullptr);
  CHECK(cylinder.surfaces->curve(0) == nullptr);
}

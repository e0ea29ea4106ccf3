// Surface meshes of all kinds of results, measured by what shares no code with what makes them: angles by the law
// of cosines, incidences by counting, lines that meet in small angles by trying all pairs of lines of the result.
#include "csg/mesh/surface_triangles.h"

#include <cmath>
#include <map>

#include "csg/formats/formats.h"
#include "csg/operators/cnrg.h"
#include "kernel/base/error.h"
#include "tests/catch.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/scenes/mesh_readers.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Index = Mesh::Index;
using Vector = std::array<double, 3>;

double apart(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
double area(const Vector& a, const Vector& b, const Vector& c) {  // Heron, as Kahan has it
  std::array<double, 3> s{apart(a, b), apart(b, c), apart(c, a)};
  std::sort(s.rbegin(), s.rend());
  return std::sqrt(std::max(0.0, (s[0] + (s[1] + s[2])) * (s[2] - (s[0] - s[1])) * (s[2] + (s[0] - s[1])) *
                                     (s[0] + (s[1] - s[2])))) /
         4;
}
/// At b, in degrees.
double angle(const Vector& a, const Vector& b, const Vector& c) {
  const double p = apart(a, b), q = apart(b, c), r = apart(c, a);
  return std::acos(std::clamp((p * p + q * q - r * r) / (2 * p * q), -1.0, 1.0)) * 180 / 3.14159265358979323846;
}

/// All straight pieces of edges and of boundaries of facets, and where any two of their lines meet.
class InputSegments {
 public:
  InputSegments(const ResultView& view, const FlatComplex& flat) {
    for (const VertexId v : flat.points) points_.push_back(view.complex->points.nearest(v));
    std::set<std::array<Index, 2>> pairs;
    const auto add = [&](Index a, Index b) { pairs.insert({std::min(a, b), std::max(a, b)}); };
    for (const auto& e : flat.edges) {
      const std::size_t n = e.points.size();
      for (std::size_t k = 0; k + (e.closed ? 0 : 1) < n; ++k) add(e.points[k], e.points[(k + 1) % n]);
    }
    for (const auto& f : flat.faces)
      for (const auto& facet : f.facets)
        for (const auto& loop : facet.loops)
          for (std::size_t k = 0; k < loop.size(); ++k) add(loop[k], loop[(k + 1) % loop.size()]);
    segments_.assign(pairs.begin(), pairs.end());
  }

  /// Do p and q lie on lines that meet in a point of the result, in less than 60 degrees as seen from there?
  bool small_angle(const Vector& p, const Vector& q) const {
    const auto on_p = lines(p), on_q = lines(q);
    for (const Vector& x : points_) {
      if (apart(x, p) < 1e-9 || apart(x, q) < 1e-9 || angle(p, x, q) > 60) continue;
      const auto through = [&](const std::array<Index, 2>& s) {
        const Vector &a = points_[s[0]], &b = points_[s[1]];
        double squared = 0;  // of twice the area of a, b, x; Heron's formula would have half the digits here
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
          squared += std::pow((b[u] - a[u]) * (x[v] - a[v]) - (b[v] - a[v]) * (x[u] - a[u]), 2);
        }
        return std::sqrt(squared) < 1e-9 * apart(a, b) * (1 + apart(a, x));
      };
      if (std::any_of(on_p.begin(), on_p.end(), through) && std::any_of(on_q.begin(), on_q.end(), through))
        return true;
    }
    return false;
  }

 private:
  std::vector<Vector> points_;
  std::vector<std::array<Index, 2>> segments_;

  std::vector<std::array<Index, 2>> lines(const Vector& p) const {
    std::vector<std::array<Index, 2>> result;
    for (const auto& s : segments_) {
      const Vector &a = points_[s[0]], &b = points_[s[1]];
      if (apart(a, p) + apart(p, b) < apart(a, b) * (1 + 1e-12) + 1e-12) result.push_back(s);
    }
    return result;
  }
};

/// Checks all that is promised of the mesh of a result.
SurfaceTriangles checked(const ResultView& view, const SurfaceOptions& options = {}) {
  const FlatComplex flat = flatten(view);
  SurfaceTriangles made = surface_triangles(view, options);
  const Mesh& mesh = made.mesh;
  CHECK(mesh.tetrahedra.empty());
  CHECK(mesh.entities[3].empty());
  CHECK(mesh.vertices.size() == flat.vertices.size());
  const auto at = [&](Index p) { return mesh.points[p]; };

  // Segments: each edge is as long as its chain, and each piece has as many triangles as the edge has sides of
  // faces.
  std::map<std::array<Index, 2>, Index> edge_of;
  std::vector<double> lengths(flat.edges.size(), 0);
  for (const auto& s : mesh.segments) {
    const auto [a, b] = std::minmax(s.points[0], s.points[1]);
    CHECK(edge_of.try_emplace({a, b}, s.entity).second);
    lengths[s.entity] += apart(at(a), at(b));
  }
  for (Index e = 0; e < flat.edges.size(); ++e) {
    double length = 0;
    const auto& points = flat.edges[e].points;
    for (std::size_t k = 0; k + (flat.edges[e].closed ? 0 : 1) < points.size(); ++k) {
      length += apart(view.complex->points.nearest(flat.points[points[k]]),
                      view.complex->points.nearest(flat.points[points[(k + 1) % points.size()]]));
    }
    CHECK(lengths[e] == Approx(length).epsilon(1e-12));
  }
  std::map<std::array<Index, 2>, std::vector<Index>> faces_at;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t.points[k], t.points[(k + 1) % 3]);
      faces_at[{a, b}].push_back(t.entity);
    }
  }
  std::size_t wrong = 0;
  for (auto& [side, faces] : faces_at) {
    std::sort(faces.begin(), faces.end());
    const auto edge = edge_of.find(side);
    if (edge == edge_of.end()) {
      wrong += faces.size() != 2 || faces[0] != faces[1];
      continue;
    }
    std::vector<Index> expected;
    for (const Index around : flat.edges[edge->second].around) expected.push_back(around >> 1);
    std::sort(expected.begin(), expected.end());
    wrong += faces != expected;
  }
  for (const auto& [side, edge] : edge_of) wrong += faces_at.count(side) == 0 && !flat.edges[edge].around.empty();
  CHECK(wrong == 0);

  // Areas, by the exact points.
  std::vector<double> areas(flat.faces.size(), 0);
  for (const auto& t : mesh.triangles) areas[t.entity] += area(at(t.points[0]), at(t.points[1]), at(t.points[2]));
  for (Index f = 0; f < flat.faces.size(); ++f) {
    double exact = 0;
    for (const auto& t : flat.faces[f].triangles) {
      Vector p[3];
      for (std::size_t k = 0; k < 3; ++k) p[k] = view.complex->points.nearest(flat.points[t[k]]);
      exact += area(p[0], p[1], p[2]);
    }
    CHECK(areas[f] == Approx(exact).epsilon(1e-9).margin(1e-15));
  }

  // Angles, and what is said of them; sizes.
  const InputSegments input(view, flat);
  std::size_t below = 0, unforced = 0, long_sides = 0;
  double least = 180;
  for (const auto& t : mesh.triangles) {
    double here = 180;
    std::size_t corner = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector &a = at(t.points[(k + 2) % 3]), &b = at(t.points[k]), &c = at(t.points[(k + 1) % 3]);
      if (angle(a, b, c) < here) here = angle(a, b, c), corner = k;
      if (!options.size) continue;
      const Vector middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
      long_sides += apart(a, b) > options.size(middle) * (1 + 1e-12);
    }
    least = std::min(least, here);
    if (here > 25 - 1e-5) continue;
    ++below;
    unforced += !input.small_angle(at(t.points[(corner + 1) % 3]), at(t.points[(corner + 2) % 3]));
  }
  CHECK(unforced == 0);
  CHECK(long_sides == 0);
  std::size_t told = 0, triangles = 0;
  double told_least = 180;
  for (const FaceTriangles& of : made.groups) {
    triangles += of.triangles;
    told += of.why[std::size_t(SmallAngle::input)];
    CHECK(of.why[std::size_t(SmallAngle::digits)] == 0);
    CHECK(of.why[std::size_t(SmallAngle::bound)] == 0);
    told_least = std::min(told_least, of.least_angle);
  }
  CHECK(triangles == mesh.triangles.size());
  CHECK(told == below);
  if (!mesh.triangles.empty()) CHECK(told_least == Approx(least).epsilon(1e-6).margin(1e-5));
  return made;
}

Case sheets(const std::vector<std::vector<RationalPoint>>& polygons) {
  Soup soup;
  for (const auto& polygon : polygons) add_sheet(soup, polygon);
  Case c(soup);
  c.show(c.unite());
  return c;
}

}  // namespace

TEST_CASE("surface: solids, walls, dangling faces, wires and points", "[mesh][surface]") {
  for (Case (*make)() : {two_regions, ring, nested, hinge, pierced, oblique}) {
    const Case c = make();
    const SurfaceTriangles made = checked(c.view());
    CHECK(made.rounding.embedded);
    CHECK(made.kept == 0);
  }
  Case c = two_regions();
  for (const double size : {0.3, 0.07}) {
    const auto graded = [&](const Vector& p) { return size + 0.2 * apart(p, {1, 1, 1}); };
    CHECK(checked(c.view(), {.size = graded}).mesh.triangles.size() > 6 / (size * size));
  }
}

TEST_CASE("surface: files say the same as the mesh", "[mesh][surface]") {
  Case c = two_regions();
  const Mesh mesh = surface_triangles(c.view()).mesh;
  const MeshFile msh = read_msh(msh_text(mesh)), medit = read_medit(medit_text(mesh));
  for (const MeshFile* file : {&msh, &medit}) {
    CHECK(file->count(3) == 0);
    CHECK(file->count(2) == mesh.triangles.size());
    CHECK(file->count(1) == mesh.segments.size());
    CHECK(file->measure(file->in_group(2, "wall rock | seam")) == Approx(4).epsilon(1e-14));
    CHECK(file->measure(file->in_group(2, "face of leaf2")) == Approx(1).epsilon(1e-14));
    CHECK(file->measure(file->in_group(1, "wire of leaf3")) == Approx(1).epsilon(1e-14));
  }
  CHECK(msh.names_of(3).empty());
  CHECK_THAT(vtu_text(c.view(), mesh), Catch::Contains("NumberOfCells"));
}

TEST_CASE("surface: the size of a wire is kept, too", "[mesh][surface]") {
  Soup soup;
  add_wire(soup, {0, 0, 0}, {10, 0, 0});
  Case c(soup);
  const SurfaceTriangles made = checked(c.view(), {.size = [](const Vector& p) { return 0.01 + 0.1 * p[0]; }});
  CHECK(made.mesh.segments.size() > 20);
  CHECK(made.groups.empty());
  for (const auto& s : made.mesh.segments) {
    const double a = made.mesh.points[s.points[0]][0], b = made.mesh.points[s.points[1]][0];
    CHECK(std::abs(b - a) <= 0.01 + 0.05 * (a + b));
  }
}

TEST_CASE("surface: networks of fractures without a region", "[mesh][surface]") {
  scenes::Random random(11);
  for (const int count : {2, 5, 12}) {
    std::vector<std::vector<RationalPoint>> polygons;
    const auto number = [&] { return Rational(random.between(-50, 50), 50); };
    while (int(polygons.size()) < count) {
      const RationalPoint o{number(), number(), number()}, u{number(), number(), number()},
          v{number(), number(), number()};
      const double across = std::abs(to_double(u[0] * v[1] - u[1] * v[0]));
      if (across < 0.2) continue;
      std::vector<RationalPoint> polygon;
      for (const auto& [s, t] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}}) {
        polygon.push_back({o[0] + s * u[0] + t * v[0], o[1] + s * u[1] + t * v[1], o[2] + s * u[2] + t * v[2]});
      }
      polygons.push_back(polygon);
    }
    checked(sheets(polygons).view());
  }
}

TEST_CASE("surface: random scenes of mixed dimension", "[mesh][surface]") {
  const auto [begin, end] = scenes::seeds(12);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    for (const auto position :
         {scenes::Position::general, scenes::Position::degenerate, scenes::Position::tilted}) {
      CAPTURE(seed, int(position));
      Case c(scenes::make_soup(scenes::random_leaves(seed, 3, position)));
      c.show(c.unite());
      const FlatComplex flat = flatten(c.view());
      const bool wires = std::any_of(flat.edges.begin(), flat.edges.end(), [](const auto& e) { return e.wire; });
      if (flat.faces.empty() && !wires) continue;
      checked(c.view());
    }
  }
}

TEST_CASE("surface: needles and faces that nearly touch end soon", "[mesh][surface]") {
  std::size_t most = 0;  // triangles
  const auto mesh = [&](const ResultView& view) { most = std::max(most, checked(view).mesh.triangles.size()); };
  for (const Rational& thin :
       {Rational(1, 10), Rational(1, 1000), Rational(17453, 1000000000), Rational(1, Integer("100000000000"))}) {
    // A needle; its lines of different lengths; one whose corner is over the middle of its longest side; lines
    // that meet in their middles; one line next to a corner; a fan of needles.
    mesh(sheets({{{0, 0, 0}, {1, 0, 0}, {1, thin, 0}}}).view());
    mesh(sheets({{{0, 0, 0}, {1, 0, 0}, {Rational(9, 10), thin, 0}}}).view());
    mesh(sheets({{{0, 0, 0}, {1, 0, 0}, {Rational(3, 10), thin, 0}}}).view());
    Soup crossed;
    add_sheet(crossed, {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    add_wire(crossed, {-1, 0, 0}, {1, 0, 0});
    add_wire(crossed, {Rational(-9, 10), -thin, 0}, {Rational(4, 5), thin, 0});
    Case c(crossed);
    c.show(c.unite(Dominance::equal));
    mesh(c.view());
    std::vector<std::vector<RationalPoint>> fan;
    for (int i = 0; i < 5; ++i) fan.push_back({{0, 0, 0}, {1 + i, i * thin, 0}, {2 + i, (i + 1) * thin, 0}});
    mesh(sheets(fan).view());
  }
  CHECK(most < 20'000);
}

TEST_CASE("surface: a gap that would take too many points keeps what it has", "[mesh][surface]") {
  // A strip that is 1e-5 wide takes 1e5 good triangles at least.
  const Case c = sheets({{{0, 0, 0}, {1, 0, 0}, {1, Rational(1, 100000), 0}, {0, Rational(11, 1000000), 0}}});
  const SurfaceTriangles made = surface_triangles(c.view(), {.max_points = 5000});
  CHECK(made.mesh.points.size() == 4);
  REQUIRE(made.groups.size() == 1);
  CHECK(made.groups[0].why[std::size_t(SmallAngle::bound)] > 0);
  CHECK(made.groups[0].area == Approx(1.05e-5).epsilon(1e-9));
  // With more points it has them.
  CHECK(checked(c.view(), {.max_points = 10'000'000}).mesh.points.size() > 100'000);
}

TEST_CASE("surface: gaps of one width are filled together, or not at all", "[mesh][surface]") {
  // Points suffice for one of the four sides of the slab.
  Soup soup;
  add_box(soup, {0, 0, 0}, {10, 10, Rational(1, 10000)});
  const Case c(soup);
  const SurfaceTriangles made = surface_triangles(c.view(), {.max_points = 5'000'000});
  CHECK(made.mesh.triangles.size() == 12);
  REQUIRE(made.groups.size() == 1);
  CHECK(made.groups[0].why[std::size_t(SmallAngle::bound)] == 8);
}

TEST_CASE("surface: long gaps are filled from the widest on, and no point is for nothing", "[mesh][surface]") {
  // Strips that are 10^2, 10^3 ... 10^7 times longer than wide.
  std::vector<std::vector<RationalPoint>> strips;
  Rational wide(1, 100);
  for (int i = 0; i < 6; ++i, wide = wide / 10)
    strips.push_back({{0, i, 0}, {1, i, 0}, {1, i + wide, 0}, {0, i + wide, 0}});
  const SurfaceTriangles made = surface_triangles(sheets(strips).view(), {.max_points = 500'000});
  std::vector<std::size_t> triangles(6, 0), small(6, 0);
  for (const auto& t : made.mesh.triangles) {
    const auto strip = std::size_t(made.mesh.points[t.points[0]][1]);
    ++triangles[strip];
    const Vector &a = made.mesh.points[t.points[0]], &b = made.mesh.points[t.points[1]],
                 &c = made.mesh.points[t.points[2]];
    small[strip] += std::min({angle(a, b, c), angle(b, c, a), angle(c, a, b)}) < 25 - 1e-5;
  }
  for (std::size_t i = 0; i < 2; ++i) CHECK(small[i] == 0);
  for (std::size_t i = 3; i < 6; ++i) CHECK(triangles[i] == 2);
}

TEST_CASE("surface: many lines that nearly lie on each other take a part of the points", "[mesh][surface]") {
  // They cross in angles of some 1e-5, with gaps of any width between them: good triangles would be millions.
  scenes::Random random(5);
  Soup soup;
  add_sheet(soup, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  for (int i = 0; i < 20; ++i) {
    const auto near = [&]() -> Rational {
      return Rational(1, 2) + Rational(random.between(-1000, 1000), 10'000'000);
    };
    const Rational from = near(), to = near();
    add_wire(soup, {0, from, 0}, {1, to, 0});
  }
  Case c(soup);
  c.show(c.unite(Dominance::equal));
  constexpr std::size_t kMost = 100'000;
  const SurfaceTriangles made = surface_triangles(c.view(), {.max_points = kMost});
  CHECK(made.mesh.points.size() < 3 * kMost / 4);
  std::size_t told = 0;
  for (const FaceTriangles& of : made.groups) told += of.why[std::size_t(SmallAngle::bound)];
  CHECK(told > 0);
}

TEST_CASE("surface: a gap that nearly closes leaves points for the rest", "[mesh][surface]") {
  // Two lines at 1e-7 across a sheet take 1e7 triangles and more; a short side in a corner takes a few.
  const Rational thin(1, 10000000), r(1, 100);
  Soup soup;
  add_sheet(soup, {{0, 0, 0}, {1 - r, 0, 0}, {1, r, 0}, {1, 1, 0}, {0, 1, 0}});
  add_wire(soup, {0, Rational(1, 2), 0}, {1, Rational(1, 2), 0});
  add_wire(soup, {0, Rational(1, 2) + thin, 0}, {1, Rational(1, 2) + thin, 0});
  Case c(soup);
  c.show(c.unite(Dominance::equal));
  const SurfaceTriangles made = surface_triangles(c.view(), {.max_points = 20'000});
  CHECK(made.mesh.points.size() < 100);
  std::size_t far = 0, near = 0;
  for (const auto& t : made.mesh.triangles) {
    double least = 180, longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector &a = made.mesh.points[t.points[k]], &b = made.mesh.points[t.points[(k + 1) % 3]];
      least = std::min(least, angle(a, b, made.mesh.points[t.points[(k + 2) % 3]]));
      longest = std::max(longest, apart(a, b));
    }
    if (least > 25 - 1e-5) continue;
    const double height =
        2 * area(made.mesh.points[t.points[0]], made.mesh.points[t.points[1]], made.mesh.points[t.points[2]]) /
        longest;
    ++(height < 1e-4 ? near : far);
  }
  CHECK(far == 0);
  CHECK(near > 0);
  std::size_t told = 0;
  for (const FaceTriangles& of : made.groups) told += of.why[std::size_t(SmallAngle::bound)];
  CHECK(told == near);
}

TEST_CASE("surface: lines that are nearer than digits match each other", "[mesh][surface]") {
  // Short lines make points on the first of two lines that meet in an angle of 1e-12; the second one was the side
  // of thousands of triangles to these, all of them upon each other.
  for (const int count : {1, 20}) {
    Soup soup;
    const Rational half(1, 2), micron(1, 1'000'000);
    add_sheet(soup, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    add_wire(soup, {0, half, 0}, {1, half, 0});
    add_wire(soup, {0, half, 0}, {1, half + Rational(1, Integer("1000000000000")), 0});
    for (int i = 0; i < count; ++i) {
      const Rational x(2 * i + 1, 2 * count);
      add_wire(soup, {x, half - micron, 0}, {x, half - 2 * micron, 0});
    }
    Case c(soup);
    c.show(c.unite(Dominance::equal));
    const Mesh mesh = surface_triangles(c.view()).mesh;
    CHECK(mesh.triangles.size() < std::size_t(400 * count + 200));
    std::map<Index, std::size_t> triangles;
    for (const auto& t : mesh.triangles)
      for (const Index p : t.points) ++triangles[p];
    for (const auto& [point, degree] : triangles) CHECK(degree < 40);
  }
}

TEST_CASE("surface: features of the result ask nothing of facets without room for points", "[mesh][surface]") {
  // The second sheet leaves a strip of the first one that is as wide as some last digits, and asks for short
  // sides.
  const Rational thin(1, Integer("18014398509481984"));
  const auto scene = [&] {
    Soup soup;
    add_sheet(soup, {{3, 0, 0}, {5, 0, 1}, {5, 7, 1}, {3, 7, 0}});
    add_wire(soup, {Rational(11, 3), 0, Rational(1, 3)}, {Rational(11, 3), 7, Rational(1, 3)});
    add_wire(soup, {Rational(11, 3) + 2 * thin, 0, Rational(1, 3) + thin}, {Rational(11, 3), 7, Rational(1, 3)});
    Case c(soup);
    c.show(c.unite(Dominance::equal));
    return c;
  };
  const Case c = scene();
  SurfaceOptions asked;
  asked.overall = 8;
  CHECK(surface_triangles(c.view(), asked).groups.size() == 1);
  asked.overall = 0.5;
  CHECK_THROWS_WITH(surface_triangles(c.view(), asked), Catch::Contains("coarser than asked for"));
}

TEST_CASE("surface: what doubles would make cross keeps its triangles", "[mesh][surface]") {
  // Two oblique sheets that meet in a side, in an angle of some last digits, each with a short side near it, which
  // takes points inside of the sheet: points that are rounded into one of them cross the other.
  const Rational thin(1, Integer("281474976710656"));
  std::vector<std::vector<RationalPoint>> twins(2);
  for (int i = 0; i < 2; ++i) {
    const Rational r(1, i == 0 ? 4 : 16);
    const std::array<std::array<Rational, 2>, 5> corners{{{r, 0}, {30, 0}, {30, 22}, {0, 22}, {0, r}}};
    for (const auto& [u, v] : corners) {
      twins[std::size_t(i)].push_back({5 + u * Rational(2, 3) - v + i * thin * v,
                                       u * Rational(7, 8) - v * Rational(6, 7), (5 * u + 6 * v - 2) / 8});
    }
  }
  const Case c = sheets(twins);
  const SurfaceTriangles made = surface_triangles(c.view());
  CHECK(made.kept > 0);
  CHECK(made.groups.size() == 2);
  CHECK(made.groups[0].why[std::size_t(SmallAngle::digits)] > 0);
  CHECK_THROWS_WITH(surface_triangles(c.view(), {.size = [](const Vector&) { return 0.1; }}),
                    Catch::Contains("coarser than asked for"));
}

TEST_CASE("surface: points of oblique facets stay in their planes, however fine", "[mesh][surface]") {
  // Thin triangles come of points that are rounded off the sides of the polygon: their own normals say nothing.
  const Case c = sheets({{{2, -1, 1}, {4, 5, 1}, {4, 5, 3}, {2, -1, 3}}});
  const SurfaceTriangles made = checked(c.view(), {.size = [](const Vector&) { return 0.028; }});
  CHECK(made.mesh.triangles.size() < 100000);
  for (const Vector& p : made.mesh.points) CHECK(std::abs(3 * p[0] - p[1] - 7) < 1e-14);
}

TEST_CASE("surface: the complex for tetrahedra has the same triangles", "[mesh][surface]") {
  Case c = oblique();
  const FlatComplex flat = flatten(c.view());
  const RoundedPoints points = round_points(c.view(), flat);
  const Plc plc = refined_plc(flat, points);
  const Mesh mesh = surface_triangles(c.view()).mesh;
  CHECK(plc.facets.size() == mesh.triangles.size());
  CHECK(plc.segments.size() == mesh.segments.size());
  CHECK(plc.regions.size() == 2);
  for (std::size_t p = 0; p < points.xyz.size(); ++p) CHECK(plc.points[p] == points.xyz[p]);
}

TEST_CASE("surface: what cannot be meshed says so", "[mesh][surface][errors]") {
  Soup soup;
  add_point(soup, {0, 0, 0});
  CHECK_THROWS_WITH(surface_triangles(Case(soup).view()), Catch::Contains("neither faces nor wires"));
  Case c = ring();
  c.show(topological_operation(*c.complex, Topological::interior, components_of(*c.complex, c.group)).value);
  CHECK_THROWS_WITH(surface_triangles(c.view()), Catch::Contains("apply `closure`"));
  c = ring();
  const auto small = [](const Vector&) { return 1e-3; };
  CHECK_THROWS_WITH(surface_triangles(c.view(), {.size = small, .max_points = 1000}),
                    Catch::Contains("coarser than asked for") && Catch::Contains("--max-points"));
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(surface_triangles(c.view(), {.watch = {{}, stop.get_token()}}), Stopped);
}

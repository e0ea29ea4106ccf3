// Snapped results: every vertex is three doubles, nothing crosses, and regions, walls, wires and points are what
// they were, but for what was thinner than the displacement.
#include "csg/result/snap.h"

#include <cmath>
#include <random>

#include "csg/formats/formats.h"
#include "csg/formats/result_file.h"
#include "csg/leaves/leaf.h"
#include "csg/mesh/mesh.h"
#include "csg/mesh/tetrahedra.h"
#include "csg/operators/cnrg.h"
#include "csg/result/rounding.h"
#include "kernel/base/error.h"
#include "kernel/selection/measure.h"
#include "tests/catch.h"
#include "tests/mesh/mesh_cases.h"
#include "tests/result/region_volumes.h"
#include "tests/result/stops.h"
#include "tests/scenes/mesh_readers.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

const Rational kTiny(1, Integer("100000000000000000"));  // 1e-17

bool plainly_embedded(const ResultView& view) {
  const FlatComplex flat = flatten(view);
  return is_faithful(round_points(view, flat), drawing_of(flat));
}

struct Measure {
  Rational volume = 0;
  double area = 0;
};

/// Volume and area of the boundary of each component with regions.
std::map<Component, Measure> measures(const ResultView& view) {
  const Selection selection = selection_of(*view.complex, *view.value);
  std::map<Component, std::vector<RegionId>> cells;
  for (const auto& [cell, component] : selection.regions) cells[component].push_back(cell);
  std::map<Component, Measure> result;
  for (const auto& [component, list] : cells) {
    Measure& m = result[component];
    m.volume = *volume(*view.complex, list);
    for (const RegionId r : list) {
      for (const HalfFace h : view.complex->region_faces[r]) {
        m.area += std::sqrt(to_double(squared_area(*view.complex, h.face())));
      }
    }
  }
  return result;
}

/// What holds for every snapped result.
void check_snapped(const ResultView& exact, const SnappedResult& snapped) {
  const ResultView view = snapped.shown(exact);
  INFO(snapped.report().text());
  REQUIRE(snapped.report().rounds > 0);
  REQUIRE(validate(*view.complex) == "");
  const FlatComplex flat = flatten(view);
  const RoundedPoints points = round_points(view, flat);
  CHECK(points.moved == 0);
  CHECK(is_faithful(points, drawing_of(flat)));

  auto before = measures(exact), after = measures(view);
  std::size_t lost = 0;
  for (auto& [component, was] : before) {
    const Measure now = after[component];
    lost += now.area == 0;
    CHECK(to_double(abs(was.volume - now.volume)) <= (was.area + now.area) * snapped.report().displacement);
  }
  CHECK(after.size() == before.size());
  CHECK(lost <= snapped.report().regions);
  for (Component i = 1; i <= exact.value->component_count(); ++i) {
    CHECK(view.value->attributes(i).name == exact.value->attributes(i).name);
    CHECK(view.value->attributes(i).material == exact.value->attributes(i).material);
  }

  // Read back by a leaf of ours: the same triangles, and nothing new.
  const ScratchFolder scratch;
  const RoundingReport report = write(scratch / "s.obj", view);
  CHECK((report.moved == 0 && report.embedded));
  const auto leaf = prepare(MeshShape{scratch / "s.obj", Fill::none, false});
  const auto built_read = build_complex(make_soup({{leaf}}));
  const Complex& read = *built_read;
  CHECK(validate(read) == "");
  CHECK(read.face_count() == drawing_of(flat).triangles.size());
  for (const VertexId v : read.vertices) CHECK(read.points.is_double(v));
}
SnapReport check_snapped(const Case& c, int most_rounds, double farthest) {
  const SnappedResult snapped(c.view(), false);
  check_snapped(c.view(), snapped);
  CHECK(snapped.report().rounds <= most_rounds);
  CHECK(snapped.report().displacement < farthest);
  return snapped.report();
}

/// A box about the origin, turned about (1, 2, 3) by the quaternion 1 + step (i + 2 j + 3 k).
LeafId add_turned_box(Soup& soup, const RationalPoint& half, const Rational& step, const RationalPoint& center) {
  const Transform turn = [&] {
    const Rational x = step, y = 2 * step, z = 3 * step, square = 1 + x * x + y * y + z * z;
    Transform t;
    t.linear = {{{1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)},
                 {2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)},
                 {2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z}}};
    for (auto& row : t.linear)
      for (Rational& entry : row) entry /= square;
    t.offset = center;
    return t;
  }();
  const LeafId leaf = soup.add_leaf(Fill::winding);
  PointId p[8];
  for (int i = 0; i < 8; ++i) {
    p[i] = soup.add_point(turn.apply({i & 1 ? half[0] : Rational(-half[0]), i & 2 ? half[1] : Rational(-half[1]),
                                      i & 4 ? half[2] : Rational(-half[2])}));
  }
  add_box_faces(soup, leaf, p);
  return leaf;
}

}  // namespace

TEST_CASE("snap: what rounding leaves as it is stays the exact result", "[snap]") {
  Case c = oblique();
  const SnappedResult snapped(c.view(), false);
  CHECK(snapped.report().rounds == 0);
  CHECK(snapped.shown(c.view()).complex == c.complex.get());
  CHECK(file_text("m.msh", snapped.shown(c.view())).text == file_text("m.msh", c.view()).text);
}

TEST_CASE("snap: a gap thinner than doubles closes to a wall", "[snap]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0, 0, 1 + kTiny}, {1, 1, 2});
  Case c(soup, {{{"low", "clay", {}}}, {{"high", "", {}}}});
  c.materials = {{"clay", ""}};
  c.show(c.unite());
  REQUIRE(!plainly_embedded(c.view()));
  CHECK_THROWS_AS(tetrahedra(c.view()), RoundingFault);
  const SnappedResult snapped(c.view(), false);
  check_snapped(c.view(), snapped);
  CHECK(snapped.report().faces == 0);
  CHECK(snapped.report().regions == 0);
  CHECK(snapped.report().moved == 4);
  CHECK(snapped.report().added == 0);
  const ResultView view = snapped.shown(c.view());
  CHECK(active_counts(*view.simplified) == std::array<std::size_t, 4>{12, 20, 11, 2});
  const MeshFile mesh = read_msh(msh_text(tetrahedra(view).mesh));
  CHECK(mesh.volume("low") == 1);
  CHECK(mesh.volume("high") == 1);
  CHECK(mesh.volume("material clay") == 1);
  CHECK(mesh.measure(mesh.in_group(2, "wall low | high")) == Approx(1));
  // As one component there is no wall, and formats of solids take it.
  Case joined(soup);
  joined.show(NodeValue(unify(*joined.complex, components_of(*joined.complex, joined.unite())).value));
  REQUIRE(!plainly_embedded(joined.view()));
  const SnappedResult one(joined.view(), false);
  check_snapped(joined.view(), one);
  CHECK(active_counts(*one.shown(joined.view()).simplified)[3] == 1);
  CHECK_NOTHROW(off_text(one.shown(joined.view())));
}

TEST_CASE("snap: a slab thinner than doubles vanishes, a sheet does not", "[snap]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {3, 0, 1}, {4, 1, 1 + kTiny});
  add_sheet(soup, {{0, 0, 3}, {1, 0, 3}, {1, Rational(1, 3), 3}});
  add_wire(soup, {2, 0, 5}, {2, 0, 5 + kTiny});
  Case c(soup);
  c.show(c.unite());
  REQUIRE(!plainly_embedded(c.view()));
  const SnappedResult snapped(c.view(), false);
  const ResultView view = snapped.shown(c.view());
  CHECK(snapped.report().faces == 6);
  CHECK(snapped.report().regions == 1);
  CHECK(snapped.report().wires == 1);
  CHECK(snapped.report().displacement >= 1e-17);
  CHECK(snapped.report().displacement < 3e-17);  // 1/3, rounded
  CHECK_THAT(snapped.report().text(), Catch::EndsWith("; 6 faces vanished; 1 wire vanished; 1 region vanished"));
  CHECK(snapped.report().lost_regions == std::vector<std::string>{"a region of leaf1, r2, at (3, 0, 1)"});
  CHECK(validate(*view.complex) == "");
  CHECK(active_counts(*view.simplified) == std::array<std::size_t, 4>{11, 15, 7, 1});
  const FlatComplex flat = flatten(view);
  CHECK(round_points(view, flat).moved == 0);
}

TEST_CASE("snap: regions that vanish are named, and their components are gone", "[snap]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {3, 0, 1}, {4, 1, 1 + kTiny});
  const LeafId two = add_box(soup, {5, 0, 0}, {6, 1, 1});
  for (const int x : {7, 9}) {  // of the same leaf a slab and a cube
    PointId p[8];
    for (int i = 0; i < 8; ++i) {
      const Rational top = x == 7 ? Rational(1) + kTiny : Rational(2);
      p[i] = soup.add_point(RationalPoint{x + (i & 1 ? 1 : 0), i & 2 ? 1 : 0, i & 4 ? top : Rational(1)});
    }
    add_box_faces(soup, two, p);
  }
  Case c(soup, {{{"rock", "clay", {}}}, {{"dust", "clay", {{"density", Rational(2)}}}}, {{"sand", "", {}}}});
  c.show(c.unite());
  ResultNames names;
  for (const LeafInfo& info : c.infos) names.leaves.push_back(info.name);
  const Result exact(c.complex, c.group, names);
  SnapReport report;
  const Result snapped = snap(exact, &report);
  INFO(report.text());
  CHECK(report.regions == 2);
  CHECK_THAT(report.text(), Catch::EndsWith("; 2 regions vanished"));
  const std::vector<std::string> told = report.warnings();
  REQUIRE(told.size() == 2);
  CHECK_THAT(told[0], Catch::StartsWith("the region dust, r") &&
                          Catch::Contains(", at (3, 0, 1), is thinner than ") &&
                          Catch::EndsWith("e-17 and has vanished"));
  CHECK_THAT(told[1], Catch::StartsWith("the region sand, r") && Catch::Contains(", at (7, 0, 1), "));
  // The file has no component without cells, and is read back.
  CHECK(snapped.component_count() + 2 == exact.component_count());
  const ScratchFolder scratch;
  write(scratch / "left.json", snapped);
  const Result read = read_result(scratch / "left.json");
  CHECK(volumes(read) == std::map<std::string, Rational>{{"rock", 1}, {"sand", 2}});
  CHECK(active_counts(read.cells()) == active_counts(snapped.cells()));
  // As one component, of which pieces vanish.
  const Result one(c.complex, unify(*c.complex, components_of(*c.complex, c.group)).value, names);
  snap(one, &report);
  REQUIRE(report.lost_regions.size() == 1);
  CHECK_THAT(report.lost_regions[0], Catch::Contains(" (2 pieces), r") && Catch::Contains(", at (3, 0, 1)"));
}

TEST_CASE("snap: a region that is parted is told", "[snap]") {
  // Two cubes and a neck between them that is thinner than doubles, as one region.
  Soup soup;
  const Rational third(1, 3);
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {1, 0, third}, {2, 1, third + kTiny / 2});
  add_box(soup, {2, 0, 0}, {Rational(5, 2), 1, 1});
  Case c(soup, {{{"rock", "", {}}}, {{"rock", "", {}}}, {{"rock", "", {}}}});
  c.show(c.unite());
  ResultNames names;
  for (const LeafInfo& info : c.infos) names.leaves.push_back(info.name);
  const Result one(c.complex, unify(*c.complex, components_of(*c.complex, c.group)).value, names);
  SnapReport report;
  snap(one, &report);
  INFO(report.text());
  CHECK(report.lost_regions.empty());
  REQUIRE(report.parted_regions.size() == 1);
  CHECK_THAT(report.parted_regions[0],
             Catch::StartsWith("the region ") &&
                 Catch::EndsWith(" is in 2 pieces now and was in one, the smallest at (2, 0, 0)"));
  CHECK(report.warnings() == report.parted_regions);
}

TEST_CASE("snap: crossing sheets, wires and points keep what they came from", "[snap]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {Rational(1, 3), Rational(1, 3), Rational(1, 3)});
  add_sheet(soup,
            {{-1, -1, Rational(1, 7)}, {1, -1, Rational(1, 7)}, {1, 1, Rational(1, 7)}, {-1, 1, Rational(1, 7)}});
  add_sheet(soup, {{-1, -1, Rational(1, 7) - kTiny},
                   {1, -1, Rational(1, 7) + kTiny},
                   {1, 1, Rational(1, 7) + kTiny},
                   {-1, 1, Rational(1, 7) - kTiny}});
  add_wire(soup, {Rational(1, 9), Rational(1, 9), -1}, {Rational(1, 9), Rational(1, 9), 1});
  add_point(soup, {Rational(1, 5), Rational(1, 5), Rational(1, 4)});
  add_point(soup, {Rational(7, 5), Rational(1, 5), Rational(1, 4)});
  Case c(soup, {{{"block", "", {}}}});
  c.show(c.unite(Dominance::right));
  REQUIRE(!plainly_embedded(c.view()));
  const SnappedResult snapped(c.view(), false);
  const ResultView view = snapped.shown(c.view());
  check_snapped(c.view(), snapped);
  const FlatComplex flat = flatten(view);
  std::set<std::uint32_t> of_faces;
  for (const auto& f : flat.faces) {
    for (const LeafCell& cell : f.origin.cells) {
      if (cell.dimension == 2) of_faces.insert(cell.leaf.value());
    }
  }
  CHECK(of_faces == std::set<std::uint32_t>{0, 1, 2});
  std::size_t wires = 0, free = 0;
  for (const auto& e : flat.edges) {
    if (!e.wire) continue;
    ++wires;
    CHECK(e.origin.leaves == ShortList<LeafId, 2>{LeafId(3)});
    CHECK(std::count(e.origin.cells.begin(), e.origin.cells.end(), LeafCell{LeafId(3), 1, 0}) == 1);
  }
  for (const auto& v : flat.vertices) {
    free += v.free;
    const auto from = [&](std::uint32_t leaf) { return v.origin.leaves == ShortList<LeafId, 2>{LeafId(leaf)}; };
    if (v.free) CHECK((from(4) || from(5)));
  }
  CHECK(wires == 4);
  CHECK(free == 2);
  CHECK_NOTHROW(file_text("m.msh", view));
  CHECK_NOTHROW(vtu_text(view));
  CHECK_NOTHROW(smesh_text(view));
  CHECK_NOTHROW(poly_text(view));
  CHECK_NOTHROW(file_text("m.mesh", view));
}

TEST_CASE("a drawing is broken though it has as many cells as it should", "[snap]") {
  // Along an edge from the first point: the second one lies on the side of the other triangle, which it cuts.
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Drawing touching{{{0, 1, 3}, {0, 2, 4}}};
  const Complex& complex = *redraw({points, 1}, touching).complex;
  CHECK(complex.vertex_count() == 5);
  CHECK(complex.edge_count() == 6);
  CHECK(complex.face_count() == 2);
  CHECK_FALSE(is_faithful({points, 1}, touching));
  CHECK(is_faithful({points, 1}, {{{0, 1, 3}, {0, 3, 4}}}));

  // Wires: one along the side of a triangle, one that ends on another, one by itself.
  CHECK_FALSE(is_faithful({points, 1}, {{{0, 2, 4}}, {{0, 1}}}));
  CHECK_FALSE(is_faithful({points, 1}, {{}, {{0, 2}, {1, 4}}}));
  CHECK_FALSE(is_faithful({points, 1}, {{}, {{0, 1}, {0, 2}}}));
  CHECK(is_faithful({points, 1}, {{}, {{0, 1}, {1, 2}, {3, 4}}}));
}

TEST_CASE("a drawing is broken where a part of it has passed through a wall", "[snap]") {
  std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {0.5, 0.5, 0.5}};
  Drawing drawing{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, {}, {4}, {4, {7, 9}}, {}, {9}};
  CHECK(is_faithful({points, 1}, drawing));
  points[4] = {5, 5, 5};
  CHECK_FALSE(is_faithful({points, 1}, drawing));
  drawing.around_points = {7};
  CHECK(is_faithful({points, 1}, drawing));
  points[4] = {1, 1, 2};  // on the wall
  CHECK_FALSE(is_faithful({points, 1}, drawing));
}

namespace {

Case nearly_coincident(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto third = [&] { return Rational(long(random() % 97 + 1), 3); };
  const RationalPoint half{third(), third(), third()}, center{third() / 7, third() / 7, third() / 7};
  Soup soup;
  add_turned_box(soup, half, 0, center);
  add_turned_box(soup, half, kTiny * Rational(long(random() % 60 + 1)), center);
  add_box(soup, {0, 0, 0}, {50, Rational(1, 3), Rational(1, 7)});
  Case c(soup, {{{"a", "", {}}}, {{"b", "", {}}}, {{"c", "", {}}}});
  c.show(c.unite(seed % 2 == 0 ? Dominance::equal : Dominance::left));
  return c;
}

}  // namespace

TEST_CASE("snap: stopped at each stage", "[snap]") {
  const Case c = nearly_coincident(1);
  check_stops([&](const Watch& watch) { SnappedResult(c.view(), false, watch); },
              {"snap", "snap, round 1: refine: contacts", "snap, round 2: refine: contacts"});
}

TEST_CASE("snap: nearly coincident boxes", "[snap]") {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u, 7u, 8u}) {
    INFO("seed " << seed);
    const Case c = nearly_coincident(seed);
    if (plainly_embedded(c.view())) continue;
    const SnappedResult snapped(c.view(), false);
    if (snapped.report().regions == 0) check_snapped(c.view(), snapped);
    CHECK(snapped.report().displacement < 1e-10);
    const SnappedResult raw(c.view(), true), again(c.view(), false);
    CHECK(raw.report().text() == snapped.report().text());
    CHECK(obj_text(again.shown(c.view())).text == obj_text(snapped.shown(c.view())).text);
  }
}

// Their edges cross in each other's facets, or miss each other by last digits; to cut them where they cross moves
// them, and then others cross.
TEST_CASE("snap: two triangulations of one plane become one", "[snap]") {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    const auto part = [&] { return double(random() % 1'000'000) / 1e6; };
    const std::array<double, 3> u{part(), part(), part()}, v{-part(), part(), -part()};
    Soup soup;
    const auto add = [&](int n, double shift, double turn) {
      const LeafId leaf = soup.add_leaf(Fill::none);
      std::vector<PointId> at;
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const double x = double(i) / n, y = double(j) / n;
          const double s = shift + 100 * (x - turn * y), t = shift + 100 * (turn * x + y);
          at.push_back(soup.add_point(s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]));
        }
      }
      std::uint32_t number = 0;
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const PointId p[4] = {at[i * (n + 1) + j], at[(i + 1) * (n + 1) + j], at[(i + 1) * (n + 1) + j + 1],
                                at[i * (n + 1) + j + 1]};
          soup.add_triangle(leaf, p[0], p[1], p[2], number, number), ++number;
          soup.add_triangle(leaf, p[0], p[2], p[3], number, number), ++number;
        }
      }
    };
    add(8, 0, 0);
    add(7, 10 * part(), part());
    Case c(soup);
    c.show(c.unite());
    if (plainly_embedded(c.view())) continue;
    CHECK(check_snapped(c, 6, 1e-10).added < 2000);
  }
}

// Their lines on the faces of the box are nearly one: what is between them has corners on both.
TEST_CASE("snap: two sheets of two triangles in one oblique plane", "[snap]") {
  Soup soup;
  add_box(soup, {Rational(-1, 5), Rational(-1, 5), Rational(-1, 5)}, {1, 1, 1});
  const auto add = [&](const std::array<std::array<double, 3>, 4>& corners, const int(&faces)[2][3]) {
    const LeafId leaf = soup.add_leaf(Fill::none);
    std::array<PointId, 4> p;
    for (std::size_t i = 0; i < 4; ++i) p[i] = soup.add_point(corners[i][0], corners[i][1], corners[i][2]);
    for (std::uint32_t f = 0; f < 2; ++f)
      soup.add_triangle(leaf, p[std::size_t(faces[f][0])], p[std::size_t(faces[f][1])],
                        p[std::size_t(faces[f][2])], f, f);
  };
  add({{{-0.6704076791806961, 0.2417719069204161, 0.9281445924685663},
        {0.9439702721230823, -0.21589294544540463, 1.200773852184369},
        {-0.2039702721230823, 1.0358929454454047, -0.500773852184369},
        {1.410407679180696, 0.5782280930795839, -0.22814459246856633}}},
      {{0, 1, 3}, {0, 3, 2}});
  add({{{-0.36476437924979094, 0.01131747209088041, 1.2138133762136725},
        {1.3038154631215295, -0.10097447333454102, 0.9084745011507791},
        {-0.5638154631215296, 0.9209744733345409, -0.20847450115077915},
        {1.104764379249791, 0.8086825279091197, -0.5138133762136725}}},
      {{0, 1, 2}, {1, 3, 2}});
  Case c(soup);
  c.show(c.unite());
  REQUIRE(!plainly_embedded(c.view()));
  check_snapped(c, 3, 1e-13);
}

// Three surfaces in one plane, as far as doubles show it. On the faces that they cross they draw lines with a
// narrow face between each two; of those only the lines stay.
TEST_CASE("snap: a sheet between two boxes in one oblique plane", "[snap]") {
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    const auto part = [&] { return double(random() % 1'000'000) / 1e6; };
    const std::array<double, 3> u{0.6 + part() / 9, 0.5, part()}, v{-part(), 0.4, 0.7};
    const std::array<double, 3> w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    Soup soup;
    const auto point = [&](double r, double s, double t) {
      return soup.add_point(r * u[0] + s * v[0] + t * w[0], r * u[1] + s * v[1] + t * w[1],
                            r * u[2] + s * v[2] + t * w[2]);
    };
    std::uint32_t number = 0;
    const auto add_quad = [&](LeafId leaf, PointId a, PointId b, PointId c, PointId d) {
      soup.add_triangle(leaf, a, b, c, number, number), ++number;
      soup.add_triangle(leaf, a, c, d, number, number), ++number;
    };
    const auto add_turned = [&](double r, double s, double turn, double lo, double hi) {
      const LeafId leaf = soup.add_leaf(Fill::winding);
      PointId p[8];
      for (int i = 0; i < 8; ++i) {
        const double x = i & 1, y = i >> 1 & 1;
        p[i] = point(r + x - turn * y, s + turn * x + y, i & 4 ? hi : lo);
      }
      add_quad(leaf, p[0], p[2], p[3], p[1]), add_quad(leaf, p[4], p[5], p[7], p[6]);
      add_quad(leaf, p[0], p[1], p[5], p[4]), add_quad(leaf, p[2], p[6], p[7], p[3]);
      add_quad(leaf, p[0], p[4], p[6], p[2]), add_quad(leaf, p[1], p[3], p[7], p[5]);
    };
    add_turned(part(), part(), 0.3 + part(), 0, 1);
    add_turned(part(), part(), part(), -1, 0);
    const LeafId sheet = soup.add_leaf(Fill::none);
    const double r = part() - 0.5, s = part() - 0.5, turn = part();
    const auto at = [&](int i, int j) { return point(r + (i - turn * j) / 2, s + (turn * i + j) / 2, 0); };
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) add_quad(sheet, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));

    Case c(soup);
    c.show(c.unite());
    if (plainly_embedded(c.view())) continue;
    check_snapped(c, 12, 1e-10);
  }
}

// Their corners are in one plane but for the last digits of a text file, a billion units in the last place of
// doubles and more: they cross at so small angles that the lines where they do move by more than such digits when
// they are rounded.
TEST_CASE("snap: sheets of one plane that were rounded to few digits", "[snap]") {
  int many = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    const auto part = [&] { return double(random() % 1'000'000) / 1e6; };
    const std::array<double, 3> u{0.5 + part() / 2, part() / 2, -part()}, v{-part(), 0.5, part()};
    const double digits = std::pow(10.0, std::array<int, 4>{6, 9, 11, 13}[seed % 4]);
    Soup soup;
    add_box(soup, {Rational(-1, 5), Rational(-1, 5), Rational(-1, 5)}, {1, 1, 1});
    for (int sheet = 0; sheet < 3; ++sheet) {
      const LeafId leaf = soup.add_leaf(Fill::none);
      const int n = 2 + int(random() % 3);
      const double turn = sheet == 2 ? 0.4 : 0, size = 0.8 + part();
      std::vector<PointId> at;
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          const double x = size * (double(i) / n - 0.5), y = size * (double(j) / n - 0.5);
          const double s = x - turn * y, t = turn * x + y;
          std::array<double, 3> p;
          for (std::size_t k = 0; k < 3; ++k) p[k] = std::round((0.37 + s * u[k] + t * v[k]) * digits) / digits;
          at.push_back(soup.add_point(p[0], p[1], p[2]));
        }
      }
      std::uint32_t number = 0;
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          std::array<PointId, 4> p{at[i * (n + 1) + j], at[(i + 1) * (n + 1) + j], at[(i + 1) * (n + 1) + j + 1],
                                   at[i * (n + 1) + j + 1]};
          if (random() % 2) std::rotate(p.begin(), p.begin() + 1, p.end());
          soup.add_triangle(leaf, p[0], p[1], p[2], number, number), ++number;
          soup.add_triangle(leaf, p[0], p[2], p[3], number, number), ++number;
        }
      }
    }
    Case c(soup);
    c.show(c.unite());
    if (plainly_embedded(c.view())) continue;
    const SnappedResult snapped(c.view(), false);
    many += snapped.report().rounds > 2;
    check_snapped(c.view(), snapped);
    CHECK(snapped.report().rounds <= 40);
    CHECK(snapped.report().displacement < 1000 / digits);
  }
  CHECK(many > 2);
}

TEST_CASE("snap: a region without bounds stays one", "[snap]") {
  Soup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0, 0, 1 + kTiny}, {1, 1, 2});
  Case c(soup);
  c.show(NodeValue(complement(*c.complex, components_of(*c.complex, c.unite())).value));
  const SnappedResult snapped(c.view(), false);
  const ResultView view = snapped.shown(c.view());
  CHECK(snapped.report().rounds == 1);
  const FlatComplex flat = flatten(view);
  CHECK(round_points(view, flat).moved == 0);
  const auto outside =
      std::find_if(flat.regions.begin(), flat.regions.end(), [](const auto& r) { return !r.bounded; });
  REQUIRE(outside != flat.regions.end());
  CHECK(outside->component == 1);
  CHECK_NOTHROW(vtu_text(view));
}

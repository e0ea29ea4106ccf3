// Local shapes of known sets, and of random ones in a grid against a count over octants; one-sided sheets.
#include "kernel/selection/manifold.h"

#include <map>

#include "kernel/base/union_find.h"
#include "kernel/selection/homology.h"
#include "tests/catch.h"
#include "tests/operators/pieces.h"
#include "tests/scenes/scene.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using namespace pieces;
using ShapeCounts = std::map<std::string, int>;

std::string words(const LocalShape& shape) {
  CHECK(shape.reason.empty() == (shape.form != LocalForm::non_manifold));
  return shape.reason.empty() ? to_string(shape.form) : shape.reason;
}
struct Shapes {
  ShapeCounts edges, vertices;
  bool manifold;
};
Shapes shapes(const Complex& complex, const CellSet& set) {
  Neighbourhoods neighbourhoods(complex);
  const Manifoldness m = manifoldness(complex, set, neighbourhoods);
  Shapes out;
  out.manifold = m.manifold();
  for (const auto& [e, shape] : m.edges) ++out.edges[words(shape)];
  for (const auto& [v, shape] : m.vertices) ++out.vertices[words(shape)];
  return out;
}
/// Everything bounded.
CellSet bounded(const Complex& complex) {
  CellSet set = all_cells(complex);
  set.regions.erase(set.regions.begin());
  return set;
}
CellSet labelled_set(const Complex& complex) {
  CellSet set;
  for (RegionId r : IdRange<RegionId>(complex.region_count)) {
    if (!complex.labels(r).empty()) set.regions.push_back(r);
  }
  return set;
}

TEST_CASE("shapes of solids", "[manifold]") {
  const auto built_one = complex_of({box({0, 0, 0}, {2, 2, 2})});
  const Complex& one = *built_one;
  const Shapes box_shapes = shapes(one, labelled_set(one));  // asked of its closure
  CHECK(box_shapes.edges == ShapeCounts{{"manifold", 12}});
  CHECK(box_shapes.vertices == ShapeCounts{{"manifold", 8}});
  CHECK(box_shapes.manifold);

  const auto built_parted = complex_of({parted_box({0, 0, 0}, {4, 2, 2}, 2)});
  const Complex& parted = *built_parted;
  Shapes inner = shapes(parted, labelled_set(parted));
  CHECK(inner.edges["interior"] == 4);
  CHECK(inner.vertices["interior"] == 1);
  CHECK(inner.manifold);

  const auto built_edge = complex_of({box({0, 0, 0}, {2, 2, 2}) + box({2, 2, 0}, {4, 4, 2})});
  const Complex& edge = *built_edge;
  const Shapes at_edge = shapes(edge, labelled_set(edge));
  CHECK(at_edge.edges == ShapeCounts{{"manifold", 22}, {"4 boundary faces meet: 2 solid sectors", 1}});
  CHECK(at_edge.vertices == ShapeCounts{{"manifold", 12}, {"a non-manifold edge ends here", 2}});
  CHECK(!at_edge.manifold);

  const auto built_corner = complex_of({box({0, 0, 0}, {2, 2, 2}) + box({2, 2, 2}, {4, 4, 4})});
  const Complex& corner = *built_corner;
  CHECK(shapes(corner, labelled_set(corner)).vertices ==
        ShapeCounts{{"manifold", 14}, {"2 solid cones touch", 1}});
  // The other side of the same vertex.
  CellSet outside;
  outside.regions = {RegionId(0)};
  CHECK(shapes(corner, outside).vertices ==
        ShapeCounts{{"manifold", 14}, {"cones of the outside touch within the solid", 1}});
}

TEST_CASE("shapes of sheets, wires and points", "[manifold]") {
  const auto built_cross = complex_of({sheet({0, 0, 0}, {4, 4, 0}), sheet({0, 2, -2}, {4, 2, 2})});
  const Complex& cross = *built_cross;
  Shapes at_cross = shapes(cross, bounded(cross));
  CHECK(at_cross.edges["4 sheets meet"] == 1);
  CHECK(at_cross.edges["surface border"] == static_cast<int>(cross.edge_count()) - 1);
  CHECK(at_cross.vertices["a non-manifold edge ends here"] == 2);

  const auto built_wires = complex_of({wire({0, 0, 0}, {4, 0, 0}), wire({2, 0, 0}, {2, 3, 0}), point({9, 9, 9}),
                                       wire({0, 5, 0}, {3, 5, 0}), wire({3, 5, 0}, {3, 5, 6})});
  const Complex& wires = *built_wires;
  const Shapes at_wires = shapes(wires, bounded(wires));
  CHECK(at_wires.edges == ShapeCounts{{"wire", 5}});
  CHECK(at_wires.vertices ==
        ShapeCounts{{"3 wires meet", 1}, {"wire end", 5}, {"wire", 1}, {"isolated point", 1}});

  const auto built_pierced = complex_of(
      {sheet({0, 0, 0}, {4, 4, 0}), wire({2, 2, -1}, {2, 2, 1}), wire({0, 0, 0}, {-1, -1, 0}), point({1, 1, 0})});
  const Complex& pierced = *built_pierced;
  const Shapes at_pierced = shapes(pierced, bounded(pierced));
  CHECK(at_pierced.edges == ShapeCounts{{"wire", 3}, {"surface border", 4}});
  CHECK(at_pierced.vertices == ShapeCounts{{"2 wires and a sheet meet in a point", 1},
                                           {"a wire and a sheet meet in a point", 1},
                                           {"surface", 1},
                                           {"surface border", 3},
                                           {"wire end", 3}});

  const auto built_slit = complex_of({sheet({0, 0, 0}, {4, 4, 0}), wire({1, 1, 0}, {2, 2, 0})});
  const Complex& slit = *built_slit;
  const Shapes at_slit = shapes(slit, bounded(slit));
  CHECK(at_slit.edges == ShapeCounts{{"surface border", 4}, {"surface", 1}});
  CHECK(at_slit.vertices == ShapeCounts{{"surface border", 4}, {"surface", 2}});

  const auto built_hung =
      complex_of({box({0, 0, 0}, {4, 4, 4}), sheet({4, 1, 1}, {6, 3, 1}), wire({0, 0, 0}, {-1, 0, 0}),
                  wire({1, 1, 1}, {2, 2, 2}), sheet({1, 1, 3}, {2, 2, 3})});
  const Complex& hung = *built_hung;
  const Shapes at_hung = shapes(hung, bounded(hung));
  CHECK(at_hung.edges == ShapeCounts{{"manifold", 12},
                                     {"a sheet hangs on the solid", 1},
                                     {"surface border", 3},
                                     {"wire", 1},
                                     {"interior", 5}});
  CHECK(at_hung.vertices == ShapeCounts{{"manifold", 7},
                                        {"a wire and a solid cone meet in a point", 1},
                                        {"wire end", 1},
                                        {"a non-manifold edge ends here", 2},
                                        {"surface border", 2},
                                        {"interior", 6}});
  // Two sheets tip to tip.
  const auto built_tips = complex_of({sheet({0, 0, 0}, {1, 1, 0}), sheet({1, 1, 0}, {2, 2, 0})});
  const Complex& tips = *built_tips;
  CHECK(shapes(tips, bounded(tips)).vertices["2 sheets touch in a point"] == 1);
}

TEST_CASE("shapes at the centre of a grid are those that counting octants gives", "[manifold]") {
  std::vector<Piece> leaves;
  for (int x : {0, 1}) {
    for (int y : {0, 1}) {
      for (int z : {0, 1}) leaves.push_back(box({x, y, z}, {x + 1, y + 1, z + 1}));
    }
  }
  const auto built_complex = complex_of(leaves);
  const Complex& complex = *built_complex;
  VertexId centre;
  for (VertexId v : complex.vertices) {
    if (complex.points.rational(v) == RationalPoint{1, 1, 1}) centre = v;
  }
  CellSet middle;
  middle.vertices = {centre};
  const CellSet around = star(complex, middle);
  REQUIRE(around.size() == 27);
  Neighbourhoods neighbourhoods(complex);
  BettiCounter counter(neighbourhoods);
  std::map<LocalForm, int> seen;
  const auto [begin, end] = scenes::seeds(3000);
  for (std::uint64_t seed = begin; seed < end; ++seed) {
    scenes::Random random(seed);
    const int percent = random.one_in(3) ? 0 : random.between(5, 95);
    const int lower = random.one_in(2) ? 0 : random.between(0, 45);
    CellSet set;
    set.vertices = {centre};
    const auto pick = [&](const auto& from, auto& to, int chance) {
      std::copy_if(from.begin(), from.end(), std::back_inserter(to),
                   [&](auto) { return random.below(100) < chance; });
    };
    pick(around.edges, set.edges, lower), pick(around.faces, set.faces, lower);
    pick(around.regions, set.regions, percent);
    const Manifoldness m = manifoldness(complex, set, neighbourhoods);
    const auto at = std::find_if(m.vertices.begin(), m.vertices.end(),
                                 [&](const auto& entry) { return entry.first == centre; });
    REQUIRE(at != m.vertices.end());
    const LocalForm form = at->second.form;
    ++seen[form];
    const CellSet local = intersect(closure(complex, set), around);
    // What is left around the centre, up to homotopy.
    CellSet rest = local;
    rest.vertices.clear();
    const auto b = counter.of(rest).z2;
    const std::map<LocalForm, std::array<long, 3>> expected{
        {LocalForm::interior, {1, 0, 1}},       {LocalForm::manifold, {1, 0, 0}}, {LocalForm::surface, {1, 1, 0}},
        {LocalForm::surface_border, {1, 0, 0}}, {LocalForm::wire, {2, 0, 0}},     {LocalForm::wire_end, {1, 0, 0}},
        {LocalForm::isolated_point, {0, 0, 0}}};
    CAPTURE(seed, to_string(form), at->second.reason);
    if (form != LocalForm::non_manifold) REQUIRE(b == expected.at(form));
    // A half-ball: only closures of octants, one run of them about each edge, solid and outside in one piece each.
    const auto has = [](const auto& list, auto id) { return std::binary_search(list.begin(), list.end(), id); };
    bool half_ball = !set.regions.empty() && set.regions.size() < 8;
    UnionFind octants(complex.region_count);
    std::size_t pieces = 8;
    for (FaceId f : around.faces) {
      const auto [p, q] = complex.face_regions[f];
      const bool in_p = has(set.regions, p), in_q = has(set.regions, q);
      if (in_p == in_q) pieces -= octants.unite(p.value(), q.value());
      half_ball = half_ball && !(has(local.faces, f) && !in_p && !in_q);
    }
    for (EdgeId e : around.edges) {
      int changes = 0, solid = 0;
      const auto behind = [&](std::size_t i) {
        const FaceUse& use = complex.edge_uses[e][i % 4];
        return has(set.regions, complex.face_regions[use.face][use.half_edge.direction()]);
      };
      for (std::size_t i = 0; i < 4; ++i) {
        solid += behind(i);
        changes += behind(i) != behind(i + 1);
      }
      half_ball = half_ball && changes <= 2 && !(solid == 0 && has(local.edges, e));
    }
    REQUIRE((form == LocalForm::manifold) == (half_ball && pieces == 2));
    REQUIRE((form == LocalForm::interior) == (set.regions.size() == 8));
  }
  if (begin == 0 && end >= 3000) CHECK(seen.size() == 8);
}

TEST_CASE("one-sided sheets", "[manifold]") {
  // A strip of triangles on two rows of points around an axis, closed with or without a half turn.
  for (const bool turned : {false, true}) {
    Soup soup;
    const LeafId leaf = soup.add_leaf(Fill::none);
    const int n = 6;
    const int xy[n][2] = {{8, 0}, {4, 7}, {-4, 7}, {-8, 0}, {-4, -7}, {4, -7}};
    // The rung turns by half a turn in six steps: radial and upward parts.
    const int tilt[n][2] = {{0, 3}, {1, 3}, {3, 2}, {3, 0}, {3, -2}, {1, -3}};
    std::vector<PointId> low, high;
    for (int i = 0; i < n; ++i) {
      const double s = turned ? tilt[i][0] / 16.0 : 0, t = turned ? tilt[i][1] : 3;
      high.push_back(soup.add_point(xy[i][0] * (1 + s), xy[i][1] * (1 + s), t));
      low.push_back(soup.add_point(xy[i][0] * (1 - s), xy[i][1] * (1 - s), -t));
    }
    for (int i = 0; i < n; ++i) {
      const bool seam = turned && i == n - 1;
      const PointId a = low[i], b = high[i];
      const PointId c = seam ? high[0] : low[(i + 1) % n], d = seam ? low[0] : high[(i + 1) % n];
      const auto number = static_cast<std::uint32_t>(2 * i);
      soup.add_triangle(leaf, a, c, b, number, number);
      soup.add_triangle(leaf, b, c, d, number + 1, number + 1);
    }
    const auto built_complex = build_complex(soup);
    const Complex& complex = *built_complex;
    REQUIRE(complex.edge_count() == 24);
    const CellSet set = bounded(complex);
    const auto found = sheets(complex, set);
    REQUIRE(found.size() == 1);
    CHECK(found[0].orientable == !turned);
    CHECK(!found[0].closed);
    CHECK(shapes(complex, set).manifold);
    CHECK(betti_numbers(complex, set).z2 == std::array<long, 3>{1, 1, 0});
  }
  const auto built_box_walls = complex_of({box({0, 0, 0}, {1, 1, 1}, 0)});
  const Complex& box_walls = *built_box_walls;
  const auto walls = sheets(box_walls, bounded(box_walls));  // with the inside: none
  CHECK(walls.empty());
  CellSet surface = bounded(box_walls);
  surface.regions.clear();
  const auto closed = sheets(box_walls, surface);
  REQUIRE(closed.size() == 1);
  CHECK(closed[0].orientable);
  CHECK(closed[0].closed);
}

}  // namespace
}  // namespace cnrg

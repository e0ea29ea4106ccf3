// Polygons, wires, points, groups: what is accepted, and which part a refusal names.
#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Points = std::vector<RationalPoint>;

Points square(int low, int high, const Rational& z = 0) {
  return {{low, low, z}, {high, low, z}, {high, high, z}, {low, high, z}};
}

GroupShape cube() {
  GroupShape g;
  for (int i = 0; i < 8; ++i) g.vertices.push_back({i & 1, i >> 1 & 1, i >> 2 & 1});
  const std::vector<std::uint32_t> faces[] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                              {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& face : faces) g.faces.push_back({{face}, {0, 1}, 0, 0});
  return g;
}

}  // namespace

TEST_CASE("polygons with holes") {
  const Soup soup = soup_of(PolygonShape{square(0, 9), {square(1, 3), {{5, 5, 0}, {5, 7, 0}, {7, 5, 0}}}});
  CHECK(soup.fill(LeafId(0)) == Fill::none);
  CHECK(soup.face_count() == 1);
  CHECK(soup.corners(SourceId(0)).size() == 4 + 1 + 4 + 1 + 3);
  CHECK_FALSE(soup.corners(SourceId(0))[4].valid());
  CHECK(planar(soup));
  // A reflex corner, straight corners and a plane that is not along the axes.
  CHECK(error_of(PolygonShape{{{0, 0, 0}, {2, 0, 2}, {4, 0, 4}, {4, 4, 8}, {2, 1, 3}, {0, 4, 4}}, {}}).empty());
  CHECK(error_of(PolygonShape{{{0, 0, 0}, {1, 0, r("1/3")}, {0, 1, r("1/7")}, {r("-1"), 0, r("-1/3")}}, {}})
            .empty());
}

TEST_CASE("polygons that are no faces") {
  const auto error = [](Points outer, std::vector<Points> holes = {}) {
    return error_of(PolygonShape{std::move(outer), std::move(holes)});
  };
  CHECK_THAT(error({{0, 0, 0}, {1, 0, 0}}), Catch::Contains("has 2 points"));
  CHECK_THAT(error({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 0, 0}}), Catch::Contains("on one line"));
  CHECK_THAT(error({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}}),
             Catch::Contains("point 2 and point 3 are both (1, 0, 0)"));
  CHECK_THAT(error({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}), Catch::Contains("point 4, repeats the first"));
  CHECK_THAT(error({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, r("1/1000000000000000000000")}}),
             Catch::Contains("not planar: point 4 (0, 1, 1e-21)"));
  CHECK_THAT(error({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}),
             Catch::Contains("edge 1 (point 1 to point 2) crosses or touches edge 3 (point 3 to point 4)"));
  // touching at a corner, a spike, an overlap of edges that are not neighbours
  CHECK_THAT(error({{0, 0, 0}, {2, 2, 0}, {4, 0, 0}, {4, 4, 0}, {2, 2, 0}, {0, 4, 0}}),
             Catch::Contains("not simple"));
  CHECK_THAT(error({{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, {2, 2, 0}}),
             Catch::Contains("edge 1 (point 1 to point 2) crosses or touches edge 2"));
  CHECK_THAT(error({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 1, 0}, {3, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
             Catch::Contains("not simple"));
  CHECK_THAT(error(square(0, 9), {square(10, 11)}), Catch::Contains("hole 1 of the polygon is outside"));
  CHECK_THAT(error(square(0, 9), {square(1, 8), square(2, 3)}),
             Catch::Contains("hole 2 of the polygon is inside hole 1"));
  CHECK_THAT(error(square(0, 9), {square(1, 4), square(2, 5)}),
             Catch::Contains("loops of the polygon meet: edge 2 of hole 1"));
  CHECK_THAT(error(square(0, 9), {square(0, 4)}), Catch::Contains("meet"));
  CHECK_THAT(error(square(0, 9), {square(1, 2, 1)}),
             Catch::Contains("point 1 of hole 1 (1, 1, 1) is off the plane"));
}

TEST_CASE("large polygons are checked fast") {
  Points zigzag;
  for (int i = 0; i < 2000; ++i) zigzag.push_back({i, i % 2, 0});
  for (int i = 1999; i >= 0; --i) zigzag.push_back({i, i % 2 + 3, 0});
  CHECK(error_of(PolygonShape{zigzag, {}}).empty());
  zigzag[700][1] = 5;
  CHECK_THAT(error_of(PolygonShape{zigzag, {}}), Catch::Contains("not simple: edge 700"));
}

TEST_CASE("polylines and points") {
  const Soup open = soup_of(PolylineShape{{{0, 0, 0}, {1, 0, 0}, {1, r("1/3"), 0}}, false});
  CHECK(open.wires().size() == 2);
  CHECK(open.wires()[1].leaf_edge == 1);
  CHECK(soup_of(PolylineShape{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, true}).wires().size() == 3);
  CHECK_THAT(error_of(PolylineShape{{{0, 0, 0}}, false}), Catch::Contains("at least 2"));
  CHECK_THAT(error_of(PolylineShape{{{0, 0, 0}, {0, 0, 0}}, false}), Catch::Contains("points 1 and 2"));
  CHECK_THAT(error_of(PolylineShape{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}, true}),
             Catch::Contains("points 4 and 1"));
  CHECK(soup_of(PointsShape{{{0, 0, 0}, {0, 0, 0}, {1, 2, 3}}}).isolated().size() == 3);
  CHECK_THAT(error_of(PointsShape{}), Catch::Contains("the list is empty"));
}

TEST_CASE("groups") {
  GroupShape g = cube();
  g.edges = {{0, 7}};
  g.points = {3};
  g.regions[2] = {"rock", "lower"};
  const auto leaf = prepare(g);
  const std::vector<Attributes> regions = leaf->regions();
  REQUIRE(regions.size() == 2);
  CHECK(regions[1].material == "rock");
  CHECK(regions[1].name == "lower");
  const Soup soup = make_soup({{leaf}});
  CHECK(soup.fill(LeafId(0)) == Fill::sides);
  CHECK(closed(soup));
  CHECK(volume(soup) == 1);
  CHECK(soup.face(SourceId(3)).back == 1);
  CHECK(soup.face(SourceId(3)).front == 0);
  CHECK(soup.wires().size() == 1);
  CHECK(soup.isolated().size() == 1);

  SECTION("fill instead of sides") {
    for (Fill fill : {Fill::winding, Fill::parity, Fill::cells, Fill::none}) {
      g.fill = fill;
      const Soup filled = soup_of(g);
      CHECK(filled.fill(LeafId(0)) == fill);
      CHECK(filled.face(SourceId(0)).back == 0);
    }
  }
  SECTION("not closed, or not oriented alike") {
    g.fill = Fill::winding;
    std::swap(g.faces[0].loops[0][0], g.faces[0].loops[0][2]);
    CHECK_THAT(error_of(g), Catch::Contains("not oriented alike along 4 edges"));
    g.fill = Fill::parity;
    CHECK(error_of(g).empty());
    g.faces.pop_back();
    CHECK_THAT(error_of(g), Catch::Contains("not closed along 4 edges"));
    g.fill = Fill::cells;
    CHECK(error_of(g).empty());
  }
  SECTION("faults name the part") {
    g.faces[1].loops[0][2] = 8;
    g.faces[1].line = 12;
    g.faces[1].column = 7;
    CHECK_THAT(error_of(g),
               Catch::Contains("face 1 (line 12, column 7) has the vertex 8, but there are 8 vertices"));
    g = cube();
    g.edges = {{1, 1}};
    CHECK_THAT(error_of(g), Catch::Contains("edge 0 has equal ends"));
    g.edges = {{1, 9}};
    CHECK_THAT(error_of(g), Catch::Contains("edge 0 has the vertex 9"));
    g.edges.clear();
    g.points = {99};
    CHECK_THAT(error_of(g), Catch::Contains("points: entry 0 has the vertex 99"));
    g.points.clear();
    g.vertices[7] = {2, 1, 1};
    CHECK_THAT(error_of(g), Catch::Contains("face 1 is not planar: vertex 5"));
    g = cube();
    g.faces[2].loops.clear();
    CHECK_THAT(error_of(g), Catch::Contains("face 2 has no loops"));
    g = cube();
    g.regions[0] = {};
    CHECK_THAT(error_of(g), Catch::Contains("number regions from 1"));
    g = cube();
    g.faces[0].sides = {0, 4000000000u};
    CHECK_THAT(error_of(g), Catch::Contains("region number 4000000000"));
    CHECK_THAT(error_of(GroupShape{}), Catch::Contains("no faces, edges or points"));
  }
}

TEST_CASE("disks lie in their planes exactly, on their ellipses nearly") {
  for (const RationalPoint& normal : {RationalPoint{0, 0, 1}, RationalPoint{1, 2, 3}, RationalPoint{-1, 0, 4}}) {
    const DiskShape shape{{5, r("1/3"), -2}, {3, 2}, normal, {1, 1, 0}, 12};
    const Soup soup = soup_of(shape);
    REQUIRE(soup.face_count() == 1);
    const Points loop = loops(soup, SourceId(0))[0];
    REQUIRE(loop.size() == 12);
    CHECK(dot(cross(loop[0] - shape.center, loop[1] - shape.center), normal) > 0);
    for (const RationalPoint& p : loop) {
      const RationalPoint w = p - shape.center;
      CHECK(dot(w, normal) == 0);
      const RationalPoint v = cross(normal, shape.along), u = cross(v, normal);
      const double x = to_double(dot(w, u)) / std::sqrt(to_double(dot(u, u))) / 3;
      const double y = to_double(dot(w, v)) / std::sqrt(to_double(dot(v, v))) / 2;
      CHECK(std::abs(x * x + y * y - 1) < 1e-15);
    }
    CHECK(dot(loop[0] - shape.center, cross(normal, shape.along)) == 0);
  }
  CHECK_THAT(error_of(DiskShape{{0, 0, 0}, {1, 0}, {0, 0, 1}, {1, 0, 0}}), Catch::Contains("a radius is 0"));
  CHECK_THAT(error_of(DiskShape{{0, 0, 0}, {1, 1}, {0, 0, 0}, {1, 0, 0}}),
             Catch::Contains("the normal is [0, 0, 0]"));
  CHECK_THAT(error_of(DiskShape{{0, 0, 0}, {1, 1}, {0, 0, 2}, {0, 0, 1}}),
             Catch::Contains("runs along the normal"));
}

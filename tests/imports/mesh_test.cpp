// What a mesh leaf makes of a file's polygons: fill, closedness, coplanar faces, repairs.
#include <random>

#include "csg/leaves/mesh_data.h"
#include "kernel/exact/coplanar.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

Rational r(const char* text) { return *parse_rational(text); }

constexpr const char* kCube =
    "OFF\n8 12 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n"
    "3 0 4 6\n3 0 6 2\n3 1 3 7\n3 1 7 5\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n";

MeshShape mesh(const std::string& path, std::optional<Fill> fill = {}, bool decimal = false) {
  return {path, fill, decimal};
}

std::string without_line(std::string text, int number) {
  std::size_t at = 0;
  for (int i = 1; i < number; ++i) at = text.find('\n', at) + 1;
  return text.erase(at, text.find('\n', at) + 1 - at);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("a closed mesh is a solid whose coplanar triangles are one face") {
  const Files files;
  const auto leaf = prepare(mesh(files.write("cube.off", kCube)));
  CHECK(leaf->notices().empty());
  CHECK(leaf->regions().size() == 1);
  const Soup soup = make_soup({{leaf}});
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(closed(soup));
  CHECK(volume(soup) == 1);
  CHECK(soup.face_count() == 12);
  CHECK(leaf_faces(soup) == 6);
}

TEST_CASE("an open mesh") {
  const Files files;
  const std::string open = replaced(without_line(kCube, 22), "8 12 0", "8 11 0");
  const std::string path = files.write("open.off", open);
  const auto leaf = prepare(mesh(path));
  REQUIRE(leaf->notices().size() == 1);
  CHECK_THAT(leaf->notices()[0],
             Catch::Contains("not closed, it has 3 boundary edges") && Catch::Contains("fill: none"));
  CHECK(leaf->regions().empty());
  CHECK(make_soup({{leaf}}).fill(LeafId(0)) == Fill::none);
  CHECK_THAT(error_of(mesh(path, Fill::winding)),
             Catch::Contains("3 boundary edges, such as (") && Catch::Contains("`fill: cells`"));
  CHECK_THAT(error_of(mesh(path, Fill::parity)), Catch::Contains("not closed"));
  CHECK_THAT(error_of(mesh(path, Fill::sides)), Catch::Contains("fill is sides"));
  CHECK(prepare(mesh(path, Fill::none))->notices().empty());
  CHECK(soup_of(mesh(path, Fill::cells)).fill(LeafId(0)) == Fill::cells);
}

TEST_CASE("closed but not oriented alike") {
  const Files files;
  const std::string path = files.write("turned.off", replaced(kCube, "3 0 4 6", "3 0 6 4"));
  const auto leaf = prepare(mesh(path));
  REQUIRE(leaf->notices().size() == 1);
  CHECK_THAT(leaf->notices()[0], Catch::Contains("closed, but its faces are not oriented alike along 3 edges"));
  CHECK_THAT(error_of(mesh(path, Fill::winding)), Catch::Contains("fill: parity"));
  CHECK(soup_of(mesh(path, Fill::parity)).fill(LeafId(0)) == Fill::parity);
}

TEST_CASE("T-junctions are closed in space") {
  const Files files;
  // The cube's face z = 0 is cut at (1/2, 0, 0), its neighbour y = 0 is not.
  std::string text = replaced(kCube, "8 12 0", "9 13 0");
  text = replaced(text, "1 1 1\n", "1 1 1\n.5 0 0\n");
  text = replaced(text, "3 0 3 1\n", "3 0 3 8\n3 8 3 1\n");
  const auto leaf = prepare(mesh(files.write("junction.off", text)));
  CHECK(leaf->notices().empty());
  CHECK(make_soup({{leaf}}).fill(LeafId(0)) == Fill::winding);
  // A point beside the line leaves a gap.
  const auto gap = prepare(mesh(files.write("gap.off", replaced(text, ".5 0 0", ".5 1e-300 0"))));
  CHECK(gap->notices().size() == 1);
  // Sewn by a triangle of zero area, it is closed edge by edge.
  std::string sewn = replaced(replaced(text, "9 13 0", "9 14 0"), "3 8 3 1\n", "3 8 3 1\n3 0 8 1\n");
  const auto zero = prepare(mesh(files.write("sewn.off", sewn)));
  REQUIRE(zero->notices().size() == 1);
  CHECK_THAT(zero->notices()[0], Catch::Contains("1 face has zero area"));
  const Soup soup = make_soup({{zero}});
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(soup.face_count() == 13);
  CHECK(volume(soup) == 1);
}

TEST_CASE("a face that goes back all the way that it came is left out, with a notice") {
  const Files files;
  const auto leaf = prepare(mesh(
      files.write("thread.off", "OFF\n6 2 0\n2 2 2\n2 2 0\n2 1 0\n4 4 4\n5 4 4\n4 5 4\n4 0 1 0 2\n3 3 4 5\n")));
  REQUIRE(leaf->notices().size() == 2);
  CHECK_THAT(leaf->notices()[0] + leaf->notices()[1], Catch::Contains("1 face has zero area: left out"));
  CHECK(make_soup({{leaf}}).face_count() == 1);
}

TEST_CASE("corners that repeat and faces that collapse") {
  const Files files;
  std::string text = replaced(kCube, "8 12 0", "9 15 0");
  text = replaced(text, "1 1 1\n", "1 1 1\n1 1 1.0\n");  // vertex 8 equals vertex 7
  text += "3 0 0 1\n3 7 8 1\n4 2 2 6 2\n";
  text = replaced(text, "3 4 7 6", "4 4 7 8 6");
  const auto leaf = prepare(mesh(files.write("repeats.off", text)));
  REQUIRE(leaf->notices().size() == 2);
  CHECK_THAT(leaf->notices()[0], Catch::Contains("1 face repeats a corner"));
  CHECK_THAT(leaf->notices()[1], Catch::Contains("3 faces have fewer than 3 distinct corners"));
  const Soup soup = make_soup({{leaf}});
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(soup.point_count() == 8);
  CHECK(volume(soup) == 1);
}

TEST_CASE("polygons stay polygons where they are planar exactly") {
  const Files files;
  const std::string planar_text = "OFF\n4 1 0\n0 0 0\n1 0 1\n1 1 2\n0 1 1\n4 0 1 2 3\n";
  const Soup quad = soup_of(mesh(files.write("quad.off", planar_text)));
  CHECK(quad.face_count() == 1);
  CHECK(quad.corners(SourceId(0)).size() == 4);
  const auto bent =
      prepare(mesh(files.write("bent.off", replaced(planar_text, "0 1 1\n", "0 1 1.0000000000000002\n"))));
  const Soup cut = make_soup({{bent}});
  REQUIRE(cut.face_count() == 2);
  CHECK(leaf_faces(cut) == 2);
  CHECK_THAT(bent->notices().back(), Catch::Contains("1 polygon was not exactly planar"));
  const auto corners = cut.corners(SourceId(0));
  CHECK(value(cut, corners[0]) == RationalPoint{0, 0, 0});
  CHECK(value(cut, corners[1]) == RationalPoint{1, 0, 1});
  CHECK(value(cut, corners[2]) == RationalPoint{1, 1, 2});
  // An arrow whose diagonal from the first corner lies outside: the ear is clipped elsewhere.
  const Soup arrow =
      soup_of(mesh(files.write("arrow.off", "OFF\n4 1 0\n0 4 0\n-3 0 0\n0 1 0\n3 0 0.5\n4 0 1 2 3\n")));
  REQUIRE(arrow.face_count() == 2);
  for (SourceId f : IdRange<SourceId>(2)) {
    const auto loop = loops(arrow, f)[0];
    CHECK(cross(loop[1] - loop[0], loop[2] - loop[0])[2] > 0);
  }
}

TEST_CASE("coordinates as doubles or as decimals") {
  const Files files;
  const std::string path = files.write("thirds.off", "OFF 3 1 0\n0.1 0 0\n1 0.3 0\n0 1e-400 5\n3 0 1 2\n");
  const Soup doubles = soup_of(mesh(path));
  CHECK(all_doubles(doubles));
  CHECK(value(doubles, PointId(0))[0] == from_double(0.1));
  CHECK(value(doubles, PointId(2))[1] == 0);
  const Soup decimals = soup_of(mesh(path, {}, true));
  CHECK(value(decimals, PointId(0))[0] == r("0.1"));
  CHECK(value(decimals, PointId(2))[1] == r("1e-400"));
  // Coplanar as decimals, not as doubles.
  const std::string flat =
      files.write("flat.off", "OFF 4 2 0\n0 0 0\n1 0 0.1\n1 1 0.3\n0 1 0.2\n3 0 1 2\n3 0 2 3\n");
  CHECK(leaf_faces(soup_of(mesh(flat))) == 2);
  CHECK(leaf_faces(soup_of(mesh(flat, {}, true))) == 1);
}

TEST_CASE("a mesh in memory is what the same mesh is in a file") {
  const Files files;
  const auto data = std::make_shared<MeshData>();
  data->xyz = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5};
  data->exact.emplace_back(3, RationalPoint{0, 0, r("1/3")});  // nearest to no double
  data->corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  data->offsets = {0, 3, 6, 9, 12};
  const Soup soup = soup_of(MeshShape{.file = {}, .fill = {}, .data = data});
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(volume(soup) == r("1/18"));
  data->offsets = {0, 3, 6, 9};
  CHECK_THAT(error_of(MeshShape{.file = {}, .fill = Fill::winding, .data = data}),
             Catch::StartsWith("mesh is not closed, it has 3 boundary edges"));
}

TEST_CASE("groups of a file separate coplanar faces") {
  const Files files;
  const std::string start = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  CHECK(leaf_faces(soup_of(mesh(files.write("a.obj", start + "f 1 2 3\nf 1 3 4\n")))) == 1);
  CHECK(leaf_faces(soup_of(mesh(files.write("b.obj", start + "g p\nf 1 2 3\ng q\nf 1 3 4\n")))) == 2);
  CHECK(leaf_faces(soup_of(mesh(files.write("c.obj", start + "usemtl p\nf 1 2 3\nusemtl q\nf 1 3 4\n")))) == 2);
  CHECK(leaf_faces(soup_of(mesh(files.write("d.obj", start + "g p\nf 1 2 3\ng p\nf 1 3 4\n")))) == 1);
}

TEST_CASE("exact zero tests agree with rationals") {
  std::mt19937_64 random(9);
  int zero = 0;
  for (int i = 0; i < 3000; ++i) {
    double p[4][3];
    for (auto& q : p) {
      for (double& x : q)
        x = static_cast<double>(static_cast<int>(random() % 5) - 2) * (i % 3 ? 0.1 : 1) + (i % 7 ? 0 : 1e6);
    }
    if (i % 5 == 0) {  // nearly or exactly on the line or plane
      for (int k = 0; k < 3; ++k) p[3][k] = p[0][k] + (p[1][k] - p[0][k]) * 0.5 + (p[2][k] - p[0][k]) * 0.25;
      for (int k = 0; k < 3; ++k) p[2][k] = i % 2 ? p[0][k] + (p[1][k] - p[0][k]) * 0.75 : p[2][k];
    }
    const auto exact = [](const double* q) {
      return RationalPoint{from_double(q[0]), from_double(q[1]), from_double(q[2])};
    };
    const bool flat = volume6(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3])) == 0;
    const bool straight = collinear(exact(p[0]), exact(p[1]), exact(p[2]));
    zero += flat;
    REQUIRE(coplanar(p[0], p[1], p[2], p[3]) == flat);
    REQUIRE(collinear(p[0], p[1], p[2]) == straight);
  }
  CHECK(zero > 100);
  const double a[] = {0, 0, 0}, b[] = {1e-300, 0, 0}, c[] = {0, 1e-300, 0}, d[] = {0, 0, 5e-324};
  CHECK_FALSE(coplanar(a, b, c, d));
  CHECK_FALSE(collinear(a, b, c));
  const double e[] = {1e308, 0, 0}, f[] = {0, 1e308, 0}, g[] = {-1e308, -1e308, 1};
  CHECK_FALSE(coplanar(a, e, f, g));
}

// Height fields over scattered points: volumes by hand, walls, faults with their line.
#include <algorithm>
#include <random>

#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;
using Catch::Contains;

namespace {

std::string text_of(const std::vector<std::array<int, 3>>& points) {
  std::string text;
  for (const auto& [x, y, z] : points)
    text += std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
  return text;
}

std::size_t patches(const Soup& soup) {
  std::set<std::uint32_t> numbers;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) numbers.insert(soup.face(f).leaf_face);
  return numbers.size();
}

}  // namespace

TEST_CASE("height field over points") {
  const Files files;
  HeightfieldShape shape;
  // A pyramid's top over a square whose southern side has a point in the middle; a point twice, a word behind one.
  shape.file = files.write(
      "a.XYZ", "# x y z\n0 0 1\n4 0 1 0.7 clay\n 4\t4 1 # a corner\r\n\n0 4 1\n2 2 4\n2 0 1\n0 4 1.0\n");
  const Soup surface = soup_of(shape);
  CHECK(surface.fill(LeafId(0)) == Fill::none);
  CHECK(surface.face_count() == 5);
  CHECK(surface.point_count() == 6);
  CHECK(surface.curve_ends().size() == 4);  // the point in the middle of a side is no corner
  REQUIRE(prepare(shape)->notices().size() == 1);
  CHECK_THAT(prepare(shape)->notices()[0], Contains("1 line repeats a point: left out"));
  shape.base = -1;
  const Soup solid = soup_of(shape);
  CHECK(closed(solid));
  CHECK(volume(solid) == 16 * 2 + 16);  // to the level of the rim, and a pyramid 3 high
  CHECK(patches(solid) == 6);
  shape.base = 1;
  CHECK_THAT(error_of(shape), Contains("base is 1, but the lowest height is 1"));
}

TEST_CASE("a plane over any points is cut off exactly") {
  // z = 100 + 3x - 2y over random points: the volume is the area of the hull times the height at its centroid.
  const Files files;
  std::mt19937 random(11);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::array<int, 3>> points;
    for (int i = 0; i < 30; ++i) {
      const int x = static_cast<int>(random() % 12), y = static_cast<int>(random() % 9);
      points.push_back({x, y, 100 + 3 * x - 2 * y});
    }
    HeightfieldShape shape;
    shape.file = files.write("plane.xyz", text_of(points));
    shape.base = 0;
    const Soup solid = soup_of(shape);
    CHECK(closed(solid));
    // The hull by turning around it, with moments of its triangles from the first corner.
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const auto turn = [](const auto& a, const auto& b, const auto& c) {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    std::vector<std::array<int, 3>> hull;
    for (int pass = 0; pass < 2; ++pass, std::reverse(points.begin(), points.end())) {
      const std::size_t start = hull.size();
      for (const auto& p : points) {
        while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
      }
      hull.pop_back();
    }
    Rational expected = 0;
    for (std::size_t i = 1; i + 1 < hull.size(); ++i)
      expected += Rational(turn(hull[0], hull[i], hull[i + 1])) * (hull[0][2] + hull[i][2] + hull[i + 1][2]) / 6;
    CHECK(volume(solid) == expected);
    CHECK(patches(solid) == 2 + hull.size());
  }
}

TEST_CASE("points of a grid make the surface of the grid") {
  const Files files;
  HeightfieldShape grid, points;
  grid.heights = {{1, 5, 2, 4}, {3, 1, 7, 1}, {6, 2, 1, 9}};
  std::vector<std::array<int, 3>> list;
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 4; ++i)
      list.push_back(
          {i, j,
           static_cast<int>(
               grid.heights[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)].get_num().get_si())});
  }
  grid.base = points.base = 0;
  std::mt19937 random(2);
  std::optional<Rational> first;
  for (int round = 0; round < 5; ++round) {
    points.file = files.write("grid.xyz", text_of(list));
    const Soup soup = soup_of(points);
    CHECK(closed(soup));
    CHECK(patches(soup) == 6);
    CHECK(soup.face_count() == soup_of(grid).face_count());
    if (!first) first = volume(soup);
    CHECK(volume(soup) == *first);  // whatever the order of lines
    std::shuffle(list.begin(), list.end(), random);
  }
}

TEST_CASE("points that make no height field") {
  const Files files;
  const auto error = [&](const std::string& text) {
    HeightfieldShape shape;
    shape.file = files.write("bad.xyz", text);
    return error_of(shape);
  };
  CHECK_THAT(error(" \n"), Contains("bad.xyz:1:1: error: the file is empty"));
  CHECK_THAT(error("0 0 0\n1 0\n"), Contains("bad.xyz:2: error: a line of 2 entries: give x, y and z"));
  CHECK_THAT(error("4\nwater\n"), Contains("bad.xyz:1: error: a line of 1 entry"));
  CHECK_THAT(error("# x\nx y z\n"), Contains("bad.xyz:2: error: 'x' is no number"));
  CHECK_THAT(error("0,5 1 2\n"), Contains("bad.xyz:1: error: '0,5' is no number, x, y or z of a point"));
  CHECK_THAT(error("0 0 nan\n"), Contains("bad.xyz:1: error: 'nan' is no finite number"));
  CHECK_THAT(error("0 0 1\n5 5 5\n-0.0 0 2\n"),
             Contains("bad.xyz:3: error: another height at the place of line 1: a height field has one height"));
  CHECK_THAT(error("0 0 1\n0 0 1\n"), Contains("has 1 point: give three or more"));
  CHECK_THAT(error("0 0 1\n1 1 5\n2 2 3\n"), Contains("has 3 points, all on one line as seen from above"));
}

// The key `fit`: corners that were rounded move onto planes. Judged by the exact width of the corners (the least
// distance of two parallel planes that hold them, by trying all candidates), by exact planarity, and by volumes.
#include <cmath>
#include <random>

#include "csg/leaves/mesh_data.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Points = std::vector<RationalPoint>;
using Vector = std::array<double, 3>;

/// The width of points along the best normal: it is that of a face of their hull, or of two edges.
double least_width(const Points& points) {
  std::vector<RationalPoint> ways;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) ways.push_back(points[i] - points[j]);
  double best = 1e300;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const RationalPoint n = cross(ways[i], ways[j]);
      if (is_zero(n)) continue;
      Rational low = dot(n, points[0]), high = low;
      for (const RationalPoint& p : points) {
        low = std::min(low, dot(n, p));
        high = std::max(high, dot(n, p));
      }
      best = std::min(best, to_double(high - low) / std::sqrt(to_double(dot(n, n))));
    }
  }
  return best;
}

/// A rotation matrix, random.
std::array<Vector, 3> random_frame(std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::array<double, 4> q{};
  double square = 0;
  for (double& x : q) x = normal(random), square += x * x;
  for (double& x : q) x /= std::sqrt(square);
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

/// The point turned, its coordinates rounded to so many decimals.
RationalPoint rounded(const std::array<Vector, 3>& frame, const Vector& p, int decimals) {
  RationalPoint result;
  const double grid = std::pow(10.0, decimals);
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = frame[k][0] * p[0] + frame[k][1] * p[1] + frame[k][2] * p[2];
    result[k] = Rational(static_cast<std::int64_t>(std::llround(x * grid)), static_cast<std::int64_t>(grid));
    result[k].canonicalize();
  }
  return result;
}

/// Corners of a star, or of a corridor bent to a C, which has little area.
Points random_polygon(std::mt19937& random, int decimals, bool corridor) {
  std::uniform_real_distribution<double> radius(1, 5), place(-50, 50);
  const std::array<Vector, 3> frame = random_frame(random);
  const Vector center{place(random), place(random), place(random)};
  Points points;
  const auto add = [&](double x, double y) {
    points.push_back(rounded(frame, {center[0] + x, center[1] + y, center[2]}, decimals));
  };
  const int n = 4 + static_cast<int>(random() % 4);
  for (int i = 0; i < n; ++i) {
    const double angle = (corridor ? 3.0 : 6.283185307) * i / n, r = corridor ? 5 : radius(random);
    add(r * std::cos(angle), r * std::sin(angle));
  }
  for (int i = n; corridor && i-- > 0;) add(5.1 * std::cos(3.0 * i / n), 5.1 * std::sin(3.0 * i / n));
  return points;
}

Points corners_of(const Soup& soup) { return loops(soup, SourceId(0))[0]; }

/// The squared distance that the farthest corner moved.
Rational farthest_move(const Points& a, const Points& b) {
  REQUIRE(a.size() == b.size());
  Rational most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, Rational(dot(a[i] - b[i], a[i] - b[i])));
  return most;
}

Rational fit_in(const std::string& message) {
  const std::string mark = "give `fit: ";
  const std::size_t at = message.find(mark) + mark.size();
  return *parse_rational(message.substr(at, message.find('`', at) - at));
}

/// A box, turned, with rounded coordinates; of quadrilaterals or triangles.
MeshShape turned_box(std::mt19937& random, int decimals, bool triangles) {
  const std::array<Vector, 3> frame = random_frame(random);
  auto data = std::make_shared<MeshData>();
  for (std::uint32_t i = 0; i < 8; ++i) {
    const RationalPoint p = rounded(frame, {2.0 * (i & 1), 3.0 * (i >> 1 & 1), 4.0 * (i >> 2)}, decimals);
    for (const Rational& x : p) data->xyz.push_back(to_double(x));
    data->exact.emplace_back(i, p);
  }
  const std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    if (triangles) {
      data->corners.insert(data->corners.end(), {f[0], f[1], f[2]});
      data->end_face();
      data->corners.insert(data->corners.end(), {f[0], f[2], f[3]});
    } else {
      data->corners.insert(data->corners.end(), std::begin(f), std::end(f));
    }
    data->end_face();
  }
  MeshShape shape;
  shape.data = data;
  return shape;
}

}  // namespace

TEST_CASE("corners within `fit` move onto one plane, hardly farther than they must", "[fit][random]") {
  std::mt19937 random(20261129);
  int fitted = 0;
  for (int round = 0; round < 60; ++round) {
    const Points given = random_polygon(random, 3 + round % 5, round % 3 == 0);
    const std::string refused = error_of(PolygonShape{given, {}});
    if (refused.find("not planar") == std::string::npos) continue;
    const Rational fit = fit_in(refused);
    const double width = least_width(given);
    CAPTURE(round, width, refused);
    const auto leaf = prepare(PolygonShape{given, {}, fit});
    const Soup soup = make_soup({{leaf}});
    CHECK(planar(soup));
    const double moved = std::sqrt(to_double(farthest_move(given, corners_of(soup))));
    CHECK(moved <= to_double(fit));
    CHECK(moved >= width / 2 * (1 - 1e-9));
    CHECK(moved <= 1.6 * width / 2);
    REQUIRE(leaf->notices().size() == 1);
    CHECK_THAT(leaf->notices()[0], Catch::StartsWith("polygon: fit ") && Catch::Contains("by "));
    // What the message says is needed: not much less does.
    CHECK_THAT(error_of(PolygonShape{given, {}, fit * Rational(4, 5)}), Catch::Contains("not planar"));
    // Far more changes nothing: the plane is that of the corners, not of the length.
    const auto moved_by = [&](const Rational& d) {
      return farthest_move(given, corners_of(make_soup({{prepare(PolygonShape{given, {}, d})}})));
    };
    CHECK(moved_by(fit * 2) == moved_by(fit * 1000));
    // Where the loop begins, and which way it runs, is all the same.
    Points other(given.rbegin(), given.rend());
    std::rotate(other.begin(), other.begin() + 2, other.end());
    Points there = corners_of(make_soup({{prepare(PolygonShape{other, {}, fit})}})), here = corners_of(soup);
    std::sort(there.begin(), there.end());
    std::sort(here.begin(), here.end());
    CHECK(there == here);
    ++fitted;
  }
  CHECK(fitted >= 50);
}

TEST_CASE("a planar polygon stays to the last bit", "[fit]") {
  const Points given{{0, 0, 0}, {3, 0, Rational(1, 3)}, {3, 3, Rational(2, 3)}, {0, 3, Rational(1, 3)}};
  const auto leaf = prepare(PolygonShape{given, {}, Rational(1, 10)});
  CHECK(leaf->notices().empty());
  CHECK(corners_of(make_soup({{leaf}})) == given);
}

TEST_CASE("bases of prisms and pyramids, with holes", "[fit]") {
  const Rational off(1, 1000000);
  const Points outer{{0, 0, 0}, {4, 0, off}, {4, 4, 0}, {0, 4, 0}};
  const std::vector<Points> holes{{{1, 1, 0}, {1, 2, off}, {2, 2, 0}, {2, 1, 0}}};
  CHECK_THAT(error_of(PrismShape{outer, holes, {0, 0, 2}}),
             Catch::Contains("the prism's base is not planar") && Catch::Contains("`fit: "));
  const Soup prism = soup_of(PrismShape{outer, holes, {0, 0, 2}, Rational(1, 100000)});
  CHECK((planar(prism) && closed(prism)));
  CHECK(std::abs(to_double(volume(prism)) - 30) < 1e-5);
  const Soup pyramid = soup_of(PyramidShape{outer, {0, 0, 3}, Rational(1, 100000)});
  CHECK((planar(pyramid) && closed(pyramid)));
  CHECK(std::abs(to_double(volume(pyramid)) - 16) < 1e-4);
  // A group has no such key.
  GroupShape group;
  group.vertices = outer;
  group.faces.push_back({{{0, 1, 2, 3}}, {0, 0}, 0, 0});
  CHECK_THAT(error_of(group), Catch::Contains("apart: correct it") && !Catch::Contains("fit"));
}

TEST_CASE("faces of a mesh that are one plane within `fit` become one", "[fit][random]") {
  std::mt19937 random(48);
  int fitted = 0;
  for (int round = 0; round < 20; ++round) {
    const int decimals = 4 + round % 6;
    MeshShape shape = turned_box(random, decimals, round % 2 == 0);
    CAPTURE(round);
    if (leaf_faces(soup_of(shape)) == 6) continue;  // rounding kept it
    ++fitted;
    shape.fit = Rational(std::pow(10.0, 1 - decimals));
    const auto leaf = prepare(shape);
    const Soup soup = make_soup({{leaf}});
    CHECK(leaf_faces(soup) == 6);
    CHECK((planar(soup) && closed(soup)));
    CHECK(std::abs(to_double(volume(soup)) - 24) < 200 * to_double(*shape.fit));
    REQUIRE(leaf->notices().size() == 1);
    CHECK_THAT(leaf->notices()[0], Catch::Contains("mesh: fit ") && Catch::Contains("by "));
  }
  CHECK(fitted >= 15);
}

TEST_CASE("a face that a fit would take away is refused", "[fit]") {
  MeshShape shape;
  auto data = std::make_shared<MeshData>();
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (const double x : {2.0 * (i & 1), 3.0 * (i >> 1 & 1), 0.001 * (i >> 2)}) data->xyz.push_back(x);
  }
  for (const auto& f : {std::array<std::uint32_t, 4>{0, 2, 3, 1},
                        {4, 5, 7, 6},
                        {0, 1, 5, 4},
                        {2, 6, 7, 3},
                        {0, 4, 6, 2},
                        {1, 3, 7, 5}}) {
    data->corners.insert(data->corners.end(), f.begin(), f.end());
    data->end_face();
  }
  shape.data = data;
  shape.fit = Rational(1, 100);
  CHECK_THAT(error_of(shape),
             Catch::Contains("fit: the solid would have no volume") && Catch::Contains("give a smaller length"));
}

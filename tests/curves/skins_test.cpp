// Sweeps along paths and lofts: volumes in closed form of what is drawn, ends that fit exactly, what is refused.
//
// A prism between two planes has the volume of its section times its length along the centroid. Between two
// sections that are turned by d about an axis, facets enclose the section times the distance of its centroid times
// sin d.
#include "csg/geometry/circle.h"
#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

using Points = std::vector<RationalPoint>;

ProfileLine outline(const Points& corners) {
  ProfileLine result;
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.segments.push_back({{corners[i], corners[(i + 1) % corners.size()]}, {}, 0, {}});
  return result;
}

/// Four quarters of a circle at x, exactly, about the x axis or with another center.
ProfileLine round_line(const Rational& x, const Rational& radius, const Rational& y = 0, const Rational& z = 0) {
  ProfileLine result;
  Rational a = radius, b = 0;
  for (int k = 0; k < 4; ++k) {
    const Rational c = -b, d = a;
    result.segments.push_back(
        {{{x, y + a, z + b}, {x, y + a + c, z + b + d}, {x, y + c, z + d}}, {1, 1, 2}, 0, {}});
    a = c;
    b = d;
  }
  return result;
}

/// Centroid at the origin, in the plane x = 0, of area 4 less a hole of 1/4 whose centroid is there, too.
Profile square_with_hole() {
  const Rational q = r("1/4");
  return {{outline({{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}}),
           outline({{0, -q, -q}, {0, q, -q}, {0, q, q}, {0, -q, q}})}};
}

void check_skin(const Soup& soup) {
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(planar(soup));
  CHECK(closed(soup));
}

/// Different points of the face of the highest number less `back`.
Points end_points(const Soup& soup, std::uint32_t back) {
  std::uint32_t most = 0;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) most = std::max(most, soup.face(f).leaf_face);
  Points result;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf_face != most - back) continue;
    for (const auto& loop : loops(soup, f)) result.insert(result.end(), loop.begin(), loop.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Points put_at(Points points, const Transform& transform) {
  for (RationalPoint& p : points) p = transform.apply(p);
  std::sort(points.begin(), points.end());
  return points;
}

/// The sum of the sines of the steps of a bend, `steps` equal ones of the tangent of half the angle, t in all.
Rational sines(const Rational& t, int steps) {
  Rational sum = 0;
  for (int k = 0; k < steps; ++k) {
    const Rational low = t * Rational(k) / Rational(steps), high = t * Rational(k + 1) / Rational(steps);
    const Rational half = (high - low) / (1 + low * high);
    sum += 2 * half / (1 + half * half);
  }
  return sum;
}

}  // namespace

TEST_CASE("a mitred sweep is as long as its path, exactly", "[sweep]") {
  // Lengths 10, 5, 7, 15; the last bend leaves the plane of the others.
  const SweepShape shape{square_with_hole(), {{0, 0, 0}, {10, 0, 0}, {14, 3, 0}, {14, 10, 0}, {14, 19, 12}}};
  const Soup soup = soup_of(shape);
  check_skin(soup);
  CHECK(volume(soup) == r("15/4") * 37);
  CHECK(leaf_faces(soup) == 4 * 8 + 2);
  CHECK(soup.face_count() == 4 * 8 + 2);
  // The ends are congruent to the profile: all squared distances are those of its points.
  const Points start = end_points(soup, 1), end = end_points(soup, 0);
  REQUIRE(start.size() == 8);
  REQUIRE(end.size() == 8);
  const auto distances = [](const Points& points) {
    std::vector<Rational> all;
    for (const RationalPoint& p : points)
      for (const RationalPoint& q : points) all.push_back(dot(p - q, p - q));
    std::sort(all.begin(), all.end());
    return all;
  };
  CHECK(distances(start) == distances(end));
}

TEST_CASE("a sweep with round bends has the volume of its facets in closed form", "[sweep]") {
  for (const int steps : {4, 8, 32}) {
    // A right angle, then 3-4-5; tangents of half the angles are 1 and 1/3, of the second bend leaves 2 - 2/3.
    SweepShape shape{square_with_hole(), {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {16, 18, 0}}, Rational(2)};
    shape.tessellation.segments = steps;
    const Soup soup = soup_of(shape);
    check_skin(soup);
    const Rational straight = (10 - 2) + (10 - 2 - r("2/3")) + (10 - r("2/3"));
    CHECK(volume(soup) == r("15/4") * (straight + 2 * sines(1, steps) + 2 * sines(r("1/3"), steps)));
    // The path lies in a plane: the frame keeps its normal, exactly.
    const Points end = end_points(soup, 0);
    REQUIRE(end.size() == 8);
    const RationalPoint across{r("-4/5"), r("3/5"), 0};
    Points there;
    for (const RationalPoint& p : end_points(soup, 1))
      there.push_back(RationalPoint{16, 18, 0} + p[1] * across + p[2] * RationalPoint{0, 0, 1});
    std::sort(there.begin(), there.end());
    CHECK(end == there);
  }
}

TEST_CASE("any path: no section is deformed, though lengths are irrational", "[sweep][random]") {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> coordinate(-30, 30);
  for (int round = 0; round < 20; ++round) {
    SweepShape shape{square_with_hole(), {{0, 0, 0}, {20, 0, 0}}, {}};
    for (int i = 0; i < 3; ++i) {
      const RationalPoint& last = shape.path.back();
      shape.path.push_back(
          {last[0] + 40 + coordinate(random), last[1] + coordinate(random), last[2] + coordinate(random)});
    }
    if (round % 2 == 0) shape.radius = 3;
    shape.tessellation.chord = r("1/100");
    const Soup soup = soup_of(shape);
    check_skin(soup);
    double length = 0;
    for (std::size_t i = 1; i < shape.path.size(); ++i) {
      const RationalPoint by = shape.path[i] - shape.path[i - 1];
      length += std::sqrt(to_double(dot(by, by)));
    }
    for (std::size_t i = 1; shape.radius && i + 1 < shape.path.size(); ++i) {
      const RationalPoint a = shape.path[i] - shape.path[i - 1], b = shape.path[i + 1] - shape.path[i];
      const double angle = std::acos(to_double(dot(a, b)) / std::sqrt(to_double(dot(a, a) * dot(b, b))));
      length += 3 * angle - 6 * std::tan(angle / 2);
    }
    const double exact = 3.75 * length;
    CAPTURE(round);
    // Facets are within the chord; the surface is 10 along the path.
    CHECK(std::abs(to_double(volume(soup)) - exact) < (shape.radius ? 10 * length * 0.01 : 1e-9));
    double diameter = 0;
    for (const RationalPoint& p : end_points(soup, 0))
      for (const RationalPoint& q : end_points(soup, 0))
        diameter = std::max(diameter, to_double(dot(p - q, p - q)));
    CHECK(std::abs(diameter - 8) < 1e-12);
  }
}

TEST_CASE("arcs are drawn alike in sweeps and extrusions, and fit at the ends", "[sweep]") {
  for (const bool by_chord : {false, true}) {
    Tessellation fineness;
    if (by_chord) fineness.chord = r("1/50");
    else fineness.segments = 12;
    const Profile tube{{round_line(0, 3), round_line(0, 2)}};
    ExtrudeShape straight{tube, {7, 0, 0}};
    straight.tessellation = fineness;
    const SweepShape pipe{tube, {{0, 0, 0}, {7, 0, 0}}, {}, fineness};
    const Soup extruded = soup_of(straight), swept = soup_of(pipe);
    check_skin(swept);
    CHECK(volume(swept) == volume(extruded));
    CHECK(leaf_faces(swept) == leaf_faces(extruded));
    // With a bend the ends are still those of the extrusion, moved.
    const SweepShape bent{tube, {{0, 0, 0}, {10, 0, 0}, {10, 9, 0}}, Rational(4), fineness};
    const Soup elbow = soup_of(bent);
    check_skin(elbow);
    CHECK(end_points(elbow, 1) == end_points(swept, 1));
    CHECK(end_points(elbow, 0) == put_at(end_points(swept, 1), Transform::translation({10, 9, 0}) *
                                                                   Transform::rotation({0, 0, 1}, 90, {0, 0, 0})));
  }
}

TEST_CASE("the end of a revolution is its start, rotated exactly", "[revolve]") {
  for (const RationalPoint& axis : {RationalPoint{0, 0, 1}, RationalPoint{2, -1, 2}, RationalPoint{1, 2, 3}}) {
    for (const char* degrees : {"45", "90", "37.5", "359"}) {
      RevolveShape shape;
      shape.axis = axis;
      shape.center = {5, 6, r("1/7")};
      shape.degrees = r(degrees);
      ProfileLine ring = round_line(0, 1, 4, 2);
      for (CurveNet& net : ring.segments) {
        for (RationalPoint& p : net.points) p = {p[1], 0, p[2]};
      }
      shape.profile.lines = {ring};
      const Soup soup = soup_of(shape);
      Points ends[2];
      for (SourceId f : IdRange<SourceId>(soup.face_count())) {
        if (soup.face(f).leaf_face < 2) ends[soup.face(f).leaf_face] = loops(soup, f)[0];
      }
      std::sort(ends[1].begin(), ends[1].end());
      CHECK(ends[1] == put_at(ends[0], Transform::rotation(axis, shape.degrees, shape.center)));
    }
  }
}

TEST_CASE("lofts: frustums, prismatoids, cones", "[loft]") {
  const auto square = [](const Rational& half, const Rational& z) {
    return outline({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}});
  };
  // Similar squares: walls are flat, and so is what lies between the holes.
  const LoftShape frustum{{{{square(2, 0), square(1, 0)}}, {{square(4, 6), square(2, 6)}}}};
  const Soup soup = soup_of(frustum);
  check_skin(soup);
  CHECK(soup.face_count() == 10);
  CHECK(volume(soup) == (Rational(6) / 3) * ((16 + 32 + 64) - (4 + 8 + 16)));
  // Given in any direction; several parts.
  ProfileLine back = outline({{-1, 1, 9}, {1, 1, 9}, {1, -1, 9}, {-1, -1, 9}});
  std::rotate(back.segments.begin(), back.segments.begin() + 3, back.segments.end());
  const Soup three = soup_of(LoftShape{{{{square(2, 0)}}, {{square(4, 6)}}, {{back}}}});
  check_skin(three);
  CHECK(volume(three) == 224 + (64 + 16 + 4));
  // An eighth of a turn between: walls are saddles, and the area of sections is quadratic.
  const Rational s = r("3/2");
  LoftShape turned{{{{square(1, 0)}}, {{outline({{0, -s, 3}, {s, 0, 3}, {0, s, 3}, {-s, 0, 3}})}}}};
  turned.tessellation.chord = r("1/1000");
  const Soup saddle = soup_of(turned);
  check_skin(saddle);
  const auto area_between = [&](double t) {  // corners (-1, -1) + t ((0, -s) - (-1, -1)), turned by quarters
    const double x = -1 + t, y = -1 + t * (1 - 1.5);
    return 2 * (x * x + y * y);
  };
  const double exact = 3.0 / 6 * (area_between(0) + 4 * area_between(0.5) + area_between(1));
  CHECK(std::abs(to_double(volume(saddle)) - exact) < 0.001 * 4 * 3 * 2.2);
  // Circles: rulings of equal parameters make flat facets, a frustum of the polygons drawn.
  LoftShape cone{{{{round_line(0, 1)}}, {{round_line(5, 3)}}}};
  cone.tessellation.segments = 6;
  const Soup round = soup_of(cone);
  check_skin(round);
  CHECK(leaf_faces(round) == 6);
  ExtrudeShape lower{{{round_line(0, 1)}}, {1, 0, 0}};
  lower.tessellation.segments = 6;
  CHECK(volume(round) == volume(soup_of(lower)) * (1 + 3 + 9) * 5 / 3);
}

TEST_CASE("sweeps and lofts that cannot be are refused", "[sweep]") {
  const Profile square{{outline({{0, -1, -1}, {0, 1, -1}, {0, 1, 1}, {0, -1, 1}})}};
  const auto error = [&](Points path, std::optional<Rational> radius = {}) {
    return error_of(SweepShape{square, std::move(path), std::move(radius)});
  };
  CHECK_THAT(error({{0, 0, 0}}), Catch::Contains("fewer than two points"));
  CHECK_THAT(error({{0, 0, 0}, {0, 0, 0}}), Catch::Contains("two points of the path are both (0, 0, 0)"));
  CHECK_THAT(error({{0, 0, 0}, {1, 1, 0}}), Catch::Contains("at right angles"));
  CHECK_THAT(error({{1, 0, 0}, {2, 0, 0}}), Catch::Contains("in a plane through its beginning (1, 0, 0)"));
  CHECK_THAT(error({{0, 0, 0}, {5, 0, 0}, {2, 0, 0}}), Catch::Contains("turns back at (5, 0, 0)"));
  CHECK_THAT(error({{0, 0, 0}, {r("1/2"), 0, 0}, {r("1/2"), 9, 0}}),
             Catch::Contains("before (0.5, 0, 0) is too short") && Catch::Contains("or a `radius`"));
  CHECK_THAT(error({{0, 0, 0}, {3, 0, 0}, {3, 9, 0}}, Rational(4)), Catch::Contains("or a smaller radius"));
  CHECK_THAT(error({{0, 0, 0}, {3, 0, 0}, {3, 9, 0}}, Rational(1)),
             Catch::Contains("reaches the axis of the bend"));
  CHECK_THAT(error({{0, 0, 0}, {3, 0, 0}}, Rational(0)), Catch::Contains("the radius is 0"));
  CHECK(error({{0, 0, 0}, {3, 0, 0}, {6, 0, 0}}, Rational(4)).empty());
  CHECK_THAT(error_of(LoftShape{{square}}), Catch::Contains("fewer than two profiles"));
  const Profile triangle{{outline({{3, -1, -1}, {3, 1, -1}, {3, 1, 1}})}};
  CHECK_THAT(error_of(LoftShape{{square, triangle}}),
             Catch::Contains("profile 2 has other numbers of lines or segments"));
  const Profile bent{{outline({{3, -1, -1}, {3, 1, -1}, {4, 1, 1}, {3, -1, 1}})}};
  CHECK_THAT(error_of(LoftShape{{square, bent}}), Catch::Contains("the profile of loft is not planar"));
}

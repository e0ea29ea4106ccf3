// Extrusions and revolutions: volumes against integrals, faces as people count them, what is refused.
#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

constexpr double kPi = 3.14159265358979;

CurveNet line(const RationalPoint& a, const RationalPoint& b) { return {{a, b}, {}, 0, {}}; }

ProfileLine polygon(const std::vector<RationalPoint>& corners) {
  ProfileLine result;
  for (std::size_t i = 0; i < corners.size(); ++i)
    result.segments.push_back(line(corners[i], corners[(i + 1) % corners.size()]));
  return result;
}

/// A circle in the plane z = 0, exactly: four quarters.
ProfileLine circle(const Rational& x, const Rational& y, const Rational& radius) {
  ProfileLine result;
  Rational a = radius, b = 0;
  for (int k = 0; k < 4; ++k) {
    const Rational c = -b, d = a;
    result.segments.push_back(
        {{{x + a, y + b, 0}, {x + a + c, y + b + d, 0}, {x + c, y + d, 0}}, {1, 1, 2}, 0, {}});
    a = c;
    b = d;
  }
  return result;
}

void check_solid(const Soup& soup) {
  CHECK(soup.fill(LeafId(0)) == Fill::winding);
  CHECK(planar(soup));
  CHECK(closed(soup));
}

const std::vector<RationalPoint> kSquare{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};

}  // namespace

TEST_CASE("extrusion of straight segments is a prism") {
  for (const bool down : {false, true}) {
    ExtrudeShape shape;
    shape.profile.lines = {polygon(kSquare), polygon({{0, 0, 0}, {0, r("1/2"), 0}, {r("1/2"), 0, 0}})};
    shape.vector = {1, 2, down ? -3 : 3};
    const Soup soup = soup_of(shape);
    check_solid(soup);
    CHECK(volume(soup) == (4 - r("1/8")) * 3);
    CHECK(leaf_faces(soup) == 9);
    CHECK(soup.face_count() == 9);
  }
}

TEST_CASE("extrusion of curves keeps the chord") {
  for (const char* chord : {"0.1", "0.01", "0.0001"}) {
    ExtrudeShape shape;
    shape.profile.lines = {circle(0, 0, 3), circle(1, 0, 1)};
    shape.vector = {0, 0, 2};
    shape.tessellation.chord = r(chord);
    const Soup soup = soup_of(shape);
    check_solid(soup);
    CHECK(leaf_faces(soup) == 10);
    // Both circles are inscribed: each area is short by less than chord times its length.
    const double exact = 2 * kPi * (9 - 1), e = to_double(r(chord));
    CHECK(to_double(volume(soup)) > exact - 2 * e * 6 * kPi);
    CHECK(to_double(volume(soup)) < exact + 2 * e * 2 * kPi);
    // Scaled to half on the way: a frustum, (1 + 1/2 + 1/4) / 3 of the volume.
    shape.scale = r("1/2");
    shape.center = RationalPoint{0, 0, 17};
    const Soup frustum = soup_of(shape);
    check_solid(frustum);
    CHECK(volume(frustum) * 12 == volume(soup) * 7);
    shape.scale = 0;
    const Soup cone = soup_of(shape);
    check_solid(cone);
    CHECK(volume(cone) * 3 == volume(soup));
    CHECK(leaf_faces(cone) == 9);
  }
}

TEST_CASE("a twisted cube keeps its sections and its chord") {
  for (const char* twist : {"45", "-90", "270"}) {
    double last = 1;
    for (const char* chord : {"0.1", "0.02", "0.002"}) {
      ExtrudeShape shape;
      shape.profile.lines = {polygon(kSquare)};
      shape.vector = {0, 0, 2};
      shape.twist = r(twist);
      shape.center = RationalPoint{0, 0, 0};
      shape.tessellation.chord = r(chord);
      const Soup soup = soup_of(shape);
      check_solid(soup);
      CHECK(leaf_faces(soup) == 6);
      const double error = std::abs(to_double(volume(soup)) - 8);
      CHECK(error < to_double(r(chord)) * 8 * 4);  // chord times more than the surface
      CHECK(error < last);
      last = error;
      // Points of the walls: within chord of the turned square, whose sides are at a distance of 1 from the axis.
      for (SourceId f : IdRange<SourceId>(soup.face_count())) {
        if (soup.face(f).leaf_face < 2) continue;
        const std::vector<RationalPoint> loop = loops(soup, f)[0];
        RationalPoint middle{0, 0, 0};
        for (const RationalPoint& p : loop) middle = middle + Rational(Rational(1) / Rational(loop.size())) * p;
        const double angle = to_double(shape.twist) / 180 * kPi * to_double(middle[2]) / 2;
        const double x = to_double(middle[0]), y = to_double(middle[1]);
        const double u = x * std::cos(angle) + y * std::sin(angle), v = y * std::cos(angle) - x * std::sin(angle);
        REQUIRE(std::abs(std::max(std::abs(u), std::abs(v)) - 1) <= to_double(r(chord)));
      }
    }
  }
}

TEST_CASE("twist and scale at once, along any vector, with steps in number") {
  ExtrudeShape shape;
  shape.profile.lines = {polygon({{2, 0, 0}, {0, 2, 0}, {0, 0, 2}})};
  shape.vector = {3, 3, 3};
  shape.twist = 100;
  shape.scale = 2;
  shape.center = RationalPoint{r("2/3"), r("2/3"), r("2/3")};
  shape.tessellation.segments = 6;
  const Soup soup = soup_of(shape);
  check_solid(soup);
  CHECK(leaf_faces(soup) == 5);
  // Area 2 sqrt(3), height 3 sqrt(3), times (1 + 2 + 4) / 3.
  CHECK(std::abs(to_double(volume(soup)) - 42) < 2);
}

TEST_CASE("an open curve is swept to a surface") {
  ExtrudeShape shape;
  shape.profile.closed = false;
  shape.profile.lines.push_back({{{{{0, 0, 0}, {1, 1, 0}, {2, 0, 1}}, {}, 0, {}}, line({2, 0, 1}, {3, 0, 1})}});
  shape.vector = {0, 1, 3};
  const Soup soup = soup_of(shape);
  CHECK(soup.fill(LeafId(0)) == Fill::none);
  CHECK(leaf_faces(soup) == 2);
  CHECK(soup.face_count() == 17);
  shape.vector = {1, 0, 0};
  CHECK_THAT(error_of(shape), Catch::Contains("the curve runs along the vector at (2, 0, 1)"));
}

TEST_CASE("a ball and a torus by revolution") {
  for (const char* text : {"0.1", "0.01", "0.004"}) {
    const double e = to_double(r(text));
    RevolveShape ball;
    ball.tessellation.chord = r(text);
    ball.profile.lines.push_back({{{{{0, 0, -2}, {2, 0, -2}, {2, 0, 0}}, {1, 1, 2}, 0, {}},
                                   {{{2, 0, 0}, {2, 0, 2}, {0, 0, 2}}, {1, 1, 2}, 0, {}},
                                   line({0, 0, 2}, {0, 0, -2})}});
    for (const RationalPoint& axis : {RationalPoint{0, 0, 1}, RationalPoint{1, 2, -2}, RationalPoint{1, 1, 1}}) {
      ball.axis = axis;
      const Soup soup = soup_of(ball);
      check_solid(soup);
      CHECK(leaf_faces(soup) == 2);
      const double exact = 4.0 / 3 * kPi * 8;
      CHECK(to_double(volume(soup)) < exact);
      CHECK(to_double(volume(soup)) > exact - e * 4 * kPi * 4);
    }
    RevolveShape ring;
    ring.tessellation.chord = r(text);
    ProfileLine tube = circle(3, 0, 1);
    for (CurveNet& net : tube.segments) {
      for (RationalPoint& p : net.points) std::swap(p[1], p[2]);
    }
    ring.profile.lines = {tube};
    const Soup soup = soup_of(ring);
    check_solid(soup);
    CHECK(leaf_faces(soup) == 4);
    CHECK(std::abs(to_double(volume(soup)) - 2 * kPi * kPi * 3) < e * 4 * kPi * kPi * 3);
    ring.degrees = 60;
    const Soup part = soup_of(ring);
    check_solid(part);
    CHECK(leaf_faces(part) == 6);
    CHECK(std::abs(to_double(volume(part)) - kPi * kPi) < e * (4 * kPi * kPi * 3 / 6 + 2 * kPi));
  }
}

TEST_CASE("revolution counts its steps, and holes stay holes") {
  RevolveShape shape;
  shape.profile.lines = {polygon({{1, 0, 0}, {4, 0, 0}, {4, 0, 3}, {1, 0, 3}}),
                         polygon({{2, 0, 1}, {3, 0, 1}, {3, 0, 2}, {2, 0, 2}})};
  shape.degrees = 90;
  shape.tessellation.segments = 4;
  const Soup soup = soup_of(shape);
  check_solid(soup);
  CHECK(leaf_faces(soup) == 10);
  CHECK(soup.face_count() == 10);
  // One step of 90 degrees: the sections' distance makes r^2 / 2 of a square of r.
  CHECK(volume(soup) == Rational(15) / 2 * 3 - Rational(5) / 2);
  CHECK(all_doubles(soup));
}

TEST_CASE("sweeps that cannot be are refused") {
  ExtrudeShape shape;
  CHECK_THAT(error_of(shape), Catch::Contains("the vector is zero"));
  shape.vector = {0, 0, 1};
  CHECK_THAT(error_of(shape), Catch::Contains("the profile is empty"));
  shape.profile.lines = {polygon({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}})};
  CHECK_THAT(error_of(shape), Catch::Contains("is not simple"));
  shape.profile.lines = {polygon(kSquare), polygon({{5, 5, 0}, {6, 5, 0}, {5, 6, 0}})};
  CHECK_THAT(error_of(shape), Catch::Contains("hole 1 of the profile of extrude is outside"));
  shape.profile.lines = {polygon(kSquare)};
  shape.profile.lines[0].segments[1].points[1] = {1, 2, 0};
  CHECK_THAT(error_of(shape),
             Catch::Contains("segment 2 of the profile ends in (1, 2, 0), the next one begins in (1, 1, 0)"));
  shape.profile.lines = {polygon({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}})};
  CHECK_THAT(error_of(shape), Catch::Contains("segment 2 of the profile is one point"));
  shape.profile.lines = {polygon(kSquare)};
  shape.scale = -1;
  CHECK_THAT(error_of(shape), Catch::Contains("scale is -1"));
  shape.scale = 1;
  shape.vector = {1, 0, 0};
  CHECK_THAT(error_of(shape), Catch::Contains("lies in the plane of the profile"));
  shape.vector = {1, 0, 1};
  shape.twist = 5;
  CHECK_THAT(error_of(shape), Catch::Contains("must lie at right angles to the vector"));

  RevolveShape turn;
  turn.profile.lines = {polygon({{-1, 0, 0}, {1, 0, 0}, {1, 0, 1}})};
  CHECK_THAT(error_of(turn), Catch::Contains("the profile crosses the axis, at [-1, 0]"));
  turn.profile.lines = {polygon({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}})};
  CHECK_THAT(error_of(turn), Catch::Contains("lies on the axis"));
  for (const auto& [control, fault] :
       {std::pair{-201, true}, {-200, true}, {-199, false}}) {  // r = 2 where it is drawn
    turn.profile.lines = {polygon({{2, 0, 2}, {2, 0, 0}, {4, 0, 0}, {4, 0, 2}})};
    turn.profile.lines[0].segments[0].points.insert(turn.profile.lines[0].segments[0].points.begin() + 1,
                                                    {fraction(control, 100), 0, 1});
    turn.tessellation.segments = 13;
    CHECK((error_of(turn).find("segment 1 of the profile comes to the axis between its ends") !=
           std::string::npos) == fault);
  }
  turn.profile.lines = {polygon({{0, 0, 0}, {1, 0, 1}, {1, 0, 2}})};
  CHECK(error_of(turn) == "");
  turn.tessellation.segments = 8192;
  turn.profile.lines[0].segments[0] = {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {}, 0, {}};
  CHECK_THAT(error_of(turn), Catch::Contains("more than 10000000 facets"));
  turn.degrees = 361;
  CHECK_THAT(error_of(turn), Catch::Contains("degrees is 361"));
  turn.degrees = 360;
  turn.axis = {0, 0, 0};
  CHECK_THAT(error_of(turn), Catch::Contains("the axis is [0, 0, 0]"));
}

// Booleans of curved leaves against Nef polyhedra made from the leaves' own facets (coarse: Nef is slow).
#include "tests/oracles/curved_nef.h"

#include "tests/catch.h"

namespace cnrg::properties {
namespace {

void check_pair(const Shape& a, const Transform& to_a, const Shape& b, const Transform& to_b) {
  CHECK(compare_with_nef({prepare(a), to_a}, {prepare(b), to_b}) == "");
}

CurveNet line(const RationalPoint& a, const RationalPoint& b) { return {{a, b}, {}, 0, {}}; }

RevolveShape bottle(int segments) {
  RevolveShape shape;
  shape.profile.lines.push_back({{line({0, 0, 0}, {1, 0, 0}),
                                  {{{1, 0, 0}, {Rational(3, 2), 0, 1}, {Rational(1, 4), 0, 2}}, {}, 0, {}},
                                  line({Rational(1, 4), 0, 2}, {Rational(1, 4), 0, 3}),
                                  line({Rational(1, 4), 0, 3}, {0, 0, 3}),
                                  line({0, 0, 3}, {0, 0, 0})}});
  shape.tessellation.segments = segments;
  return shape;
}

}  // namespace

TEST_CASE("two bottles that cross equal Nef's", "[nef][curved]") {
  check_pair(
      bottle(7), {}, bottle(6),
      Transform::translation({0, Rational(1, 2), Rational(1, 3)}) * Transform::rotation({1, 0, 0}, 90, {0, 0, 1}));
  check_pair(bottle(4), {}, bottle(4), Transform::translation({1, 0, 0}));  // with touching facets and edges
}

TEST_CASE("a bottle and a twisted cube equal Nef's", "[nef][curved]") {
  ExtrudeShape cube;
  cube.profile.lines.push_back({{line({0, 0, 1}, {2, 0, 1}), line({2, 0, 1}, {2, 2, 1}),
                                 line({2, 2, 1}, {0, 2, 1}), line({0, 2, 1}, {0, 0, 1})}});
  cube.vector = {0, 0, 1};
  cube.twist = 60;
  cube.center = RationalPoint{1, 1, 1};
  cube.tessellation.segments = 3;
  check_pair(bottle(4), {}, cube, {});
}

TEST_CASE("a solid of patches and a box equal Nef's", "[nef][curved]") {
  // A pillow: two bulges over one square.
  const auto net = [](int z) {
    return PatchNet{
        {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 0}, {1, 1, z}, {2, 1, 0}}, {{0, 2, 0}, {1, 2, 0}, {2, 2, 0}}},
        {},
        {0, 0},
        {}};
  };
  BezierShape pillow;
  pillow.patches = {net(3), net(-3)};
  std::swap(pillow.patches[1].points[0], pillow.patches[1].points[2]);
  pillow.fill = Fill::winding;
  pillow.tessellation.chord = Rational(1, 4);
  check_pair(pillow, {}, BoxShape{{1, 1, -1}, {3, 3, Rational(1, 2)}}, {});
}

}  // namespace cnrg::properties

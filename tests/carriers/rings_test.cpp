// Rings, cones and balls that planes and others touch in a point or along a line, in random rational frames: the
// contact is there at any fineness, and nothing else.
#include "kernel/exact/exact_vectors.h"
#include "tests/carriers/rows.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

/// A rotation by a random quaternion of whole numbers, and a shift.
class Frame {
 public:
  /// As it is.
  Frame() : rows_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}} {}
  explicit Frame(std::mt19937_64& random) {
    std::uniform_int_distribution<int> some(-3, 3), shift(-40, 40);
    long a = 0, b = 0, c = 0, d = 0;
    while (a == 0 || (b == 0 && c == 0 && d == 0))
      a = some(random), b = some(random), c = some(random), d = some(random);
    const Rational n = a * a + b * b + c * c + d * d;
    rows_ = {{{a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)},
              {2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)},
              {2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d}}};
    for (RationalPoint& row : rows_) {
      for (Rational& x : row) x /= n;
    }
    for (Rational& x : shift_) x = fraction(shift(random), 7);
  }
  std::string vector(const RationalPoint& v) const { return text({dot3(0, v), dot3(1, v), dot3(2, v)}); }
  std::string point(const RationalPoint& p) const {
    return text({dot3(0, p) + shift_[0], dot3(1, p) + shift_[1], dot3(2, p) + shift_[2]});
  }

 private:
  Rational dot3(std::size_t k, const RationalPoint& v) const {
    return rows_[k][0] * v[0] + rows_[k][1] * v[1] + rows_[k][2] * v[2];
  }
  static std::string text(const RationalPoint& p) {
    return "[" + p[0].get_str() + ", " + p[1].get_str() + ", " + p[2].get_str() + "]";
  }
  std::array<RationalPoint, 3> rows_;
  RationalPoint shift_;
};

/// One constellation in a frame and at a fineness.
class Leaves {
 public:
  Leaves(const Frame& frame, std::mt19937_64& random) : frame_(frame), random_(random) {}
  std::string ring(const RationalPoint& center, const RationalPoint& axis, const std::string& radii) {
    return "torus: {center: " + frame_.point(center) + ", axis: " + frame_.vector(axis) + ", " + radii + steps();
  }
  std::string ball(const RationalPoint& center, const std::string& radius) {
    return "sphere: {center: " + frame_.point(center) + ", radius: " + radius + steps();
  }
  std::string rod(const RationalPoint& from, const RationalPoint& to, const std::string& radius) {
    return "cylinder: {from: " + frame_.point(from) + ", to: " + frame_.point(to) + ", radius: " + radius +
           steps();
  }
  std::string cone(const RationalPoint& from, const RationalPoint& to, const std::string& radii) {
    return "cone: {from: " + frame_.point(from) + ", to: " + frame_.point(to) + ", " + radii + steps();
  }
  std::string half(const RationalPoint& point, const RationalPoint& normal) {
    return "halfspace: {point: " + frame_.point(point) + ", normal: " + frame_.vector(normal) + "}";
  }
  /// Around a square of the plane through the point, on the side of -normal; `along` and `across` are in the
  /// plane.
  std::string slab(const RationalPoint& point, const RationalPoint& normal, const RationalPoint& along,
                   const RationalPoint& across) {
    std::string corners;
    for (const auto& [x, y] : {std::pair(-3, -3), std::pair(4, -3), std::pair(4, 5), std::pair(-3, 5)})
      corners += (corners.empty() ? "" : ", ") + frame_.point(point + Rational(x) * along + Rational(y) * across);
    return "prism: {base: [" + corners + "], vector: " + frame_.vector(Rational(-1) * normal) + "}";
  }

 private:
  std::string steps() { return ", segments: " + number(std::uniform_int_distribution<int>(6, 40)(random_)) + "}"; }
  const Frame& frame_;
  std::mt19937_64& random_;
};

struct Truth {
  Cells common, rest;  ///< of a and b, and of a less b
};

void check_contact(const std::string& a, const std::string& b, const Truth& truth) {
  const std::string nodes = "  a: {" + a + "}\n  b: {" + b + "}\n  common: {intersection: [a, b]}\n" +
                            "  rest: {difference: [a, b]}\n  model: {union: [common, rest], dominance: left}\n";
  INFO(nodes);
  const Evaluation found = evaluated(nodes);
  for (const NodeRow& row : found.rows) {
    if (row.name == "common") CHECK(row.cells == truth.common);
    if (row.name == "rest") CHECK(row.cells == truth.rest);
  }
}

Rational f(long n, long d) { return fraction(n, d); }

const RationalPoint origin{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
const Truth in_a_point{{1, 0, 0, 0}, {0, 0, 1, 1}};

/// `test` with leaves in six frames.
template <class Test>
void in_frames(unsigned first, const Test& test) {
  for (unsigned seed = first; seed < first + 6; ++seed) {
    std::mt19937_64 random(seed);
    const Frame frame(random);
    CAPTURE(seed);
    test(Leaves(frame, random));
  }
}

TEST_CASE("a ring touches a plane in any direction") {
  in_frames(31, [](Leaves of) {
    const std::string ring = of.ring(origin, z, "radius: 2, tube: 1");
    // Upright, oblique, from below; of a half-space and of a prism.
    const RationalPoint n{f(3, 5), 0, f(4, 5)}, along{f(4, 5), 0, f(-3, 5)};
    check_contact(ring, of.half({3, 0, 0}, {-1, 0, 0}), in_a_point);
    check_contact(ring, of.half({0, f(-33, 25), f(-44, 25)}, {0, 3, 4}), in_a_point);
    check_contact(ring, of.slab(f(11, 5) * n, Rational(-1) * n, along, y), in_a_point);
    // From inside of the ring the plane cuts it, and touches it where the section passes through itself.
    check_contact(ring, of.half({1, 0, 0}, x), {{1, 2, 3, 1}, {1, 2, 3, 1}});
    // Through its middle, in two circles that cross in two contacts.
    check_contact(of.ring(origin, z, "radius: 2, tube: 6/5"), of.half(origin, n), {{2, 4, 3, 1}, {2, 4, 3, 1}});
  });
}

TEST_CASE("a ring touches balls, tubes and rings beside it") {
  in_frames(41, [](Leaves of) {
    const std::string ring = of.ring(origin, z, "radius: 3, tube: 1");
    // Above its outer half, on its top, in its hole above the middle, in its middle.
    check_contact(ring, of.ball({f(21, 5), 0, f(8, 5)}, "1"), in_a_point);
    check_contact(ring, of.ball({f(9, 5), f(12, 5), 3}, "2"), in_a_point);
    check_contact(ring, of.ball({0, f(9, 5), f(8, 5)}, "1"), in_a_point);
    check_contact(ring, of.ball({-1, 0, 0}, "1"), in_a_point);
    // Upright outside of it and in its hole, across its side, on its top.
    check_contact(ring, of.rod({3, 4, -2}, {3, 4, 2}, "1"), in_a_point);
    check_contact(ring, of.rod({f(3, 5), f(4, 5), -2}, {f(3, 5), f(4, 5), 2}, "1"), in_a_point);
    check_contact(ring, of.rod({-3, f(23, 5), f(6, 5)}, {2, f(23, 5), f(6, 5)}, "1"), in_a_point);
    check_contact(ring, of.rod({f(9, 5), -4, 2}, {f(9, 5), 5, 2}, "1"), {{2, 0, 0, 0}, {0, 0, 1, 1}});
    // In one plane, and in planes that cross at right angles.
    check_contact(ring, of.ring({f(18, 5), f(24, 5), 0}, z, "radius: 3/2, tube: 1/2"), in_a_point);
    check_contact(ring, of.ring({6, 0, 0}, {0, f(3, 5), f(4, 5)}, "radius: 3/2, tube: 1/2"), in_a_point);
  });
}

TEST_CASE("a cone touches a plane along a line, and a ball beside it in a point") {
  in_frames(51, [](Leaves of) {
    const std::string cone = of.cone(origin, {0, 0, 4}, "radius: 3"),
                      part = of.cone(origin, {0, 0, 2}, "radius: 3, top: 3/2");
    const RationalPoint n{f(4, 5), 0, f(3, 5)}, along{f(-3, 5), 0, f(4, 5)};
    check_contact(cone, of.half({0, 0, 4}, Rational(-1) * n), {{2, 1, 0, 0}, {0, 1, 2, 1}});
    check_contact(part, of.slab({3, 0, 0}, Rational(-1) * n, along, y), {{2, 1, 0, 0}, {0, 2, 3, 1}});
    // Beside it, and in a conical hole.
    check_contact(cone, of.ball({f(3, 2) + f(8, 5), 0, 2 + f(6, 5)}, "2"), {{1, 0, 0, 0}, {0, 1, 2, 1}});
    check_contact(cone, of.ball({f(3, 2) - f(4, 5), 0, 2 - f(3, 5)}, "1"), {{0, 0, 1, 1}, {1, 1, 3, 1}});
  });
}

TEST_CASE("a rod that touches a larger ball from inside leaves it above and below") {
  in_frames(71, [](Leaves of) {
    const Truth touching{{1, 2, 3, 1}, {1, 2, 2, 1}};
    check_contact(of.ball(origin, "2"), of.rod({f(3, 5), f(4, 5), -3}, {f(3, 5), f(4, 5), 3}, "1"), touching);
    check_contact(of.ball(origin, "5/2"), of.rod({2, 0, -3}, {2, 0, 3}, "1/2"), touching);
  });
}

TEST_CASE("half a ring and its pipe have one circle, though even steps of both are not quite on it") {
  for (const unsigned seed : {61U, 62U, 63U, 64U, 65U, 66U}) {
    std::mt19937_64 random(seed);
    for (const bool turned : {false, true}) {
      const Frame frame = turned ? Frame(random) : Frame();
      Leaves of(frame, random);
      CAPTURE(seed, turned);
      // Axes of 3, 4, 5: the frames of circles are rational, and even steps are rounded all the same.
      const std::string nodes = "  ring: {" + of.ring(origin, {-3, 0, 4}, "radius: 2, tube: 1") + "}\n  cut: {" +
                                of.half(origin, {4, 0, 3}) + "}\n  pipe: {" +
                                of.rod({0, -2, 0}, {-4, -2, -3}, "1") +
                                "}\n  bend: {difference: [ring, cut]}\n  model: {union: [bend, pipe]}\n";
      INFO(nodes);
      CHECK(row(nodes).cells == Cells{0, 3, 4, 1});
    }
  }
}

}  // namespace
}  // namespace cnrg

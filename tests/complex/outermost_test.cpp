// Regions of scenes of many surfaces, beside the boxes that hold a point on each side of each face.
//
// Half the boxes are of one kind, so that they lie apart, in each other, touch in corners, edges and faces, or
// cross; some are open, some turned inside out, and all are moved far from zero, made thin or so small at times
// that their volumes underflow: where the volume of a surface in doubles is not certain, a ray has to tell.
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "kernel/base/error.h"
#include "kernel/complex/complex.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

using namespace cnrg;

namespace {

struct TestBox {
  std::array<double, 3> low, high;  // on a grid of integers
  bool open;                        // a sheet of five faces: no region
  bool holds(const std::array<double, 3>& p) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (p[k] < low[k] || p[k] > high[k]) return false;
    }
    return !open;
  }
};

/// `move` maps the grid into space, one coordinate at a time.
template <class Random, class Move>
void add_to(Soup& soup, const TestBox& box, Random& random, const Move& move) {
  const LeafId leaf = soup.add_leaf(box.open ? Fill::none : Fill::parity);
  std::vector<PointId> p;
  for (int i = 0; i < 8; ++i) {
    p.push_back(soup.add_point(move(0, i & 1 ? box.high[0] : box.low[0]),
                               move(1, i & 2 ? box.high[1] : box.low[1]),
                               move(2, i & 4 ? box.high[2] : box.low[2])));
  }
  const std::size_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const std::size_t without = box.open ? random() % 6 : 6;
  for (std::uint32_t f = 0; f < 6; ++f) {
    if (f == without) continue;
    std::vector<std::vector<PointId>> loops(1);
    for (const std::size_t i : quads[f]) loops[0].push_back(p[i]);
    if (random() % 3 == 0) std::reverse(loops[0].begin(), loops[0].end());
    soup.add_face(leaf, loops, f, f);
  }
}

bool coplanar(const std::array<std::array<double, 3>, 4>& t) {
  std::array<std::array<Rational, 3>, 3> v;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) v[i][k] = from_double(t[i + 1][k]) - from_double(t[0][k]);
  }
  return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) + v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
             v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]) ==
         0;
}

}  // namespace

TEST_CASE("regions of many surfaces are those of the boxes around them") {
  const auto [first, end] = scenes::seeds(150);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    const auto below = [&](std::uint64_t n) { return static_cast<double>(random() % n); };
    const int size = 4 + static_cast<int>(random() % 40), count = 20 + static_cast<int>(random() % 40);
    const auto longest = 1 + random() % static_cast<std::uint64_t>(size / 2);
    std::vector<TestBox> boxes;
    for (int i = 0; i < count; ++i) {
      TestBox& box = boxes.emplace_back();
      box.open = random() % 5 == 0;
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = below(static_cast<std::uint64_t>(size));
        box.high[k] = box.low[k] + 1 + below(longest);
      }
    }
    // Powers of two move the grid without rounding.
    const double unit = random() % 3 == 0 ? std::ldexp(1, -359) : 1;
    const double shift = random() % 3 == 0 ? std::ldexp(unit, 40) : 0;
    const std::array<double, 3> scale{unit, random() % 3 == 0 ? std::ldexp(unit, -12) : unit, unit};
    const auto move = [&](std::size_t k, double x) { return x * scale[k] + shift; };
    Soup soup;
    for (const TestBox& box : boxes) add_to(soup, box, random, move);
    const auto complex = build_complex(soup);
    REQUIRE(validate(*complex) == "");
    for (const FaceId f : IdRange<FaceId>(complex->face_count())) {
      // Back on the grid the planes are integers, and inside of a face no coordinate but one is.
      const RationalPoint in_face = interior_point(*complex, f).rational();
      const ExactPlane& plane = complex->points.exact_plane(complex->plane(f));
      std::array<double, 3> at;
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = to_double((in_face[k] - from_double(shift)) / from_double(scale[k]));
      const int normal[3] = {sgn(plane.a), sgn(plane.b), sgn(plane.c)};
      for (const unsigned side : {0U, 1U}) {
        std::array<double, 3> p = at;
        for (std::size_t k = 0; k < 3; ++k) p[k] += (side == 0 ? 0.5 : -0.5) * normal[k];
        std::set<std::size_t> expected, found;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
          if (boxes[i].holds(p)) expected.insert(i);
        }
        for (const Label& label : complex->labels(complex->region(HalfFace(f, side))))
          found.insert(label.leaf.index());
        REQUIRE(found == expected);
      }
    }
  }
}

// Thin tetrahedra in a row, so small that products of their coordinates underflow: what their volume is in doubles
// has any sign.
TEST_CASE("regions of surfaces whose volume underflows are inside of them") {
  const auto [first, end] = scenes::seeds(100);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    INFO("seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> digit(-99, 99);
    using Place = std::array<double, 3>;
    std::vector<std::array<Place, 4>> tetrahedra;
    Soup soup;
    while (tetrahedra.size() < 30) {
      std::array<Place, 4> t;
      for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) t[i][k] = std::ldexp(digit(random), 33);
        t[3][k] = t[0][k] + t[1][k] - t[2][k] + digit(random);
      }
      for (Place& p : t) {
        p[0] += std::ldexp(static_cast<double>(tetrahedra.size()), 42);
        for (double& x : p) x = std::ldexp(x, -396);
      }
      if (coplanar(t)) continue;
      const LeafId leaf = soup.add_leaf(Fill::parity);
      std::array<PointId, 4> id;
      for (std::size_t i = 0; i < 4; ++i) id[i] = soup.add_point(t[i][0], t[i][1], t[i][2]);
      const std::size_t sides[4][3] = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
      for (std::uint32_t f = 0; f < 4; ++f) {
        const std::vector<std::vector<PointId>> loops{{id[sides[f][0]], id[sides[f][1]], id[sides[f][2]]}};
        soup.add_face(leaf, loops, f, f);
      }
      tetrahedra.push_back(t);
    }
    const auto complex = build_complex(soup);
    REQUIRE(complex->face_count() == 4 * tetrahedra.size());
    for (const FaceId f : IdRange<FaceId>(complex->face_count())) {
      const RationalPoint in_face = interior_point(*complex, f).rational();
      const ExactPlane& plane = complex->points.exact_plane(complex->plane(f));
      const unsigned in = complex->labels(complex->region(HalfFace(f, 0))).size() == 1 ? 0 : 1;
      REQUIRE(complex->labels(complex->region(HalfFace(f, 1 - in))).empty());
      const auto labels = complex->labels(complex->region(HalfFace(f, in)));
      REQUIRE(labels.size() == 1);
      Rational above = 0;  // four times how far the centroid is above the plane
      for (const Place& p : tetrahedra[labels[0].leaf.index()]) {
        above += plane.a * (from_double(p[0]) - in_face[0]) + plane.b * (from_double(p[1]) - in_face[1]) +
                 plane.c * (from_double(p[2]) - in_face[2]);
      }
      REQUIRE((sgn(above) > 0) == (in == 0));
    }
  }
}

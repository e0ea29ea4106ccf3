// Planes and half-spaces: the frame holds every vertex of the arrangement.
#include "csg/leaves/unbounded.h"

#include <random>

#include "tests/exact/rational_text.h"
#include "tests/leaves/soup_checks.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

ExactBox frame_of(const Soup& soup) {
  ExactBox box{{0, 0, 0}, {0, 0, 0}};
  bool first = true;
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf != soup.frame()) continue;
    for (PointId p : soup.corners(f)) {
      const RationalPoint x = value(soup, p);
      for (std::size_t k = 0; k < 3; ++k) {
        if (first || x[k] < box.low[k]) box.low[k] = x[k];
        if (first || x[k] > box.high[k]) box.high[k] = x[k];
      }
      first = false;
    }
  }
  return box;
}

bool strictly_inside(const ExactBox& box, const RationalPoint& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (p[k] <= box.low[k] || p[k] >= box.high[k]) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("a half-space in its frame") {
  const auto half = prepare(HalfspaceShape{{0, 0, r("1/3")}, {0, 0, 2}});
  CHECK(half->unbounded());
  CHECK(half->regions().size() == 1);
  const auto box = prepare(BoxShape{{0, 0, 0}, {1, 1, 1}});
  CHECK_FALSE(box->unbounded());
  const Soup soup = make_soup({{half}, {box}});
  REQUIRE(soup.leaf_count() == 3);
  CHECK(soup.frame() == LeafId(2));
  CHECK(soup.fill(LeafId(0)) == Fill::sides);
  CHECK(planar(soup));
  CHECK(closed(soup, LeafId(2)));
  CHECK(volume(soup, LeafId(2)) > 0);
  const ExactBox frame = frame_of(soup);
  CHECK(strictly_inside(frame, {0, 0, 0}));
  CHECK(strictly_inside(frame, {1, 1, 1}));
  CHECK(value(soup, soup.frame_seed()) == frame.high);
  CHECK(soup.seed_regions().empty());  // the seed is above
  for (SourceId f : IdRange<SourceId>(soup.face_count())) {
    if (soup.face(f).leaf != LeafId(0)) continue;
    CHECK(soup.face(f).front == 0);
    CHECK(soup.face(f).back == 1);
    const auto loop = loops(soup, f)[0];
    CHECK(loop.size() == 4);
    CHECK(cross(loop[1] - loop[0], loop[2] - loop[1])[2] > 0);
  }
  SECTION("turned over, the seed is inside") {
    const Soup over = make_soup({{half, Transform::scaling({1, 1, -1})}});
    REQUIRE(over.seed_regions().size() == 1);
    CHECK(over.seed_regions()[0] == std::pair<LeafId, std::uint32_t>(LeafId(0), 1));
  }
  SECTION("without unbounded leaves there is no frame") { CHECK_FALSE(make_soup({{box}}).frame().valid()); }
  CHECK_THAT(error_of(PlaneShape{{0, 0, 0}, {0, 0, 0}}), Catch::Contains("plane: the normal"));
  CHECK_THAT(error_of(HalfspaceShape{{0, 0, 0}, {0, 0, 0}}), Catch::Contains("halfspace: the normal"));
}

TEST_CASE("planes of all kinds lie in the frame with all their vertices") {
  std::mt19937 random(4);
  for (int round = 0; round < 40; ++round) {
    std::vector<std::shared_ptr<const PreparedLeaf>> leaves;
    std::vector<LeafInstance> instances;
    std::vector<ExactHalfspace> planes;
    const int count = 1 + static_cast<int>(random() % 6);
    for (int i = 0; i < count; ++i) {
      const auto number = [&] { return Rational(static_cast<long>(random() % 7) - 3); };
      RationalPoint normal{number(), number(), number()};
      if (is_zero(normal)) normal = {1, -1, 0};
      const RationalPoint point{number(), number() * 10, number() / 3};
      leaves.push_back(prepare(PlaneShape{point, normal}));
      instances.push_back({leaves.back(), {}});
      planes.push_back({normal, dot(normal, point)});
    }
    const Soup soup = make_soup(instances);
    REQUIRE(planar(soup));
    const ExactBox frame = frame_of(soup);
    const RationalPoint seed = value(soup, soup.frame_seed());
    for (const ExactHalfspace& p : planes) REQUIRE(dot(p.normal, seed) != p.offset);
    for (int i = 0; i < count; ++i) {
      const auto loop = loops(soup, SourceId(static_cast<std::size_t>(i)))[0];
      RationalPoint area{0, 0, 0};
      for (std::size_t k = 0; k < loop.size(); ++k) {
        REQUIRE(dot(planes[i].normal, loop[k]) == planes[i].offset);
        REQUIRE_FALSE(strictly_inside(frame, loop[k]));
        const RationalPoint turn = cross(loop[(k + 1) % loop.size()] - loop[k],
                                         loop[(k + 2) % loop.size()] - loop[(k + 1) % loop.size()]);
        REQUIRE(dot(turn, planes[i].normal) > 0);  // strictly convex, counter-clockwise
        area = area + turn;
      }
      for (int j = 0; j < i; ++j) {
        for (int k = 0; k < j; ++k) {
          const RationalPoint line = cross(planes[i].normal, planes[j].normal);
          const Rational determinant = dot(line, planes[k].normal);
          if (determinant == 0) continue;
          const RationalPoint common =
              Rational(1 / determinant) *
              (planes[k].offset * line + planes[i].offset * cross(planes[j].normal, planes[k].normal) +
               planes[j].offset * cross(planes[k].normal, planes[i].normal));
          REQUIRE(dot(planes[i].normal, common) == planes[i].offset);
          REQUIRE(strictly_inside(frame, common));
        }
      }
    }
  }
}

TEST_CASE("planes through the frame's corner move the corner") {
  // x = y, y = z and x + y = 2 z all pass through the corners of a cube.
  const auto a = prepare(PlaneShape{{0, 0, 0}, {1, -1, 0}}), b = prepare(PlaneShape{{0, 0, 0}, {0, 1, -1}}),
             c = prepare(PlaneShape{{0, 0, 0}, {1, 1, -2}});
  const Soup soup = make_soup({{a}, {b}, {c}});
  const RationalPoint seed = value(soup, soup.frame_seed());
  CHECK(seed[0] != seed[1]);
  CHECK(seed[1] != seed[2]);
  CHECK(seed[0] + seed[1] != 2 * seed[2]);
  CHECK(planar(soup));
}

TEST_CASE("a half-space under a general transform keeps its inside") {
  const Transform t = Transform::reflection({1, 2, 3}, {0, 0, 1}) * Transform::scaling({2, r("1/3"), 1}) *
                      Transform::rotation({1, 1, 0}, 40, {0, 0, 0});
  const UnboundedLeaf leaf({1, 1, 1}, {1, -2, r("1/2")}, true);
  const ExactHalfspace image = leaf.image(t);
  const RationalPoint on{1, 1, 1}, front = on + RationalPoint{1, -2, r("1/2")};
  CHECK(dot(image.normal, t.apply(on)) == image.offset);
  CHECK(dot(image.normal, t.apply(front)) > image.offset);
  CHECK(dot(image.normal, t.apply(on + RationalPoint{2, 1, 0})) == image.offset);
}

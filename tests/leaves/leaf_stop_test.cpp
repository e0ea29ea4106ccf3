// Leaves hear of a stop while they are made.
#include "csg/leaves/leaf_stop.h"

#include "csg/leaves/leaf.h"
#include "kernel/base/error.h"
#include "tests/catch.h"

using namespace cnrg;

namespace {

/// Shapes of some hundred points.
std::vector<Shape> large_shapes() {
  HeightfieldShape field;
  for (int j = 0; j < 20; ++j) {
    auto& row = field.heights.emplace_back();
    for (int i = 0; i < 20; ++i) row.emplace_back(i * j % 7);
  }
  PatchNet patch;
  for (int j = 0; j < 3; ++j) {
    auto& row = patch.points.emplace_back();
    for (int i = 0; i < 3; ++i) row.push_back({i, j, (i + 1) * j});
  }
  const Tessellation fine{{}, 64};
  ProfileLine line;
  const std::vector<RationalPoint> corners{{1, 0, 0}, {2, 0, 1}, {1, 0, 2}};
  for (std::size_t i = 0; i < 3; ++i) line.segments.emplace_back().points = {corners[i], corners[(i + 1) % 3]};
  std::vector<RationalPoint> points;
  for (int i = 0; i < 400; ++i) points.push_back({i, 0, 0});
  return {SphereShape{{0, 0, 0}, 1, 64, 32},
          TorusShape{{0, 0, 0}, {0, 0, 1}, 4, 1, 32, 16},
          CylinderShape{{0, 0, 0}, {0, 0, 1}, 1, 400},
          ConeShape{{0, 0, 0}, {0, 0, 1}, 1, 0, 400},
          BezierShape{{patch}, {}, Fill::none, fine},
          RevolveShape{Profile{{line}}, {0, 0, 0}, {0, 0, 1}, 360, fine},
          field,
          PolylineShape{points}};
}

}  // namespace

TEST_CASE("the making of each large leaf is stopped", "[leaves][stop]") {
  std::stop_source stop;
  stop.request_stop();
  for (const Shape& shape : large_shapes()) {
    INFO("shape " << shape.index());
    std::shared_ptr<const PreparedLeaf> leaf;
    {
      const LeafStop asked(stop.get_token());
      CHECK_THROWS_AS(prepare(shape), Stopped);
    }
    REQUIRE_NOTHROW(leaf = prepare(shape));  // nobody waits now
    Soup soup;
    {
      const LeafStop asked(stop.get_token());
      CHECK_THROWS_AS(leaf->add_to(soup, {}), Stopped);
    }
    Soup other;
    CHECK_NOTHROW(leaf->add_to(other, {}));
  }
}

TEST_CASE("who asks last is the owner of a leaf, and others come after", "[leaves][stop]") {
  std::stop_source stop;
  stop.request_stop();
  const LeafStop none{std::stop_token()};
  {
    const LeafStop asked(stop.get_token());
    CHECK(LeafStop::token().stop_requested());
    const LeafStop inner{std::stop_token()};
    CHECK_FALSE(LeafStop::token().stop_possible());
    CHECK_NOTHROW(prepare(SphereShape{{0, 0, 0}, 1, 64, 32}));
  }
  CHECK_FALSE(LeafStop::token().stop_possible());
}

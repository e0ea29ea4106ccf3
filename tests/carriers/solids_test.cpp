// Solids of curved patches that share walls: what touches touches, and what is equal cancels, at any fineness.
//
// The solids are images of boxes under one polynomial map of space, so their walls are pieces of the same
// surfaces. What Booleans make of them is known from the boxes.
#include <functional>

#include "csg/curves/control_nets.h"
#include "csg/operators/boolean.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/measure.h"
#include "tests/carriers/nets_scenes.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

/// A map of the unit cube, triquadratic, near the identity: control points [k][j][i]. If asked, the edges of the
/// cube stay straight, of degree 1.
struct Warp {
  std::array<Net4, 3> net;
  explicit Warp(std::mt19937& random, bool straight = false) {
    for (long k = 0; k < 3; ++k) {
      for (long j = 0; j < 3; ++j) {
        Row4& row = net[static_cast<std::size_t>(k)].emplace_back();
        for (long i = 0; i < 3; ++i) {
          const bool on_edge = (i % 2 == 0) + (j % 2 == 0) + (k % 2 == 0) >= 2;
          const auto near = [&](long x) -> Rational {
            return straight && on_edge ? Rational(x) : Rational(x) + ratio(pick(random, -2, 2), 16);
          };
          row.push_back({near(i), near(j), near(k), 1});
        }
      }
    }
  }
  /// The image of the rectangle u0..u1 by v0..v1 in the plane across `axis` at height `h`; u and v are the next
  /// two axes.
  Net4 wall(std::size_t axis, const Rational& h, const Rectangle& r) const {
    // The control point with the indices of all three axes.
    const auto control = [&](const std::array<std::size_t, 3>& at) -> const Point4& {
      return net[at[2]][at[1]][at[0]];
    };
    Net4 flat(3, Row4(3));
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t u = 0; u < 3; ++u) {
        Row4 column;
        for (std::size_t x = 0; x < 3; ++x) {
          std::array<std::size_t, 3> at{};
          at[axis] = x;
          at[(axis + 1) % 3] = u;
          at[(axis + 2) % 3] = v;
          column.push_back(control(at));
        }
        flat[v][u] = blossom(column, {h, h});
      }
    }
    return piece_of(flat, r);
  }
};

using Block = std::array<std::array<Rational, 2>, 3>;

/// The image of a box, its patches written in any way that keeps their fronts outside; of raised degree if asked.
LeafInstance solid(const Warp& warp, const Block& box, std::mt19937& random, const Tessellation& fineness) {
  const Transform transform = random_transform(random), back = transform.inverse();
  BezierShape shape;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t end = 0; end < 2; ++end) {
      const Net4 wall = warp.wall(axis, box[axis][end], {box[(axis + 1) % 3], box[(axis + 2) % 3]});
      // u x v points along the axis; the near end looks the other way. An odd number of turns changes sides.
      constexpr std::array<int, 4> kSame{0, 3, 5, 6};
      const int way = kSame[static_cast<std::size_t>(pick(random, 0, 3))] ^ (end == 0 ? 4 : 0);
      shape.patches.push_back(patch_net(raised(written(wall, way), pick(random, 0, 1), pick(random, 0, 1)), back));
    }
  }
  // Sides that meet have one degree after all: of raised ones the leaf takes the least.
  shape.fill = Fill::winding;
  shape.tessellation = fineness;
  return placed(shape, transform);
}

/// Pieces of a set of cells of a grid of 12^3, by flooding.
constexpr int kGrid = 12;
std::size_t pieces(const std::function<bool(const Rational&, const Rational&, const Rational&)>& inside) {
  std::vector<int> state(kGrid * kGrid * kGrid, 0);  // 1: inside
  const auto index = [](int x, int y, int z) { return static_cast<std::size_t>((z * kGrid + y) * kGrid + x); };
  for (int z = 0; z < kGrid; ++z) {
    for (int y = 0; y < kGrid; ++y) {
      for (int x = 0; x < kGrid; ++x) {
        const auto middle = [](int i) { return ratio(2 * i + 1, 2 * kGrid); };
        state[index(x, y, z)] = inside(middle(x), middle(y), middle(z)) ? 1 : 0;
      }
    }
  }
  std::size_t count = 0;
  for (std::size_t first = 0; first < state.size(); ++first) {
    if (state[first] != 1) continue;
    ++count;
    std::vector<std::size_t> open{first};
    state[first] = 2;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const int x = static_cast<int>(at) % kGrid, y = static_cast<int>(at) / kGrid % kGrid,
                z = static_cast<int>(at) / kGrid / kGrid;
      for (const auto& [dx, dy, dz] : std::initializer_list<std::array<int, 3>>{
               {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        const int nx = x + dx, ny = y + dy, nz = z + dz;
        if (nx < 0 || ny < 0 || nz < 0 || nx >= kGrid || ny >= kGrid || nz >= kGrid) continue;
        if (state[index(nx, ny, nz)] != 1) continue;
        state[index(nx, ny, nz)] = 2;
        open.push_back(index(nx, ny, nz));
      }
    }
  }
  return count;
}

bool in(const Block& b, const Rational& x, const Rational& y, const Rational& z) {
  return b[0][0] < x && x < b[0][1] && b[1][0] < y && y < b[1][1] && b[2][0] < z && z < b[2][1];
}

Rational volume_of(const Complex& complex, const Group& group) {
  std::vector<RegionId> cells;
  for (const auto& [cell, region] : group.cells) cells.push_back(cell);
  return volume(complex, cells).value();
}

Block random_block(std::mt19937& random) {
  Block b;
  for (auto& side : b) {
    const int a = pick(random, 0, 3);
    side = {ratio(a, 4), ratio(pick(random, a + 1, 4), 4)};
  }
  return b;
}

}  // namespace

TEST_CASE("solids whose walls are pieces of common surfaces cut each other as the boxes do") {
  const auto [first, last] = scenes::seeds(60);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const Warp warp(random, seed % 3 == 0);
    const Block a = random_block(random), b = random_block(random);
    const auto fineness = [&]() -> Tessellation {
      if (pick(random, 0, 2) == 0) return {ratio(1, pick(random, 30, 60)), std::nullopt};
      return {std::nullopt, pick(random, 3, 5)};
    };
    const LeafInstance one = solid(warp, a, random, fineness()), other = solid(warp, b, random, fineness());
    const auto complex = build_complex(make_soup(with_common_nets({one, other})));
    const std::vector<Group> leaves = leaf_groups(*complex);
    const auto apply = [&](BooleanOp op, std::size_t left, std::size_t right) {
      return boolean_operation(*complex, op, Dominance::equal, leaves[left], leaves[right]).group;
    };
    const Group common = apply(BooleanOp::intersect, 0, 1), a_only = apply(BooleanOp::subtract, 0, 1),
                b_only = apply(BooleanOp::subtract, 1, 0);
    CHECK(common.regions.size() == pieces([&](auto&&... p) { return in(a, p...) && in(b, p...); }));
    CHECK(a_only.regions.size() == pieces([&](auto&&... p) { return in(a, p...) && !in(b, p...); }));
    CHECK(b_only.regions.size() == pieces([&](auto&&... p) { return in(b, p...) && !in(a, p...); }));
    // Together no more cells than these: no voids.
    CHECK(complex->region_count == 1 + common.regions.size() + a_only.regions.size() + b_only.regions.size());
    CHECK(volume_of(*complex, leaves[0]) == volume_of(*complex, common) + volume_of(*complex, a_only));
  }
}

TEST_CASE("a solid of patches minus itself, written, placed and tessellated otherwise, is nothing") {
  const auto [first, last] = scenes::seeds(40);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(static_cast<unsigned>(seed + 500));
    const Warp warp(random, seed % 3 == 0);
    const Block box = random_block(random);
    const LeafInstance one = solid(warp, box, random, random_fineness(random)),
                       other = solid(warp, box, random, random_fineness(random));
    const std::vector<LeafInstance> both = with_common_nets({one, other});
    CHECK(facets(both[0]) == facets(both[1]));
    const auto complex = build_complex(make_soup(both));
    const std::vector<Group> leaves = leaf_groups(*complex);
    CHECK(leaves[0].cells.size() == 1);
    CHECK(leaves[0].cells == leaves[1].cells);
    const Soup soup = make_soup(both);
    CHECK(volume(soup, LeafId(0)) > 0);
    CHECK(volume(soup, LeafId(0)) == volume(soup, LeafId(1)));
    CHECK(volume_of(*complex, leaves[0]) == volume(soup, LeafId(0)));
  }
}

TEST_CASE("two halves of a warped block, of different fineness, have one wall between them") {
  std::mt19937 random(3);
  for (int round = 0; round < 10; ++round) {
    CAPTURE(round);
    const Warp warp(random);
    const Rational h = ratio(pick(random, 1, 4), 5);
    const std::vector<LeafInstance> both =
        with_common_nets({solid(warp, {{{0, 1}, {0, 1}, {0, h}}}, random, {std::nullopt, pick(random, 1, 7)}),
                          solid(warp, {{{0, 1}, {0, 1}, {h, 1}}}, random, {std::nullopt, pick(random, 1, 7)})});
    const Soup soup = make_soup(both);
    const auto complex = build_complex(soup);
    CHECK(complex->region_count == 3);
    const Facets lower = facets(both[0]), upper = facets(both[1]);
    Facets wall;
    std::set_intersection(lower.begin(), lower.end(), upper.begin(), upper.end(), std::inserter(wall, wall.end()));
    // The walls alone, by their patch: 2 n^2 triangles of the finer one.
    std::size_t on_wall = 0;
    for (SourceId f : IdRange<SourceId>(soup.face_count()))
      on_wall += soup.face(f).leaf == LeafId(0) && soup.face(f).patch == 5 ? 1 : 0;
    CHECK(wall.size() == on_wall);
    const Group whole = boolean_operation(*complex, BooleanOp::unite, Dominance::left, leaf_groups(*complex)[0],
                                          leaf_groups(*complex)[1])
                            .group;
    CHECK(whole.regions.size() == 2);
    CHECK(volume_of(*complex, whole) == volume(soup, LeafId(0)) + volume(soup, LeafId(1)));
  }
}

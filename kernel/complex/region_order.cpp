// Regions are numbered by where they are, not by how they came to be: by their least vertex (in the order of
// coordinates), then by their least direction there, then by the angle about it. All three are those of the region
// as a set of points: of a region that faces cut the least piece has them, whatever the cuts are. So what else is
// in the complex changes no order.
//
// Directions (x, y, z) at a least vertex are lexicographically positive: so is L = x + e y + e^2 z for a small e.
// Their order is that of (y/L, z/L): the cone of a region is a polygon of that plane, whose least corner is an
// edge. To the right of the least corner lies all of the polygon; about it the plane turns as space does about the
// edge.
#include <algorithm>

#include "kernel/base/parallel.h"
#include "kernel/complex/builder.h"
#include "kernel/complex/radial.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

constexpr Projection kXY{0, 1}, kYZ{1, 2}, kXZ{0, 2};

/// -1 if the direction from v to p comes before that to q, 1 behind it, 0 if they are the same.
int compare_directions(const PointTable& t, VertexId v, VertexId p, VertexId q) {
  if (const int s = orient2d(t, kXY, v, p, q)) return -s;
  if (const int s = orient2d(t, kYZ, v, p, q)) return s;
  return -orient2d(t, kXZ, v, p, q);
}

}  // namespace

/// The places of the regions: `place[r]` for the number r that a region has now; that of infinity is 0.
std::vector<std::uint32_t> ComplexBuilder::places_of_regions(const std::vector<RegionId>& region_of) const {
  const PointTable& t = c_.points;
  const auto region = [&](HalfFace h) { return region_of[shell(h).index()].index(); };
  IdVector<FaceId, VertexId> least_of_face(c_.face_count());
  for_each_index(c_.face_count(), [&](std::size_t i) {
    VertexId& least = least_of_face[FaceId(i)];
    for (const HalfEdge h : c_.loop[c_.face_loops[FaceId(i)].front()]) {
      const VertexId v = c_.origin(h);
      if (!least.valid() || compare_lex(t, v, least) < 0) least = v;
    }
  });
  std::vector<VertexId> least(c_.region_count);
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) {
    const VertexId v = least_of_face[f];
    for (const unsigned side : {0u, 1u}) {
      VertexId& best = least[region(HalfFace(f, side))];
      if (best != v && (!best.valid() || compare_lex(t, v, best) < 0)) best = v;
    }
  }

  std::vector<std::uint32_t> order;
  for (std::uint32_t r = 1; r < c_.region_count; ++r) order.push_back(r);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return least[a] != least[b] ? compare_lex(t, least[a], least[b]) < 0 : a < b;
  });
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end = std::find_if(begin, order.end(), [&](std::uint32_t r) { return least[r] != least[*begin]; });
    if (end - begin > 1) order_at(least[*begin], region_of, std::span(begin, end));
    begin = end;
  }
  std::vector<std::uint32_t> place(c_.region_count, 0);
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i + 1;
  return place;
}

/// Puts regions with the least vertex v in order.
void ComplexBuilder::order_at(VertexId v, const std::vector<RegionId>& region_of,
                              std::span<std::uint32_t> regions) const {
  const PointTable& t = c_.points;
  std::vector<HalfEdge> out;
  for (const EdgeId e : std::as_const(c_.vertex_edges)[v]) {
    const HalfEdge h(e, c_.edge_ends[e][0] == v ? 0 : 1);
    if (compare_lex(t, v, c_.target(h)) < 0) out.push_back(h);
  }
  std::sort(out.begin(), out.end(),
            [&](HalfEdge a, HalfEdge b) { return compare_directions(t, v, c_.target(a), c_.target(b)) < 0; });
  std::vector<std::uint32_t> left(regions.begin(), regions.end());
  std::size_t placed = 0;
  for (const HalfEdge h : out) {
    for (const HalfFace side : wedges_from_least(h)) {
      const auto found = std::find(left.begin(), left.end(), region_of[shell(side).index()].value());
      if (found == left.end()) continue;
      regions[placed++] = *found;
      left.erase(found);
    }
    if (left.empty()) return;
  }
  require(left.empty(), "a region has no edge at its least vertex");
}

/// Sides of faces that look into the wedges about an edge, in their order: those that begin in the half plane of
/// directions behind that of the edge, one for each wedge.
std::vector<HalfFace> ComplexBuilder::wedges_from_least(HalfEdge h) const {
  const auto uses = std::as_const(c_.edge_uses)[h.edge()];
  const RadialOrder radial(c_, h.edge());
  // The normal of a face is the cross product of the edge and a direction into the face, by its signs.
  const auto is_behind = [&](const FaceUse& x) {
    const int sign = x.half_edge.direction() == h.direction() ? 1 : -1;
    for (const auto& [axis, positive] : {std::pair(2, 1), std::pair(0, -1), std::pair(1, -1)}) {
      if (const int s = normal_sign(c_.points, c_.plane(x.face), axis)) return s * sign * positive > 0;
    }
    return false;
  };
  std::vector<FaceUse> behind;
  for (const FaceUse& x : uses) {
    if (is_behind(x)) behind.push_back(x);
  }
  const int turn = h.direction() == 0 ? 1 : -1;
  std::sort(behind.begin(), behind.end(),
            [&](const FaceUse& x, const FaceUse& y) { return x != y && radial.sine(x, y) * turn > 0; });
  std::vector<HalfFace> sides;
  for (const FaceUse& x : behind) sides.push_back(turn > 0 ? x.after() : x.before());
  return sides;
}

}  // namespace cnrg

// Regions are numbered by where they are, not by how they came to be: by their least vertex (in the order of
// coordinates), then by their least direction there, then by the angle about it. All three are those of the region
// as a set of points: of a region that faces cut the least piece has them, whatever the cuts are. So what else is
// in the complex changes no order.
//
// Directions (x, y, z) at a least vertex are lexicographically positive: so is L = x + e y + e^2 z for a small e.
// Their order is that of (y/L, z/L): the cone of a region is a polygon of that plane, whose least corner is an
// edge. To the right of the least corner lies all of the polygon; about it the plane turns as space does about the
// edge.
//
// A region without a least vertex comes before all that have one (far_order.h). Vertices of the frame are none.
//
// A leaf that was turned counts its cavities in its own coordinates. These are linear functions of x, y and z, so
// signs of them decide in the same way; where they are mirrored, angles turn the other way.
#include "kernel/complex/region_order.h"

#include <algorithm>

#include "kernel/base/parallel.h"
#include "kernel/complex/builder.h"
#include "kernel/complex/far_order.h"
#include "kernel/complex/radial.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"

namespace cnrg {
namespace {

constexpr Projection kXY{0, 1}, kYZ{1, 2}, kXZ{0, 2};

RationalPoint in(const LeafAxes& axes, const RationalPoint& p) {
  return {dot(axes[0], p), dot(axes[1], p), dot(axes[2], p)};
}

class PlaceOrder {
 public:
  PlaceOrder(const Complex& complex, const BodiesOfSpace& bodies, const LeafAxes* axes)
      : c_(complex), bodies_(bodies), axes_(axes) {
    if (axes != nullptr) handedness_ = sgn(dot(cross((*axes)[0], (*axes)[1]), (*axes)[2]));
  }

  std::vector<std::uint32_t> run() const {
    const std::vector<std::uint32_t> far = places_without_end();
    const std::vector<VertexId> least = least_vertices();
    std::vector<std::uint32_t> order;
    for (std::uint32_t b = 1; b < bodies_.count; ++b) order.push_back(b);
    const auto bounded = std::partition(order.begin(), order.end(), [&](std::uint32_t b) { return far[b] != 0; });
    std::sort(order.begin(), bounded, [&](std::uint32_t a, std::uint32_t b) { return far[a] < far[b]; });
    std::sort(bounded, order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return least[a] != least[b] ? compare(least[a], least[b]) < 0 : a < b;
    });
    for (auto begin = bounded; begin != order.end();) {
      const auto end =
          std::find_if(begin, order.end(), [&](std::uint32_t b) { return least[b] != least[*begin]; });
      if (end - begin > 1) order_at(least[*begin], std::span(begin, end));
      begin = end;
    }
    return order;
  }

 private:
  const Complex& c_;
  const BodiesOfSpace& bodies_;
  const LeafAxes* axes_;
  int handedness_ = 1;

  int compare(VertexId v, VertexId w) const {
    if (axes_ == nullptr) return compare_lex(c_.points, v, w);
    const RationalPoint from = c_.points.rational(w), to = c_.points.rational(v);
    for (const RationalPoint& axis : *axes_) {
      if (const int s = sgn(dot(axis, to - from))) return s;
    }
    return 0;
  }

  /// From v to p, in the coordinates of the order.
  RationalPoint direction(VertexId v, VertexId p) const {
    return in(*axes_, c_.points.rational(p) - c_.points.rational(v));
  }

  /// -1 if the direction from v to p comes before that to q, 1 behind it, 0 if they are the same.
  int compare_directions(VertexId v, VertexId p, VertexId q) const {
    if (axes_ != nullptr) {
      const RationalPoint normal = cross(direction(v, p), direction(v, q));
      return normal[2] != 0 ? -sgn(normal[2]) : normal[0] != 0 ? sgn(normal[0]) : sgn(normal[1]);
    }
    const PointTable& t = c_.points;
    if (const int s = orient2d(t, kXY, v, p, q)) return -s;
    if (const int s = orient2d(t, kYZ, v, p, q)) return s;
    return -orient2d(t, kXZ, v, p, q);
  }

  /// Of bodies that go on to lower and lower points: which come first; 0 for all others.
  std::vector<std::uint32_t> places_without_end() const {
    std::vector<std::uint32_t> places(bodies_.count, 0);
    std::optional<FarOrder> far;
    for (const FaceId f : bodies_.faces) {
      if (!c_.on_frame(f)) continue;
      const HalfFace front(f, 0), outside = bodies_.body(front) == 0 ? front : front.opposite();
      const std::uint32_t body = bodies_.body(outside.opposite());
      if (body == 0) continue;
      if (!far) far.emplace(c_, axes_);
      const std::uint32_t place = far->place(outside);
      if (place != 0 && (places[body] == 0 || place < places[body])) places[body] = place;
    }
    return places;
  }

  std::vector<VertexId> least_vertices() const {
    std::vector<VertexId> of_face(bodies_.faces.size()), least(bodies_.count);
    for_each_index(of_face.size(), [&](std::size_t i) {
      for (const HalfEdge h : c_.loop[c_.face_loops[bodies_.faces[i]].front()]) {
        const VertexId v = c_.origin(h);
        if (c_.on_frame(v)) continue;
        if (!of_face[i].valid() || compare(v, of_face[i]) < 0) of_face[i] = v;
      }
    });
    for (std::size_t i = 0; i < of_face.size(); ++i) {
      for (const unsigned side : {0u, 1u}) {
        VertexId& best = least[bodies_.body(HalfFace(bodies_.faces[i], side))];
        if (of_face[i].valid() && best != of_face[i] && (!best.valid() || compare(of_face[i], best) < 0))
          best = of_face[i];
      }
    }
    return least;
  }

  /// Puts bodies with the least vertex v in order.
  void order_at(VertexId v, std::span<std::uint32_t> bodies) const {
    std::vector<HalfEdge> out;
    for (const EdgeId e : c_.vertex_edges[v]) {
      const HalfEdge h(e, c_.edge_ends[e][0] == v ? 0 : 1);
      if (compare(v, c_.target(h)) < 0) out.push_back(h);
    }
    std::sort(out.begin(), out.end(),
              [&](HalfEdge a, HalfEdge b) { return compare_directions(v, c_.target(a), c_.target(b)) < 0; });
    std::vector<std::uint32_t> left(bodies.begin(), bodies.end());
    std::size_t placed = 0;
    for (const HalfEdge h : out) {
      for (const HalfFace side : wedges_from_least(h)) {
        const auto found = std::find(left.begin(), left.end(), bodies_.body(side));
        if (found == left.end()) continue;
        bodies[placed++] = *found;
        left.erase(found);
      }
      if (left.empty()) return;
    }
    require(left.empty(), "a region has no edge at its least vertex");
  }

  /// The signs of a direction that has a face to its left, crossed with a direction into that face.
  std::array<int, 3> normal_signs(const FaceUse& x) const {
    std::array<int, 3> signs{};
    if (axes_ == nullptr) {
      for (int k = 0; k < 3; ++k) signs[static_cast<std::size_t>(k)] = normal_sign(c_.points, c_.plane(x.face), k);
      return signs;
    }
    const ExactPlane& plane = c_.points.exact_plane(c_.plane(x.face));
    const RationalPoint normal{plane.a, plane.b, plane.c};
    const RationalPoint along =
        c_.points.rational(c_.target(x.half_edge)) - c_.points.rational(c_.origin(x.half_edge));
    const RationalPoint here = cross(in(*axes_, along), in(*axes_, cross(normal, along)));
    for (std::size_t k = 0; k < 3; ++k) signs[k] = sgn(here[k]);
    return signs;
  }

  /// Sides of faces that look into the wedges about an edge, in their order: those that begin in the half plane of
  /// directions behind that of the edge, one for each wedge.
  std::vector<HalfFace> wedges_from_least(HalfEdge h) const {
    const RadialOrder radial(c_, h.edge());
    const auto is_behind = [&](const FaceUse& x) {
      const int sign = x.half_edge.direction() == h.direction() ? 1 : -1;
      const std::array<int, 3> normal = normal_signs(x);
      for (const auto& [axis, positive] : {std::pair(2, 1), std::pair(0, -1), std::pair(1, -1)}) {
        if (const int s = normal[static_cast<std::size_t>(axis)]) return s * sign * positive > 0;
      }
      return false;
    };
    std::vector<FaceUse> behind;
    for (const FaceUse& x : c_.edge_uses[h.edge()]) {
      if (is_behind(x)) behind.push_back(x);
    }
    const int turn = (h.direction() == 0 ? 1 : -1) * handedness_;
    std::sort(behind.begin(), behind.end(),
              [&](const FaceUse& x, const FaceUse& y) { return x != y && radial.sine(x, y) * turn > 0; });
    std::vector<HalfFace> sides;
    for (const FaceUse& x : behind) sides.push_back(turn > 0 ? x.after() : x.before());
    return sides;
  }
};

}  // namespace

std::vector<std::uint32_t> in_order_of_place(const Complex& complex, const BodiesOfSpace& bodies,
                                             const LeafAxes* axes) {
  return PlaceOrder(complex, bodies, axes).run();
}

/// The places of the regions: `place[r]` for the number r that a region has now; that of infinity is 0.
std::vector<std::uint32_t> ComplexBuilder::places_of_regions(const std::vector<RegionId>& region_of) const {
  BodiesOfSpace regions{{},
                        [&](HalfFace h) { return region_of[shell(h).index()].value(); },
                        static_cast<std::uint32_t>(c_.region_count)};
  for (const FaceId f : IdRange<FaceId>(c_.face_count())) regions.faces.push_back(f);
  const std::vector<std::uint32_t> order = in_order_of_place(c_, regions);
  std::vector<std::uint32_t> place(c_.region_count, 0);
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i + 1;
  return place;
}

}  // namespace cnrg

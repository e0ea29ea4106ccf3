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
// A region without a least vertex comes before all that have one (FarOrder). Vertices of the frame are none.
//
// A leaf that was turned counts its cavities in its own coordinates. These are linear functions of x, y and z, so
// signs of them decide in the same way; where they are mirrored, angles turn the other way.
#include "kernel/complex/region_order.h"

#include <algorithm>
#include <memory>

#include "kernel/base/parallel.h"
#include "kernel/base/sorted.h"
#include "kernel/complex/builder.h"
#include "kernel/complex/complex.h"
#include "kernel/complex/plane_cut.h"
#include "kernel/complex/radial.h"
#include "kernel/exact/exact_vectors.h"
#include "kernel/exact/predicates.h"
#include "kernel/refine/box_faces.h"

namespace cnrg {
namespace {

// Which regions come first that go on for ever.
//
// The frame that planes are cut at (Complex::frame) is as large as all leaves need it, so its corners must not
// decide which region comes first. Regions that go on for ever towards lower x (or, if x is the same on the way,
// lower y or z) have no least point. They have one in a box of which the sides are farther away than any number,
// each much farther than the one before. Whatever is cut off by finite leaves, the least point is that of a cell
// of the planes alone. So they are those of a second complex: the planes in a box that is large enough.

class FarOrder {
 public:
  /// Of a complex with a frame, in the coordinates `axes` (nullptr: x, y, z).
  FarOrder(const Complex& complex, const LeafAxes* axes);
  ~FarOrder();
  /// The place, from 1, of what goes on for ever beyond a face of the frame, of which `outside` is the outer side;
  /// 0 if there is no way there to lower and lower points.
  std::uint32_t place(HalfFace outside) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// The coordinates of the order, and the way back from them.
class Coordinates {
 public:
  explicit Coordinates(const LeafAxes* axes) {
    if (axes != nullptr) axes_ = *axes;
    const Rational determinant = dot(cross(axes_[0], axes_[1]), axes_[2]);
    for (std::size_t i = 0; i < 3; ++i)
      back_[i] = Rational(1 / determinant) * cross(axes_[(i + 1) % 3], axes_[(i + 2) % 3]);
  }
  RationalPoint of(const RationalPoint& p) const { return {dot(axes_[0], p), dot(axes_[1], p), dot(axes_[2], p)}; }
  ExactHalfspace of(const ExactPlane& plane) const {
    const RationalPoint normal{plane.a, plane.b, plane.c};
    return {{dot(back_[0], normal), dot(back_[1], normal), dot(back_[2], normal)}, Rational(-plane.d)};
  }

 private:
  LeafAxes axes_{RationalPoint{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, back_;
};

/// The planes that reach the frame, each once.
std::vector<ExactHalfspace> planes_of(const Complex& complex, const Coordinates& coordinates) {
  IdVector<PlaneId, char> known(complex.points.plane_count(), 0);
  std::vector<ExactHalfspace> planes;
  for (const FaceId f : IdRange<FaceId>(complex.face_count())) {
    if (complex.on_frame(f)) continue;
    const auto loop = complex.loop[complex.face_loops[f].front()];
    if (std::none_of(loop.begin(), loop.end(), [&](HalfEdge h) { return complex.on_frame(h.edge()); })) continue;
    if (!std::exchange(known[complex.plane(f)], 1))
      planes.push_back(coordinates.of(complex.points.exact_plane(complex.plane(f))));
  }
  return planes;
}

/// How coordinates of a point in which planes meet sides of the box depend on where these are: on a line of two
/// planes and a side, or of a plane and two sides, a coordinate is a constant and multiples of places of sides.
struct Dependence {
  std::vector<Rational> factors{0, 1, -1};
  Rational constant = 0;  ///< the largest

  void add_factor(const Rational& x) { factors.push_back(x), factors.push_back(-x); }
  void add_constant(const Rational& x) { constant = std::max(constant, Rational(abs(x))); }

  explicit Dependence(const std::vector<ExactHalfspace>& planes) {
    for (std::size_t p = 0; p < planes.size(); ++p) {
      add(planes[p]);
      for (std::size_t q = 0; q < p; ++q) add(planes[p], planes[q]);
    }
    sort_unique(factors);
  }

  void add(const ExactHalfspace& p) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (p.normal[j] == 0) continue;
      add_constant(p.offset / p.normal[j]);
      for (const std::size_t k : {(j + 1) % 3, (j + 2) % 3}) add_factor(p.normal[k] / p.normal[j]);
    }
  }

  void add(const ExactHalfspace& p, const ExactHalfspace& q) {
    const RationalPoint line = cross(p.normal, q.normal);
    for (std::size_t k = 0; k < 3; ++k) {
      if (line[k] == 0) continue;
      for (const std::size_t j : {(k + 1) % 3, (k + 2) % 3}) {
        const std::size_t i = 3 - j - k;
        add_factor(line[j] / line[k]);
        add_constant((p.offset * q.normal[i] - q.offset * p.normal[i]) / line[k]);
      }
    }
  }

  /// If each side of the box is so many times as far away as the one before, the farthest one decides which of two
  /// coordinates is larger, unless they depend on it alike.
  Rational ratio() const {
    Rational least = 1;
    for (std::size_t i = 1; i < factors.size(); ++i)
      least = std::min(least, Rational(factors[i] - factors[i - 1]));
    return 24 * (factors.back() + 1) / least;
  }
};

Rational power_of_two_above(const Rational& x) {
  Rational power = 1;
  while (power <= x) power *= 2;
  return power;
}

ExactBox far_box(const Complex& complex, const Coordinates& coordinates,
                 const std::vector<ExactHalfspace>& planes) {
  Dependence dependence(planes);
  for (const VertexId v : complex.vertices) {
    if (!complex.on_frame(v)) continue;
    for (const Rational& x : coordinates.of(complex.points.rational(v))) dependence.add_constant(x);
  }
  const Rational ratio = power_of_two_above(dependence.ratio());
  Rational side = power_of_two_above(dependence.constant + 1);
  ExactBox box;
  for (std::size_t k = 3; k-- > 0;) {
    box.low[k] = -(side *= ratio);
    box.high[k] = side *= ratio;
  }
  return box;
}

Soup soup_of(const std::vector<ExactHalfspace>& planes, const ExactBox& box) {
  Soup soup;
  const LeafId leaf = soup.add_leaf(Fill::none);
  const auto add_face = [&](const std::vector<RationalPoint>& corners) {
    std::vector<PointId> loop;
    for (const RationalPoint& p : corners) loop.push_back(soup.add_point(p));
    soup.add_face(leaf, std::span(&loop, 1), 0, 0);
  };
  for (const ExactHalfspace& plane : planes) add_face(cut(plane, box));
  for (const auto& face : kBoxFaces)
    add_face({box.corner(face[0]), box.corner(face[1]), box.corner(face[2]), box.corner(face[3])});
  return soup;
}

VertexId least_vertex(const Complex& complex, RegionId r) {
  VertexId least;
  for (const HalfFace side : complex.region_faces[r]) {
    for (const HalfEdge h : complex.loop[complex.face_loops[side.face()].front()]) {
      const VertexId v = complex.origin(h);
      if (!least.valid() || compare_lex(complex.points, v, least) < 0) least = v;
    }
  }
  return least;
}

struct FarOrder::Data {
  const Complex& complex;
  Coordinates coordinates;
  Rational scale;  // `far` is so many times smaller, for it may be larger than doubles
  std::shared_ptr<const Complex> far;
  Locator locator;
  std::vector<std::optional<RationalPoint>> least;  // by region of `far`: its least point, if that is on the box

  Data(const Complex& c, const Coordinates& in, const std::vector<ExactHalfspace>& planes, const ExactBox& box,
       const Rational& times)
      : complex(c), coordinates(in), scale(times), far(build_complex(soup_of(planes, box))), locator(*far) {
    for (const RegionId r : IdRange<RegionId>(far->region_count)) {
      least.emplace_back();
      if (r == RegionId(0)) continue;
      const RationalPoint p = far->points.rational(least_vertex(*far, r));
      for (std::size_t k = 0; k < 3; ++k)
        if (p[k] == box.low[k] || p[k] == box.high[k]) least.back() = p;
    }
  }
};

FarOrder::FarOrder(const Complex& complex, const LeafAxes* axes) {
  const Coordinates coordinates(axes);
  std::vector<ExactHalfspace> planes = planes_of(complex, coordinates);
  ExactBox box = far_box(complex, coordinates, planes);
  const Rational scale = box.high[0];
  for (ExactHalfspace& plane : planes) plane.offset /= scale;
  for (RationalPoint* corner : {&box.low, &box.high}) {
    for (Rational& x : *corner) x /= scale;
  }
  data_ = std::make_unique<Data>(complex, coordinates, planes, box, scale);
}
FarOrder::~FarOrder() = default;

/// Both ends of a cell that goes on in two opposite directions alone have the least point of one of them. That end
/// is the one with a face of the frame that the point is beyond.
std::uint32_t FarOrder::place(HalfFace outside) const {
  const Complex& complex = data_->complex;
  const RationalPoint inside = data_->coordinates.of(interior_point(complex, outside.face()).rational());
  const Location at = data_->locator.locate(Rational(1 / data_->scale) * inside);
  require(at.dimension == 3, "FarOrder: a face of the frame lies in a plane");
  const std::optional<RationalPoint>& least = data_->least[at.region.index()];
  if (!least) return 0;
  const ExactHalfspace side = data_->coordinates.of(complex.points.exact_plane(complex.plane(outside.face())));
  const int beyond =
      sgn(Rational(data_->scale * dot(side.normal, *least) - side.offset)) * (outside.side() == 0 ? 1 : -1);
  return beyond > 0 ? at.region.value() : 0;
}

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

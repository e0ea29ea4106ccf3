// Incidence gives nodes, arcs and circles: an arc joins two uses that follow each other in a loop of a face, a
// walk turns at a node to the next dart of the radial order. Each connected part of the graph is a planar graph
// of its own whose circles bound disks.
//
// Which disks of different parts are one germ, incidence does not tell (a part may lie on either of two disks that
// belong to one region). So a path is drawn on the sphere from each part to the first one, over a way point that
// is in general position; between two crossings with arcs it stays in one germ, whose circles on either side of
// the path are joined. Parts and germs form a tree, as the sphere falls apart along every part; a path from a
// part to the first one passes every germ in between. Directions are integers, so all signs are exact.
#include "kernel/selection/neighbourhood.h"

#include <algorithm>
#include <optional>

#include "kernel/base/error.h"
#include "kernel/base/products.h"
#include "kernel/base/union_find.h"

namespace cnrg {
namespace {

using Index = Neighbourhood::Index;
using Vector = std::array<Integer, 3>;

int sign(const Integer& x) { return sgn(x); }
/// Sign of the determinant: positive if c is counter-clockwise from b as seen from the tip of a.
int turn(const Vector& a, const Vector& b, const Vector& c) { return sign(dot(a, cross(b, c))); }
Vector combine(const Integer& s, const Vector& a, const Integer& t, const Vector& b) {
  return {s * a[0] + t * b[0], s * a[1] + t * b[1], s * a[2] + t * b[2]};
}

/// From one point towards another, scaled by something positive.
Vector direction(const ExactPoint& from, const ExactPoint& to) {
  return {to.x * from.w - from.x * to.w, to.y * from.w - from.y * to.w, to.z * from.w - from.z * to.w};
}

/// The parts of a neighbourhood that is not connected, nested by paths on the sphere.
class Nesting {
 public:
  Nesting(const Complex& complex, const Neighbourhood& n, const std::vector<Index>& circle_of_side,
          const std::vector<Index>& circle_of_wire)
      : n_(n), circle_of_side_(circle_of_side), circle_of_wire_(circle_of_wire) {
    const ExactPoint& centre = complex.points.exact(n.vertex);
    for (const auto& node : n.nodes) {
      nodes_.push_back(direction(centre, complex.points.exact(complex.target(node.edge))));
    }
    for (const auto& arc : n.arcs) {
      const ExactPlane& plane = complex.points.exact_plane(complex.plane(arc.face));
      normals_.push_back({plane.a, plane.b, plane.c});
    }
  }

  /// Joins circles of one germ.
  void join(UnionFind& circles) const {
    std::vector<Start> starts(n_.parts);
    for (Index i = 0; i < n_.nodes.size(); ++i) {
      Start& start = starts[n_.nodes[i].part];
      if (start.node == Neighbourhood::kNone) start = {nodes_[i], i, Neighbourhood::kNone};
    }
    for (Index k = n_.arcs.size(); k-- > 0;) {
      starts[n_.arcs[k].part] = {middle(k), Neighbourhood::kNone, k};
    }
    for (Index part = 1; part < n_.parts; ++part) {
      for (std::uint32_t attempt = 0; !try_path(starts[part], starts[0], way_point(attempt), circles); ++attempt) {
        require(attempt < 100000, "neighbourhood: no path in general position");
      }
    }
  }

 private:
  /// A point on a part: a node without arcs, or inside of an arc.
  struct Start {
    Vector at;
    Index node = Neighbourhood::kNone, arc = Neighbourhood::kNone;
  };
  struct Crossing {
    Integer here, there;  // distances to the plane of the arc from both ends of the leg, one of them negative
    Index arc;
    unsigned side;  // on which the path arrives
  };

  static Vector way_point(std::uint32_t attempt) {
    std::uint32_t state = attempt * 2654435761u + 12345u;
    Vector w;
    for (Integer& x : w) {
      state = state * 1664525u + 1013904223u;
      x = static_cast<std::int32_t>(state >> 16) - 32768;
    }
    return w;
  }

  /// A direction inside of an arc.
  Vector middle(Index k) const {
    const auto& arc = n_.arcs[k];
    const Vector& normal = normals_[k];
    if (arc.full_circle()) {
      const Vector axis = sgn(normal[0]) != 0 ? Vector{0, 1, 0} : Vector{1, 0, 0};
      return cross(normal, axis);
    }
    const Vector &a = nodes_[arc.nodes[0]], &b = nodes_[arc.nodes[1]];
    const int bend = turn(normal, a, b);
    if (bend != 0) return combine(bend, a, bend, b);
    if (sign(dot(a, b)) < 0) return cross(normal, a);
    return {-a[0], -a[1], -a[2]};
  }

  /// True if x, in the plane of the arc and on no node, lies on the arc.
  bool on_arc(Index k, const Vector& x) const {
    const auto& arc = n_.arcs[k];
    if (arc.full_circle()) return true;
    const Vector &normal = normals_[k], &a = nodes_[arc.nodes[0]], &b = nodes_[arc.nodes[1]];
    const int bend = turn(normal, a, b);
    if (bend > 0) return turn(normal, a, x) > 0 && turn(normal, x, b) > 0;
    if (bend < 0) return !(turn(normal, b, x) > 0 && turn(normal, x, a) > 0);
    return sign(dot(a, b)) > 0 || turn(normal, a, x) > 0;
  }

  /// The arcs that the leg from a to b (less than half a great circle) crosses, in order; nothing if it is not in
  /// general position. Arcs whose plane holds a or b are met there, if at all.
  std::optional<std::vector<Crossing>> leg(const Start& from, const Vector& to, bool backwards) const {
    const Vector &a = from.at, &b = to;
    const Vector normal = cross(a, b);
    if (sign(dot(normal, normal)) == 0) return std::nullopt;
    for (Index i = 0; i < nodes_.size(); ++i) {
      if (i == from.node || sign(dot(normal, nodes_[i])) != 0) continue;
      if (turn(normal, a, nodes_[i]) >= 0 && turn(normal, nodes_[i], b) >= 0) return std::nullopt;
    }
    std::vector<Crossing> out;
    for (Index k = 0; k < n_.arcs.size(); ++k) {
      const Integer here = dot(normals_[k], a), there = dot(normals_[k], b);
      if (sign(there) == 0) return std::nullopt;
      if (sign(here) * sign(there) >= 0) continue;
      if (!on_arc(k, combine(abs(there), a, abs(here), b))) continue;
      const bool from_front = backwards ? sign(there) > 0 : sign(here) > 0;
      out.push_back({abs(here), abs(there), k, from_front ? 0u : 1u});
    }
    std::sort(out.begin(), out.end(), [](const Crossing& x, const Crossing& y) {
      return x.here * (y.here + y.there) < y.here * (x.here + x.there);
    });
    if (backwards) std::reverse(out.begin(), out.end());
    return out;
  }

  /// The circle on which a path leaves its start towards `to`.
  Index circle_at(const Start& start, const Vector& to) const {
    if (start.arc == Neighbourhood::kNone) return circle_of_wire_[start.node];
    return circle_of_side_[start.arc * 2 + (sign(dot(normals_[start.arc], to)) > 0 ? 0 : 1)];
  }

  bool try_path(const Start& from, const Start& to, const Vector& over, UnionFind& circles) const {
    const auto out = leg(from, over, false), back = leg(to, over, true);
    if (!out || !back) return false;
    Index circle = circle_at(from, over);
    for (const auto* crossings : {&*out, &*back}) {
      for (const Crossing& c : *crossings) {
        circles.unite(circle, circle_of_side_[c.arc * 2 + c.side]);
        circle = circle_of_side_[c.arc * 2 + 1 - c.side];
      }
    }
    circles.unite(circle, circle_at(to, over));
    return true;
  }

  const Neighbourhood& n_;
  const std::vector<Index>&circle_of_side_, &circle_of_wire_;
  std::vector<Vector> nodes_, normals_;
};

/// Fills a neighbourhood whose nodes, darts and arcs are linked: parts, circles, germs.
class Faces {
 public:
  Faces(const Complex& complex, Neighbourhood& n)
      : complex_(complex),
        n_(n),
        circle_of_side_(n.arcs.size() * 2, Neighbourhood::kNone),
        circle_of_wire_(n.nodes.size(), Neighbourhood::kNone) {}

  void run(const std::vector<std::array<Index, 2>>& darts_of_arc) {
    number_parts();
    walk_circles(darts_of_arc);
    UnionFind joined(n_.circles.size());
    if (n_.parts > 1) Nesting(complex_, n_, circle_of_side_, circle_of_wire_).join(joined);
    number_germs(joined);
  }

 private:
  void number_parts() {
    const auto nodes = static_cast<Index>(n_.nodes.size());
    UnionFind parts(nodes);
    for (const auto& arc : n_.arcs) {
      if (!arc.full_circle()) parts.unite(arc.nodes[0], arc.nodes[1]);
    }
    for (Index i = 0; i < nodes; ++i) {
      const Index root = parts.find(i);
      n_.nodes[i].part = root == i ? n_.parts++ : n_.nodes[root].part;
    }
    for (auto& arc : n_.arcs) arc.part = arc.full_circle() ? n_.parts++ : n_.nodes[arc.nodes[0]].part;
  }

  RegionId region(Index side) const { return complex_.face_regions[n_.arcs[side / 2].face][side & 1]; }

  void walk_circles(const std::vector<std::array<Index, 2>>& darts_of_arc) {
    for (Index start = 0; start < circle_of_side_.size(); ++start) {
      if (circle_of_side_[start] != Neighbourhood::kNone) continue;
      const auto number = static_cast<Index>(n_.circles.size());
      Neighbourhood::Circle circle;
      circle.first = static_cast<Index>(n_.sides.size());
      circle.part = n_.arcs[start / 2].part;
      for (Index side = start; circle_of_side_[side] == Neighbourhood::kNone;) {
        require(region(side) == region(start), "neighbourhood: a walk around a germ passes two regions");
        circle_of_side_[side] = number;
        n_.sides.push_back(side);
        if (n_.arcs[side / 2].full_circle()) break;
        // The front is walked from tail to head; at the node, turn clockwise to the next dart.
        const Index end = (side & 1) == 0 ? 1 : 0;
        const Index arrived = darts_of_arc[side / 2][end];
        const auto& node = n_.nodes[n_.arcs[side / 2].nodes[end]];
        const Index turned = arrived == node.first ? node.first + node.count - 1 : arrived - 1;
        n_.darts[turned].germ = number;  // the circle, until germs have numbers
        side = n_.darts[turned].arc * 2 + n_.darts[turned].end;
      }
      circle.count = static_cast<Index>(n_.sides.size()) - circle.first;
      n_.circles.push_back(circle);
    }
    for (Index i = 0; i < n_.nodes.size(); ++i) {
      if (n_.nodes[i].count != 0) continue;
      circle_of_wire_[i] = static_cast<Index>(n_.circles.size());
      n_.circles.push_back({0, static_cast<Index>(n_.sides.size()), 0, i, n_.nodes[i].part});
    }
  }

  void number_germs(UnionFind& joined) {
    if (n_.circles.empty()) n_.germs.push_back({complex_.some_region(n_.vertex), 0});
    for (Index i = 0; i < n_.circles.size(); ++i) {
      auto& circle = n_.circles[i];
      const RegionId r = circle.count == 0 ? complex_.edge_region[n_.nodes[circle.node].edge.edge()]
                                           : region(n_.sides[circle.first]);
      const Index root = joined.find(i);
      if (root == i) n_.germs.push_back({r, 0});
      circle.germ = root == i ? static_cast<Index>(n_.germs.size() - 1) : n_.circles[root].germ;
      require(n_.germs[circle.germ].region == r, "neighbourhood: circles of two regions bound one germ");
      ++n_.germs[circle.germ].circles;
    }
    for (auto& dart : n_.darts) dart.germ = n_.circles[dart.germ].germ;
    for (Index side = 0; side < circle_of_side_.size(); ++side) {
      n_.arcs[side / 2].germs[side & 1] = n_.circles[circle_of_side_[side]].germ;
    }
    for (Index i = 0; i < n_.nodes.size(); ++i) {
      if (n_.nodes[i].count == 0) n_.nodes[i].germ = n_.circles[circle_of_wire_[i]].germ;
    }
  }

  const Complex& complex_;
  Neighbourhood& n_;
  std::vector<Index> circle_of_side_, circle_of_wire_;
};

}  // namespace

std::int64_t Neighbourhood::euler() const {
  std::int64_t edges = 0;
  for (const Arc& arc : arcs) edges += !arc.full_circle();
  return static_cast<std::int64_t>(nodes.size()) - edges + static_cast<std::int64_t>(germs.size());
}

Neighbourhoods::Neighbourhoods(const Complex& complex)
    : complex_(complex), linked_(complex.face_count()), next_(complex.edge_uses.value_count()) {}

std::uint32_t Neighbourhoods::use_of(FaceId f, HalfEdge h) const {
  const auto uses = complex_.edge_uses[h.edge()];
  const auto at = std::find(uses.begin(), uses.end(), FaceUse{f, h});
  require(at != uses.end(), "neighbourhood: a loop passes an edge that does not know its face");
  return complex_.edge_uses.offsets()[h.edge().index()] + static_cast<std::uint32_t>(at - uses.begin());
}

void Neighbourhoods::link(FaceId f) {
  if (linked_[f]) return;
  linked_[f] = 1;
  for (LoopId l : complex_.face_loops[f]) {
    const auto loop = complex_.loop[l];
    const std::uint32_t first = use_of(f, loop.front());
    std::uint32_t last = first;
    for (HalfEdge h : loop.subspan(1)) {
      const std::uint32_t use = use_of(f, h);
      next_[Use(last)] = use;
      last = use;
    }
    next_[Use(last)] = first;
  }
}

Neighbourhood Neighbourhoods::at(VertexId v) {
  Neighbourhood out;
  at(v, out);
  return out;
}

void Neighbourhoods::at(VertexId v, Neighbourhood& out) {
  out.vertex = v;
  out.nodes.clear(), out.darts.clear(), out.arcs.clear();
  out.circles.clear(), out.sides.clear(), out.germs.clear();
  out.parts = 0;
  const auto& uses = complex_.edge_uses.values();
  for (EdgeId e : complex_.vertex_edges[v]) {
    const std::uint32_t begin = complex_.edge_uses.offsets()[e.index()];
    const std::uint32_t end = complex_.edge_uses.offsets()[e.index() + 1];
    const bool leaves = complex_.edge_ends[e][0] == v;  // then the radial order is that seen from outside
    Neighbourhood::Node node;
    node.edge = HalfEdge(e, leaves ? 0 : 1);
    node.first = static_cast<Index>(out.darts.size());
    node.count = end - begin;
    for (std::uint32_t i = 0; i < node.count; ++i) {
      Neighbourhood::Dart dart;
      dart.use = leaves ? begin + i : end - 1 - i;
      dart.sector = leaves ? dart.use : (dart.use == begin ? end - 1 : dart.use - 1);
      dart.end = complex_.target(uses[dart.use].half_edge) == v ? 1 : 0;
      out.darts.push_back(dart);
      link(uses[dart.use].face);
    }
    out.nodes.push_back(node);
  }
  const auto dart_of = [&](std::uint32_t use) -> std::pair<Index, Index> {
    const EdgeId e = uses[use].half_edge.edge();
    const auto node = std::lower_bound(out.nodes.begin(), out.nodes.end(), e,
                                       [](const auto& n, EdgeId id) { return n.edge.edge() < id; });
    const std::uint32_t begin = complex_.edge_uses.offsets()[e.index()];
    const std::uint32_t i = node->edge.direction() == 0 ? use - begin : node->count - 1 - (use - begin);
    return {static_cast<Index>(node - out.nodes.begin()), node->first + i};
  };
  std::vector<std::array<Index, 2>> darts_of_arc;
  for (Index d = 0; d < out.darts.size(); ++d) {
    if (out.darts[d].end != 1) continue;
    const std::uint32_t use = out.darts[d].use;
    const auto [head, arriving] = dart_of(use);
    const auto [tail, leaving] = dart_of(next_[Use(use)]);
    Neighbourhood::Arc arc;
    arc.face = uses[use].face;
    arc.nodes = {tail, head};
    arc.use = use;
    out.darts[arriving].arc = out.darts[leaving].arc = static_cast<Index>(out.arcs.size());
    out.arcs.push_back(arc);
    darts_of_arc.push_back({leaving, arriving});
  }
  for (FaceId f : complex_.vertex_faces[v]) {
    Neighbourhood::Arc arc;
    arc.face = f;
    out.arcs.push_back(arc);
  }
  Faces(complex_, out).run(darts_of_arc);
}

}  // namespace cnrg

// Null edges without the order of directions (mantyla1988, section 15.6.3). A null edge parts the half-edges from
// one corner to another; where both crossings are in one corner it is a strut, turned by the convexity of an edge
// of the other solid. Null edges that are there already are recognized by their length. A vertex in a face gets a
// ring there for each null edge.
#include "bench/baseline/separate.h"

namespace cnrg::bench::mantyla {
namespace {

template <class N>
class Separation {
 public:
  Separation(Scene<N>& scene, const Crossing<N>& crossing)
      : scene_(scene), topology_(scene.topology), crossing_(crossing) {}

  std::array<EdgeId, 2> separate(const RayPair& pair) {
    return crossing_.face == kNo<FaceId> ? of_two_vertices(pair) : of_vertex_in_face(pair);
  }

 private:
  /// The half-edge that ends the corner of a ray.
  HalfEdgeId corner(int solid, std::uint32_t ray) const {
    const std::vector<StarItem>& star = crossing_.stars[solid];
    std::size_t k = 0;
    while (star[k].half_edge != kNo<HalfEdgeId> || star[k].ray != ray) ++k;
    while (star[k].half_edge == kNo<HalfEdgeId>) k = (k + 1) % star.size();
    return star[k].half_edge;
  }

  std::array<EdgeId, 2> of_two_vertices(const RayPair& pair) {
    const HalfEdgeId a_in = corner(0, pair.forward), a_out = corner(0, pair.backward);
    const HalfEdgeId b_out = corner(1, pair.forward), b_in = corner(1, pair.backward);
    if (a_in == a_out) {
      const EdgeId strut = make_strut(a_in, is_turned(a_in, b_out, b_in));
      return {strut, part(b_out, b_in)};
    }
    if (b_in == b_out) {
      const EdgeId strut = make_strut(b_in, is_turned(b_in, a_out, a_in));
      return {part(a_out, a_in), strut};
    }
    const EdgeId edge_a = part(a_out, a_in);
    return {edge_a, part(b_out, b_in)};
  }

  std::array<EdgeId, 2> of_vertex_in_face(const RayPair& pair) {
    const int solid = crossing_.vertices[0] == kNo<VertexId> ? 1 : 0;
    const std::uint32_t to_out = solid == 0 ? pair.backward : pair.forward;
    const std::uint32_t to_in = solid == 0 ? pair.forward : pair.backward;
    std::array<EdgeId, 2> edges;
    edges[solid] = make(corner(solid, to_out), corner(solid, to_in));
    const HalfEdgeId lone = make_ring(scene_, crossing_.face, crossing_.point);
    edges[1 - solid] = make(lone, lone);
    return edges;
  }

  EdgeId make(HalfEdgeId from, HalfEdgeId to) {
    const EdgeId edge = topology_.mev(from, to);
    scene_.place(topology_.origin(topology_.edge(edge).first), crossing_.point);
    return edge;
  }

  bool is_null(HalfEdgeId h) const {
    return scene_.metric.equal(scene_.point(topology_.origin(h)), scene_.point(topology_.target(h)));
  }
  bool is_null_strut(HalfEdgeId h) const {
    const HalfEdgeId other = topology_.mate(h);
    return is_null(h) && (topology_.next(other) == h || topology_.prev(other) == h);
  }
  const Edge& edge_of(HalfEdgeId h) const { return topology_.edge(topology_.edge(h)); }

  /// The half-edges from one to before another one.
  EdgeId part(HalfEdgeId from, HalfEdgeId to) {
    const HalfEdgeId strut = topology_.prev(from), strut_to = topology_.prev(to);
    if (is_null_strut(strut) && edge_of(strut).second == strut) from = topology_.prev(strut);
    if (is_null_strut(strut_to) && edge_of(strut_to).first == strut_to) to = topology_.prev(strut_to);
    if (topology_.origin(from) != topology_.origin(to)) {
      const HalfEdgeId before = topology_.prev(from), before_to = topology_.prev(to);
      if (before == topology_.mate(before_to) || topology_.origin(before) == topology_.origin(to)) from = before;
      else if (topology_.origin(before_to) == topology_.origin(from)) to = before_to;
    }
    return make(from, to);
  }

  EdgeId make_strut(HalfEdgeId at, bool turned) {
    const HalfEdgeId before = topology_.prev(at);
    if (is_null(before) && (edge_of(before).first == before) == turned) at = before;
    const EdgeId edge = make(at, at);
    if (turned) topology_.flip(edge);
    return edge;
  }

  bool is_turned(HalfEdgeId at, HalfEdgeId from, HalfEdgeId to) const {
    const HalfEdgeId after_from = topology_.around(from), after_to = topology_.around(to);
    bool convex = is_convex(after_from != to && after_to == from ? to : from);
    if (is_narrow(after_from) && is_narrow(at)) convex = !convex;
    return !convex;
  }

  bool is_convex(HalfEdgeId h) const {
    const HalfEdgeId end = is_null(h) ? topology_.next(topology_.next(h)) : topology_.next(h);
    const Vec<N> line = cross(normal(h), normal(topology_.mate(h)));
    if (scene_.metric.null_unit(line)) return true;
    return dot(scene_.point(topology_.origin(end)) - scene_.point(topology_.origin(h)), line) > 0;
  }

  /// What the archive calls a wide sector, turned there when it was written: straight, or less than half a turn.
  bool is_narrow(HalfEdgeId h) const {
    const Vec<N>& at = scene_.point(topology_.origin(h));
    const auto towards = [&](HalfEdgeId other) {
      return Metric<N>::direction(scene_.point(topology_.origin(other)) - at);
    };
    const Vec<N> turn = cross(towards(topology_.prev(h)), towards(topology_.next(h)));
    return scene_.metric.null_unit(turn) || !(dot(turn, normal(h)) > 0);
  }

  const Vec<N>& normal(HalfEdgeId h) const { return scene_.plane(topology_.face(h)).normal; }

  Scene<N>& scene_;
  Topology& topology_;
  const Crossing<N>& crossing_;
};

}  // namespace

template <class N>
std::vector<std::array<EdgeId, 2>> separate(Scene<N>& scene, const Crossing<N>& crossing,
                                            const std::vector<RayPair>& pairs) {
  Separation<N> separation(scene, crossing);
  std::vector<std::array<EdgeId, 2>> edges;
  for (const RayPair& pair : pairs) edges.push_back(separation.separate(pair));
  return edges;
}

template std::vector<std::array<EdgeId, 2>> separate(Scene<double>&, const Crossing<double>&,
                                                     const std::vector<RayPair>&);
template std::vector<std::array<EdgeId, 2>> separate(Scene<Rational>&, const Crossing<Rational>&,
                                                     const std::vector<RayPair>&);

}  // namespace cnrg::bench::mantyla

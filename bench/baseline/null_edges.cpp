// Null edges (mantyla1988, sections 14.5.4 and 15.6.3): each vertex where the boundaries cross is split along
// pairs of rays, between an OUT part that gets the new edge's first half's start and an IN part. A part without
// edges makes a strut. A point inside of a face first becomes a ring of it.
//
// Rays are paired along A's arcs of the side that the result keeps, and their order inside of a corner is known,
// so that no null edge has to be looked for or turned afterwards. Without the departure `order`: separate.cpp.
#include <algorithm>
#include <set>

#include "bench/baseline/separate.h"

namespace cnrg::bench::mantyla {
namespace {

[[noreturn]] void fail_null_edges(const char* what) { throw Failure(Stage::null_edges, what); }

/// The parts of a neighbourhood, one by vertex, while it is split.
template <class N>
class Splitter {
 public:
  /// `lone`: the half-edge of a vertex without edges, or none.
  Splitter(Scene<N>& scene, const Vec<N>& point, std::vector<StarItem> star, HalfEdgeId lone)
      : scene_(scene), point_(point), parts_{{std::move(star), lone}} {}

  /// Splits between two rays: what lies clockwise from `start` to `end` is OUT at its ends.
  EdgeId split(std::uint32_t start, std::uint32_t end) {
    for (Part& part : parts_) {
      const std::size_t s = find(part, start), e = find(part, end);
      if (s == part.items.size() && e == part.items.size()) continue;
      if (s == part.items.size() || e == part.items.size()) break;
      Part out, in;
      collect(part.items, s, e, out.items);
      collect(part.items, e, s, in.items);
      const EdgeId edge = insert(part, out, in);
      part = std::move(out);
      parts_.push_back(std::move(in));
      return edge;
    }
    fail_null_edges("null edges cross each other in a neighbourhood");
  }

 private:
  struct Part {
    std::vector<StarItem> items;
    HalfEdgeId lone = kNo<HalfEdgeId>;
  };

  static std::size_t find(const Part& part, std::uint32_t ray) {
    std::size_t k = 0;
    while (k < part.items.size() && (part.items[k].half_edge != kNo<HalfEdgeId> || part.items[k].ray != ray)) ++k;
    return k;
  }

  /// What lies strictly between two places, clockwise.
  static void collect(const std::vector<StarItem>& items, std::size_t start, std::size_t end,
                      std::vector<StarItem>& between) {
    for (std::size_t k = (start + 1) % items.size(); k != end; k = (k + 1) % items.size())
      between.push_back(items[k]);
  }

  static HalfEdgeId first_of(const Part& part) {
    for (const StarItem& item : part.items)
      if (item.half_edge != kNo<HalfEdgeId>) return item.half_edge;
    return kNo<HalfEdgeId>;
  }

  EdgeId insert(const Part& whole, Part& out, Part& in) {
    Topology& topology = scene_.topology;
    HalfEdgeId head = first_of(out), tail = first_of(in);
    const bool in_has_none = tail == kNo<HalfEdgeId>;
    const bool turned = in_has_none && head != kNo<HalfEdgeId>;  // the new vertex gets the IN part
    if (head == kNo<HalfEdgeId>) head = tail;
    if (head == kNo<HalfEdgeId>) head = whole.lone;
    if (in_has_none) tail = head;
    const EdgeId edge = topology.mev(head, tail);
    scene_.place(topology.origin(topology.edge(edge).first), point_);
    if (turned) topology.flip(edge);
    out.items.insert(out.items.begin(), {topology.edge(edge).first, 0});
    in.items.insert(in.items.begin(), {topology.edge(edge).second, 0});
    return edge;
  }

  Scene<N>& scene_;
  Vec<N> point_;
  std::vector<Part> parts_;
};

/// Rays of a star, clockwise.
std::vector<std::uint32_t> rays_of(const std::vector<StarItem>& star) {
  std::vector<std::uint32_t> rays;
  for (const StarItem& item : star)
    if (item.half_edge == kNo<HalfEdgeId>) rays.push_back(item.ray);
  return rays;
}

template <class N>
std::vector<RayPair> pairs_along_arcs(const Scene<N>& scene, const Crossing<N>& crossing) {
  const std::vector<std::uint32_t> rays = rays_of(crossing.stars[0]);
  const bool along_out = scene.kept(0) == Side::out;
  std::vector<RayPair> pairs;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const std::uint32_t r = rays[k], t = rays[(k + 1) % rays.size()];
    // On A a backward ray is followed by OUT and a forward one by IN.
    if (crossing.rays[r].forward == along_out) continue;
    pairs.push_back(along_out ? RayPair{t, r} : RayPair{r, t});
  }
  return pairs;
}

/// Two by two: of two vertices in the order of their sectors, of one in a face along its OUT arcs. The last of an
/// odd number is left over.
template <class N>
std::vector<RayPair> pairs_as_found(const Crossing<N>& crossing) {
  std::vector<std::uint32_t> rays(crossing.rays.size());
  for (std::uint32_t r = 0; r < rays.size(); ++r) rays[r] = r;
  const auto is_forward = [&](std::uint32_t r) { return crossing.rays[r].forward; };
  if (crossing.face != kNo<FaceId>) {
    const bool of_b = crossing.vertices[0] == kNo<VertexId>;
    rays = rays_of(crossing.stars[of_b]);
    const auto to_out =
        std::find_if(rays.begin(), rays.end(), [&](std::uint32_t r) { return is_forward(r) == of_b; });
    std::rotate(rays.begin(), to_out, rays.end());
  }
  std::vector<RayPair> pairs;
  for (std::size_t k = 0; k + 1 < rays.size(); k += 2) {
    if (is_forward(rays[k]) == is_forward(rays[k + 1]))
      fail_null_edges("a null edge between two ends of one kind");
    pairs.push_back(is_forward(rays[k]) ? RayPair{rays[k], rays[k + 1]} : RayPair{rays[k + 1], rays[k]});
  }
  return pairs;
}

/// By the order of directions.
template <class N>
std::vector<std::array<EdgeId, 2>> split(Scene<N>& scene, const Crossing<N>& crossing,
                                         const std::vector<RayPair>& pairs) {
  std::array<HalfEdgeId, 2> lone = {kNo<HalfEdgeId>, kNo<HalfEdgeId>};
  for (int solid = 0; solid < 2; ++solid)
    if (crossing.vertices[solid] == kNo<VertexId>) lone[solid] = make_ring(scene, crossing.face, crossing.point);
  Splitter<N> a(scene, crossing.point, crossing.stars[0], lone[0]);
  Splitter<N> b(scene, crossing.point, crossing.stars[1], lone[1]);
  std::vector<std::array<EdgeId, 2>> edges;
  for (const auto& [forward, backward] : pairs) {
    const EdgeId edge_a = a.split(backward, forward);
    edges.push_back({edge_a, b.split(forward, backward)});
  }
  return edges;
}

template <class N>
void insert(Scene<N>& scene, const Crossing<N>& crossing) {
  const std::vector<RayPair> pairs =
      scene.departures.pairs ? pairs_along_arcs(scene, crossing) : pairs_as_found(crossing);
  const auto edges = scene.departures.order ? split(scene, crossing, pairs) : separate(scene, crossing, pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    scene.null_pairs.push_back({edges[k], crossing.point, crossing.rays[pairs[k].forward].direction,
                                crossing.rays[pairs[k].backward].direction});
}

}  // namespace

template <class N>
HalfEdgeId make_ring(Scene<N>& scene, FaceId face, const Vec<N>& p) {
  Topology& topology = scene.topology;
  const HalfEdgeId at = topology.loop(topology.face(face).loops.front()).start;
  const EdgeId strut = topology.mev(at, at);
  scene.place(topology.origin(topology.edge(strut).first), p);
  return topology.loop(topology.kemr(topology.edge(strut).second)).start;
}

template <class N>
void insert_null_edges(Scene<N>& scene) {
  std::set<VertexId> taken;
  const auto insert_at = [&](const Crossing<N>& crossing) {
    for (const VertexId v : crossing.vertices)
      if (v != kNo<VertexId>)
        check(scene.departures, taken.insert(v).second, Stage::null_edges,
              "a vertex crosses the other boundary, which touches itself there, in more than one place");
    insert(scene, crossing);
  };
  for (const Crossing<N>& crossing : scene.crossings)
    staged(
        Stage::null_edges, [&] { insert_at(crossing); }, [&] { return Failure::Places{exact(crossing.point)}; });
}

template HalfEdgeId make_ring(Scene<double>&, FaceId, const Vec<double>&);
template HalfEdgeId make_ring(Scene<Rational>&, FaceId, const Vec<Rational>&);
template void insert_null_edges(Scene<double>&);
template void insert_null_edges(Scene<Rational>&);

}  // namespace cnrg::bench::mantyla

// Connecting (mantyla1988, section 15.7). Ends of null edges in the same two faces are joined into the pieces of
// the intersection curve: each piece becomes a strip without width in a face of A and in one of B, and where two
// strips meet the null edge between them is cut, until each closed curve is one null face with two loops, OUT and
// IN.
//
// An end is joined with the nearest end ahead of it on the line of its faces, found before anything is joined.
// Without the departure `nearest` it is joined with the first of the ends seen so far in the sorted order, which
// may be behind it where three or more null edges are on one line. Rings go to the part of a face that a join
// needs them in, and all others at the end, by their places; without the departure `rings`, when a face is split.
#include <algorithm>
#include <map>
#include <utility>

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

[[noreturn]] void fail_connecting(const char* what) { throw Failure(Stage::connecting, what); }

template <class N>
class Connection {
 public:
  explicit Connection(Scene<N>& scene) : scene_(scene), topology_(scene.topology) {}

  void run() {
    sort_null_edges();
    joined_.resize(scene_.null_pairs.size());
    if (scene_.departures.nearest) join_nearest();
    else join_in_order();
    if (scene_.departures.rings) settle_rings();
  }

 private:
  /// An end of a null pair.
  struct End {
    std::uint32_t pair;
    bool forward;
  };

  void join_nearest() {
    find_joints();
    for (Joint& joint : scene_.joints) join(joint);
    for (int solid = 0; solid < 2; ++solid)
      for (std::uint32_t k = 0; k < joined_.size(); ++k)
        if (joined_[k] == 2) cut(k, solid);
  }

  void join_in_order() {
    std::vector<End> loose;
    for (std::uint32_t k = 0; k < joined_.size(); ++k)
      for (const bool forward : {true, false}) {
        const End end{k, forward};
        const auto found = std::find_if(loose.begin(), loose.end(), [&](const End& e) { return fit(e, end); });
        if (found == loose.end()) {
          loose.push_back(end);
          continue;
        }
        const std::uint32_t other = found->pair;
        loose.erase(found);
        scene_.joints.push_back({forward ? k : other, forward ? other : k, {}, {}});
        join(scene_.joints.back());
        for (int solid = 0; solid < 2; ++solid) {
          if (joined_[other] == 2) cut(other, solid);
          if (joined_[k] == 2 && k != other) cut(k, solid);
        }
      }
    std::vector<std::uint32_t> ahead;
    for (const End& end : loose)
      if (end.forward) ahead.push_back(end.pair);
    check_loose(ahead);
  }

  /// Ends of both kinds in the same face of A and of B.
  bool fit(const End& e, const End& end) const {
    if (e.forward == end.forward) return false;
    for (int solid = 0; solid < 2; ++solid)
      if (!can_meet(half(e.pair, solid, e.forward), half(end.pair, solid, end.forward))) return false;
    return true;
  }

  /// In one face, or in parts of one with a ring that follows.
  bool can_meet(HalfEdgeId h, HalfEdgeId g) const {
    if (topology_.face(h) == topology_.face(g)) return true;
    return scene_.departures.rings &&
           topology_.face(topology_.face(h)).surface == topology_.face(topology_.face(g)).surface &&
           (!topology_.is_outer(topology_.loop(h)) || !topology_.is_outer(topology_.loop(g)));
  }

  Failure::Places places(const std::vector<std::uint32_t>& pairs) const {
    Failure::Places places;
    for (const std::uint32_t k : pairs) places.push_back(exact(scene_.null_pairs.at(k).point));
    return places;
  }

  void check_loose(const std::vector<std::uint32_t>& loose) const {
    if (!loose.empty() && scene_.departures.checks)
      throw Failure(
          Stage::connecting,
          std::to_string(loose.size()) + " of " + std::to_string(joined_.size()) + " null edges stay loose ahead",
          places(loose));
  }

  void join(Joint& joint) {
    staged(
        Stage::connecting,
        [&] {
          join(half(joint.from, 0, true), half(joint.to, 0, false), joint, 0);
          join(half(joint.to, 1, false), half(joint.from, 1, true), joint, 1);
        },
        [&] {
          return places({joint.from, joint.to});
        });
    ++joined_[joint.from];
    ++joined_[joint.to];
  }

  /// The half of a pair's null edge at its forward or backward end.
  HalfEdgeId half(std::uint32_t pair, int solid, bool forward) const {
    const Edge& edge = topology_.edge(scene_.null_pairs.at(pair).edges[solid]);
    return forward == (solid == 0) ? edge.first : edge.second;
  }

  void sort_null_edges() {
    std::stable_sort(scene_.null_pairs.begin(), scene_.null_pairs.end(),
                     [](const NullPair<N>& p, const NullPair<N>& q) { return p.point < q.point; });
  }

  /// The backward ends are grouped by their faces. Faces whose planes are parallel may have many lines in common.
  void find_joints() {
    const auto faces = [&](std::uint32_t pair, bool forward) {
      return std::pair(topology_.face(half(pair, 0, forward)), topology_.face(half(pair, 1, forward)));
    };
    std::map<std::pair<FaceId, FaceId>, std::vector<std::uint32_t>> ends;
    const auto count = static_cast<std::uint32_t>(scene_.null_pairs.size());
    for (std::uint32_t k = 0; k < count; ++k) ends[faces(k, false)].push_back(k);
    std::vector<std::uint32_t> loose;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto key = faces(k, true);
      const auto group = ends.find(key);
      const std::uint32_t to = group == ends.end() ? count : nearest(k, key, group->second);
      if (to == count) {
        loose.push_back(k);
        continue;
      }
      group->second.erase(std::find(group->second.begin(), group->second.end(), to));
      scene_.joints.push_back({k, to, {}, {}});
    }
    check_loose(loose);
  }

  std::uint32_t nearest(std::uint32_t from, const std::pair<FaceId, FaceId>& faces,
                        const std::vector<std::uint32_t>& candidates) const {
    const Metric<N>& metric = scene_.metric;
    const NullPair<N>& start = scene_.null_pairs[from];
    const bool parallel =
        metric.null_unit(cross(scene_.plane(faces.first).normal, scene_.plane(faces.second).normal));
    auto best = static_cast<std::uint32_t>(scene_.null_pairs.size());
    N best_distance = 0;
    for (const std::uint32_t to : candidates) {
      const NullPair<N>& end = scene_.null_pairs[to];
      const Vec<N> way = end.point - start.point;
      const N distance = dot(way, start.forward);
      if (!(distance > 0) || !(dot(end.backward, start.forward) < 0)) continue;
      if (parallel && !metric.null_length(cross(way, start.forward))) continue;
      if (best == scene_.null_pairs.size() || distance < best_distance) {
        best = to;
        best_distance = distance;
      }
    }
    return best;
  }

  /// Both half-edges into one face: a ring that is elsewhere in what was their face follows.
  void bring_together(HalfEdgeId h, HalfEdgeId g) {
    const FaceId f = topology_.face(h), e = topology_.face(g);
    if (f == e) return;
    if (topology_.face(f).surface != topology_.face(e).surface) fail_connecting("null edges in different faces");
    if (!topology_.is_outer(topology_.loop(h))) topology_.ringmv(topology_.loop(h), e);
    else if (!topology_.is_outer(topology_.loop(g))) topology_.ringmv(topology_.loop(g), f);
    else fail_connecting("null edges that the intersection curve separated");
  }

  /// The strip between `head`, OUT to IN, and `tail`, IN to OUT. An edge that is there already is its side.
  void join(HalfEdgeId head, HalfEdgeId tail, Joint& joint, int solid) {
    if (scene_.departures.rings) bring_together(head, tail);
    bool parted = false;
    LoopId old_loop = topology_.loop(head);
    if (old_loop != topology_.loop(tail)) {
      topology_.mekr(head, topology_.next(tail));
    } else if (topology_.next(topology_.next(tail)) != head) {
      topology_.mef(head, topology_.next(tail));
      parted = true;
    }
    const bool has_in = topology_.next(topology_.next(head)) == tail;
    if (!has_in) topology_.mef(tail, topology_.next(head));
    joint.in[solid] = topology_.next(head);
    joint.out[solid] = topology_.prev(head);
    check(scene_.departures, topology_.next(joint.in[solid]) == tail && topology_.prev(joint.out[solid]) == tail,
          Stage::connecting, "a strip that does not close");
    check(scene_.departures, topology_.face(topology_.face(head)).loops.size() == 1, Stage::connecting,
          "a strip with rings");
    null_faces_.push_back(topology_.face(head));
    if (!parted || has_in) return;
    const LoopId new_loop = topology_.loop(topology_.mate(joint.in[solid]));
    if (!scene_.departures.rings) give_rings(topology_.loop(old_loop).face, topology_.loop(new_loop).face);
    else if (!topology_.is_outer(old_loop)) turn_ring(new_loop, old_loop);
  }

  /// Rings whose first vertex is outside of the face that has them, to its other part.
  void give_rings(FaceId from, FaceId to) {
    const LoopId outer = topology_.face(from).loops.front();
    const std::vector<Segment<N>> segments = segments_of_loop(outer);
    const std::vector<LoopId> loops = topology_.face(from).loops;
    for (std::size_t k = 1; k < loops.size(); ++k) {
      const Vec<N>& p = scene_.point(topology_.origin(topology_.loop(loops[k]).start));
      if (locate(scene_.metric, scene_.plane(from).normal, segments, p).where == Where::outside)
        topology_.ringmv(loops[k], to);
    }
  }

  /// A ring that was parted is a hole and an island, which is counter-clockwise and a face of its own.
  void turn_ring(LoopId new_loop, LoopId old_loop) {
    const FaceId around = topology_.loop(old_loop).face;
    if (!(signed_area(scene_, scene_.plane(around).normal, new_loop) < 0)) return;
    topology_.kfmrh(around, topology_.loop(new_loop).face);
    topology_.mfkrh(old_loop);
  }

  void cut(std::uint32_t pair, int solid) {
    staged(
        Stage::connecting, [&] { cut_edge(pair, solid); }, [&] { return places({pair}); });
  }

  void cut_edge(std::uint32_t pair, int solid) {
    const Edge edge = topology_.edge(scene_.null_pairs[pair].edges[solid]);
    if (topology_.loop(edge.first) != topology_.loop(edge.second)) {
      topology_.kef(edge.first);
      return;
    }
    scene_.null_faces[solid].push_back({topology_.next(edge.first), topology_.next(edge.second)});
    topology_.kemr(edge.first);
  }

  /// Rings of faces that were split, each into the smallest part that it lies in.
  void settle_rings() {
    std::map<std::uint32_t, std::vector<FaceId>> parts;
    std::vector<bool> null_face(topology_.face_ids(), false);
    for (const FaceId f : null_faces_) null_face[static_cast<std::size_t>(f)] = true;
    for (std::size_t f = 0; f < topology_.face_ids(); ++f) {
      const auto id = static_cast<FaceId>(f);
      if (topology_.alive(id) && !null_face[f]) parts[topology_.face(id).surface].push_back(id);
    }
    for (const auto& [surface, faces] : parts) {
      if (faces.size() == 1) continue;
      for (const FaceId face : faces) {
        const std::vector<LoopId> loops = topology_.face(face).loops;
        for (std::size_t k = 1; k < loops.size(); ++k)
          staged(
              Stage::connecting, [&] { settle(loops[k], faces, scene_.surfaces[surface].normal); },
              [&] { return places_of(scene_, topology_.loop(loops[k]).start); });
      }
    }
  }

  void settle(LoopId ring, const std::vector<FaceId>& faces, const Vec<N>& normal) {
    FaceId best = kNo<FaceId>;
    N best_area = 0;
    for (const FaceId face : faces) {
      const LoopId outer = topology_.face(face).loops.front();
      if (!inside(ring, outer, normal)) continue;
      const N area = signed_area(scene_, normal, outer);
      if (best != kNo<FaceId> && !(area < best_area)) continue;
      best = face;
      best_area = area;
    }
    check(scene_.departures, best != kNo<FaceId>, Stage::connecting, "a ring in no part of its face");
    if (best != kNo<FaceId> && best != topology_.loop(ring).face) topology_.ringmv(ring, best);
  }

  std::vector<Segment<N>> segments_of_loop(LoopId loop) const {
    std::vector<Segment<N>> segments;
    for (const HalfEdgeId h : topology_.cycle(loop))
      segments.push_back({&scene_.point(topology_.origin(h)), &scene_.point(topology_.target(h))});
    return segments;
  }

  /// By the first vertex or middle of an edge of the ring that is not on the outer loop.
  bool inside(LoopId ring, LoopId outer, const Vec<N>& normal) const {
    const std::vector<Segment<N>> segments = segments_of_loop(outer);
    const std::vector<HalfEdgeId> all = topology_.cycle(ring);
    for (const bool middle : {false, true})
      for (const HalfEdgeId h : all) {
        Vec<N> p = scene_.point(topology_.origin(h));
        if (middle) p = (p + scene_.point(topology_.target(h))) * N(N(1) / N(2));
        const Where where = locate(scene_.metric, normal, segments, p).where;
        if (where == Where::inside || where == Where::outside) return where == Where::inside;
      }
    return false;
  }

  Scene<N>& scene_;
  Topology& topology_;
  std::vector<int> joined_;  ///< ends, by null pair
  std::vector<FaceId> null_faces_;
};

}  // namespace

template <class N>
N signed_area(const Scene<N>& scene, const Vec<N>& normal, LoopId loop) {
  std::vector<Vec<N>> polygon;
  for (const HalfEdgeId h : scene.topology.cycle(loop)) polygon.push_back(scene.point(scene.topology.origin(h)));
  return dot(polygon_normal(polygon), normal);
}

template <class N>
void connect(Scene<N>& scene) {
  Connection<N>(scene).run();
}

template double signed_area(const Scene<double>&, const Vec<double>&, LoopId);
template Rational signed_area(const Scene<Rational>&, const Vec<Rational>&, LoopId);
template void connect(Scene<double>&);
template void connect(Scene<Rational>&);

}  // namespace cnrg::bench::mantyla

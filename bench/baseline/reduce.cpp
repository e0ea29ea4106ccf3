// Reduction (mantyla1988, section 15.5): edges of each solid against faces of the other. Afterwards the boundaries
// meet in vertices only, up to coplanar faces: a vertex of one lies at a vertex or inside of a face of the other,
// and the lists name all such pairs.
#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "bench/baseline/scene.h"

namespace cnrg::bench::mantyla {
namespace {

struct Box {
  std::array<double, 3> low, high;
  bool apart(const Box& other) const {
    for (int k = 0; k < 3; ++k)
      if (low[k] > other.high[k] || other.low[k] > high[k]) return true;
    return false;
  }
};

template <class N>
class Reduction {
 public:
  explicit Reduction(Scene<N>& scene)
      : scene_(scene),
        topology_(scene.topology),
        margin_(scene.extent * 1e-12 + 2 * approximate(scene.metric.length)) {
    for (std::size_t f = 0; f < topology_.face_ids(); ++f) {
      const auto id = static_cast<FaceId>(f);
      Box box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
      for (const LoopId loop : topology_.face(id).loops)
        for (const HalfEdgeId h : topology_.cycle(loop)) grow(box, topology_.origin(h));
      boxes_.push_back(box);
      faces_[topology_.face(id).solid].push_back(id);
    }
  }

  void run() {
    for (int solid = 0; solid < 2; ++solid) {
      std::vector<std::pair<EdgeId, std::size_t>> work;  // with the first face to look at
      for (std::size_t e = 0; e < topology_.edge_ids(); ++e) {
        const auto id = static_cast<EdgeId>(e);
        if (topology_.face(topology_.face(topology_.edge(id).first)).solid == static_cast<std::uint32_t>(solid))
          work.push_back({id, 0});
      }
      const auto& faces = faces_[1 - solid];
      while (!work.empty()) {
        const auto [edge, first] = work.back();
        work.pop_back();
        Box box = edge_box(edge);
        for (std::size_t k = first; k < faces.size(); ++k) {
          if (box.apart(boxes_[static_cast<std::size_t>(faces[k])])) continue;
          const EdgeId rest = edge_against_face(edge, faces[k], solid);
          if (rest == kNo<EdgeId>) continue;
          work.push_back({rest, k + 1});
          box = edge_box(edge);
        }
      }
    }
    for (const auto& [solid, vertex, face] : vertex_faces_) scene_.vertex_faces.push_back({solid, vertex, face});
    for (const auto& [a, b] : vertex_vertices_) scene_.vertex_vertices.push_back({a, b});
  }

 private:
  void grow(Box& box, VertexId v) const {
    for (int k = 0; k < 3; ++k) {
      const double x = approximate(scene_.point(v)[k]);
      box.low[k] = std::min(box.low[k], x - margin_);
      box.high[k] = std::max(box.high[k], x + margin_);
    }
  }

  Box edge_box(EdgeId edge) const {
    Box box{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
    grow(box, topology_.origin(topology_.edge(edge).first));
    grow(box, topology_.origin(topology_.edge(edge).second));
    return box;
  }

  /// Splits the edge at p. Its first half keeps the new vertex as start; gives the vertex and the edge of the
  /// rest.
  std::pair<VertexId, EdgeId> split(EdgeId edge, const Vec<N>& p) {
    const HalfEdgeId half = topology_.edge(edge).first;
    const EdgeId rest = topology_.mev(half, topology_.around(half));
    const VertexId vertex = topology_.origin(half);
    scene_.place(vertex, p);
    return {vertex, rest};
  }

  PlaneLocation locate_in(FaceId face, const Vec<N>& p, std::vector<HalfEdgeId>& half_edges) const {
    std::vector<Segment<N>> segments;
    for (const LoopId loop : topology_.face(face).loops)
      for (const HalfEdgeId h : topology_.cycle(loop)) {
        half_edges.push_back(h);
        segments.push_back({&scene_.point(topology_.origin(h)), &scene_.point(topology_.target(h))});
      }
    return locate(scene_.metric, scene_.plane(face).normal, segments, p);
  }

  /// Records a vertex in the plane of a face; splits an edge of the face that it lies on.
  void vertex_against_face(VertexId vertex, FaceId face, int solid) {
    std::vector<HalfEdgeId> half_edges;
    const PlaneLocation at = locate_in(face, scene_.point(vertex), half_edges);
    if (at.where != Where::outside) record(vertex, face, at, half_edges, solid);
  }

  void record(VertexId vertex, FaceId face, const PlaneLocation& at, const std::vector<HalfEdgeId>& half_edges,
              int solid) {
    if (at.where == Where::inside) {
      vertex_faces_.insert({static_cast<std::uint32_t>(solid), vertex, face});
      return;
    }
    const HalfEdgeId h = half_edges[at.segment];
    const VertexId other = at.where == Where::on_vertex
                               ? topology_.origin(h)
                               : split(topology_.edge(h), Vec<N>(scene_.point(vertex))).first;
    vertex_vertices_.insert(solid == 0 ? std::pair(vertex, other) : std::pair(other, vertex));
  }

  /// Gives the edge of the rest when the face splits the edge, otherwise none.
  EdgeId edge_against_face(EdgeId edge, FaceId face, int solid) {
    const VertexId v = topology_.origin(topology_.edge(edge).first);
    const VertexId w = topology_.origin(topology_.edge(edge).second);
    const Plane<N>& plane = scene_.plane(face);
    const N dv = scene_.metric.distance(plane, scene_.point(v)),
            dw = scene_.metric.distance(plane, scene_.point(w));
    const int sv = scene_.metric.length_sign(dv), sw = scene_.metric.length_sign(dw);
    if (sv * sw < 0) {
      const Vec<N> p = scene_.point(v) + (scene_.point(w) - scene_.point(v)) * N(dv / (dv - dw));
      std::vector<HalfEdgeId> half_edges;
      const PlaneLocation at = locate_in(face, p, half_edges);
      if (at.where == Where::outside) return kNo<EdgeId>;
      const auto [vertex, rest] = split(edge, p);
      record(vertex, face, at, half_edges, solid);
      return rest;
    }
    if (sv == 0) vertex_against_face(v, face, solid);
    if (sw == 0) vertex_against_face(w, face, solid);
    return kNo<EdgeId>;
  }

  Scene<N>& scene_;
  Topology& topology_;
  double margin_;
  std::vector<Box> boxes_;
  std::array<std::vector<FaceId>, 2> faces_;
  std::set<std::tuple<std::uint32_t, VertexId, FaceId>> vertex_faces_;
  std::set<std::pair<VertexId, VertexId>> vertex_vertices_;
};

}  // namespace

template <class N>
void reduce(Scene<N>& scene) {
  Reduction<N>(scene).run();
}

template void reduce(Scene<double>&);
template void reduce(Scene<Rational>&);

}  // namespace cnrg::bench::mantyla

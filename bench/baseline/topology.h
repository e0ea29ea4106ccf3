// Half-edge boundary models and their Euler operators (mantyla1988, chapters 9 to 11), without coordinates.
//
// Notation. A half-edge starts at its vertex and has its face on its left, seen from outside: outer loops run
// counter-clockwise, rings clockwise (the book runs all of it the other way). `around(h)` is the next half-edge of
// the same vertex, clockwise; it lies across the edge of h. A vertex without edges has one half-edge, which has no
// edge and is its own next. A face has an outer loop and rings; its shell is what can be reached over edges and
// between loops of a face. With s shells, r rings and g handles, v - e + f - r = 2 (s - g).
//
// An operator checks what it needs before it changes anything and throws TopologyError when that is missing, so a
// structure made by operators is valid at any time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace cnrg::bench::mantyla {

enum class VertexId : std::uint32_t {};
enum class EdgeId : std::uint32_t {};
enum class HalfEdgeId : std::uint32_t {};
enum class LoopId : std::uint32_t {};
enum class FaceId : std::uint32_t {};
/// No vertex, no edge, ...
template <class Id>
inline constexpr Id kNo = static_cast<Id>(0xffffffffu);

class TopologyError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};
inline void require(bool holds, const char* what) {
  if (!holds) throw TopologyError(what);
}

/// An array by ids. A wrong id throws: a broken state must not become a crash.
template <class Id, class T>
class Table {
 public:
  T& operator[](Id id) { return items_[checked(id)]; }
  const T& operator[](Id id) const { return items_[checked(id)]; }
  std::size_t size() const { return items_.size(); }
  Id add(T item) {
    items_.push_back(std::move(item));
    return static_cast<Id>(items_.size() - 1);
  }

 private:
  std::size_t checked(Id id) const {
    if (static_cast<std::size_t>(id) >= items_.size()) throw TopologyError("an id of nothing");
    return static_cast<std::size_t>(id);
  }
  std::vector<T> items_;
};

struct Vertex {
  HalfEdgeId out = kNo<HalfEdgeId>;  ///< one that starts here; none: killed
};
struct Edge {
  /// The book's positive and negative half. Killed: none.
  HalfEdgeId first = kNo<HalfEdgeId>, second = kNo<HalfEdgeId>;
};
struct HalfEdge {
  VertexId vertex = kNo<VertexId>;
  EdgeId edge = kNo<EdgeId>;  ///< none: the half-edge of a vertex without edges
  LoopId loop = kNo<LoopId>;  ///< none: killed
  HalfEdgeId next = kNo<HalfEdgeId>, prev = kNo<HalfEdgeId>;
};
struct Loop {
  FaceId face = kNo<FaceId>;  ///< none: killed
  HalfEdgeId start = kNo<HalfEdgeId>;
};
struct Face {
  std::vector<LoopId> loops;  ///< the outer one first; empty: killed
  std::uint32_t surface = 0;  ///< the caller's; parts of a face inherit it
  std::uint32_t solid = 0;    ///< likewise
};

/// Terms of the Euler-Poincare formula.
struct EulerCounts {
  std::size_t vertices = 0, edges = 0, faces = 0, rings = 0, shells = 0;
  long genus = 0;  ///< handles of all shells together
};

class Topology {
 public:
  struct Seed {
    VertexId vertex;
    FaceId face;
    HalfEdgeId half_edge;
  };

  /// Make a vertex and a face: a new shell of nothing else. `kvfs` undoes it.
  Seed mvfs(std::uint32_t surface, std::uint32_t solid);
  void kvfs(FaceId face);

  /// Make an edge and a vertex: splits the vertex of both. Half-edges from `from` on, clockwise and before `to`,
  /// go to the new vertex; `from == to` makes a strut in the corner before it. The new edge's first half starts at
  /// the new vertex and lies before `to`, its second half lies before `from`.
  EdgeId mev(HalfEdgeId from, HalfEdgeId to);
  /// Kills the edge of `half_edge` and its vertex, whose other half-edges go to the other end.
  void kev(HalfEdgeId half_edge);

  /// Make an edge and a face: an edge between the vertices of two half-edges of one loop. The new face's loop
  /// holds `from` up to before `to`, and the new edge's first half; with `from == to` nothing but that.
  EdgeId mef(HalfEdgeId from, HalfEdgeId to);
  /// Kills the edge of `half_edge` and its face, which has one loop and differs from the face of the other half.
  void kef(HalfEdgeId half_edge);

  /// Kill an edge, make a ring: both halves are in one loop. What lies behind the end of `half_edge` becomes the
  /// ring, which is returned.
  LoopId kemr(HalfEdgeId half_edge);
  /// Make an edge, kill a ring: joins two loops of a face by an edge whose first half runs from the vertex of
  /// `from` to that of `to`, before both. An outer loop stays outer.
  EdgeId mekr(HalfEdgeId from, HalfEdgeId to);

  /// Kill a face, make a ring and a hole: the only loop of `killed` becomes a ring of `kept`.
  void kfmrh(FaceId kept, FaceId killed);
  /// Make a face of a ring.
  FaceId mfkrh(LoopId ring);
  /// Moves a ring to another face, as a ring.
  void ringmv(LoopId ring, FaceId face);

  /// Adds closed oriented surfaces of polygons: loops of corners below `corners` by face, the outer one first. A
  /// face gets the surface `first_surface` + its place. Gives the vertices by corner (none for a corner of no
  /// polygon). Throws TopologyError where the polygons are no closed 2-manifold.
  std::vector<VertexId> assemble(const std::vector<std::vector<std::vector<std::uint32_t>>>& faces,
                                 std::size_t corners, std::uint32_t first_surface, std::uint32_t solid);
  /// Turns the faces of a solid inside out.
  void revert(std::uint32_t solid);
  /// Exchanges the halves of an edge.
  void flip(EdgeId edge);

  HalfEdgeId mate(HalfEdgeId half_edge) const;
  HalfEdgeId next(HalfEdgeId half_edge) const { return half_edges_[half_edge].next; }
  HalfEdgeId prev(HalfEdgeId half_edge) const { return half_edges_[half_edge].prev; }
  HalfEdgeId around(HalfEdgeId half_edge) const { return next(mate(half_edge)); }
  VertexId origin(HalfEdgeId half_edge) const { return half_edges_[half_edge].vertex; }
  VertexId target(HalfEdgeId half_edge) const { return origin(next(half_edge)); }
  LoopId loop(HalfEdgeId half_edge) const { return half_edges_[half_edge].loop; }
  FaceId face(HalfEdgeId half_edge) const { return loops_[loop(half_edge)].face; }
  EdgeId edge(HalfEdgeId half_edge) const { return half_edges_[half_edge].edge; }
  bool lone(HalfEdgeId half_edge) const { return edge(half_edge) == kNo<EdgeId>; }
  /// All half-edges of a vertex, clockwise; of a loop, in its direction.
  std::vector<HalfEdgeId> star(VertexId vertex) const;
  std::vector<HalfEdgeId> cycle(LoopId loop) const;
  bool is_outer(LoopId loop) const { return face(loop).loops.front() == loop; }

  const Vertex& vertex(VertexId id) const { return vertices_[id]; }
  const Edge& edge(EdgeId id) const { return edges_[id]; }
  const Loop& loop(LoopId id) const { return loops_[id]; }
  const Face& face(FaceId id) const { return faces_[id]; }
  const Face& face(LoopId id) const { return faces_[loops_[id].face]; }
  /// Ids run from 0 to below these; some may be killed.
  std::size_t vertex_ids() const { return vertices_.size(); }
  std::size_t edge_ids() const { return edges_.size(); }
  std::size_t half_edge_ids() const { return half_edges_.size(); }
  std::size_t loop_ids() const { return loops_.size(); }
  std::size_t face_ids() const { return faces_.size(); }
  bool alive(VertexId id) const { return vertices_[id].out != kNo<HalfEdgeId>; }
  bool alive(EdgeId id) const { return edges_[id].first != kNo<HalfEdgeId>; }
  bool alive(HalfEdgeId id) const { return half_edges_[id].loop != kNo<LoopId>; }
  bool alive(LoopId id) const { return loops_[id].face != kNo<FaceId>; }
  bool alive(FaceId id) const { return !faces_[id].loops.empty(); }

  /// The shell of each face, counted from 0 in the order of their first faces; killed ones: 0xffffffff.
  std::vector<std::uint32_t> shells() const;
  /// Checks all links and the Euler-Poincare formula of each shell, genus whole and not negative. Throws
  /// TopologyError with what is wrong.
  EulerCounts validate() const;

 private:
  HalfEdgeId insert_before(HalfEdgeId where, VertexId vertex, EdgeId edge);
  void link(HalfEdgeId before, HalfEdgeId after);
  void unlink(HalfEdgeId half_edge);
  void make_lone(HalfEdgeId half_edge, VertexId vertex, LoopId loop);
  void give(HalfEdgeId start, LoopId loop);
  void kill(HalfEdgeId half_edge) { half_edges_[half_edge] = HalfEdge(); }
  void drop_loop(LoopId loop);
  FaceId add_face(LoopId outer, const Face& like);

  Table<VertexId, Vertex> vertices_;
  Table<EdgeId, Edge> edges_;
  Table<HalfEdgeId, HalfEdge> half_edges_;
  Table<LoopId, Loop> loops_;
  Table<FaceId, Face> faces_;
};

}  // namespace cnrg::bench::mantyla

// One sheet, subdivided: the planar map of its edges, its faces with the soup faces that cover each.
#pragma once

#include <optional>
#include <vector>

#include "kernel/refine/box_tree.h"
#include "kernel/refine/segments.h"

namespace cnrg {

/// Edges of the arrangement, as refinement makes them.
struct EdgeTable {
  IdVector<EdgeId, std::array<VertexId, 2>> ends;  ///< the lexicographically smaller first
  Csr<EdgeId, SegmentId> segments;                 ///< all segments that cover the edge, ascending
  Csr<SegmentId, EdgeId> chain;                    ///< the edges of a segment from its first to its second end
};

/// The covered faces of one sheet.
struct SheetFaces {
  std::vector<HalfEdge> half_edges;          ///< loop after loop
  std::vector<std::uint32_t> loop_end;       ///< ends of loops in `half_edges`
  std::vector<std::uint32_t> face_loop_end;  ///< ends of faces in `loop_end`; the outer loop comes first
  std::vector<VertexId> isolated;            ///< face after face
  std::vector<std::uint32_t> face_isolated_end;
  std::vector<Cover> covers;  ///< face after face, ascending
  std::vector<std::uint32_t> face_cover_end;
  std::size_t face_count() const { return face_loop_end.size(); }
};

/// What subdivision reads.
struct SubdivisionContext {
  const RefineInput& input;
  const SegmentTable& segments;
  const EdgeTable& edges;
  /// Soup faces with the input segment on their boundary.
  const Csr<SegmentId, SourceId>& segment_faces;
  const IdVector<SourceId, SheetId>& sheet_of;
};

/// Subdivides sheets one after another; keeps its scratch memory, so one per thread.
class Subdivider {
 public:
  explicit Subdivider(const SubdivisionContext& context) : x_(context) {}
  /// `content.points` are vertices of the sheet that may be isolated. Throws InvariantError if the edges of the
  /// sheet are no plane graph.
  SheetFaces subdivide(const SheetContent& content);

 private:
  struct LocalEdge {
    EdgeId edge;
    SegmentId line;                    ///< a segment of the edge, for directions
    std::array<std::uint32_t, 2> end;  ///< local vertices
    bool right;                        ///< direction of the edge lies in the right half plane
  };
  void collect(const SheetContent& content);
  void sort_around_vertices();
  void walk_loops();
  void find_outer_loops();
  void nest(const SheetContent& content);
  void cover(const SheetContent& content);
  SheetFaces emit(const SheetContent& content);
  void index_edges();
  std::uint32_t containing_face(VertexId v, std::uint32_t component);
  bool is_nearer(std::uint32_t h, std::uint32_t g) const;
  bool before(std::uint32_t h, std::uint32_t g) const;
  bool left_of(VertexId v, VertexId w) const;  ///< order (u, v) in the projection
  VertexId origin(std::uint32_t h) const { return vertices_[edges_[h >> 1].end[h & 1]]; }
  std::uint32_t local_origin(std::uint32_t h) const { return edges_[h >> 1].end[h & 1]; }

  SubdivisionContext x_;
  Projection axes_;
  static constexpr std::uint32_t kNone = 0xffffffffu;
  std::vector<LocalEdge> edges_;
  std::vector<VertexId> vertices_, isolated_;
  std::vector<std::uint32_t> out_begin_, out_;  // half-edges around each vertex, counter-clockwise
  std::vector<std::uint32_t> rank_;             // place of each half-edge in out_
  std::vector<std::uint32_t> next_, loop_of_, loop_first_;
  std::vector<std::uint32_t> component_, component_min_, component_outer_;
  std::vector<std::uint32_t> loop_face_;  // face of each loop; 0 is the unbounded one
  std::vector<std::uint32_t> isolated_face_;
  std::vector<std::vector<SourceId>> face_cover_;
  std::size_t face_count_ = 0, component_count_ = 0;
  std::optional<BoxTree> edge_tree_;  // of (-u, v): the first of its order are those in the east
};

}  // namespace cnrg

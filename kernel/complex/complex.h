// The complete geometric complex of space (Cavalcanti et al. 1997): parallel arrays, constant once built.
//
// All that a program computes refers to one complex by 4-byte ids, from many threads, without locks; so nobody may
// write to it, and the types see to that. Only ComplexBuilder makes one, it cannot be copied, moved or assigned,
// and what `build_complex` gives is a std::shared_ptr<const Complex>. Readers take a `const Complex&` and read the
// arrays as they are: no call stands between them and a cell. Who keeps something that refers to a complex for
// longer than the caller does keeps a copy of the pointer. (Members that are const would do the same, but could
// not be filled step by step; functions that return the arrays would be a call for each of the many readers.)
//
// Cells are pairwise disjoint and open; the boundary of each is a union of cells. Notation:
//   v  vertex, e  edge (from ends[0] to ends[1], ends[0] lexicographically smaller), h  half-edge,
//   f  face (planar, maximal between edges, with holes, slits and isolated vertices in its interior),
//   F  half-face: front (0) is where the normal of the face's sheet points, back (1) the other side,
//   R  region (3-cell); R0 is the unbounded one (with a frame: what lies outside of the frame).
// A loop of a face is a closed walk of half-edges with the face to the left as seen from the front: outer loops
// are counter-clockwise, holes clockwise; an edge with the face on both sides is walked twice.
// An edge with no face around it is a wire; it hangs in one region. The same for isolated vertices.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/complex/sparse.h"
#include "kernel/exact/points.h"
#include "kernel/refine/report.h"
#include "kernel/refine/soup.h"

namespace cnrg {

/// The region of one leaf that holds a 3-cell (leaf regions from 1; 0 is never listed).
struct Label {
  LeafId leaf;
  std::uint32_t region = 0;
  friend auto operator<=>(const Label&, const Label&) = default;
};

/// A face, a wire, an isolated point or a region of a leaf that a cell lies in.
struct LeafCell {
  LeafId leaf;
  std::uint8_t dimension = 2;  ///< 0 isolated point, 1 wire, 2 face, 3 region
  /// Of the face or wire in its leaf (Soup::Face::leaf_face, Soup::Wire::leaf_edge), of the region from 1; 0 for a
  /// point.
  std::uint32_t number = 0;
  friend auto operator<=>(const LeafCell&, const LeafCell&) = default;
};

/// A face that lay around an edge and was removed before the complex was refined.
struct RemovedFacet {
  Soup::Face source;
  ExactPlane plane;
  SheetId sheet;  ///< that of its plane: one of the complex, or a number above them
};

/// A face around an edge: the face lies to the left of `half_edge` as seen from its front.
struct FaceUse {
  FaceId face;
  HalfEdge half_edge;
  /// The side of the face that looks into the wedge before the face in radial order, and into that after it.
  HalfFace before() const { return {face, 1 - half_edge.direction()}; }
  HalfFace after() const { return {face, half_edge.direction()}; }
  friend auto operator<=>(const FaceUse&, const FaceUse&) = default;
};

class Complex {
 public:
  Complex(const Complex&) = delete;
  Complex& operator=(const Complex&) = delete;

  // --- geometry
  PointTable points;                       ///< indexed by VertexId; may hold points that are no vertex
  IdVector<SheetId, PlaneId> sheet_plane;  ///< the plane of each sheet; its normal is the front
  IdVector<SheetId, Projection> sheet_projection;

  // --- vertices; ids are those of `points`
  std::vector<VertexId> vertices;              ///< all 0-cells, ascending
  Csr<VertexId, EdgeId> vertex_edges;          ///< incident edges, ascending
  SparseLists<VertexId, FaceId> vertex_faces;  ///< faces that hold the vertex as an isolated point
  /// The region of a vertex that has no edge and lies in no face; none() otherwise.
  SparseVector<VertexId, RegionId> vertex_region;

  // --- edges
  IdVector<EdgeId, std::array<VertexId, 2>> edge_ends;
  /// The uses of the faces around each edge, in radial order: counter-clockwise as seen with the edge pointing
  /// towards the viewer. A dangling face has one use there, a face with a slit two.
  Csr<EdgeId, FaceUse> edge_uses;
  SparseVector<EdgeId, RegionId> edge_region;  ///< the region of a wire; none() if the edge has uses
  Csr<EdgeId, SegmentId> edge_segments;        ///< the input segments and traces that cover the edge

  // --- segments: where edges come from
  IdVector<SegmentId, std::array<VertexId, 2>> segment_ends;
  Csr<SegmentId, SourceId> segment_faces;        ///< soup faces that have the segment on their boundary
  SparseLists<SegmentId, WireId> segment_wires;  ///< soup wires on it; a trace has neither

  // --- faces
  IdVector<FaceId, SheetId> face_sheet;
  Csr<FaceId, LoopId> face_loops;  ///< the outer loop first
  Csr<LoopId, HalfEdge> loop;
  SparseLists<FaceId, VertexId> face_vertices;  ///< isolated vertices in the interior
  IdVector<FaceId, SourceSetId> face_cover;
  Csr<SourceSetId, Cover> covers;
  IdVector<FaceId, std::array<RegionId, 2>> face_regions;  ///< on its front, on its back

  // --- regions
  std::size_t region_count = 0;  ///< with R0
  IdVector<RegionId, LabelSetId> region_labels;
  Csr<LabelSetId, Label> label_sets;
  Csr<RegionId, HalfFace> region_faces;     ///< all half-faces that bound the region, by shell
  Csr<RegionId, EdgeId> region_wires;       ///< wires hanging in it
  Csr<RegionId, VertexId> region_vertices;  ///< isolated vertices in it

  // --- leaves
  std::size_t leaf_count = 0;
  SparseLists<VertexId, LeafId> isolated_leaves;  ///< leaves that have the vertex as an isolated point
  SparseLists<VertexId, LeafId> curve_ends;       ///< leaves whose curves end in the vertex
  /// Cells of leaves that hold a cell, beside those that covers, wires and labels tell. They were removed before
  /// this complex was refined (ComplexSources); none otherwise.
  SparseLists<VertexId, LeafCell> vertex_leaf_cells;
  SparseLists<EdgeId, LeafCell> edge_leaf_cells;
  SparseLists<FaceId, LeafCell> face_leaf_cells;
  /// Those of them around an edge of a curved surface.
  std::vector<RemovedFacet> removed_facets;
  SparseLists<EdgeId, std::uint32_t> edge_removed_facets;  ///< places in `removed_facets`
  /// Attributes of soup faces. `surface` is 0 for faces that lie on their planes alone; those of a curved patch
  /// whose surface is not known have a number of its own.
  IdVector<SourceId, Soup::Face> sources;
  std::uint32_t surface_count = 0;     ///< curved ones
  IdVector<WireId, Soup::Wire> wires;  ///< attributes of soup wires
  IdVector<LeafId, Fill> fills;
  /// The number of regions of each leaf (the largest label).
  IdVector<LeafId, std::uint32_t> leaf_regions;

  // --- the frame of unbounded leaves (none() when there is none)
  LeafId frame;
  /// True for cells that lie on the frame or outside of it: never active, counted or written.
  bool on_frame(FaceId f) const { return frame.valid() && frame_faces_[f]; }
  bool on_frame(EdgeId e) const { return frame.valid() && frame_edges_[e]; }
  bool on_frame(VertexId v) const { return frame.valid() && frame_vertices_[v]; }
  bool outside_frame(RegionId r) const { return frame.valid() && r == RegionId(0); }
  /// True for R0 and, with a frame, for each region that reaches the frame.
  bool unbounded(RegionId r) const { return r == RegionId(0) || (frame.valid() && frame_regions_[r]); }

  std::size_t vertex_count() const { return vertices.size(); }
  std::size_t edge_count() const { return edge_ends.size(); }
  std::size_t face_count() const { return face_sheet.size(); }

  VertexId origin(HalfEdge h) const { return edge_ends[h.edge()][h.direction()]; }
  VertexId target(HalfEdge h) const { return edge_ends[h.edge()][1 - h.direction()]; }
  RegionId region(HalfFace h) const { return face_regions[h.face()][h.side()]; }
  PlaneId plane(FaceId f) const { return sheet_plane[face_sheet[f]]; }
  std::span<const Cover> cover(FaceId f) const { return covers[face_cover[f]]; }
  /// All half-edges of its loops, loop by loop: these are numbered face by face.
  std::span<const HalfEdge> half_edges(FaceId f) const {
    const auto loops = face_loops[f];
    if (loops.empty()) return {};
    const auto last = loop[loops.back()];
    return {loop[loops.front()].data(), last.data() + last.size()};
  }
  std::span<const Label> labels(RegionId r) const { return label_sets[region_labels[r]]; }

  /// One region next to the cell: every cell has one; all of them for a cell off every face.
  RegionId some_region(FaceId f) const { return face_regions[f][0]; }
  RegionId some_region(EdgeId e) const;
  RegionId some_region(VertexId v) const;

  /// The faces in the star of a vertex or an edge, ascending and unique.
  void star_faces(VertexId v, std::vector<FaceId>& out) const;
  void star_faces(EdgeId e, std::vector<FaceId>& out) const;
  /// The regions in the star of a cell, ascending and unique; of a face those on its front and on its back.
  void star_regions(VertexId v, std::vector<RegionId>& out) const;
  void star_regions(EdgeId e, std::vector<RegionId>& out) const;
  void star_regions(FaceId f, std::vector<RegionId>& out) const {
    out.assign(face_regions[f].begin(), face_regions[f].end());
  }
  /// The edges in the closure of a face: loops and slits; ascending and unique.
  void closure_edges(FaceId f, std::vector<EdgeId>& out) const;

 private:
  friend class ComplexBuilder;
  Complex() = default;
  IdVector<FaceId, char> frame_faces_;
  IdVector<EdgeId, char> frame_edges_;
  IdVector<VertexId, char> frame_vertices_;
  IdVector<RegionId, char> frame_regions_;
};

/// Calls `see` for each cell that bounds another one, as often as it does: the faces of a region, and the wires
/// and isolated vertices in it; the edges along a face, each with its origin, and the isolated vertices in it; the
/// ends of an edge.
template <class See>
void for_each_bounding(const Complex& complex, RegionId r, const See& see) {
  for (const HalfFace h : complex.region_faces[r]) see(h.face());
  for (const EdgeId e : complex.region_wires[r]) see(e);
  for (const VertexId v : complex.region_vertices[r]) see(v);
}
template <class See>
void for_each_bounding(const Complex& complex, FaceId f, const See& see) {
  for (const HalfEdge h : complex.half_edges(f)) see(h.edge()), see(complex.origin(h));
  for (const VertexId v : complex.face_vertices[f]) see(v);
}
template <class See>
void for_each_bounding(const Complex& complex, EdgeId e, const See& see) {
  for (const VertexId v : complex.edge_ends[e]) see(v);
}

/// Refines the soup and builds its complex, labels included; the soup may go then. Throws InputError for a face
/// that is not planar and for sides that contradict each other (the message names leaf and faces as `leaf i, face
/// j`), InvariantError for a bug.
std::shared_ptr<const Complex> build_complex(const Soup& soup, const RefineOptions& options = {},
                                             RefineReport* report = nullptr);

/// Checks the invariants (kernel/README.md#invariants): vertices distinct, loops closed, radial order, incidence
/// both ways, d d = 0, Euler's formula per shell, labels consistent. Returns the first violation in words, or an
/// empty string.
std::string validate(const Complex& complex);

/// Where a point lies.
struct Location {
  int dimension = 3;
  VertexId vertex;
  EdgeId edge;
  FaceId face;
  RegionId region;
};

/// A point in the open interior of a face (edge): exact, off every other cell.
ExactPoint interior_point(const Complex& complex, FaceId f);
ExactPoint interior_point(const Complex& complex, EdgeId e);

/// Exact point location in a complex, which must outlive it. Building is O(n log n); a query is about O(log n).
class Locator {
 public:
  explicit Locator(const Complex& complex);
  ~Locator();
  Location locate(const RationalPoint& p) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace cnrg

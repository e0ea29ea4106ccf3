// Simplification of a selection (Rossignac & O'Connor 1990, SGC; csg/SEMANTICS.md#simplification).
//
// Removes what no label needs: faces whose two regions and itself carry one state; then edges with exactly
// two faces of their state on one plane or curved surface, or in the interior of a region of their state;
// then vertices between exactly two collinear edges (or of one curve) of their state, or in the interior of a
// face or region of their state. Features stay, and so do marked cells, which merge with their like only.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "kernel/base/short_list.h"
#include "kernel/selection/selection.h"

namespace cnrg {

/// The cells that remain, each with the cells of the complex that it unites. Indices are into the vectors here.
/// The order is that of the smallest cell id, so that it is the same for every thread count.
struct SimplifiedComplex {
  struct Vertex {
    VertexId cell;
    Component component = 0;
  };
  struct Edge {
    ShortList<HalfEdge, 2> chain;  ///< head to tail; a closed chain has no end vertices
    bool closed = false;
    Component component = 0;
  };
  struct Face {
    ShortList<HalfFace, 2> cells;     ///< the faces united, each by the half-face that is the front
    ShortLists<HalfEdge> loops;       ///< boundary walks, the face to the left; slits twice
    ShortList<VertexId, 2> isolated;  ///< remaining vertices in the interior
    Component component = 0;
    std::array<std::uint32_t, 2> regions{};  ///< indices of the regions on front and back
  };
  struct Region {
    std::vector<RegionId> cells;
    Component component = 0;  ///< 0: inactive
    bool bounded = true;
    std::vector<std::vector<std::uint32_t>> shells;  ///< face index * 2 + side, per shell
  };
  std::vector<Vertex> vertices;  ///< active ones and those that bound something; none on the frame
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<Region> regions;  ///< all regions that touch an active cell or hold one; outside of the frame: none

  /// Index of the simplified cell that holds a cell of the complex, by dimension of the result.
  struct Place {
    int dimension = 3;
    std::uint32_t index = 0;  ///< into the vector of that dimension; kNowhere for an inactive region not listed
  };
  static constexpr std::uint32_t kNowhere = 0xffffffffu;
  Place place(const Complex& complex, const Location& location) const;

  // maps from cells, filled by simplify
  std::vector<Place> vertex_place, edge_place, face_place, region_place;

  /// Edges within faces between two facets of the leaves that lie in one plane, ascending; of flat faces, too.
  std::vector<EdgeId> facet_edges;

  /// Of files, in their order: put_in_order (canonical.h) has given the cells their numbers. Empty before that.
  std::vector<VertexId> points;
};

enum class SimplifyMode {
  features,  ///< keep features
  points,    ///< forget features, curved surfaces and curves: the canonical form of the point set
  raw,       ///< merge nothing but what is inactive on both sides: every active cell stays a cell
};

/// The leaves that each cell of a selection came from. What these say of surfaces and curves counts alone: then
/// the result does not depend on what else is in the complex. And a mark for cells that are told from others of
/// their component: they merge with cells of the same mark, and never with a larger cell around them.
class CellSources {
 public:
  virtual ~CellSources() = default;
  /// False: all marks are 0.
  virtual bool marks_anything() const { return false; }
  /// 0: none. Threads may ask at a time.
  virtual std::uint32_t mark(FaceId) const { return 0; }
  virtual std::uint32_t mark(EdgeId) const { return 0; }
  virtual std::uint32_t mark(VertexId) const { return 0; }
  /// Ascending, unique, into `out`. Cells of the closure are asked for, too. Threads may ask at a time.
  virtual void leaves_of(FaceId f, std::vector<LeafId>& out) const = 0;
  virtual void leaves_of(EdgeId e, std::vector<LeafId>& out) const = 0;
};

/// Decides at the cost of the selection; the result with its maps takes a pass over the complex. Without `sources`
/// all leaves of the complex count everywhere.
SimplifiedComplex simplify(const Complex& complex, const Selection& selection, const Features& features,
                           SimplifyMode mode = SimplifyMode::features, const CellSources* sources = nullptr);

/// What people call a simplified cell: `v3`, `e0`, `f12`, `r1`; `-` for an inactive region that is not listed.
std::string cell_name(int dimension, std::uint32_t index);

/// The component of the cell at a place; 0 when it is inactive or not listed.
Component component_of(const SimplifiedComplex& simplified, const SimplifiedComplex::Place& place);

/// Active cells of a value by dimension.
struct CellCounts {
  std::array<std::size_t, 4> raw{};  ///< as the refinement has them
  std::array<std::size_t, 4> simplified{};
};

/// Counts of active cells by dimension, 0 to 3.
std::array<std::size_t, 4> active_counts(const SimplifiedComplex& simplified);

/// `active_counts(simplify(...))`, at the cost of the active cells, the features and their closure.
std::array<std::size_t, 4> simplified_counts(const Complex& complex, const Selection& selection,
                                             const Features& features, SimplifyMode mode = SimplifyMode::features,
                                             const CellSources* sources = nullptr);

}  // namespace cnrg

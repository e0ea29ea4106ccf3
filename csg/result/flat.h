// A result flattened to points, chains, loops and triangles: what every writer starts from.
//
// The numbering is canonical. Points are sorted by their exact coordinates; everything else follows from
// point numbers alone. So a result has the same numbers whichever way it was computed, and reading a file
// back and writing it again gives the same file.
//
//   * A point inside a straight chain that is no vertex and touches flat faces only is left out.
//   * The front of a face is the outside, where exactly one of its sides is active; else the side to which
//     the lexicographically positive normal of its first facet points.
//   * A face on one plane has one facet. A face of a curved patch has a facet for each planar piece.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "csg/result/result_view.h"
#include "kernel/base/short_list.h"

namespace cnrg {

struct FlatComplex {
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffffffffu;
  using Triangle = std::array<Index, 3>;
  using Loop = ShortList<Index, 4>;  ///< point numbers

  /// Where an active cell came from, over all cells of the complex that it unites (of its own dimension): the
  /// leaves and their faces, wires, points and regions that hold it. Both ascending; empty for inactive cells.
  struct Provenance {
    ShortList<LeafId, 2> leaves;
    ShortList<LeafCell, 4> cells;
    /// What is said of a face, edge or vertex that speaks for itself (csg/operators/cell_sources.h); nullptr where
    /// nothing is said. Of the value that was flattened.
    const Attributes* said = nullptr;
  };
  /// A patch of a leaf, or a curve of one.
  struct Patch {
    LeafId first;
    std::uint32_t second = 0;
    friend auto operator<=>(const Patch&, const Patch&) = default;
  };
  struct Vertex {
    Index point = 0;
    Component component = 0;
    bool entity = false;   ///< active, and not just the interior of a region of its component
    bool own = false;      ///< an entity, or something is said of it: it is more than the interior of a region
    bool feature = false;  ///< of the group; of components: of the groups they were made of
    bool free = false;     ///< no listed edge ends there (it may lie inside of a face)
    Index region = kNone;  ///< the region that holds a vertex on no edge and no face
    Provenance origin;
  };
  struct Edge {
    Loop points;  ///< from end to end; a closed chain does not repeat the first
    bool closed = false;
    Component component = 0;
    bool entity = false, own = false, feature = false;
    bool wire = false;     ///< no listed face has it on its boundary
    bool slit = false;     ///< a face walks it twice
    Index region = kNone;  ///< the region that holds a wire
    Provenance origin;
    /// With ResultView::parameters: patches, of the leaves that it came from, that are around all of it, and the
    /// curve that covers all of it.
    ShortList<Patch, 2> patches;
    std::optional<Patch> curve;  ///< Soup::Wire::leaf_edge
    /// The faces around it in radial order, each by the side that is seen first (face * 2 + side, 0: front); a
    /// slit twice.
    ShortList<Index, 2> around;
  };
  struct Facet {
    std::vector<Loop> loops;  ///< outer first, seen from the front counter-clockwise, holes clockwise
    ShortList<Index, 2> isolated;
    friend auto operator<=>(const Facet&, const Facet&) = default;
  };
  struct Face {
    std::vector<Loop> loops;           ///< boundary walks, the face to the left as seen from the front
    ShortList<Index, 2> isolated;      ///< vertices in the interior, by point
    std::vector<Facet> facets;         ///< of a face that is not flat; empty for a flat one
    ShortList<Triangle, 1> triangles;  ///< counter-clockwise as seen from the front
    std::vector<Index> facet_ends;     ///< of a face that is not flat: where the triangles of each facet end
    Component component = 0;
    bool entity = false, own = false;
    std::array<Index, 2> regions{kNone, kNone};  ///< on front and back
    Provenance origin;
    /// The patch that covers all of it, if there is one; of the leaves that it came from if possible.
    std::optional<Patch> patch;
    /// With ResultView::parameters, the cells of the leaf's patch (parameters.h) that the face lies in: of each
    /// facet (of a flat face: of all of it), each list ascending. Empty where `patch` has no parameters.
    std::vector<std::vector<std::vector<PatchCorner>>> cells;
    /// The number of the curved surface that all of it lies on (Soup::Face::surface); 0: a plane, or several.
    std::uint32_t surface = 0;
    /// With ResultView::parameters, of a face of one surface but of several patches: the cells of all.
    std::vector<std::pair<Patch, std::vector<PatchCorner>>> cells_of_patches;
  };
  struct Region {
    Component component = 0;
    bool bounded = true;
    std::vector<std::vector<Index>> shells;  ///< face * 2 + side (0: front), ascending in each
    std::vector<RegionId> cells;             ///< 3-cells of the complex
    Provenance origin;
  };

  std::vector<VertexId> points;     ///< ascending by coordinates
  std::vector<Index> frame_points;  ///< points on the frame of unbounded leaves, ascending
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<Region> regions;

  bool active(Index region) const { return region != kNone && regions[region].component != 0; }
  /// 0: dangling (in or out of a region), 1: bounds one active region, 2: a wall between two.
  int regions_bounded(const Face& face) const {
    return face.regions[0] == face.regions[1] ? 0 : active(face.regions[0]) + active(face.regions[1]);
  }
};

/// Calls `see(a, b)` for each straight segment of an edge, with its points.
template <class See>
void for_each_segment(const FlatComplex::Edge& edge, const See& see) {
  const std::size_t n = edge.points.size();
  for (std::size_t k = 0; k + (edge.closed ? 0 : 1) < n; ++k) see(edge.points[k], edge.points[(k + 1) % n]);
}

/// Calls `see(loops, isolated, begin, end)` for each planar facet of a face, in order, with the places of its
/// triangles, if there are any; a flat face is one facet.
template <class See>
void for_each_facet(const FlatComplex::Face& face, const See& see) {
  using Index = FlatComplex::Index;
  if (face.facets.empty()) see(face.loops, face.isolated, Index(0), Index(face.triangles.size()));
  Index begin = 0;
  for (std::size_t k = 0; k < face.facets.size(); ++k) {
    const Index end = face.facet_ends.empty() ? 0 : face.facet_ends[k];
    see(face.facets[k].loops, face.facets[k].isolated, begin, end);
    begin = end;
  }
}

enum class Flattening : std::uint8_t {
  whole,
  cells,   ///< all cells and what bounds them: without what comes of leaves, and without triangles
  shapes,  ///< for formats of mere triangles: without what comes of leaves, and without more than components and
           ///< `wire` of edges and vertices that faces have on them, slits apart
};
FlatComplex flatten(const ResultView& view, Flattening what = Flattening::whole);

/// Name, material and leaves of a component; empty for 0.
const RegionAttributes& attributes_of(const ResultView& view, Component component);

}  // namespace cnrg

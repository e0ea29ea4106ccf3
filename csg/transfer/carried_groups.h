// Values that were evaluated on complexes of their own and go on in another one.
//
// A section of a tree (sections.h) is refined by itself. What of its value its users may see is *carried* into
// their refinement: the faces that stayed, the walls between 3-cells that came from different leaves, wires and
// points. Everything that the section has removed stays behind, and so does every cut that only removed cells
// made. That is what makes a section worth its while.
//
// To take the value as a solid with new faces would be simpler, and wrong in two ways. Its corners are constructed
// points, and planes through these would have numbers that grow from section to section: so each face keeps the
// plane of the input face that it is a piece of. And results tell which faces of which leaves they are made of: so
// each carried cell knows what it came from, and once the next complex is built its cells are told
// (kernel/complex/draft.h). Above it only what csg/README.md lists (Refined apart) shows that a
// value was carried.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "csg/leaves/geometry_leaf.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/group.h"
#include "csg/transfer/cell_map.h"
#include "kernel/complex/draft.h"

namespace cnrg {

class CarriedGroup {
 public:
  /// `places`: of `complex`, whose leaves have the same numbers where the group goes.
  CarriedGroup(const Complex& complex, const Group& group, const LeafPlaces& places);

  /// One leaf whose labels are classes of 3-cells, to be added to a soup as it is.
  const std::shared_ptr<const GeometryLeaf>& leaf() const { return leaf_; }

 private:
  friend class CarriedGroups;
  using Index = std::uint32_t;
  static constexpr Index kNone = 0xffffffffu;
  class Maker;

  /// An input face as the soup has it, with its leaf's number where the group goes, and its place in that leaf.
  struct Source {
    Soup::Face face;
    Index place;
    std::uint32_t regions;  ///< of its leaf
  };
  struct Wire {
    Soup::Wire wire;
    Index place;
  };
  /// The sides of input faces and the wires that cover an edge.
  struct Segment {
    std::vector<Index> sources, wires;
  };
  struct Face {
    Index cover;       ///< place in `covers_`
    LeafSetId origin;  ///< none(): it is no entity
    Index gone;        ///< place in `gone_`
  };
  struct Edge {
    std::array<Index, 2> ends;  ///< points
    Index segments;             ///< place in `segments_of_`
    LeafSetId origin;
    bool feature;
    Index gone;
    Index facets;  ///< place in `facets_of_`
  };
  struct Vertex {
    Index point;
    LeafSetId origin;
    bool feature;
    Index gone;
    std::vector<LeafId> isolated, curve_ends;
  };
  struct Class {
    std::uint32_t region;  ///< of the group
    std::vector<Label> labels;
  };

  std::shared_ptr<const GeometryLeaf> leaf_;
  std::vector<Face> faces_;                                  // by leaf_face
  std::vector<std::vector<std::pair<Index, bool>>> covers_;  // sources, each on the front of the face or not
  std::vector<Edge> edges_;
  std::vector<std::vector<Index>> segments_of_;  // distinct lists
  std::vector<Vertex> vertices_;
  std::vector<Class> classes_;  // by label - 1
  std::vector<Source> sources_;
  std::vector<Wire> wires_;
  std::vector<Segment> segments_;
  std::vector<std::vector<LeafCell>> gone_;    // distinct lists of leaves' cells that held a cell and were removed
  std::vector<RemovedFacet> facets_;           // of edges along curved surfaces and curves
  std::vector<std::vector<Index>> facets_of_;  // distinct lists
  std::vector<RegionAttributes> regions_;
  Rational dominance_;
  LeafSets sets_;
};

/// The groups that are carried into one complex. Their leaves are the last ones of its soup, in their order.
class CarriedGroups {
 public:
  explicit CarriedGroups(std::vector<CarriedGroup> groups) : groups_(std::move(groups)) {}
  bool empty() const { return groups_.empty(); }
  const std::vector<CarriedGroup>& groups() const { return groups_; }

  /// The values on the new complex; `vertex_of` as RefineReport has it.
  std::vector<Group> on(const Complex& complex, const std::vector<VertexId>& vertex_of);
  /// After `on`: what the cells of the complex come from. `places` become those of the new sources.
  /// `surfaces` as `make_soup` has it: patches that it gives no number, and are curved, get one each.
  ComplexSources sources(const Complex& complex, std::span<const std::vector<std::uint32_t>> surfaces,
                         LeafPlaces& places) const;

 private:
  using Index = CarriedGroup::Index;
  static constexpr Index kNone = CarriedGroup::kNone;
  class SourcesMaker;
  using Piece = CellMap::Piece;  // of the group at its part's place
  std::vector<CarriedGroup> groups_;
  CellMap cells_;

  CellMap map_of(const Complex& complex, const std::vector<VertexId>& vertex_of) const;
  LeafSetId origin(const Piece& piece) const;
  const std::vector<LeafCell>& gone(const Piece& piece) const;
};

}  // namespace cnrg

// A group (csg/SEMANTICS.md#groups; pereira2012 2.1): entities of dimension 2 at most, closed, and regions.
//
// Sparse and sorted by id. `cells` holds the 3-cells inside of regions. A cell of dimension <= 2 that is no
// entity has one and the same region of the group (or none) all around it.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "csg/materials/attributes.h"
#include "csg/operators/origins.h"
#include "kernel/complex/complex.h"
#include "kernel/selection/selection.h"

namespace cnrg {

/// What people say of a region; combined by dominance.
struct RegionAttributes : Attributes {
  std::vector<LeafId> leaves{};  ///< provenance: leaves with a region there, ascending
};

/// A value by itself; the ids in it are those of one complex.
struct Group {
  std::vector<std::pair<RegionId, std::uint32_t>> cells;  ///< 3-cell -> region of the group, from 1
  std::vector<RegionAttributes> regions;                  ///< regions[i - 1] belongs to region i
  std::vector<FaceId> faces;
  std::vector<EdgeId> edges;
  std::vector<VertexId> vertices;
  Features features;  ///< subsets of `edges` and `vertices`
  /// Parallel to `vertices`, `edges` and `faces`, and what is said of these; cells inside of regions came from the
  /// region's leaves.
  Origins origins;
  Rational dominance = 0;

  /// The region of the group that holds a 3-cell; 0: outside.
  std::uint32_t region_of(RegionId r) const;
  bool has(FaceId f) const;
  bool has(EdgeId e) const;
  bool has(VertexId v) const;
  /// A plane has a face and neither edges nor vertices: those on the frame are no entities.
  bool has_entities() const { return !(faces.empty() && edges.empty() && vertices.empty()); }
};

/// The selection of |G|: component i for region i and the cells in its interior, component
/// `regions.size() + 1` for the entities.
Selection selection_of(const Complex& complex, const Group& group);

/// The group of each leaf, by LeafId, read off the labels and covers of the complex in one pass; that of the frame
/// is empty. `attributes[leaf][label - 1]` says what people call a labelled region (missing ones have none);
/// `leaves` of each region is set to the leaf.
///
/// Entities of a leaf: the faces that a soup face of it covers, with their closure (cells that other leaves cut
/// into their interior included), its wires, its isolated vertices. Regions: the 3-cells with a label of the
/// leaf, joined across faces that are no entities.
/// Features of a leaf: edges on the boundary of its soup faces that part two of its faces or patches or are a free
/// border, and its wires; its isolated vertices, and the ends of feature edges but those where exactly two of
/// them continue each other, on a line or on one tessellated curve.
std::vector<Group> leaf_groups(const Complex& complex,
                               const std::vector<std::vector<Attributes>>& attributes = {});

}  // namespace cnrg

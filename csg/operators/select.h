// What somebody picks out of a value: cells by dimension, attributes, leaves, place, and what is around them
// (csg/SEMANTICS.md#select).
//
// Nothing is made: criteria are asked of the cells that the value has. The obvious way, to take regions and walls
// apart into values of their own first and to look for names there, loses what a cell is the wall between; the
// complex knows it.
//
// Asked are the cells that people see: those that simplification leaves (kernel/selection/simplify.h). The complex
// has more, where other leaves cut them, and a selection must not depend on these: a vertex that some wire has
// left in a face is none that anybody would pick.
//
// Of a group its regions and entities are asked, and what is picked is closed, or it would be no group: faces
// bring their edges and vertices, edges their ends, and regions all entities on their boundary, sheets, wires and
// points inside of them included. Of components each cell is asked, and comes alone: they need not be closed.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/operators/components.h"

namespace cnrg {

/// What lies on a side of a cell: a region by its name or material, or (none given) no region of the value. Of
/// components a region is a component with 3-cells there.
using SideName = std::optional<std::string>;

/// A cell is picked if all criteria hold; an empty list, and a set that is not given, holds for every cell. Of a
/// list one value suffices.
struct Criteria {
  std::vector<int> dimensions{};  ///< 3 regions, 2 faces, 1 edges, 0 vertices
  /// Said of the region, or of the cell by itself (cell_sources.h); where that is silent, of its component.
  std::vector<std::string> names{};
  std::vector<std::string> materials{};                        ///< the same
  std::vector<std::pair<std::string, Property>> properties{};  ///< the same; each key must hold by one value
  /// The cell is, bounds or lies in a region with one of these names or numbers (from 1), or is of such a
  /// component.
  std::vector<std::string> regions{};
  std::vector<Component> region_numbers{};
  /// A side of these surfaces (sides.h), which ascend.
  struct Side {
    std::vector<LeafId> surfaces;
    bool front = true;
  };
  /// That region or component is on each of these.
  std::vector<Side> sides{};
  std::vector<LeafId> leaves{};  ///< ascending; the cell came from one of these leaves
  /// It lies in one of these faces of `leaves`, borders included: numbers as the leaf has them, from 0.
  std::vector<std::uint32_t> source_faces{};
  /// Around the cell are two regions, or a region and no region, the one as the first says and the other as the
  /// second. Holds for no region.
  std::vector<std::array<SideName, 2>> between{};
  std::optional<CellSet> inside{};    ///< the cell is in this set; of a region all its 3-cells are
  std::optional<CellSet> touching{};  ///< the cell or its boundary has a cell in this set
};

/// Do the numbers of regions, by themselves or in a name (`two.1`), decide what is picked, and are there regions
/// with curved faces? Which one is the first then depends on facets.
bool picks_by_drawn_numbers(const Complex& complex, const Group& group, const Criteria& criteria);
bool picks_by_drawn_numbers(const Complex& complex, const Components& components, const Criteria& criteria);

/// The closure of the picked cells of `group`: with their features and origins, the regions in their order with
/// their attributes, and the dominance of `group`.
Group select(const Complex& complex, const Group& group, const Criteria& criteria);

/// The picked cells in their components, which keep their order and attributes; those of which nothing is picked
/// are left out.
Components select(const Complex& complex, const Components& components, const Criteria& criteria);

}  // namespace cnrg

// What somebody picks out of a group: cells by dimension, attributes, leaves, and the regions around them.
//
// Nothing is made: criteria are asked of the cells that the group has, regions and entities. The obvious way, to
// take regions and walls apart into groups first and to look for names there, loses what a cell is the wall
// between; the complex knows it.
//
// A selection is closed, or it would be no group: picked faces bring their edges and vertices, picked edges their
// ends, and picked regions all entities on their boundary, sheets, wires and points inside of them included.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "csg/operators/group.h"

namespace cnrg {

/// What lies on a side of a cell: a region by its name or material, or (none given) no region of the group.
using SideName = std::optional<std::string>;

/// A cell is picked if all criteria hold; an empty list holds for every cell. Of a list one value suffices.
struct Criteria {
  std::vector<int> dimensions{};         ///< 3 regions, 2 faces, 1 edges, 0 vertices
  std::vector<std::string> names{};      ///< said of the region, or of the cell by itself (cell_sources.h)
  std::vector<std::string> materials{};  ///< the same
  std::vector<std::pair<std::string, Property>> properties{};  ///< the same
  std::vector<std::string> regions{};  ///< the cell is, bounds or lies in a region with one of these names
  std::vector<LeafId> leaves{};        ///< the cell came from one of these leaves
  /// Around the cell are two regions, or a region and no region, the one as the first says and the other as the
  /// second. Holds for no region.
  std::vector<std::array<SideName, 2>> between{};
};

/// The closure of the picked cells of `group`: with their features and origins, the regions in their order with
/// their attributes, and the dominance of `group`.
Group select(const Complex& complex, const Group& group, const Criteria& criteria);

}  // namespace cnrg

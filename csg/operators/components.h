// The values of CNRG operators (rossignac1991; csg/SEMANTICS.md#components): selections with many components.
//
// A component is any set of cells: open, closed, neither, of any dimension, unbounded. Components are disjoint and
// numbered from 1.
//
// Between the families of operators:
//   * A group as operand of a CNRG operator is its components: region i with the cells in its interior is
//     component i; the entities (walls, wires, points) together are one more, called `entities`.
//   * Components as operand of a group Boolean must be closed together. The group then has a region for each
//     connected set of 3-cells of one component; entities are the cells that are not in the interior of one
//     component. What is not closed needs the operator `closure`.
#pragma once

#include <vector>

#include "csg/operators/group.h"
#include "csg/operators/origins.h"

namespace cnrg {

struct ComponentAttributes : RegionAttributes {
  Rational dominance = 0;
};

struct Components {
  Selection selection;
  std::vector<ComponentAttributes> attributes;  ///< of component i at i - 1
  Features features;                            ///< active cells; of the groups that it was made of
  Origins origins;                              ///< parallel to the lists of `selection`
};

/// A group as components; each has the group's dominance. The entities come last, if there are any.
Components components_of(const Complex& complex, const Group& group);

/// Closed components as a group, with the largest dominance among them. Requires `missing_boundary(...)` to be
/// empty.
Group group_of(const Complex& complex, const Components& components);

/// cl|X| - |X|.
CellSet missing_boundary(const Complex& complex, const Components& components);

}  // namespace cnrg

// Our side of the comparison: results in forms that oracles know.
#pragma once

#include "csg/operators/boolean.h"
#include "csg/operators/group.h"
#include "csg/operators/node_value.h"
#include "kernel/selection/simplify.h"
#include "tests/oracles/nef_oracle.h"
#include "tests/oracles/skeleton.h"
#include "tests/scenes/scene.h"

namespace cnrg::properties {

/// |G| as one component.
Selection point_set(const Complex& complex, const Group& group);

/// All components of a selection as one: |X|.
Selection joined(Selection selection);

/// The component of the cell at a place; 0 where it is not in the selection.
Component component_at(const Selection& selection, const Location& at);

/// The canonical form of |X| as `simplify` makes it in mode `points`, with unmarked cells where X is not closed.
Skeleton skeleton(const Complex& complex, const Selection& set);

/// |X| as a Nef polyhedron, open, unbounded or neither: the regions filled, then the cells of each lower
/// dimension of the simplified form taken off or put back.
NefSet to_nef(const Complex& complex, const Selection& set);

/// The canonical form of |G| as `simplify` makes it in mode `points`.
Skeleton skeleton(const Complex& complex, const Group& group);

/// |G| as a Nef polyhedron: the closed faces, wires and points of its simplified form, and its regions filled.
NefSet to_nef(const Complex& complex, const Group& group);

/// The sum of the volumes of the regions of a bounded group.
Rational volume(const Complex& complex, const Group& group);

/// What is wrong with a group (csg/SEMANTICS.md#groups) in words; empty when nothing is: closed under boundary,
/// walls complete, regions as detection finds them, features among the entities.
std::string validate(const Complex& complex, const Group& group);

}  // namespace cnrg::properties

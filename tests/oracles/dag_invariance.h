// What must not change the values of a dag: the order of its leaves, faces and points, and an exact rigid motion
// (csg/SEMANTICS.md#identities). Values are compared by their canonical forms, component by component.
//
// Each function returns the first difference in words, or an empty string.
#pragma once

#include <string>

#include "tests/oracles/dag.h"

namespace cnrg::properties {

/// All lists of the leaves turned round, the first points of loops moved on, the leaves in another order.
std::string permutation_failure(const RandomDag& dag);
/// Turned by a rational rotation, and moved.
std::string motion_failure(const RandomDag& dag);

}  // namespace cnrg::properties

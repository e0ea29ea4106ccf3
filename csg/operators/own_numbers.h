// Numbers of regions in the coordinates of a node that was moved with all below it.
//
// Regions of a group are numbered by where they are. A node that takes them by number, or makes components of
// them, must find the numbers that they have where the node stands alone, wherever its users have moved it.
#pragma once

#include <vector>

#include "csg/geometry/transform.h"
#include "csg/operators/node_value.h"

namespace cnrg {

/// By region of the group, from 1, its number before `transform` moved all that the group came from; that of 0 is
/// 0.
std::vector<Component> own_numbers(const Complex& complex, const Group& group, const Transform& transform);

/// The components of a value; those of a group are numbered so.
Components components_of(const Complex& complex, const NodeValue& value, const Transform& transform);

}  // namespace cnrg

// Faces whose two sides have nodes of their own, so that a solver can let them open and slip.
//
// Tetrahedra at a node are of one sector if one reaches the other through faces that are not split. Each sector of
// a node gets a node: at the tip of a fault there is one, within it there are two, where faults cross there are
// four. What lies elsewhere follows the tetrahedra at it: a bolt that crosses a fault is cut there.
#pragma once

#include <string>
#include <vector>

#include "csg/mesh/mesh.h"

namespace cnrg {

struct SplitReport {
  std::size_t twins = 0;  ///< nodes that were added
  std::size_t wedges = 0;
};

/// Throws InputError for a name that neither a group of faces nor a leaf has.
void require_groups(const std::vector<std::string>& groups, const std::vector<std::string>& names);

/// Parts the tetrahedra on both sides of the faces of groups, or of leaves (`from NAME`). A triangle there is in
/// the mesh twice, in the groups `back of NAME` and `front of NAME` too, on the nodes of the tetrahedron behind
/// and in front of it; with `interfaces` wedges join these, without thickness, in the group `interface NAME`. One
/// with all nodes at tips stays once, behind. Wires in such a face stay behind it. Of a mesh of second order the
/// middle of an edge is parted where an end of it is. Tetrahedra keep their places, volumes and shapes. O(n log
/// n).
///
/// Throws InputError as `require_groups`, for a group without a face between tetrahedra, and for `interfaces` in a
/// mesh of second order.
SplitReport split(Mesh& mesh, const std::vector<std::string>& names, bool interfaces);

/// For pictures: with nodes in one place again, but for wedges; a triangle that was split is there twice.
Mesh joined_again(Mesh mesh);

}  // namespace cnrg

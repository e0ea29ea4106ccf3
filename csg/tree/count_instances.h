// Whether a tree unfolds to too many instances, before it is unfolded.
#pragma once

#include <cstddef>
#include <vector>

#include "csg/tree/tree.h"

namespace cnrg {

/// Throws TreeError when the tree below `roots` surely has more than `most` instances. It looks at no more than
/// about `most` of them, mostly at far fewer; it knows a place by a number that two places may share, though
/// hardly ever do: so it may let a tree pass that has too many, and refuses none that has not.
void refuse_too_many_instances(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most);

}  // namespace cnrg

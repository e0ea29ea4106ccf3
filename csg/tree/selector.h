// What a node `select` picks, as the tree file says it: criteria without what only an evaluation knows. Leaves are
// named by nodes, sets of points are further operands of the node, behind the one that is picked from.
#pragma once

#include <vector>

#include "csg/operators/select.h"
#include "csg/tree/position.h"
#include "kernel/base/ids.h"

namespace cnrg {

struct Selector {
  Criteria criteria;
  /// `from`: leaves, or nodes for all leaves below them; all of them below the first operand.
  std::vector<NodeId> from;
  Position from_at;        ///< of the key
  std::size_t inside = 0;  ///< so many operands behind the first are for `inside`, those after them for `touching`
};

}  // namespace cnrg

// What a node `select` picks, as the tree file says it: criteria without what only an evaluation knows. Leaves are
// named by nodes, sets of points are further operands of the node, behind the one that is picked from.
#pragma once

#include <string>
#include <vector>

#include "csg/operators/select.h"
#include "csg/tree/tree.h"

namespace cnrg {

struct Selector {
  Criteria criteria;
  /// `from`: leaves, or nodes for all leaves below them; all of them below the first operand.
  std::vector<NodeId> from;
  Position from_at;  ///< of the key
  /// `front of` and `behind`: of the surfaces below a node, as of `from`.
  struct Side {
    NodeId of;
    std::string name;  ///< of that node
    bool front = true;
    Position at;
  };
  std::vector<Side> sides;
  std::string file;        ///< what to call the text that says so
  std::size_t inside = 0;  ///< so many operands behind the first are for `inside`, those after them for `touching`
};

/// Adds a node to the tree that picks cells of `of`. `criteria` is the value of `select` without `of`, such as
/// `{dimension: 2, material: rock}`; nodes in it are those of the tree. The node is inline, called `OF/select`.
/// Throws TreeError, with a place in `criteria` and `file` as its name, for what `select` does not take; the tree
/// is then as it was.
NodeId add_selection(Tree& tree, NodeId of, const std::string& criteria, const std::string& file);

}  // namespace cnrg

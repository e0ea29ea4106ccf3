// Which parts of a tree are refined by themselves.
//
// All leaves of a tree could be refined together, once: what has met is then never looked for again. But what an
// operator removes has met everything by then, too. Of 64 balls, each cut to one small box before they are united,
// nearly all faces are gone when the union is formed; refined together, each ball is cut by all others far away
// from the box. A *section* is a node, with all below it, that is refined alone; only what is left of it goes on
// to its users (carried_groups.h). That pays where much of it dies in the section and would meet others if it were
// refined with them. Where little dies, it would cost: what lives is refined twice.
//
// An intersection of many operands is a special case. It is formed in *steps*, from left to right, and what dies
// in one step meets no later operand.
//
// Of the nodes that may be sections the choice looks at boxes and numbers of faces only. It changes costs; what
// else it changes is listed in csg/README.md (Refined apart).
#pragma once

#include <vector>

#include "csg/leaves/leaf.h"
#include "csg/tree/tree.h"
#include "csg/tree/unfold.h"

namespace cnrg {

struct Sections {
  std::vector<InstanceId> roots;  ///< ascending: sections below others come first
  std::vector<InstanceId> steps;  ///< ascending: intersections that are formed in steps
  bool empty() const { return roots.empty() && steps.empty(); }
};

/// `leaves` are numbered by `leaf_of`. No section holds an instance that was asked for. `all`:
/// whether it pays or not.
Sections choose_sections(const Tree& tree, const Unfolding& unfolding, const IdVector<InstanceId, LeafId>& leaf_of,
                         const std::vector<LeafInstance>& leaves, bool all);

}  // namespace cnrg

// Lines that leaves of a tree are to have besides those of their fineness (csg/carriers/extra_lines.h).
//
// A leaf is known by its node and by where it lies: all transforms from a root down to it (Instance::transform).
// So it is the same leaf below every node that places it alike, drawn together with others or alone, and its lines
// go with it.
#pragma once

#include <map>
#include <utility>

#include "csg/carriers/extra_lines.h"
#include "csg/geometry/placement.h"
#include "csg/tree/tree.h"

namespace cnrg {

struct Evaluation;

using LeafKey = std::pair<NodeId, Placement>;
struct LeafLines {
  std::map<LeafKey, ExtraLines> of;
};
/// Of the leaves of an evaluation, but for those below joined nodes.
std::map<LeafId, LeafKey> leaf_keys(const Evaluation& evaluation);

}  // namespace cnrg

// Attributes of the components of CNRG operators; the rules are those of cnrg.h.
#pragma once

#include <optional>
#include <vector>

#include "csg/operators/components.h"
#include "csg/operators/tables.h"

namespace cnrg {

struct Combined {
  ComponentAttributes attributes;
  std::vector<Yielded> yielded;  ///< what gave way without being dominated
};

/// Which of two components decides. `dominance` overrides their numbers.
Dominance dominant(const ComponentAttributes& a, const ComponentAttributes& b, std::optional<Dominance> dominance);

/// The attributes of what two components have in common. `dominance` overrides their numbers.
Combined combine(const ComponentAttributes& a, const ComponentAttributes& b, std::optional<Dominance> dominance);

/// Sets the leaves of each component from the origins of its cells.
void collect_leaves(Components& x);

}  // namespace cnrg

// Which parts of the operands of a fold may meet: connected sets of parts whose boxes do.
#pragma once

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include "csg/operators/parts.h"
#include "csg/operators/tables.h"

namespace cnrg {

/// Part `part` of operand `operand`.
struct PartPlace {
  std::uint32_t operand, part;
  friend auto operator<=>(const PartPlace&, const PartPlace&) = default;
};
using Cluster = std::vector<PartPlace>;  ///< ascending; two at least

/// The clusters of a fold in the order of their first parts. A part that meets none is in none. Parts of a union
/// hang together however they meet; those of an intersection or a difference by the first operand alone, as
/// nothing of the value is ever outside of it.
std::vector<Cluster> find_clusters(BooleanOp op, std::span<const PartedGroup> operands);

}  // namespace cnrg

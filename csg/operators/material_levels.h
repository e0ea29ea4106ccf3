// Booleans where materials say who dominates (sun2002; csg/SEMANTICS.md#dominance-of-materials).
//
// Of two regions that meet, the one whose material has the greater dominance wins; of equal ones the Boolean is
// that of equal dominance. One operand may win here and lose there, and a wall of it may have a winner on one side
// and a loser on the other, so no row of the tables can be asked about it with one dominance.
//
// So each operand is split by *level*, and every piece of it dominates or is dominated as a whole. The level of a
// region is the dominance of its material, 0 without one. A level of a group is a group by itself: its regions
// with all their walls, and entities that are no walls or that have a material of their own. A
// wall between two levels is in both.
//
//   union         From the lowest level up: what both operands have at a level is united with equal dominance, and
//                 that dominates in the union with all that is there already. Pieces of one operand never lie in
//                 each other's regions, so nothing of it is lost but to the other operand, and a union never
//                 removes what is an entity of both: the wall between two levels stays as long as one of them
//                 does.
//   intersection  For each level, what A has at it and B below it, what B has at it and A below it, and what both
//                 have at it: A n B is the union of these. The lower levels of an operand come together, not one
//                 by one, since a wall between two of them is to go where the other operand dominates both, and a
//                 group that has only one of them takes it for its boundary. Pieces of A n B then have no point in
//                 common but on walls, which are entities of both pieces: a union in the order of levels, of which
//                 each dominates what is there, loses none. (An entity in a region of its own operand is at that
//                 region's level at least, so it never comes before the region that it lies in; what both operands
//                 have at one level comes last of it, since there alone an entity may lie in a region of another
//                 piece.)
#pragma once

#include <optional>

#include "csg/operators/fold.h"

namespace cnrg {

/// A union or intersection in which materials decide. Removals: each cell that is gone counts once, by the row
/// of its relation under `dominance_at`.
FoldResult boolean_by_materials(const Complex& complex, BooleanOp op, PartedGroup left, PartedGroup right,
                                const LeafOrder& order = {});

/// The levels of both operands at a cell: of an entity the greatest around it, of another cell that of the region
/// that it is in, none outside.
struct LevelsAt {
  std::optional<Rational> left, right;
  /// Equal where one operand is not there.
  Dominance dominance() const;
};
template <class IdT>
LevelsAt levels_at(const Complex& complex, const Group& left, const Group& right, IdT cell);

}  // namespace cnrg

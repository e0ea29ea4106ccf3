// Group operators: Booleans by the paper's tables, complement, regularization (pereira2012 3;
// csg/SEMANTICS.md#the-tables).
//
// Both operands are groups on one complex. Rows of the tables remove entities, faces first, then edges, then
// vertices; regions follow from what is left. Nothing is constructed. The rows are data in tables.h and decided in
// table_engine.cpp; values that consist of parts far from each other go through fold.h.
#pragma once

#include <vector>

#include "csg/operators/attributes.h"
#include "csg/operators/group.h"
#include "csg/operators/tables.h"

namespace cnrg {

struct BooleanResult {
  Group group;
  Removals removals;                         ///< in the order of the tables
  std::vector<AttributeConflict> conflicts;  ///< in the order of the regions of `group`
};

/// left op right. `dominance` names the dominant operand; for union and intersection the operands swap roles when
/// it is the right one, so that A in a row id is the dominant operand. The difference ignores it.
/// The result takes the larger dominance number. Attributes of regions: csg/SEMANTICS.md#attributes; with equal
/// dominance an operand without a material or name yields to the other.
BooleanResult boolean_operation(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left,
                                const Group& right);

/// The group whose regions are all that is not inside a region of `g`, the unbounded included, with the walls
/// that bound them. Dangling entities of `g` vanish: they lie inside of the complement's regions.
Group complement(const Complex& complex, const Group& g);

/// Regions, the faces that bound one on exactly one side or separate two, their edges and vertices.
Group regularize(const Complex& complex, const Group& g);

}  // namespace cnrg

// Group Booleans by the paper's tables (pereira2012 3; csg/SEMANTICS.md#the-tables).
//
// Both operands are groups on one complex. Entities are classified by propagation (region labels are there
// already), removed by the rows of tables.h, faces first, then edges, then vertices; then regions are detected
// again. Nothing is constructed. The cost is that of the operands' cells and what is around them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "csg/operators/group.h"
#include "csg/operators/tables.h"

namespace cnrg {

/// Two materials of operands in one region of the result, where dominance does not decide.
struct MaterialConflict {
  std::uint32_t region = 0;    ///< region of the result, from 1; 0 in a step of a fold that is over
  RegionMaterial kept, other;  ///< `kept` is the left operand's
  CellSet cells;               ///< where `other` gave way
};

struct BooleanResult {
  Group group;
  /// Removed entities per table row (id), in table order; rows that removed nothing are left out.
  std::vector<std::pair<std::string, std::size_t>> removals;
  std::vector<MaterialConflict> conflicts;
};

/// Which operand is A in the rows, and whether it is dominant there.
struct Roles {
  bool swapped;   ///< A is the right operand
  bool dominant;  ///< the rows of A > B, and those of the difference
};
Roles roles(BooleanOp op, Dominance dominance);

/// A op B. `dominance` names the dominant operand; for union and intersection the operands swap roles when it
/// is the right one, so that A in a row id is the dominant operand. The difference ignores it.
/// The result takes the larger dominance number. Attributes of regions: csg/SEMANTICS.md#attributes; with equal
/// dominance an operand without a material or name yields to the other.
BooleanResult apply(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b);

/// The group whose regions are all that is not inside a region of `g`, the unbounded included, with the walls
/// that bound them. Dangling entities of `g` vanish: they lie inside of the complement's regions.
Group complement(const Complex& complex, const Group& g);

/// Regions, the faces that bound one on exactly one side or separate two, their edges and vertices.
Group regularize(const Complex& complex, const Group& g);

/// What became of one entity of the operands at one node, for `cnrg explain`.
struct Verdict {
  bool entity = false;  ///< of one of the operands; otherwise nothing else is set
  Relation relation = Relation::common;
  bool swapped = false;      ///< the right operand is A
  bool bounds_kept = false;  ///< kept since it bounds a kept face or edge; the row was not asked
  bool removed = false;
  const TableRow* row = nullptr;  ///< the row of its relation
  friend bool operator==(const Verdict&, const Verdict&) = default;
};
Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b,
                const Group& result, FaceId f);
Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b,
                const Group& result, EdgeId e);
Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& a, const Group& b,
                const Group& result, VertexId v);

/// Numbers the connected sets of 3-cells `inside` (ascending) that no face of `walls` (ascending) parts, from 1
/// in the order of their smallest cells.
std::vector<std::pair<RegionId, std::uint32_t>> detect_regions(const Complex& complex,
                                                               const std::vector<RegionId>& inside,
                                                               const std::vector<FaceId>& walls);

}  // namespace cnrg

// The decision of one Boolean about one entity, for `cnrg explain`.
#pragma once

#include "csg/operators/group.h"
#include "csg/operators/tables.h"

namespace cnrg {

/// An entity of the operands, the row that was to decide about it, and how that went.
struct Verdict {
  bool entity = false;  ///< of one of the operands; otherwise nothing else is set
  Relation relation = Relation::common;
  bool swapped = false;      ///< the right operand is A
  bool bounds_kept = false;  ///< kept since it bounds a kept face or edge; the row was not asked
  bool removed = false;
  const TableRow* row = nullptr;  ///< the row of its relation
  friend bool operator==(const Verdict&, const Verdict&) = default;
};
template <class IdT>
Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
                const Group& result, IdT cell);

}  // namespace cnrg

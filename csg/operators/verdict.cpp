// The verdict is read off afterwards: the operands tell the relation and so the row, the result tells what stayed.
// Nothing is evaluated again.
#include "csg/operators/verdict.h"

#include "csg/operators/bounds.h"

namespace cnrg {

template <class IdT>
Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
                const Group& result, IdT cell) {
  const auto [swapped, dominant] = roles(op, dominance);
  const Group& a = swapped ? right : left;
  const Group& b = swapped ? left : right;
  const bool of_a = a.has(cell), of_b = b.has(cell);
  Verdict out;
  if (!of_a && !of_b) return out;
  out.entity = true;
  out.swapped = swapped;
  out.relation = relation_of(of_a, of_b, (of_a ? b : a).region_of(complex.some_region(cell)) != 0);
  if constexpr (!std::is_same_v<IdT, FaceId>)
    out.bounds_kept = bounds_any(complex, cell, [&](auto other) { return result.has(other); });
  out.removed = !result.has(cell);
  out.row = &table_rows()[table_row(op, dominant, dimension_of(cell), out.relation)];
  return out;
}

template Verdict verdict(const Complex&, BooleanOp, Dominance, const Group&, const Group&, const Group&, FaceId);
template Verdict verdict(const Complex&, BooleanOp, Dominance, const Group&, const Group&, const Group&, EdgeId);
template Verdict verdict(const Complex&, BooleanOp, Dominance, const Group&, const Group&, const Group&, VertexId);

}  // namespace cnrg

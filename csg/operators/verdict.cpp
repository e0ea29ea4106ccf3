// The verdict is read off afterwards: the operands tell the relation and so the row, the result tells what stayed.
// Nothing is evaluated again.
#include "csg/operators/verdict.h"

#include "csg/operators/bounds.h"

namespace cnrg {
namespace {

template <class IdT>
Verdict judge(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
              const Group& result, IdT cell, int dimension, bool bounds_kept) {
  const auto [swapped, dominant] = roles(op, dominance);
  const Group& a = swapped ? right : left;
  const Group& b = swapped ? left : right;
  const bool of_a = a.has(cell), of_b = b.has(cell);
  Verdict out;
  if (!of_a && !of_b) return out;
  out.entity = true;
  out.swapped = swapped;
  out.relation = relation_of(of_a, of_b, (of_a ? b : a).region_of(complex.some_region(cell)) != 0);
  out.bounds_kept = bounds_kept;
  out.removed = !result.has(cell);
  out.row = &table_rows()[table_row(op, dominant, dimension, out.relation)];
  return out;
}

}  // namespace

Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
                const Group& result, FaceId f) {
  return judge(complex, op, dominance, left, right, result, f, 2, false);
}

Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
                const Group& result, EdgeId e) {
  const bool bounds = bounds_any(complex, e, [&](auto cell) { return result.has(cell); });
  return judge(complex, op, dominance, left, right, result, e, 1, bounds);
}

Verdict verdict(const Complex& complex, BooleanOp op, Dominance dominance, const Group& left, const Group& right,
                const Group& result, VertexId v) {
  const bool bounds = bounds_any(complex, v, [&](auto cell) { return result.has(cell); });
  return judge(complex, op, dominance, left, right, result, v, 0, bounds);
}

}  // namespace cnrg

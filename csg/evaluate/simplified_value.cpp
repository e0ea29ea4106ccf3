// `simplify` leaves cells in the order of the refinement's ids; `put_in_order` gives them the numbers people see.
#include "csg/evaluate/simplified_value.h"

#include "kernel/selection/canonical.h"

namespace cnrg {

SimplifiedComplex simplified_in_order(const Complex& complex, const NodeValue& value, const Selection& selection,
                                      SimplifyMode mode) {
  SimplifiedComplex made = simplify(complex, value, selection, mode);
  put_in_order(complex, made);
  return made;
}

const Selection& SimplifiedValue::selection() {
  if (!selection_) selection_ = selection_of(complex_, value_);
  return *selection_;
}

SimplifiedComplex& SimplifiedValue::get() {
  if (!made_) made_ = simplified_in_order(complex_, value_, selection());
  return *made_;
}

}  // namespace cnrg

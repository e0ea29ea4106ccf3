// The simplified complex of a value: what people see of it. Its cells have the numbers that files and messages
// use.
#pragma once

#include <optional>

#include "csg/operators/node_value.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

/// The simplified complex of a value with its cells in the order that depends on the result alone. `selection` is
/// that of the value.
SimplifiedComplex simplified_in_order(const Complex& complex, const NodeValue& value, const Selection& selection,
                                      SimplifyMode mode = SimplifyMode::features);

/// Made when it is first asked for, once: conflicts of materials name its cells, the row of the result has its
/// counts, the files of the result are it. Both `complex` and `value` must outlive this.
class SimplifiedValue {
 public:
  SimplifiedValue(const Complex& complex, const NodeValue& value) : complex_(complex), value_(value) {}
  const Selection& selection();
  SimplifiedComplex& get();

 private:
  const Complex& complex_;
  const NodeValue& value_;
  std::optional<Selection> selection_;
  std::optional<SimplifiedComplex> made_;
};

}  // namespace cnrg

// The simplified complex of a value. Files and messages use the numbers of its cells.
#pragma once

#include <memory>

#include "kernel/complex/complex.h"
#include "kernel/selection/simplify.h"

namespace cnrg {

class NodeValue;

/// Made when it is first asked for, once, and shared by copies: conflicts of materials name its cells, the row of
/// the result has their counts, the files of the result are it; and often nobody asks. It shares the complex and
/// the value. Several threads may ask at a time.
class SimplifiedValue {
 public:
  SimplifiedValue(std::shared_ptr<const Complex> complex, std::shared_ptr<const NodeValue> value,
                  SimplifyMode mode = SimplifyMode::features);
  /// Its cells are in an order that depends on the value alone (kernel/selection/canonical.h).
  const SimplifiedComplex& operator*() const;
  const SimplifiedComplex* operator->() const { return &**this; }
  std::shared_ptr<const SimplifiedComplex> share() const;
  /// For less than the complex itself: no cell needs its number.
  const CellCounts& counts() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace cnrg

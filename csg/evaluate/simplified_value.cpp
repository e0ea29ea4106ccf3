// `simplify` leaves cells in the order of the refinement's ids; `put_in_order` gives them the numbers people see.
#include "csg/evaluate/simplified_value.h"

#include <mutex>
#include <utility>

#include "csg/operators/node_value.h"
#include "kernel/selection/canonical.h"

namespace cnrg {

struct SimplifiedValue::State {
  std::shared_ptr<const Complex> complex;
  std::shared_ptr<const NodeValue> value;
  SimplifyMode mode;
  std::once_flag made, ordered;
  SimplifiedComplex cells{};
  CellCounts counts{};

  void make() {
    std::call_once(made, [&] {
      const Selection selection = selection_of(*complex, *value);
      cells = simplify(*complex, *value, selection, mode);
      counts.raw = {selection.vertices.size(), selection.edges.size(), selection.faces.size(),
                    selection.regions.size()};
      counts.simplified = active_counts(cells);
    });
  }
  void order() {
    make();
    std::call_once(ordered, [&] { put_in_order(*complex, cells); });
  }
};

SimplifiedValue::SimplifiedValue(std::shared_ptr<const Complex> complex, std::shared_ptr<const NodeValue> value,
                                 SimplifyMode mode)
    : state_(std::make_shared<State>()) {
  state_->complex = std::move(complex);
  state_->value = std::move(value);
  state_->mode = mode;
}

const SimplifiedComplex& SimplifiedValue::operator*() const {
  state_->order();
  return state_->cells;
}

std::shared_ptr<const SimplifiedComplex> SimplifiedValue::share() const { return {state_, &**this}; }

const CellCounts& SimplifiedValue::counts() const {
  state_->make();
  return state_->counts;
}

}  // namespace cnrg

// The values of instances for as long as somebody needs them.
//
// A value has one use for each place where it is an operand and one more if it is a root's. When an operator has
// run, its operands lose the uses that it was: a value that has none left is freed. The uses of roots are never
// taken back, so their values stay; with `keep_all` every value stays. Peak memory is that of the values that are
// in use at a time: of a chain of nodes one or two, however long it is.
#pragma once

#include <memory>
#include <span>
#include <utility>

#include "csg/operators/node_value.h"
#include "csg/tree/unfold.h"

namespace cnrg {

class ValueStore {
 public:
  ValueStore(std::size_t instances, bool keep_all) : keep_all_(keep_all), values_(instances), uses_(instances) {}
  /// Before anything is evaluated: an operator that is going to run takes the value, or a root is.
  void add_use(InstanceId id) { ++uses_[id]; }

  void put(InstanceId id, NodeValue value) { values_[id] = std::make_shared<NodeValue>(std::move(value)); }
  /// False before it was put and after it was freed.
  bool has(InstanceId id) const { return values_[id] != nullptr; }
  /// The value must be there. It stays where it is until it is freed.
  NodeValue& operator[](InstanceId id) { return *values_[id]; }
  std::size_t size() const { return values_.size(); }
  std::shared_ptr<const NodeValue> share(InstanceId id) const { return values_[id]; }

  /// Whether only one use is left: that of the operator that runs now, or of a root.
  bool used_once_more(InstanceId id) const { return uses_[id] == 1; }
  /// Whether the operator that runs now may take the value apart, since nobody sees it afterwards.
  bool expendable(InstanceId operand) const { return used_once_more(operand) && !keep_all_; }
  /// The operator that takes these has run.
  void release(std::span<const InstanceId> operands) {
    for (const InstanceId operand : operands) {
      if (--uses_[operand] == 0 && !keep_all_) values_[operand].reset();
    }
  }

  /// Of all instances, by InstanceId; empty places for those that were freed.
  IdVector<InstanceId, std::shared_ptr<const NodeValue>> take() {
    IdVector<InstanceId, std::shared_ptr<const NodeValue>> all;
    for (std::shared_ptr<NodeValue>& value : values_) all.push_back(std::move(value));
    return all;
  }

 private:
  bool keep_all_;
  IdVector<InstanceId, std::shared_ptr<NodeValue>> values_;
  IdVector<InstanceId, std::size_t> uses_;
};

}  // namespace cnrg

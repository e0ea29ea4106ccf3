// Uses are counted from the unfolding, before anything is evaluated.
#include "csg/evaluate/value_store.h"

#include <utility>

namespace cnrg {

ValueStore::ValueStore(const Unfolding& unfolding, bool keep_all)
    : unfolding_(unfolding),
      keep_all_(keep_all),
      values_(unfolding.instances.size()),
      uses_(unfolding.instances.size()) {
  for (const Instance& instance : unfolding.instances) {
    for (const InstanceId operand : instance.operands) ++uses_[operand];
  }
  for (const InstanceId root : unfolding.roots) ++uses_[root];
}

void ValueStore::put(InstanceId id, NodeValue value) {
  values_[id] = std::make_shared<NodeValue>(std::move(value));
}

void ValueStore::release_operands(InstanceId user) {
  for (const InstanceId operand : unfolding_.instances[user].operands) {
    if (--uses_[operand] == 0 && !keep_all_) values_[operand].reset();
  }
}

IdVector<InstanceId, std::shared_ptr<const NodeValue>> ValueStore::take() {
  IdVector<InstanceId, std::shared_ptr<const NodeValue>> all;
  for (std::shared_ptr<NodeValue>& value : values_) all.push_back(std::move(value));
  return all;
}

}  // namespace cnrg

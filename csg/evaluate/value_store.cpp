#include "csg/evaluate/value_store.h"

#include <utility>

namespace cnrg {

ValueStore::ValueStore(std::size_t instances, bool keep_all)
    : keep_all_(keep_all), values_(instances), uses_(instances) {}

void ValueStore::put(InstanceId id, NodeValue value) {
  values_[id] = std::make_shared<NodeValue>(std::move(value));
}

void ValueStore::release(std::span<const InstanceId> operands) {
  for (const InstanceId operand : operands) {
    if (--uses_[operand] == 0 && !keep_all_) values_[operand].reset();
  }
}

IdVector<InstanceId, std::shared_ptr<const NodeValue>> ValueStore::take() {
  IdVector<InstanceId, std::shared_ptr<const NodeValue>> all;
  for (std::shared_ptr<NodeValue>& value : values_) all.push_back(std::move(value));
  return all;
}

}  // namespace cnrg

#include "csg/evaluate/leaf_lines.h"

#include "csg/evaluate/evaluate.h"
#include "csg/evaluate/leaf_numbers.h"

namespace cnrg {

std::map<LeafId, LeafKey> leaf_keys(const Evaluation& evaluation) {
  std::map<LeafId, LeafKey> keys;
  for (const InstanceId id : IdRange<InstanceId>(evaluation.instances.size())) {
    const LeafId leaf = evaluation.leaves->of(id);
    const Instance& instance = evaluation.instances[id];
    if (leaf.valid()) keys.emplace(leaf, LeafKey(instance.node, Placement(*instance.transform)));
  }
  return keys;
}

}  // namespace cnrg

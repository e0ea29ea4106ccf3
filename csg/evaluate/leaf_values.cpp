// One pass over the complex gives the groups of all leaves. Most are values as they are; the cells of a result
// that was read back may be open or of many components, which its file tells cell by cell.
#include "csg/evaluate/leaf_values.h"

#include <utility>
#include <vector>

#include "csg/evaluate/operate.h"
#include "csg/leaves/cell_table.h"
#include "csg/operators/group.h"
#include "csg/operators/leaf_value.h"

namespace cnrg {
namespace {

/// A leaf's own value, without the attributes of its node; of a result read back by its cell table.
NodeValue value_of(const Tree& tree, const PreparedLeaves& leaves, const Instance& placed, Grades& grades,
                   const Complex& complex, LeafId leaf, Group group) {
  const LeafInstance& instance = leaves.instances()[leaf.index()];
  const CellTable* table = instance.leaf->cells();
  if (table == nullptr) return {complex, std::move(group)};
  try {
    const auto count = static_cast<std::uint32_t>(instance.leaf->regions().size());
    return leaf_value(complex, leaf, group, *table, instance.transform,
                      leaves.attributes(leaf, count, placed, grades));
  } catch (const InputError& e) {
    throw TreeError(tree.file, leaves.node_of(leaf).operator_at, e.what());
  }
}

}  // namespace

void put_leaf_values(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves, Grades& grades,
                     const Complex& complex, ValueStore& values) {
  const IdVector<InstanceId, Instance>& instances = unfolding.instances;
  std::vector<std::vector<RegionAttributes>> attributes;
  for (const InstanceId i : IdRange<InstanceId>(instances.size())) {  // leaves come in this order
    const LeafId leaf = leaves.leaf_of(i);
    if (!leaf.valid()) continue;
    attributes.push_back(leaves.attributes(leaf, complex.leaf_regions[leaf], instances[i], grades));
  }
  std::vector<Group> groups = leaf_groups(complex, attributes);
  for (const InstanceId i : IdRange<InstanceId>(instances.size())) {
    const LeafId leaf = leaves.leaf_of(i);
    if (!leaf.valid()) continue;
    NodeValue value = value_of(tree, leaves, instances[i], grades, complex, leaf, std::move(groups[leaf.index()]));
    // Without a material: the regions of a leaf have theirs already.
    apply_attributes(complex, tree.nodes[instances[i].node], {}, value);
    values.put(i, std::move(value));
  }
}

}  // namespace cnrg

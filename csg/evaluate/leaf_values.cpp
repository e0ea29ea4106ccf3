// One pass over the complex gives the groups of all leaves. Most are values as they are; the cells of a result
// that was read back may be open or of many components, which is stored cell by cell; so is one that was
// joined.
#include "csg/evaluate/leaf_values.h"

#include <utility>
#include <vector>

#include "csg/evaluate/operate.h"
#include "csg/operators/group.h"
#include "csg/operators/say.h"

namespace cnrg {
namespace {

/// A leaf's value; its regions have their attributes already. That of a result is stored.
NodeValue value_of(const Tree& tree, const PreparedLeaves& leaves, const Instance& placed, Grades& grades,
                   const Complex& complex, LeafId leaf, Group group, const CellMap& map, HeldCells& held) {
  const LeafInstance& instance = leaves.instances()[leaf.index()];
  const Node& node = tree.nodes[placed.node];
  Attributes own;
  if (!node.within) own = {node.label, grades.on(placed, node.material), node.properties};
  const StoredValue* stored = instance.leaf->stored();
  if (stored == nullptr) {
    say(complex, own, Saying::fills_in, group);
    return {complex, std::move(group)};
  }
  try {
    const auto count = static_cast<std::uint32_t>(instance.leaf->regions().size());
    const auto moved = [&](Attributes said) {
      said.material = grades.moved(placed, said.material);
      return said;
    };
    NodeValue value = leaf_value(complex, leaf, group, *stored, map,
                                 leaves.attributes(leaf, count, placed, grades), moved, &held);
    if (value.is_group()) {
      value.parts() =
          changed(complex, value.parts(), [&](Group& part) { say(complex, own, Saying::fills_in, part); });
    } else {
      say(complex, own, Saying::fills_in, value.components());
    }
    return value;
  } catch (const InputError& e) {
    throw TreeError(tree.file, leaves.node_of(leaf).operator_at, e.what());
  }
}

/// Of the cells of results among the leaves.
CellMap map_of_results(std::span<const InstanceId> instances, const PreparedLeaves& leaves, const Complex& complex,
                       const Soup& soup, const std::vector<VertexId>& vertex_of) {
  std::vector<CellMap::Part> parts;
  for (const InstanceId i : instances) {
    const LeafId leaf = leaves.leaf_of(i);
    const StoredValue* stored = leaf.valid() ? leaves.instances()[leaf.index()].leaf->stored() : nullptr;
    if (stored == nullptr) continue;
    parts.push_back(part_of(leaf, *stored, std::span(vertex_of).subspan(soup.first_point(leaf).index())));
  }
  return parts.empty() ? CellMap() : CellMap(complex, parts);
}

}  // namespace

HeldCells put_leaf_values(const Tree& tree, const Unfolding& unfolding, std::span<const InstanceId> instances,
                          const PreparedLeaves& leaves, Grades& grades, const Complex& complex, const Soup& soup,
                          const std::vector<VertexId>& vertex_of, ValueStore& values) {
  std::vector<std::vector<Attributes>> attributes(leaves.instances().size());
  for (const InstanceId i : instances) {
    const LeafId leaf = leaves.leaf_of(i);
    if (!leaf.valid()) continue;
    attributes[leaf.index()] = leaves.attributes(leaf, complex.leaf_regions[leaf], unfolding.instances[i], grades);
  }
  std::vector<Group> groups = leaf_groups(complex, attributes);
  const CellMap map = map_of_results(instances, leaves, complex, soup, vertex_of);
  HeldCells held;
  for (const InstanceId i : instances) {
    const LeafId leaf = leaves.leaf_of(i);
    if (!leaf.valid()) continue;
    const Instance& instance = unfolding.instances[i];
    NodeValue value =
        value_of(tree, leaves, instance, grades, complex, leaf, std::move(groups[leaf.index()]), map, held);
    // Without a material: a leaf has its attributes already. A node that joins speaks as an operator does.
    const Node& node = tree.nodes[instance.node];
    apply_attributes(complex, node, node.within ? grades.on(instance, node.material) : RegionMaterial(), value);
    values.put(i, std::move(value));
  }
  return held;
}

}  // namespace cnrg

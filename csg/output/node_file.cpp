// From an evaluated node to what writers see of it.
#include "csg/output/node_file.h"

#include <algorithm>

namespace cnrg {
namespace {

/// The tree's materials, and those that only results read back as leaves bring along.
std::vector<ResultView::Material> materials_of(const Tree& tree, const NodeValue& value) {
  std::vector<ResultView::Material> materials;
  for (const Material& m : tree.materials) materials.push_back({m.name, m.color});
  for (Component i = 1; i <= value.component_count(); ++i) {
    const std::string& name = value.attributes(i).material;
    const auto same = [&](const ResultView::Material& m) { return m.name == name; };
    if (name.empty() || std::any_of(materials.begin(), materials.end(), same)) continue;
    materials.push_back({name, ""});
  }
  return materials;
}

}  // namespace

RoundingReport write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node) {
  const KeptValue& value = evaluation.value(node);
  std::vector<LeafInfo> leaves;
  for (const std::string& name : evaluation.leaf_names) leaves.push_back({name});
  ResultView view;
  view.node = tree.nodes[node].name;
  view.complex = evaluation.complex.get();
  view.value = value.value.get();
  view.simplified = &value.simplified;
  view.leaves = &leaves;
  view.materials = materials_of(tree, *value.value);
  view.sources = value.leaves;
  try {
    return write(path, view);
  } catch (const InputError& e) {  // the format can not show this node
    throw TreeError(tree.file, tree.nodes[node].at, e.what());
  }
}

}  // namespace cnrg

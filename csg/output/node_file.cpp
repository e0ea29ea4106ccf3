// From an evaluated node to what writers see of it.
#include "csg/output/node_file.h"

#include <algorithm>

#include "csg/output/dag_graph.h"
#include "csg/output/file.h"
#include "csg/output/region_graph.h"

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

bool shows_regions(const std::string& path) {
  return extension_of(path) == ".dot" && extension_of(path.substr(0, path.size() - 4)) == ".regions";
}

}  // namespace

bool shows_dag(const std::string& path) { return extension_of(path) == ".dot" && !shows_regions(path); }

void check_file_name(const std::string& path) {
  if (extension_of(path) == ".dot") return;
  try {
    check_extension(path);
  } catch (const InputError& e) {
    throw InputError(std::string(e.what()) + " .dot .regions.dot");
  }
}

RoundingReport write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node) {
  const KeptValue& value = evaluation.value(node);
  if (extension_of(path) == ".dot") {
    replace_file(path, shows_dag(path) ? dag_dot(evaluation)
                                       : region_graph(value.simplified, value.value->attributes()).dot());
    return {};
  }
  std::vector<LeafInfo> leaves;
  for (const std::string& name : evaluation.leaf_names) leaves.push_back({name});
  ResultView view;
  view.node = tree.nodes[node].name;
  view.complex = evaluation.complex.get();
  view.value = value.value.get();
  view.simplified = &value.simplified;
  view.leaves = &leaves;
  view.materials = materials_of(tree, *value.value);
  try {
    return write(path, view);
  } catch (const InputError& e) {  // the format can not show this node
    throw TreeError(tree.file, tree.nodes[node].at, e.what());
  }
}

}  // namespace cnrg

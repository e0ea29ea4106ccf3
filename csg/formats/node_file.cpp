// From an evaluated node to what writers see of it.
#include "csg/formats/node_file.h"

#include <algorithm>

#include "csg/formats/dag_graph.h"
#include "csg/formats/formats.h"
#include "csg/mesh/material_field.h"
#include "csg/text/file.h"
#include "csg/topology/region_graph.h"

namespace cnrg {
namespace {

/// The tree's materials, and those that only results read back as leaves bring along.
std::vector<ResultView::Material> materials_of(const Tree& tree, const NodeValue& value) {
  std::vector<ResultView::Material> materials;
  for (const Material& m : tree.materials) materials.push_back({m.name, m.color});
  for (Component i = 1; i <= value.component_count(); ++i) {
    const std::string& name = value.attributes(i).material.name();
    const auto same = [&](const ResultView::Material& m) { return m.name == name; };
    if (name.empty() || std::any_of(materials.begin(), materials.end(), same)) continue;
    materials.push_back({name, ""});
  }
  return materials;
}

/// What writers see of a node, and what that refers to.
class NodeView {
 public:
  NodeView(const Tree& tree, const Evaluation& evaluation, NodeId node, bool parameters = false) {
    const KeptValue& value = evaluation.value(node);
    for (const std::string& name : evaluation.leaf_names) leaves_.push_back({name});
    view_.node = tree.nodes[node].name;
    view_.complex = evaluation.complex.get();
    view_.value = value.value.get();
    view_.simplified = &value.simplified;
    view_.leaves = &leaves_;
    if (parameters) view_.parameters = evaluation.parameters.get();
    view_.materials = materials_of(tree, *value.value);
  }
  NodeView(const NodeView&) = delete;
  NodeView& operator=(const NodeView&) = delete;
  const ResultView& view() const { return view_; }
  ResultView view(const SnappedResult* snapped) const {
    return snapped == nullptr ? view_ : snapped->shown(view_);
  }

 private:
  std::vector<LeafInfo> leaves_;
  ResultView view_;
};

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

bool is_exact(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".json" || extension == ".dot";
}

SnappedResult snap(const Tree& tree, const Evaluation& evaluation, NodeId node, bool raw) {
  const NodeView shown(tree, evaluation, node);
  try {
    return SnappedResult(shown.view(), raw);
  } catch (const InputError& e) {
    throw TreeError(tree.file, tree.nodes[node].at, e.what());
  }
}

RoundingReport write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node,
                     const FileOptions& options) {
  const KeptValue& value = evaluation.value(node);
  if (extension_of(path) == ".dot") {
    replace_file(path, shows_dag(path) ? dag_dot(evaluation)
                                       : region_graph(value.simplified, value.value->attributes()).dot());
    return {};
  }
  const NodeView shown(tree, evaluation, node, options.parameters);
  try {
    return write(path, shown.view(is_exact(path) ? nullptr : options.snapped));
  } catch (const InputError& e) {  // the format can not show this node
    throw TreeError(tree.file, tree.nodes[node].at, e.what());
  }
}

void check_mesh_file_name(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".msh" || extension == ".mesh" || extension == ".vtu") return;
  const bool surface = extension == ".smesh" || extension == ".poly";
  throw InputError(path +
                   (surface ? ": this format holds faces and no tetrahedra; `cnrg eval -o` writes it"
                            : ": no writer of tetrahedra for the extension `" + extension + "`") +
                   "; use one of .msh .mesh .vtu");
}

TetrahedralMesh tetrahedra(const Tree& tree, const Evaluation& evaluation, NodeId node,
                           const TetrahedraOptions& options, const SnappedResult* snapped) {
  const NodeView shown(tree, evaluation, node);
  try {
    TetrahedralMesh made = tetrahedra(shown.view(snapped), options);
    sample_materials(shown.view(snapped), made.mesh);
    return made;
  } catch (const InputError& e) {
    throw TreeError(tree.file, tree.nodes[node].at, e.what());
  }
}

void write(const std::string& path, const Tree& tree, const Evaluation& evaluation, NodeId node,
           const Mesh& mesh) {
  check_mesh_file_name(path);
  const NodeView shown(tree, evaluation, node);
  const std::string extension = extension_of(path);
  replace_file(path, extension == ".msh"    ? msh_text(mesh)
                     : extension == ".mesh" ? medit_text(mesh)
                                            : vtu_text(shown.view(), mesh));
}

}  // namespace cnrg

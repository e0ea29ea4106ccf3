// Nodes of B come behind those of A; positions, and so messages, are those of the files apart, and who evaluates
// the two together asks each alone for its faults.
#include "csg/compare/together.h"

#include <algorithm>
#include <filesystem>

#include "csg/text/file.h"
#include "csg/text/input_file.h"
#include "csg/tree/dag.h"

namespace cnrg {
namespace {

void refuse_weld(const Tree& tree, NodeId node) {
  if (!tree.weld) return;
  throw TreeError(tree.file, tree.weld_at,
                  "`weld` joins what is near in this tree alone, and here the leaves of two trees are cut by each "
                  "other; write the result by `cnrg eval " +
                      tree.file + (node == tree.result ? "" : " --node " + tree.nodes[node].name) +
                      " -o FILE.json` and compare that file");
}

class Joiner {
 public:
  Joiner(const Tree& a, const Tree& b) {
    // Longer than any run of this character in a name, so that no name can have it by itself.
    std::size_t longest = 0;
    const auto look = [&](const std::string& name) {
      std::size_t run = 0;
      for (const char c : name) longest = std::max(longest, run = c == '\x01' ? run + 1 : 0);
    };
    for (const Tree* tree : {&a, &b}) {
      for (const Node& node : tree->nodes) look(node.name), look(node.label);
      for (const Material& material : tree->materials) look(material.name);
    }
    out_.node_mark = std::string(longest + 1, '\x01') + "n";
    out_.material_mark = std::string(longest + 1, '\x01') + "b";
    out_.tree.file = a.file;
    out_.tree.nodes_at = a.nodes_at;
  }

  void add(const Tree& tree, NodeId root, int side) {
    const std::string mark = side == 0 ? "" : out_.material_mark;
    const auto marked = [&](std::string& name) {
      if (!name.empty()) name.insert(0, mark);
    };
    const std::size_t first = out_.tree.nodes.size();
    const std::vector<char> used = tree.dag->reachable({root});
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      Node node = tree.nodes[id];
      if (used[id.index()]) note(node, side);
      node.name.insert(0, out_.node_mark);
      marked(node.material);
      if (auto* group = node.shape ? std::get_if<GroupShape>(&*node.shape) : nullptr) {
        for (auto& [number, region] : group->regions) marked(region.material);
      }
      out_.tree.nodes.push_back(std::move(node));
      dag_.add_node();
    }
    for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
      for (const NodeId operand : tree.operands(id)) {
        dag_.add_operand(NodeId(first + id.index()), NodeId(first + operand.index()), {});
      }
    }
    for (const auto& [name, id] : tree.names) out_.tree.names.emplace(mark + name, NodeId(first + id.index()));
    for (Material material : tree.materials) {
      marked(material.name);
      auto* const distance = material.grade ? std::get_if<DistanceGrade>(&material.grade->along) : nullptr;
      if (distance != nullptr) marked(distance->to);
      out_.tree.materials.push_back(std::move(material));
    }
    out_.nodes[static_cast<std::size_t>(side)] = NodeId(first + root.index());
  }

  Together take() {
    out_.tree.result = out_.nodes[0];
    out_.tree.dag = std::make_shared<const Dag>(std::move(dag_));
    return std::move(out_);
  }

 private:
  /// Words of a name, as operators join them.
  static void add_words(const std::string& name, std::set<std::string>& words) {
    for (std::size_t begin = 0; !name.empty() && begin <= name.size();) {
      const std::size_t end = std::min(name.find(" & ", begin), name.size());
      words.insert(name.substr(begin, end - begin));
      begin = end + 3;
    }
  }

  void note(const Node& node, int side) {
    std::set<std::string>& named = out_.named[static_cast<std::size_t>(side)];
    add_words(node.label, named);
    if (!node.shape) return;
    if (std::holds_alternative<ResultShape>(*node.shape)) out_.reads_result[static_cast<std::size_t>(side)] = true;
    if (const auto* group = std::get_if<GroupShape>(&*node.shape)) {
      for (const auto& [number, region] : group->regions) {
        add_words(region.name, named);
      }
    }
  }

  Together out_;
  Dag dag_;
};

/// A tree may be JSON, too. What tells it from a result is the first key: those of a result are others, but for
/// `materials`, which is a list there.
bool is_result(const std::string& path) {
  constexpr std::size_t kEnough = 4096;
  const std::string whole = read_file(path);
  const std::string text(without_mark(whole).substr(0, kEnough));
  const std::size_t open = text.find_first_not_of(" \t\r\n");
  if (open == std::string::npos || text[open] != '{') return false;
  const std::size_t quote = text.find_first_not_of(" \t\r\n", open + 1);
  if (quote == std::string::npos || text[quote] != '"') return false;
  const std::size_t end = text.find('"', quote + 1);
  if (end == std::string::npos) return false;
  const std::string key = text.substr(quote + 1, end - quote - 1);
  if (key == "materials") {
    const std::size_t value = text.find_first_not_of(" \t\r\n:", end + 1);
    return value != std::string::npos && text[value] == '[';
  }
  return key != "cnrg" && key != "nodes" && key != "result" && key != "weld";
}

std::optional<std::pair<Shape, const char*>> shape_of(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == ".off" || extension == ".obj" || extension == ".stl" || extension == ".ply") {
    MeshShape mesh;
    mesh.file = path;
    return std::pair(Shape(mesh), "mesh");
  }
  if (extension == ".step" || extension == ".stp" || extension == ".brep") {
    CadShape cad;
    cad.format = extension == ".brep" ? CadShape::Format::brep : CadShape::Format::step;
    cad.file = path;
    return std::pair(Shape(cad), cad.name());
  }
  if (extension == ".json" && is_result(path)) return std::pair(Shape(ResultShape{path}), "cnrg");
  return std::nullopt;
}

}  // namespace

Together together(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b) {
  refuse_weld(a, node_a);
  refuse_weld(b, node_b);
  Joiner joiner(a, b);
  joiner.add(a, node_a, 0);
  joiner.add(b, node_b, 1);
  return joiner.take();
}

Tree tree_of_file(const std::string& path, const ReadOptions& options) {
  auto found = shape_of(path);
  if (!found) return read_tree(path, options);
  Tree tree;
  tree.file = path;
  Node node;
  node.name = std::filesystem::path(path).stem().string();
  node.operator_name = found->second;
  node.shape = std::move(found->first);
  Dag dag;
  tree.result = dag.add_node();
  tree.names.emplace(node.name, tree.result);
  tree.nodes.push_back(std::move(node));
  tree.dag = std::make_shared<const Dag>(std::move(dag));
  return tree;
}

}  // namespace cnrg

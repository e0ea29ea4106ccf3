// Nodes of B are appended to the nodes of A. Positions stay those of the two files, so messages name the right
// file; faults are found by evaluating each tree alone.
#include "csg/compare/together.h"

#include <algorithm>

#include "csg/tree/dag.h"
#include "csg/tree/selector.h"

namespace cnrg {
namespace {

/// Sides of walls that may be called in any of the `ways` of a name.
template <class Ways>
void accept(std::vector<std::array<SideName, 2>>& between, Ways ways) {
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<std::array<SideName, 2>> accepted;
    for (const std::array<SideName, 2>& sides : between) {
      if (!sides[side]) accepted.push_back(sides);
      else
        for (const std::string& way : ways(*sides[side])) {
          accepted.push_back(sides);
          accepted.back()[side] = way;
        }
    }
    between = std::move(accepted);
  }
}

class Joiner {
 public:
  explicit Joiner(const std::string& mark) : mark_(mark) {}

  void add(const Tree& tree, NodeId root, std::size_t side) {
    const std::string mark = side == 0 ? "" : mark_;
    const auto mark_it = [&](std::string& name) {
      if (!name.empty()) name.insert(0, mark);
    };
    const std::size_t first = out_.tree.nodes.size();
    for (Node node : tree.nodes) {
      mark_it(node.material);
      if (node.selector) node.selector = joined(*node.selector, first, side);
      if (auto* group = node.shape ? std::get_if<GroupShape>(&*node.shape) : nullptr) {
        for (auto& [number, region] : group->regions) mark_it(region.material);
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
      mark_it(material.name);
      auto* const distance = material.grade ? std::get_if<DistanceGrade>(&material.grade->along) : nullptr;
      if (distance != nullptr) mark_it(distance->to);
      if (material.grade) {
        for (Grade::Stop& stop : material.grade->stops) {
          for (auto& part : stop.mixture) mark_it(part.first);
        }
      }
      out_.tree.materials.push_back(std::move(material));
    }
    out_.nodes[side] = NodeId(first + root.index());
  }

  Together take(const std::string& file) {
    out_.tree.file = file;
    out_.tree.result = out_.nodes[0];
    out_.tree.dag = std::make_shared<const Dag>(std::move(dag_));
    return std::move(out_);
  }

 private:
  /// Nodes by their new numbers, materials with their mark.
  std::shared_ptr<const Selector> joined(Selector selector, std::size_t first, std::size_t side) const {
    for (NodeId& node : selector.from) node = NodeId(first + node.index());
    for (Selector::Side& one : selector.sides) one.of = NodeId(first + one.of.index());
    if (side == 1) {
      for (std::string& name : selector.criteria.materials) name.insert(0, mark_);
      accept(selector.criteria.between, [&](const std::string& name) { return std::array{name, mark_ + name}; });
    }
    return std::make_shared<const Selector>(std::move(selector));
  }

  const std::string& mark_;
  Together out_;
  Dag dag_;
};

}  // namespace

std::string unused_mark(const Tree& a, const Tree& b) {
  // Longer than any run of this character in a name, so that no name can have it by itself.
  std::size_t longest = 0;
  for (const Tree* tree : {&a, &b}) {
    for (const Material& each : tree->materials) {
      std::size_t run = 0;
      for (const char c : each.name) longest = std::max(longest, run = c == '\x01' ? run + 1 : 0);
    }
  }
  return std::string(longest + 1, '\x01') + "b";
}

Together together(const Tree& a, NodeId node_a, const Tree& b, NodeId node_b, const std::string& mark) {
  Joiner joiner(mark);
  joiner.add(a, node_a, 0);
  joiner.add(b, node_b, 1);
  return joiner.take(a.file);
}

}  // namespace cnrg

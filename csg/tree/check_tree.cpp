#include "csg/tree/check_tree.h"

#include <algorithm>

#include "csg/tree/selector.h"
#include "csg/tree/suggest.h"

namespace cnrg {
namespace {

[[noreturn]] void fail_as_not_below(const Tree& tree, const std::string& file, NodeId of, NodeId from,
                                    Position at) {
  throw TreeError(file, at,
                  "nothing of `" + tree.nodes[of].name + "` is from `" + tree.nodes[from].name +
                      "`; name a leaf or another node that it is made of");
}

}  // namespace

void check_selectors(const Tree& tree, const Dag& dag) {
  NodeId last;  // many pick from one node
  std::vector<char> below;
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    const Node& node = tree.nodes[id];
    if (node.op != Operator::select || (node.selector->from.empty() && node.selector->sides.empty())) continue;
    const NodeId of = dag.operands(id).front();
    if (last != of) below = dag.reachable({of});
    last = of;
    for (const NodeId from : node.selector->from) {
      if (!node.selector->criteria.source_faces.empty() && tree.nodes[from].op != Operator::leaf) {
        throw TreeError(node.selector->file, node.selector->from_at,
                        "`source face` is a face of a leaf, and `" + tree.nodes[from].name + "` is a `" +
                            tree.nodes[from].operator_name + "`; name the leaf");
      }
      if (!below[from.index()]) fail_as_not_below(tree, node.selector->file, of, from, node.selector->from_at);
    }
    for (const Selector::Side& side : node.selector->sides) {
      if (!below[side.of.index()]) fail_as_not_below(tree, node.selector->file, of, side.of, side.at);
    }
  }
}

void check_distances(const Tree& tree) {
  for (const Material& m : tree.materials) {
    const auto* distance = m.grade ? std::get_if<DistanceGrade>(&m.grade->along) : nullptr;
    if (distance == nullptr || tree.names.count(distance->to) != 0) continue;
    std::vector<std::string_view> known;
    for (const auto& [key, id] : tree.names) known.push_back(key);
    const std::string hint = did_you_mean(distance->to, known);
    throw TreeError(tree.file, m.to_at,
                    "there is no node called `" + distance->to + "` to measure a distance to" +
                        (hint.empty() ? "; use one of the names in `nodes`" : hint));
  }
}

void check_graph(const Tree& tree, const Dag& dag) {
  const Dag::Cycle cycle = dag.find_cycle();
  if (!cycle.nodes.empty()) {
    constexpr std::size_t kListed = 20;
    std::string way;
    for (std::size_t i = 0; i < std::min(cycle.nodes.size(), kListed); ++i) {
      const Node& node = tree.nodes[cycle.nodes[i]];
      way += "`" + node.name + "` (line " + std::to_string(node.at.line) + ") -> ";
    }
    if (cycle.nodes.size() > kListed) way += std::to_string(cycle.nodes.size() - kListed) + " more -> ";
    throw TreeError(tree.file, cycle.mention,
                    "these nodes use each other in a cycle: " + way + "`" + tree.nodes[cycle.nodes.front()].name +
                        "`; remove one of the uses");
  }
}

}  // namespace cnrg

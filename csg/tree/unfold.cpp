// A depth-first walk with its own stack; transforms are interned so that instances compare by number.
#include "csg/tree/unfold.h"

#include <algorithm>
#include <array>
#include <map>

namespace cnrg {
namespace {

using Coefficients = std::array<Rational, 12>;

Coefficients coefficients(const Transform& t) {
  Coefficients result;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) result[4 * i + j] = t.linear[i][j];
    result[4 * i + 3] = t.offset[i];
  }
  return result;
}

/// Numbers for equal transforms.
class TransformTable {
 public:
  std::size_t intern(const Transform& t) {
    const auto [it, added] = numbers_.emplace(coefficients(t), transforms_.size());
    if (added) transforms_.push_back(t);
    return it->second;
  }
  const Transform& operator[](std::size_t i) const { return transforms_[i]; }

 private:
  std::map<Coefficients, std::size_t> numbers_;
  std::vector<Transform> transforms_;
};

class Walk {
 public:
  Walk(const Tree& tree, std::size_t most) : tree_(tree), most_(most) {
    result_.count.assign(tree.nodes.size(), 0);
    identity_ = transforms_.intern(Transform());
  }

  InstanceId visit(NodeId root) {
    InstanceId last = enter(root, identity_);
    while (!stack_.empty()) {
      Frame& frame = stack_.back();
      if (last.valid()) frame.done.push_back(last);
      last = InstanceId();
      if (frame.done.size() < frame.operands.size()) {
        last = enter(frame.operands[frame.done.size()], frame.place);
        continue;
      }
      last = leave();
    }
    return last;
  }

  Unfolding take() { return std::move(result_); }

 private:
  struct Frame {
    NodeId node;
    std::size_t place;
    std::vector<NodeId> operands;
    std::vector<InstanceId> done;
  };

  /// The instance when it is known; otherwise a frame for it is on the stack.
  InstanceId enter(NodeId id, std::size_t above) {
    const Node& node = tree_.nodes[id];
    const std::size_t place = node.transform ? transforms_.intern(transforms_[above] * *node.transform) : above;
    const auto it = known_.find({id, place});
    if (it != known_.end()) return it->second;
    stack_.push_back({id, place, tree_.operands(id), {}});
    return {};
  }

  InstanceId leave() {
    Frame frame = std::move(stack_.back());
    stack_.pop_back();
    if (result_.instances.size() == most_) {
      const Node& node = tree_.nodes[frame.node];
      throw TreeError(tree_.file, node.at,
                      "the tree unfolds to more than " + std::to_string(most_) + " instances, many of `" +
                          node.name + "`; share nodes under one transform or use fewer copies");
    }
    const InstanceId id = result_.instances.push_back(
        {frame.node, transforms_[frame.place], std::move(frame.done), ++result_.count[frame.node]});
    known_.emplace(std::pair(frame.node, frame.place), id);
    return id;
  }

  const Tree& tree_;
  std::size_t most_;
  TransformTable transforms_;
  std::size_t identity_ = 0;
  std::map<std::pair<NodeId, std::size_t>, InstanceId> known_;
  std::vector<Frame> stack_;
  Unfolding result_;
};

}  // namespace

Unfolding unfold(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most) {
  Walk walk(tree, most);
  std::vector<InstanceId> root_instances;
  for (const NodeId root : roots) root_instances.push_back(walk.visit(root));
  Unfolding result = walk.take();
  result.roots = std::move(root_instances);
  return result;
}

IdVector<InstanceId, LeafId> number_leaves(const Tree& tree, const IdVector<InstanceId, Instance>& instances) {
  IdVector<InstanceId, LeafId> leaf_of(instances.size());
  std::size_t leaves = 0;
  for (const InstanceId i : IdRange<InstanceId>(instances.size())) {
    if (tree.nodes[instances[i].node].op == Operator::leaf) leaf_of[i] = LeafId(leaves++);
  }
  return leaf_of;
}

std::vector<InstanceId> instances_below(const IdVector<InstanceId, Instance>& instances, InstanceId root) {
  std::vector<char> below(root.index() + 1, 0);
  below[root.index()] = 1;
  std::vector<InstanceId> found;
  for (std::size_t i = below.size(); i-- > 0;) {  // users come after operands
    if (!below[i]) continue;
    found.push_back(InstanceId(i));
    for (const InstanceId operand : instances[InstanceId(i)].operands) below[operand.index()] = 1;
  }
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace cnrg

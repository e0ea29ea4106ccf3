// A depth-first walk with its own stack. Accumulated transforms, *places*, are interned so that instances compare
// by number; they become fractions for the instances that need them alone.
#include "csg/tree/unfold.h"

#include <algorithm>
#include <map>
#include <optional>

#include "csg/geometry/placement.h"
#include "csg/tree/count_instances.h"

namespace cnrg {
namespace {

/// Numbers for equal places.
class PlaceTable {
 public:
  std::size_t intern(Placement place) {
    const auto [it, added] = numbers_.emplace(std::move(place), places_.size());
    if (added) places_.push_back({&it->first, nullptr});
    return it->second;
  }
  const Placement& operator[](std::size_t i) const { return *places_[i].first; }
  const std::shared_ptr<const Transform>& transform(std::size_t i) {
    auto& [place, made] = places_[i];
    if (!made) made = std::make_shared<const Transform>(place->transform());
    return made;
  }

 private:
  std::map<Placement, std::size_t> numbers_;
  std::vector<std::pair<const Placement*, std::shared_ptr<const Transform>>> places_;
};

class Walk {
 public:
  Walk(const Tree& tree, std::size_t most) : tree_(tree), most_(most) {
    result_.count.assign(tree.nodes.size(), 0);
    own_.resize(tree.nodes.size());
    identity_ = places_.intern(Placement());
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
    const std::size_t place = node.transform ? place_below(above, id) : above;
    const auto it = known_.find({id, place});
    if (it != known_.end()) return it->second;
    stack_.push_back({id, place, tree_.operands_within(id), {}});
    return {};
  }

  std::size_t place_below(std::size_t above, NodeId id) {
    const Node& node = tree_.nodes[id];
    std::optional<Placement>& own = own_[id];
    if (!own) own.emplace(*node.transform);
    Placement place = places_[above] * *own;
    if (const std::size_t bits = place.bits(); above != identity_ && bits > kMostBits) {
      throw TreeError(
          tree_.file, node.at,
          "the transforms from the result down to `" + node.name + "` have a product with numbers of " +
              std::to_string(bits) + " bits, and " + std::to_string(kMostBits) +
              " (30,000 digits) are the limit; nest fewer of them, or transforms with shorter numbers, "
              "such as one rotation in place of many");
    }
    return places_.intern(std::move(place));
  }

  InstanceId leave() {
    Frame frame = std::move(stack_.back());
    stack_.pop_back();
    if (result_.instances.size() == most_) {
      throw TreeError(tree_.file, tree_.nodes[frame.node].at,
                      "the tree unfolds to more than " + std::to_string(most_) + " instances, many of `" +
                          tree_.nodes[frame.node].name + "`; share nodes under one transform or use fewer copies");
    }
    const Node& node = tree_.nodes[frame.node];
    const bool placed = frame.operands.empty() || !node.material.empty() || node.op != Operator::simplify;
    const InstanceId id =
        result_.instances.push_back({frame.node, placed ? places_.transform(frame.place) : nullptr,
                                     std::move(frame.done), ++result_.count[frame.node]});
    known_.emplace(std::pair(frame.node, frame.place), id);
    return id;
  }

  const Tree& tree_;
  std::size_t most_;
  PlaceTable places_;
  IdVector<NodeId, std::optional<Placement>> own_;  // of the transforms of nodes, as they are met
  std::size_t identity_ = 0;
  std::map<std::pair<NodeId, std::size_t>, InstanceId> known_;
  std::vector<Frame> stack_;
  Unfolding result_;
};

}  // namespace

Unfolding unfold(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most) {
  refuse_too_many_instances(tree, roots, most);
  Walk walk(tree, most);
  std::vector<InstanceId> root_instances;
  for (const NodeId root : roots) root_instances.push_back(walk.visit(root));
  Unfolding result = walk.take();
  result.roots = std::move(root_instances);
  return result;
}

SharedTransform transform_above(const Tree& tree, const Instance& instance) {
  const std::optional<Transform>& own = tree.nodes[instance.node].transform;
  if (instance.transform == nullptr || (own && *own == *instance.transform)) return {};
  return own ? SharedTransform(*instance.transform * own->inverse()) : SharedTransform(instance.transform);
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

std::vector<LeafId> leaves_below(const IdVector<InstanceId, Instance>& instances,
                                 const IdVector<InstanceId, LeafId>& leaf_of, InstanceId root,
                                 std::span<const NodeId> nodes) {
  const std::vector<InstanceId> below = instances_below(instances, root);
  std::vector<char> wanted(root.index() + 1, 0);
  std::vector<LeafId> leaves;
  for (std::size_t k = below.size(); k-- > 0;) {  // users before operands
    const InstanceId id = below[k];
    if (nodes.empty() || std::find(nodes.begin(), nodes.end(), instances[id].node) != nodes.end())
      wanted[id.index()] = 1;
    if (!wanted[id.index()]) continue;
    for (const InstanceId operand : instances[id].operands) wanted[operand.index()] = 1;
    if (leaf_of[id].valid()) leaves.push_back(leaf_of[id]);
  }
  std::reverse(leaves.begin(), leaves.end());
  return leaves;
}

}  // namespace cnrg

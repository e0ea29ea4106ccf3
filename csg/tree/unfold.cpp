// A depth-first walk with its own stack. Accumulated transforms, *places*, are interned so that instances compare
// by number; they become fractions for the instances that need them alone.
#include "csg/tree/unfold.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "csg/geometry/placement.h"
#include "csg/tree/dag.h"
#include "csg/tree/tree.h"
#include "kernel/base/sorted.h"
#include "kernel/exact/integers.h"

namespace cnrg {
namespace {

// Whether a tree unfolds to too many instances, before it is unfolded.
//
// The ways from a root down to a node are counted in one pass over the graph. If all of them are few, so are the
// instances. If not, different ways may still lead to one place: a stair of a hundred steps, each "the one before,
// and the same shifted by 1", has 2^100 ways and 100 places. So places are told apart, by a fingerprint: the image
// of one fixed row under the accumulated matrix, modulo a prime. It is four numbers, goes from node to operand as
// the matrix would, and differs only if the matrix does.
//
// Not all places need to be made. A node's own transform is invertible, so all nodes below one stand at as many
// places as that one, at least: a tree of doublings is refused when its first thousands are counted.

using Residue = std::uint64_t;
constexpr Residue kPrime = (Residue{1} << 61) - 1;

Residue add(Residue a, Residue b) { return a + b >= kPrime ? a + b - kPrime : a + b; }
Residue multiply(Residue a, Residue b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = Wide{a} * b;
  return add(static_cast<Residue>(product & kPrime), static_cast<Residue>(product >> 61));
}
Residue inverse(Residue a) {
  Residue out = 1;
  for (Residue exponent = kPrime - 2; exponent != 0; exponent >>= 1) {
    if (exponent & 1) out = multiply(out, a);
    a = multiply(a, a);
  }
  return out;
}

Residue residue(const Integer& n) {
  static const Integer prime = to_integer(kPrime);
  Integer rest;
  mpz_fdiv_r(rest.get_mpz_t(), n.get_mpz_t(), prime.get_mpz_t());
  return to_machine<Residue>(rest);
}

/// Nothing if the denominator is 0 modulo the prime.
std::optional<Residue> residue(const Rational& x) {
  const Residue den = residue(x.get_den());
  if (den == 0) return std::nullopt;
  const Residue num = residue(x.get_num());
  return den == 1 ? num : multiply(num, inverse(den));
}

/// A row (x, y, z, 1-part) times a matrix of four rows whose last one is (0, 0, 0, 1).
using Row = std::array<Residue, 4>;
constexpr Row kStart{0x1234567890abcdef >> 4, 0x0fedcba987654321, 0x1357924680bdf9ec >> 4, 0x1a2b3c4d5e6f708};

struct Matrix {
  std::array<std::array<Residue, 4>, 3> rows;
  Row operator()(const Row& row) const {
    Row out{0, 0, 0, row[3]};
    for (std::size_t j = 0; j < 4; ++j) {
      for (std::size_t i = 0; i < 3; ++i) out[j] = add(out[j], multiply(row[i], rows[i][j]));
    }
    return out;
  }
};

std::optional<Matrix> matrix(const Transform& transform) {
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto value = residue(j < 3 ? transform.linear[i][j] : transform.offset[i]);
      if (!value) return std::nullopt;
      out.rows[i][j] = *value;
    }
  }
  return out;
}

/// Places at which a node is used, without those that came twice.
class Places {
 public:
  void add(const std::vector<Row>& rows) {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    if (rows_.size() > 2 * once_ + 64) settle();
  }
  std::vector<Row> take() {
    settle();
    return std::move(rows_);
  }

 private:
  void settle() {
    sort_unique(rows_);
    once_ = rows_.size();
  }
  std::vector<Row> rows_;
  std::size_t once_ = 0;
};

class Counter {
 public:
  Counter(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most)
      : tree_(tree), roots_(roots), most_(most), order_(tree.dag->order()) {
    std::reverse(order_.begin(), order_.end());  // users first
  }

  void run() {
    if (few_ways()) return;
    std::vector<Places> places(tree_.nodes.size());
    for (const NodeId root : roots_) places[root.index()].add({kStart});
    std::size_t counted = 0, asked = kWorthAsking / 2;
    for (const NodeId id : order_) {
      std::vector<Row> here = places[id.index()].take();
      if (here.empty()) continue;
      counted += here.size();
      if (counted > most_) fail(id, here.size(), counted);
      if (here.size() >= 2 * asked) {
        asked = here.size();
        const std::size_t all = counted + below(id) * here.size();
        if (all > most_) fail(id, here.size(), all);
      }
      if (const std::optional<Transform>& own = tree_.nodes[id].transform) {
        const std::optional<Matrix> map = matrix(*own);
        if (!map) return;
        for (Row& row : here) row = (*map)(row);
      }
      for (const NodeId operand : operands(id)) places[operand.index()].add(here);
    }
  }

 private:
  static constexpr std::size_t kWorthAsking = 1024;

  /// Each once.
  std::vector<NodeId> operands(NodeId id) const {
    std::vector<NodeId> all = tree_.operands_within(id);
    sort_unique(all);
    return all;
  }

  bool few_ways() const {
    std::vector<std::size_t> ways(tree_.nodes.size(), 0);
    for (const NodeId root : roots_) ways[root.index()] = 1;
    std::size_t all = 0;
    for (const NodeId id : order_) {
      const std::size_t here = ways[id.index()];
      if (here == 0) continue;
      all += here;
      if (all > most_) return false;
      for (const NodeId operand : operands(id)) ways[operand.index()] += here;
    }
    return true;
  }

  std::size_t below(NodeId id) const {
    const std::vector<char> reached = tree_.dag->reachable({id});
    return static_cast<std::size_t>(std::count_if(reached.begin(), reached.end(), [](char c) { return c != 0; })) -
           1;
  }

  [[noreturn]] void fail(NodeId id, std::size_t places, std::size_t instances) const {
    const Node& node = tree_.nodes[id];
    std::string text = "the tree unfolds to more than " + std::to_string(most_) + " instances, to " +
                       std::to_string(instances) + " at least";
    if (places > 1) {
      text += ": `" + node.name + "` stands at " + std::to_string(places) +
              " places, and every node below it at as many or more";
    }
    throw TreeError(tree_.file, node.at, text + "; share nodes under one transform or use fewer copies");
  }

  const Tree& tree_;
  const std::vector<NodeId>& roots_;
  const std::size_t most_;
  std::vector<NodeId> order_;
};

/// Throws TreeError when the tree below `roots` surely has more than `most` instances. It looks at no more than
/// about `most` of them, mostly at far fewer; it knows a place by a number that two places may share, though
/// hardly ever do: so it may let a tree pass that has too many, and refuses none that has not.
void refuse_too_many_instances(const Tree& tree, const std::vector<NodeId>& roots, std::size_t most) {
  Counter(tree, roots, most).run();
}

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

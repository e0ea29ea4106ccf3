// Boxes from below, then a search from the results down: every node that pays is a section, also below another
// one.
//
// What counts is the number of faces that die: those outside of the box in which their node has anything left. Of
// these only such count as meet the box of a leaf that is not below the node: a tree of boxes tells. After four
// questions per face and a thousand more no node pays: the search must never cost what it saves.
#include "csg/evaluate/sections.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "kernel/base/limits.h"
#include "kernel/base/sorted.h"
#include "kernel/refine/box_tree.h"

namespace cnrg {
namespace {

/// Fewer faces are not worth a refinement of their own.
constexpr std::size_t kWorth = 256;
/// An intersection of fewer faces is formed at once.
constexpr std::size_t kWorthSteps = 4000;

bool empty(const Box& box) {
  return !(box.lo[0] <= box.hi[0] && box.lo[1] <= box.hi[1] && box.lo[2] <= box.hi[2]);
}

Box common(const Box& a, const Box& b) {
  Box out;
  for (std::size_t k = 0; k < 3; ++k) {
    out.lo[k] = std::max(a.lo[k], b.lo[k]);
    out.hi[k] = std::min(a.hi[k], b.hi[k]);
  }
  return empty(out) ? Box() : out;
}

Box everything() { return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}}; }

bool is_boolean(Operator op) {
  return op == Operator::unite || op == Operator::intersect || op == Operator::subtract;
}

class Choice {
 public:
  Choice(const Tree& tree, const Unfolding& unfolding, const IdVector<InstanceId, LeafId>& leaf_of,
         const Soup& soup, bool all)
      : tree_(tree),
        all_(all),
        unfolding_(unfolding),
        leaf_of_(leaf_of),
        soup_(soup),
        leaf_box_(soup.leaf_count()),
        first_face_(soup.leaf_count() + 1, 0),
        box_(unfolding.instances.size()),
        faces_(unfolding.instances.size(), 0),
        holds_root_(unfolding.instances.size(), 0),
        barred_(unfolding.instances.size(), 0),
        seen_(unfolding.instances.size(), 0),
        below_(soup.leaf_count(), 0) {}

  Sections run() {
    if (!all_ && soup_.face_count() < 2 * kWorth) return {};
    measure_leaves();
    measure_instances();
    left_ = 4 * soup_.face_count() + 1000;
    for (const InstanceId root : unfolding_.roots) holds_root_[root] = 1;
    for (const InstanceId i : IdRange<InstanceId>(unfolding_.instances.size())) {
      for (const InstanceId operand : unfolding_.instances[i].operands)
        holds_root_[i] = holds_root_[i] || holds_root_[operand];
    }
    find_barred();
    for (const InstanceId root : unfolding_.roots) search(root);
    sort_unique(out_.roots), sort_unique(out_.steps);
    return std::move(out_);
  }

 private:
  Operator op(InstanceId i) const { return tree_.nodes[unfolding_.instances[i].node].op; }
  const std::vector<InstanceId>& operands(InstanceId i) const { return unfolding_.instances[i].operands; }

  Box box_of(SourceId f) const {
    Box box;
    for (const PointId p : soup_.corners(f)) {
      if (p.valid()) extend(box, p);
    }
    return box;
  }
  void extend(Box& box, PointId p) const {
    const double* c = soup_.xyz(p);  // a point that is no double is off by less than the next one
    std::array<double, 3> lo, hi;
    for (std::size_t k = 0; k < 3; ++k) {
      lo[k] = std::nextafter(c[k], -kInfinity);
      hi[k] = std::nextafter(c[k], kInfinity);
    }
    box.extend(lo, hi);
  }

  void measure_leaves() {
    for (const SourceId f : IdRange<SourceId>(soup_.face_count())) {
      const LeafId leaf = soup_.face(f).leaf;
      leaf_box_[leaf.index()].extend(box_of(f));
      ++first_face_[leaf.index() + 1];
    }
    for (std::size_t l = 1; l < first_face_.size(); ++l) first_face_[l] += first_face_[l - 1];
    for (const Soup::Wire& wire : soup_.wires()) {
      extend(leaf_box_[wire.leaf.index()], wire.a);
      extend(leaf_box_[wire.leaf.index()], wire.b);
    }
    for (const Soup::Isolated& point : soup_.isolated()) extend(leaf_box_[point.leaf.index()], point.point);
    leaves_.emplace(leaf_box_);
  }

  std::size_t faces_of(LeafId leaf) const { return first_face_[leaf.index() + 1] - first_face_[leaf.index()]; }

  /// Where an instance has anything left at most, and how many faces are below it, shared ones as often as they
  /// are used.
  void measure_instances() {
    for (const InstanceId i : IdRange<InstanceId>(unfolding_.instances.size())) {
      if (const LeafId leaf = leaf_of_[i]; leaf.valid()) {
        box_[i] = leaf_box_[leaf.index()];
        faces_[i] = faces_of(leaf);
        continue;
      }
      for (const InstanceId operand : operands(i)) {
        const bool first = operand == operands(i).front();
        faces_[i] += faces_[operand];
        switch (op(i)) {
          case Operator::intersect: box_[i] = first ? box_[operand] : common(box_[i], box_[operand]); break;
          case Operator::subtract:
            if (first) box_[i] = box_[operand];
            break;
          case Operator::complement: box_[i] = everything(); break;
          default: box_[i].extend(box_[operand]); break;
        }
      }
    }
  }

  /// Nodes that are neither sections nor formed in steps. What came of leaves with one region is known on their
  /// faces alone. Where a leaf has several, or an operator above shows or asks what was removed, results tell
  /// more: which regions, wires and points of leaves lay there.
  void find_barred() {
    for (const InstanceId i : IdRange<InstanceId>(unfolding_.instances.size())) {
      if (const LeafId leaf = leaf_of_[i]; leaf.valid()) {
        const Fill fill = soup_.fill(leaf);
        barred_[i] = fill != Fill::none && fill != Fill::winding && fill != Fill::parity;
      }
      if (op(i) == Operator::complement) barred_[i] = 1;  // it has no bounds
      for (const InstanceId operand : operands(i)) barred_[i] = barred_[i] || barred_[operand];
    }
    std::vector<char> under(unfolding_.instances.size(), 0);
    for (std::size_t i = under.size(); i-- > 0;) {
      const Operator what = op(InstanceId(i));
      const bool asks = what == Operator::complement || what == Operator::select || is_topological(what);
      if (!under[i] && !asks) continue;
      barred_[InstanceId(i)] = 1;
      for (const InstanceId operand : operands(InstanceId(i))) under[operand.index()] = 1;
    }
  }

  void search(InstanceId root) {
    std::vector<InstanceId> stack{root};
    while (!stack.empty()) {
      const InstanceId i = stack.back();
      stack.pop_back();
      if (seen_[i]) continue;
      seen_[i] = 1;
      if (leaf_of_[i].valid()) continue;
      if (!barred_[i] && !holds_root_[i] && is_boolean(op(i)) && (all_ || pays(i))) out_.roots.push_back(i);
      if (!barred_[i] && in_steps(i)) out_.steps.push_back(i);
      stack.insert(stack.end(), operands(i).begin(), operands(i).end());
    }
  }

  bool in_steps(InstanceId i) const {
    const Node& node = tree_.nodes[unfolding_.instances[i].node];
    const auto& all = operands(i);
    if (node.op != Operator::intersect || all.size() < 3 || (!all_ && faces_[i] < kWorthSteps)) return false;
    return std::none_of(all.begin(), all.end(), [&](InstanceId operand) { return holds_root_[operand]; });
  }

  /// Some operand reaches beyond what is left of it here.
  bool cuts(InstanceId i) const {
    std::vector<InstanceId> stack{i};
    for (std::size_t looked = 0; !stack.empty() && looked < 1000; ++looked) {
      const InstanceId at = stack.back();
      stack.pop_back();
      for (const InstanceId operand : operands(at)) {
        const Box inside = common(box_[operand], box_[i]);
        if (inside.lo != box_[operand].lo || inside.hi != box_[operand].hi) return true;
        stack.push_back(operand);
      }
    }
    return false;
  }

  /// What dies must outweigh what is refined twice: leaves that others use, too, and what lives, roughly an
  /// eighth.
  bool pays(InstanceId i) {
    if (faces_[i] < kWorth || left_ == 0 || !cuts(i)) return false;
    const std::vector<LeafId> below = leaves_below(unfolding_.instances, leaf_of_, i);
    spend(below.size());
    for (const LeafId leaf : below) below_[leaf.index()] = 1;
    std::size_t dead = 0, twice = 0, all = 0;
    const std::vector<char> shared = used_elsewhere(i);
    for (const LeafId leaf : below) {
      all += faces_of(leaf);
      if (shared[leaf.index()]) twice += faces_of(leaf);
      const Box inside = common(leaf_box_[leaf.index()], box_[i]);
      if (inside.lo == leaf_box_[leaf.index()].lo && inside.hi == leaf_box_[leaf.index()].hi) continue;
      for (std::size_t f = first_face_[leaf.index()]; f < first_face_[leaf.index() + 1] && left_ > 0; ++f) {
        spend(1);
        const Box box = box_of(SourceId(f));
        if (!box.meets(box_[i]) && meets_others(box)) ++dead;
      }
    }
    for (const LeafId leaf : below) below_[leaf.index()] = 0;
    return dead >= kWorth && dead >= 2 * twice + all / 8;
  }

  /// By leaf: whether an instance that is not below `i` uses it.
  std::vector<char> used_elsewhere(InstanceId i) {
    std::vector<char> inside(unfolding_.instances.size(), 0), shared(soup_.leaf_count(), 0);
    const std::vector<InstanceId> own = instances_below(unfolding_.instances, i);
    for (const InstanceId at : own) inside[at.index()] = 1;
    spend(own.size());
    for (const InstanceId user : IdRange<InstanceId>(unfolding_.instances.size())) {
      if (inside[user.index()]) continue;
      for (const InstanceId operand : operands(user)) {
        if (inside[operand.index()] && leaf_of_[operand].valid()) shared[leaf_of_[operand].index()] = 1;
      }
    }
    return shared;
  }

  bool meets_others(const Box& box) const {
    bool found = false;
    leaves_->query([&](const Box& other) { return !found && other.meets(box); },
                   [&](std::uint32_t leaf) { found = found || !below_[leaf]; });
    return found;
  }

  void spend(std::size_t questions) { left_ -= std::min(left_, questions); }

  const Tree& tree_;
  const bool all_;
  const Unfolding& unfolding_;
  const IdVector<InstanceId, LeafId>& leaf_of_;
  const Soup& soup_;
  std::vector<Box> leaf_box_;
  std::vector<std::size_t> first_face_;  // by leaf; faces of a leaf follow each other
  std::optional<BoxTree> leaves_;
  IdVector<InstanceId, Box> box_;
  IdVector<InstanceId, std::size_t> faces_;
  IdVector<InstanceId, char> holds_root_, barred_, seen_;
  std::vector<char> below_;
  std::size_t left_ = 0;  // questions
  Sections out_;
};

}  // namespace

Sections choose_sections(const Tree& tree, const Unfolding& unfolding, const IdVector<InstanceId, LeafId>& leaf_of,
                         const std::vector<LeafInstance>& leaves, bool all) {
  // Nothing dies but in intersections and differences, and a node that was asked for is no section.
  const auto cuts = [&](InstanceId i) {
    const Node& node = tree.nodes[unfolding.instances[i].node];
    const bool is_root = std::find(unfolding.roots.begin(), unfolding.roots.end(), i) != unfolding.roots.end();
    if (all) return is_boolean(node.op);
    if (node.op == Operator::intersect) return !is_root || unfolding.instances[i].operands.size() > 2;
    return node.op == Operator::subtract && !is_root;
  };
  bool any = false;
  for (const InstanceId i : IdRange<InstanceId>(unfolding.instances.size())) any = any || cuts(i);
  if (!any || std::any_of(leaves.begin(), leaves.end(), [](const LeafInstance& i) { return i.leaf->unbounded(); }))
    return {};
  const Soup soup = make_soup(leaves);
  return Choice(tree, unfolding, leaf_of, soup, all).run();
}

}  // namespace cnrg

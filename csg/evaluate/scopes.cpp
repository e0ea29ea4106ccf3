#include "csg/evaluate/scopes.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "csg/evaluate/chains.h"
#include "csg/evaluate/diagnostics.h"
#include "csg/evaluate/leaf_values.h"
#include "csg/evaluate/rows.h"
#include "csg/leaves/geometry_leaf.h"
#include "csg/tree/selector.h"
#include "kernel/base/sorted.h"

namespace cnrg {
namespace {

constexpr std::size_t kShortestChain = 3;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The leaves below operands, one instance after the other. Along a chain of nodes with one operand each they are
/// the same: to list them anew at each node would cost the square of its length.
class LeavesBelow {
 public:
  LeavesBelow(const PreparedLeaves& leaves, const Unfolding& unfolding) : leaves_(leaves), unfolding_(unfolding) {}
  /// Those that the operator of `node` wants to know of its operand `id`.
  std::vector<std::shared_ptr<const std::vector<LeafId>>> wanted_by(const Node& node, InstanceId id,
                                                                    bool first_operand) {
    std::vector<std::shared_ptr<const std::vector<LeafId>>> lists;
    for (const std::span<const NodeId> nodes : leaves_wanted(node, first_operand)) {
      lists.push_back(nodes.empty()
                          ? of(id)
                          : std::make_shared<const std::vector<LeafId>>(leaves_.below(unfolding_, id, nodes)));
    }
    return lists;
  }

 private:
  std::shared_ptr<const std::vector<LeafId>> of(InstanceId id) {
    const std::vector<InstanceId>& operands = unfolding_.instances[id].operands;
    if (!known_ || (last_ != id && (operands.size() != 1 || operands[0] != last_)))
      known_ = std::make_shared<const std::vector<LeafId>>(leaves_.below(unfolding_, id));
    last_ = id;
    return known_;
  }

  const PreparedLeaves& leaves_;
  const Unfolding& unfolding_;
  InstanceId last_;
  std::shared_ptr<const std::vector<LeafId>> known_;  // those below `last_`
};

class Scopes {
 public:
  Scopes(const ScopeContext& context, Sections sections)
      : x_(context),
        tree_(context.tree),
        instances_(context.unfolding.instances),
        sections_(sections.roots.begin(), sections.roots.end()),
        steps_(sections.steps.begin(), sections.steps.end()),
        told_(instances_.size()),
        below_(context.leaves, context.unfolding) {}

  ScopeResult run(std::span<const InstanceId> roots, bool top) {
    Scope made = evaluate(roots, {}, top);
    return {std::move(made.complex), std::move(made.places), std::move(report_), refine_seconds_,
            std::move(made.values),  std::move(of_result_),  std::move(told_),   std::move(dropped_)};
  }

 private:
  struct Scope {
    std::vector<InstanceId> here;  // whose values are made here, operands before users
    std::shared_ptr<const Complex> complex;
    std::optional<LeafPlaces> places;
    ValueStore values;
    std::map<InstanceId, NodeValue> first;  // of instances in steps: the value of their first operands
  };

  const ScopeContext& x_;
  const Tree& tree_;
  const IdVector<InstanceId, Instance>& instances_;
  const std::set<InstanceId> sections_;
  std::set<InstanceId> steps_;
  IdVector<InstanceId, InstanceTold> told_;
  std::vector<Diagnostic> dropped_;
  std::set<std::string> dropped_texts_;
  std::map<InstanceId, Removals> removed_in_steps_;
  LeavesBelow below_;
  RefineReport report_;
  double refine_seconds_ = 0;
  std::optional<SimplifiedValue> of_result_;

  /// The operands that an instance takes here: of one in steps the last one alone.
  std::span<const InstanceId> operands_here(InstanceId id) const {
    const std::span<const InstanceId> all = instances_[id].operands;
    return steps_.count(id) != 0 ? all.last(1) : all;
  }

  /// Below some roots, which are none themselves: the sections and the instances whose values are made there.
  void list(std::span<const InstanceId> roots, std::vector<InstanceId>& here,
            std::vector<InstanceId>& sections) const {
    const std::set<InstanceId> whole(roots.begin(), roots.end());
    std::set<InstanceId> seen = whole;
    std::vector<InstanceId> stack(roots.begin(), roots.end());
    while (!stack.empty()) {
      const InstanceId id = stack.back();
      stack.pop_back();
      if (whole.count(id) == 0 && sections_.count(id) != 0) {
        sections.push_back(id);
        continue;
      }
      here.push_back(id);
      for (const InstanceId operand : operands_here(id)) {
        if (seen.insert(operand).second) stack.push_back(operand);
      }
    }
    sort_unique(here), sort_unique(sections);
  }

  /// A scope with the values of `roots`. `first`: by intersection in steps, the value of its first operands.
  /// `top`: the scope of the results.
  Scope evaluate(std::span<const InstanceId> roots, std::vector<std::pair<InstanceId, CarriedGroup>> first,
                 bool top) {
    Scope scope{{}, nullptr, std::nullopt, ValueStore(instances_.size(), x_.options.keep_all), {}};
    std::vector<InstanceId> sections;
    list(roots, scope.here, sections);
    for (const InstanceId id : scope.here) {
      const auto is_it = [&](const auto& entry) { return entry.first == id; };
      if (steps_.count(id) == 0 || std::any_of(first.begin(), first.end(), is_it)) continue;
      std::optional<CarriedGroup> value = first_of(id);
      if (!value) {  // it must be formed at once: the scope begins again, with what it has so far
        steps_.erase(id);
        return evaluate(roots, std::move(first), top);
      }
      first.emplace_back(id, std::move(*value));
    }
    std::vector<CarriedGroup> carried;
    std::vector<InstanceId> of;  // by carried group
    for (const InstanceId id : sections) {
      Scope section = evaluate(std::span(&id, 1), {}, false);
      carried.emplace_back(*section.complex, section.values[id].group(), places_of(section));
      of.push_back(id);
    }
    const std::size_t whole = carried.size();
    for (auto& [id, value] : first) {
      carried.push_back(std::move(value));
      of.push_back(id);
    }
    refine(scope, CarriedGroups(std::move(carried)), of, whole, top);
    for (const InstanceId id : scope.here) {
      for (const InstanceId operand : operands_here(id)) scope.values.add_use(operand);
    }
    for (const InstanceId root : roots) scope.values.add_use(root);
    if (x_.options.rows == Rows::all) prepare_totals(*scope.complex, scope.values);
    make_values(scope, roots, top);
    return scope;
  }

  static const LeafPlaces& places_of(Scope& scope) {
    if (!scope.places) scope.places.emplace(*scope.complex);
    return *scope.places;
  }

  /// The leaves of a scope and what is carried into it; then the values of both.
  void refine(Scope& scope, CarriedGroups carried, const std::vector<InstanceId>& of, std::size_t whole,
              bool top) {
    const Stopwatch stopwatch;
    RefineReport report;
    x_.leaves.locate_errors([&] {
      std::vector<LeafInstance> instances(x_.placed.instances.size(), LeafInstance{no_geometry(), {}});
      for (const InstanceId id : scope.here) {
        if (const LeafId leaf = x_.leaves.leaf_of(id); leaf.valid())
          instances[leaf.index()] = x_.placed.instances[leaf.index()];
      }
      const bool has_results = std::any_of(instances.begin(), instances.end(),
                                           [](const auto& i) { return i.leaf->stored() != nullptr; });
      for (const CarriedGroup& group : carried.groups()) instances.push_back({group.leaf(), {}});
      Soup soup = make_soup(instances, x_.options.reach, surfaces(instances.size()));
      x_.options.watch.check();
      RefineOptions options;
      options.threads = x_.options.threads;
      options.watch = x_.options.watch;
      if (!top) options.watch.progress = {};
      options.vertices = has_results || !carried.empty();
      ComplexDraft draft(soup, options, &report);
      const HeldCells held = put_leaf_values(tree_, x_.unfolding, scope.here, x_.leaves, x_.grades, *draft, soup,
                                             report.vertex_of, scope.values);
      if (!carried.empty()) {
        std::vector<Group> groups = carried.on(*draft, report.vertex_of);
        scope.places.emplace(*draft);
        draft.set_sources(carried.sources(*draft, x_.placed.surfaces, *scope.places));
        for (std::size_t i = 0; i < groups.size(); ++i) {
          NodeValue value(*draft, std::move(groups[i]));
          if (i < whole) scope.values.put(of[i], std::move(value));
          else scope.first.emplace(of[i], std::move(value));
        }
      }
      draft.hold(std::move(held));
      scope.complex = draft.finish();
    });
    for (Diagnostic& dropped : dropped_faces(tree_, x_.leaves, *scope.complex, report)) {
      if (dropped_texts_.insert(dropped.message).second) dropped_.push_back(std::move(dropped));
    }
    add(report_, report);
    refine_seconds_ += stopwatch.seconds();
  }

  std::vector<std::vector<std::uint32_t>> surfaces(std::size_t leaves) const {
    std::vector<std::vector<std::uint32_t>> all = x_.placed.surfaces;
    if (!all.empty()) all.resize(leaves);
    return all;
  }

  std::vector<Operand> operands_of(Scope& scope, InstanceId id) {
    const Instance& instance = instances_[id];
    const Node& node = tree_.nodes[instance.node];
    std::vector<Operand> operands;
    if (const auto first = scope.first.find(id); first != scope.first.end())
      operands.push_back({&first->second, node.name, &first->second, {}});
    for (const InstanceId operand : operands_here(id)) {
      NodeValue* const value = &scope.values[operand];
      operands.push_back({value, tree_.nodes[instances_[operand].node].name,
                          scope.values.expendable(operand) ? value : nullptr,
                          below_.wanted_by(node, operand, operands.empty())});
    }
    return operands;
  }

  /// The operator of an inner instance on its operands' values; faults of the input come at the operator's place.
  StepOutcome run_operator(Scope& scope, InstanceId id) {
    const Instance& instance = instances_[id];
    const Node& node = tree_.nodes[instance.node];
    try {
      return operate(*scope.complex, node, x_.grades.on(instance, node.material), operands_of(scope, id),
                     x_.options.validate,
                     {instance.transform, transform_above(x_.tree, instance), order_below(id), removed(),
                      x_.options.proof == AskedProof::to_the_end});
    } catch (const FaultAt& e) {
      throw TreeError(file_of(node), e.at(), e.what());
    } catch (const LeafError& e) {
      throw TreeError(file_of(node), node.operator_at, x_.leaves.in_words(e.words()));
    } catch (const InputError& e) {
      throw TreeError(file_of(node), node.operator_at, e.what());
    }
  }

  const std::string& file_of(const Node& node) const { return node.selector ? node.selector->file : tree_.file; }

  LeafOrder order_below(InstanceId id) const { return x_.leaves.numbers().order_below(instances_, id); }

  Removed removed() const { return x_.options.rows == Rows::none ? Removed::uncounted : Removed::counted; }

  void make_values(Scope& scope, std::span<const InstanceId> roots, bool top) {
    std::optional<Steps> steps;
    if (top) steps.emplace(x_.options.watch, "nodes", scope.here.size());
    const std::map<InstanceId, std::vector<InstanceId>> chains = chains_in(scope);
    std::set<InstanceId> later;  // nodes of chains but the last ones
    for (const auto& [last, chain] : chains) later.insert(chain.begin(), chain.end() - 1);
    for (const InstanceId id : scope.here) {
      if (later.count(id) == 0) {
        const auto chain = chains.find(id);
        if (chain == chains.end()) make_value(scope, id, roots, top);
        else make_chain(scope, chain->second, roots, top);
      }
      if (steps) steps->step();
      else x_.options.watch.check();
    }
  }

  /// The value of an instance, if there is none yet, and its row.
  void make_value(Scope& scope, InstanceId id, std::span<const InstanceId> roots, bool top) {
    NodeRow row = row_of(tree_, x_.unfolding, id);
    std::vector<AttributeConflict> conflicts;
    if (!scope.values.has(id)) {
      const Stopwatch stopwatch;
      StepOutcome outcome = run_operator(scope, id);
      row.seconds = stopwatch.seconds();
      row.removals = std::move(removed_in_steps_[id]);
      row.removals.add(outcome.removals);
      conflicts = std::move(outcome.conflicts);
      scope.values.put(id, std::move(outcome.value));
      scope.first.erase(id);
    }
    finish(scope, id, std::move(row), conflicts, roots, top);
  }

  void finish(Scope& scope, InstanceId id, NodeRow row, const std::vector<AttributeConflict>& conflicts,
              std::span<const InstanceId> roots, bool top) {
    const NodeId node = row.node;
    if (!told_[id].row) {
      const NodeValue& value = scope.values[id];
      const SimplifiedValue simplified(scope.complex, scope.values.share(id));
      append(told_[id].diagnostics,
             material_conflicts(tree_, tree_.nodes[node], value, conflicts, *scope.complex, simplified,
                                transform_above(x_.tree, x_.unfolding.instances[id])));
      append(told_[id].diagnostics, empty_selection(tree_, node, value));
      const bool is_root = top && std::find(roots.begin(), roots.end(), id) != roots.end();
      const bool last = is_root && id == roots.front() && scope.values.used_once_more(id) && !x_.options.raw;
      if (last) of_result_ = simplified;
      if (x_.options.rows == Rows::all || (is_root && x_.options.rows == Rows::kept)) {
        // The files need the simplified result, too, so that is no part of the time of its row.
        if (last) simplified.counts();
        const Stopwatch stopwatch;
        fill_totals(*scope.complex, scope.values[id], x_.options.region_volumes, last ? &simplified : nullptr,
                    row);
        row.totals_seconds = stopwatch.seconds();
      }
      told_[id].row = std::move(row);
    }
    scope.values.release(operands_here(id));
  }

  /// The chains among the instances of a scope, each by its last one: nodes in their order. A value is not
  /// seen if its only use is as the first operand of the next node and no option asks for it.
  std::map<InstanceId, std::vector<InstanceId>> chains_in(Scope& scope) const {
    std::map<InstanceId, std::vector<InstanceId>> chains;
    if (x_.options.validate || x_.options.keep_all || x_.options.region_volumes) return chains;
    const auto node_of = [&](InstanceId id) -> const Node& { return tree_.nodes[instances_[id].node]; };
    for (const InstanceId id : scope.here) {
      if (scope.values.has(id) || steps_.count(id) != 0 || !can_be_in_chain(node_of(id))) continue;
      const InstanceId first = operands_here(id).front();
      auto before = chains.find(first);
      std::vector<InstanceId> chain;
      if (before != chains.end() && node_of(first).op == node_of(id).op && can_be_followed(node_of(first)) &&
          scope.values.used_once_more(first)) {
        chain = std::move(before->second);
        chains.erase(before);
      }
      chain.push_back(id);
      chains.emplace(id, std::move(chain));
    }
    std::erase_if(chains, [](const auto& entry) { return entry.second.size() < kShortestChain; });
    return chains;
  }

  void make_chain(Scope& scope, const std::vector<InstanceId>& chain, std::span<const InstanceId> roots,
                  bool top) {
    std::vector<ChainNode> nodes;
    for (const InstanceId id : chain) {
      ChainNode& node = nodes.emplace_back();
      node.node = &tree_.nodes[instances_[id].node];
      for (const InstanceId operand : operands_here(id)) {
        if (scope.values.has(operand))
          node.operands.push_back(
              {&scope.values[operand], tree_.nodes[instances_[operand].node].name, nullptr, {}});
      }
    }
    std::optional<ChainOutcome> outcome =
        evaluate_chain(*scope.complex, nodes, x_.options.rows == Rows::all, order_below(chain.back()), removed());
    if (!outcome) {
      for (const InstanceId id : chain) make_value(scope, id, roots, top);
      return;
    }
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const InstanceId id = chain[i];
      ChainStep& step = outcome->nodes[i];
      NodeRow row = row_of(tree_, x_.unfolding, id);
      row.seconds = step.seconds;
      row.removals = std::move(step.removals);
      if (id == chain.back()) {
        NodeValue value(std::move(outcome->value));
        apply_attributes(*scope.complex, *nodes[i].node, x_.grades.on(instances_[id], nodes[i].node->material),
                         value);
        scope.values.put(id, std::move(value));
        finish(scope, id, std::move(row), {}, roots, top);
        continue;
      }
      if (!told_[id].row) {
        if (step.totals) fill_totals(*step.totals, row);
        told_[id].row = std::move(row);
      }
      scope.values.release(operands_here(id));
    }
  }

  /// All operands of an instance but the last one, folded from left to right, each step in a scope of its own.
  /// Nothing if materials or properties conflict there: who keeps which is told in cells of the whole.
  std::optional<CarriedGroup> first_of(InstanceId id) {
    const std::vector<InstanceId>& all = instances_[id].operands;
    const Node& node = tree_.nodes[instances_[id].node];
    std::optional<CarriedGroup> value;
    Removals removals;
    for (std::size_t k = value ? 1 : 2; k < all.size(); ++k) {
      std::vector<InstanceId> roots(all.begin() + (k == 2 ? 0 : static_cast<std::ptrdiff_t>(k) - 1),
                                    all.begin() + static_cast<std::ptrdiff_t>(k));
      std::vector<std::pair<InstanceId, CarriedGroup>> first;
      if (value) first.emplace_back(id, std::move(*value));
      const std::vector<InstanceId> distinct = unique(roots);
      Scope scope = evaluate(distinct, std::move(first), false);
      std::vector<Operand> operands;
      if (k > 2) operands.push_back({&scope.first.at(id), node.name, &scope.first.at(id), {}});
      for (const InstanceId operand : roots)
        operands.push_back({&scope.values[operand], tree_.nodes[instances_[operand].node].name, nullptr, {}});
      StepOutcome outcome = [&] {
        try {
          return first_steps(*scope.complex, node, operands, order_below(id), removed());
        } catch (const InputError& e) {
          throw TreeError(tree_.file, node.operator_at, e.what());
        }
      }();
      if (!outcome.conflicts.empty()) return std::nullopt;
      removals.add(outcome.removals);
      value.emplace(*scope.complex, outcome.value.group(), places_of(scope));
    }
    removed_in_steps_[id] = std::move(removals);
    return value;
  }
  static std::vector<InstanceId> unique(std::vector<InstanceId> list) {
    sort_unique(list);
    return list;
  }
};

}  // namespace

void add(RefineReport& sum, const RefineReport& more) {
  sum.candidates += more.candidates;
  for (std::size_t k = 0; k < sum.contacts.size(); ++k) sum.contacts[k] += more.contacts[k];
  sum.constructed += more.constructed;
  sum.stages.filter += more.stages.filter;
  sum.stages.interval += more.stages.interval;
  sum.stages.exact += more.stages.exact;
}

ScopeResult evaluate_scopes(const ScopeContext& context, std::span<const InstanceId> roots, Sections sections,
                            bool top) {
  return Scopes(context, std::move(sections)).run(roots, top);
}

}  // namespace cnrg

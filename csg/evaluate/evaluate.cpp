// The driver, from a tree to the values of its nodes:
//
//   tree -> instances            csg/tree/unfold.h: a node under each of its transforms; operands before users
//        -> prepared leaves      prepared_leaves.h: files are read, everything that can be checked is checked
//        -> common lines         csg/carriers/common_lines.h: of leaves that share a curved surface
//        -> welded leaves        csg/weld: what is near coincides, where the tree has `weld`; round surfaces first
//        -> soup -> complex      make_soup.cpp, then the kernel: all leaves are refined together, once
//        -> leaf values          leaf_values.h
//        -> node values          operate.h: a node selects cells and makes none; it costs what its operands touch
//        -> rows, diagnostics    rows.h, diagnostics.h
//        -> kept values          value_store.h: every other value is freed after its last user
//
// The way through the nodes is a loop over instances: the depth of a tree costs no stack. One thing calls the
// driver from inside: a node to which a graded material measures distances is evaluated first, as the root of a
// complex of its own (grades.h). Materials do not matter there, so it is evaluated without grades, and this inner
// run does not call the driver again.
#include "csg/evaluate/evaluate.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <optional>
#include <utility>

#include "csg/carriers/common_lines.h"
#include "csg/carriers/surface_numbers.h"
#include "csg/evaluate/diagnostics.h"
#include "csg/evaluate/grades.h"
#include "csg/evaluate/leaf_values.h"
#include "csg/evaluate/operate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/evaluate/rows.h"
#include "csg/evaluate/simplified_value.h"
#include "csg/evaluate/value_store.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/weld/weld_leaves.h"
#include "csg/weld/weld_surfaces.h"

namespace cnrg {
namespace {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The result and the nodes asked for, each once.
std::vector<NodeId> roots_of(const Tree& tree, const EvaluateOptions& options) {
  std::vector<NodeId> roots{tree.result};
  for (const NodeId node : options.nodes) {
    if (std::find(roots.begin(), roots.end(), node) == roots.end()) roots.push_back(node);
  }
  return roots;
}

void append(std::vector<Diagnostic>& all, std::vector<Diagnostic> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

/// Soup and complex of all leaves, and what the complex does not know of them: names, parameters.
void build_complex_of(const Tree& tree, const PreparedLeaves& leaves, const EvaluateOptions& options,
                      Evaluation& result) {
  const Stopwatch stopwatch;
  RefineOptions refine_options;
  refine_options.threads = options.threads;
  refine_options.watch = options.watch;
  std::vector<LeafInstance> instances;
  leaves.locate_errors([&] {
    std::vector<NearSurfaces> near;
    std::vector<std::string> apart;
    const auto tell = [&](const std::string& notice) {
      if (!notice.empty())
        result.diagnostics.push_back(
            {tree.file, tree.weld_at, Diagnostic::Level::notice, leaves.in_words(notice)});
    };
    instances = leaves.instances();
    WeldedSurfaces round;
    if (tree.weld) {
      round = weld_surfaces(instances, *tree.weld);
      instances = round.instances;
      tell(round.notice);
    }
    const std::vector<std::vector<std::uint32_t>> surfaces = surface_numbers(instances);
    instances = with_common_lines(std::move(instances), &near, &apart, round.anew);
    if (tree.weld) {
      WeldedLeaves welded = weld_leaves(instances, *tree.weld, round.farthest);
      instances = std::move(welded.instances);
      tell(welded.notice);
      std::erase_if(near, [&](const NearSurfaces& pair) { return pair.apart <= to_double(*tree.weld); });
    }
    append(result.diagnostics, leaves.near_notices(near));
    append(result.diagnostics, leaves.located_notices(apart));
    options.watch.check();
    const Soup soup = make_soup(instances, options.reach, surfaces);
    options.watch.check();
    result.complex = build_complex(soup, refine_options, &result.refine);
  });
  if (options.validate) {
    const std::string violation = validate(*result.complex);
    require(violation.empty(), "the complex of the leaves is broken: " + violation);
  }
  result.leaf_names.resize(result.complex->leaf_count);
  std::vector<PlacedParameters> placed;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    result.leaf_names[i] = leaves.node_of(LeafId(i)).name;
    const PreparedLeaf& leaf = *instances[i].leaf;
    placed.push_back({leaf.parameters(), instances[i].transform, leaf.surfaces(), leaf.boxes()});
  }
  result.parameters = std::make_shared<const SurfaceParameters>(*result.complex, std::move(placed));
  result.refine_seconds = stopwatch.seconds();
}

/// The leaves below operands, one instance after the other. Along a chain of nodes with one operand each they are
/// the same: to list them anew at each node would cost the square of its length.
class LeavesBelow {
 public:
  LeavesBelow(const PreparedLeaves& leaves, const Unfolding& unfolding) : leaves_(leaves), unfolding_(unfolding) {}
  /// Those that the operator of `node` wants to know of its operand `id`.
  std::shared_ptr<const std::vector<LeafId>> wanted_by(const Node& node, InstanceId id, bool first_operand) {
    const auto nodes = leaves_wanted(node, first_operand);
    if (!nodes) return nullptr;
    if (nodes->empty()) return of(id);
    return std::make_shared<const std::vector<LeafId>>(leaves_.below(unfolding_, id, *nodes));
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

/// The operator of an inner instance on its operands' values; faults of the input come at the operator's place.
Outcome run_operator(const Tree& tree, const Unfolding& unfolding, InstanceId id, LeavesBelow& below,
                     Grades& grades, const Complex& complex, ValueStore& values, bool validate) {
  const Instance& instance = unfolding.instances[id];
  const Node& node = tree.nodes[instance.node];
  std::vector<Operand> operands;
  for (const InstanceId operand : instance.operands) {
    NodeValue* const value = &values[operand];
    operands.push_back({value, tree.nodes[unfolding.instances[operand].node].name,
                        values.expendable(operand) ? value : nullptr,
                        below.wanted_by(node, operand, operands.empty())});
  }
  try {
    return operate(complex, node, grades.on(instance, node.material), operands, validate,
                   grades.placement(instance));
  } catch (const InputError& e) {
    throw TreeError(tree.file, node.operator_at, e.what());
  }
}

/// `roots`: those whose values are kept. Without `graded` every material is the same all over.
Evaluation evaluate_roots(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                          bool graded) {
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  Evaluation result;
  const Unfolding unfolding = unfold(tree, roots);

  options.watch.begin("leaves");
  const PreparedLeaves leaves(tree, unfolding);
  append(result.diagnostics, leaves.notices());

  options.watch.begin("refine");
  build_complex_of(tree, leaves, options, result);
  const Complex& complex = *result.complex;
  append(result.diagnostics, dropped_faces(tree, leaves, complex, result.refine));

  Grades grades(tree, graded ? unfolding : Unfolding(), [&](NodeId node) {
    EvaluateOptions alone;
    alone.threads = options.threads;
    alone.watch = options.watch;
    alone.rows = false;
    return evaluate_roots(tree, {node}, alone, false);
  });
  ValueStore values(unfolding, options.keep_all);
  put_leaf_values(tree, unfolding, leaves, grades, complex, values);
  if (options.rows) prepare_totals(complex, unfolding, values);

  LeavesBelow below(leaves, unfolding);
  std::optional<SimplifiedComplex> of_result;
  Steps steps(options.watch, "nodes", unfolding.instances.size());
  for (const InstanceId id : IdRange<InstanceId>(unfolding.instances.size())) {
    const NodeId node = unfolding.instances[id].node;
    NodeRow row = row_of(tree, unfolding, id);
    std::vector<AttributeConflict> conflicts;
    if (!values.has(id)) {
      const Stopwatch stopwatch;
      Outcome outcome = run_operator(tree, unfolding, id, below, grades, complex, values, options.validate);
      row.seconds = stopwatch.seconds();
      row.removals = std::move(outcome.removals);
      conflicts = std::move(outcome.conflicts);
      values.put(id, std::move(outcome.value));
    }
    SimplifiedValue simplified(complex, values[id]);
    append(result.diagnostics, material_conflicts(tree, tree.nodes[node], values[id], conflicts, simplified));
    append(result.diagnostics, empty_selection(tree, node, values[id]));
    const bool is_root = std::find(unfolding.roots.begin(), unfolding.roots.end(), id) != unfolding.roots.end();
    if (options.rows || is_root) {
      // The result is simplified for its files in any case, so that is no part of the time of its row.
      const bool last = node == tree.result && is_root && values.used_once_more(id) && !options.raw;
      if (last) simplified.get();
      const Stopwatch stopwatch;
      fill_totals(complex, values[id], options.region_volumes || is_root, last ? &simplified : nullptr, row);
      row.totals_seconds = stopwatch.seconds();
      if (last) of_result = std::move(simplified.get());
    }
    values.release_operands(id);
    result.rows.push_back(std::move(row));
    steps.step();
  }
  const SimplifyMode mode = options.raw ? SimplifyMode::raw : SimplifyMode::features;
  for (const InstanceId root : unfolding.roots) {
    const NodeId node = unfolding.instances[root].node;
    const NodeValue& value = values[root];
    SimplifiedComplex simplified = of_result && node == tree.result
                                       ? std::move(*of_result)
                                       : simplified_in_order(complex, value, selection_of(complex, value), mode);
    result.kept.push_back({node, values.share(root),
                           std::make_shared<const SimplifiedComplex>(std::move(simplified)),
                           leaves.below(unfolding, root), tree.nodes[node].name});
  }
  for (const Material& m : tree.materials) result.materials.push_back({m.name, m.color});
  result.raw = options.raw;
  result.instances = unfolding.instances;
  if (options.keep_all) result.values = values.take();
  return result;
}

}  // namespace

Evaluation evaluate(const Tree& tree, const EvaluateOptions& options) {
  return evaluate_roots(tree, roots_of(tree, options), options, true);
}

std::vector<Diagnostic> check(const Tree& tree) {
  unfold(tree, {tree.result});
  return PreparedLeaves(tree).notices();
}

const KeptValue& Evaluation::value(NodeId node) const {
  const auto it = std::find_if(kept.begin(), kept.end(), [&](const KeptValue& k) { return k.node == node; });
  require(it != kept.end(), "evaluate: the value of this node was not kept");
  return *it;
}

}  // namespace cnrg

// The driver, from a tree to the values of its nodes:
//
//   tree -> joined nodes         joined_nodes.h: each is a run by itself, and then a leaf; mostly there are none
//        -> instances            csg/tree/unfold.h: a node under each of its transforms; operands before users
//        -> prepared leaves      prepared_leaves.h: files are read, everything that can be checked is checked
//        -> drawings             drawings.h: leaves that share a curved surface on common lines; where the tree
//                                has `weld`, what is near coincides; finer where surfaces do not meet as facets do
//        -> sections             sections.h: nodes that are refined apart, mostly none
//        -> scopes               scopes.h: each section, then the whole tree:
//             soup -> complex      make_soup.cpp, then the kernel: all leaves of the scope are refined together
//             leaf values          leaf_values.h; those of sections come by carried_groups.h
//             node values          operate.h: a node selects cells, makes none, and costs what its operands touch
//             rows, diagnostics    rows.h, diagnostics.h
//        -> nodes alone          a scope, for its row, of each node that is drawn otherwise when it stands alone
//        -> kept values          value_store.h: every other value is freed after its last user
//
// The way through the nodes is a loop over instances, and joined nodes are evaluated operands before users: the
// depth of a tree costs no stack. One thing calls the driver from inside: a node to which a graded material
// measures distances is evaluated first, as the root of a complex of its own (grades.h). Materials do not matter
// there, so it is evaluated without grades, and so is what is joined below it: this inner run does not call the
// driver again.
#include "csg/evaluate/evaluate.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>

#include "csg/evaluate/diagnostics.h"
#include "csg/evaluate/drawings.h"
#include "csg/evaluate/grades.h"
#include "csg/evaluate/joined_nodes.h"
#include "csg/evaluate/leaf_numbers.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/evaluate/scopes.h"
#include "csg/evaluate/volume_bounds.h"
#include "csg/leaves/leaf_stop.h"
#include "csg/leaves/surface_parameters.h"

namespace cnrg {
namespace {

/// The result and the nodes asked for, each once.
std::vector<NodeId> roots_of(const Tree& tree, const EvaluateOptions& options) {
  std::vector<NodeId> roots{options.result.valid() ? options.result : tree.result};
  for (const NodeId node : options.nodes) {
    if (std::find(roots.begin(), roots.end(), node) == roots.end()) roots.push_back(node);
  }
  return roots;
}

/// Nobody who wants to see all cells, or all values on one complex, is served by sections.
Sections sections_of(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves,
                     const PlacedLeaves& placed, const EvaluateOptions& options) {
  if (options.refining == Refining::together || options.raw || options.keep_all || options.validate) return {};
  IdVector<InstanceId, LeafId> leaf_of;
  for (const InstanceId id : IdRange<InstanceId>(unfolding.instances.size()))
    leaf_of.push_back(leaves.leaf_of(id));
  return choose_sections(tree, unfolding, leaf_of, placed.instances, options.refining == Refining::apart);
}

/// What the complex does not know of the leaves: names, parameters.
void name_leaves(const PreparedLeaves& leaves, const PlacedLeaves& placed, std::optional<LeafPlaces> places,
                 Evaluation& result) {
  result.leaves = std::make_shared<const LeafNumbers>(leaves.numbers());
  result.leaf_names.resize(result.complex->leaf_count);
  std::vector<PlacedParameters> parameters;
  for (std::size_t i = 0; i < placed.instances.size(); ++i) {
    result.leaf_names[i] = leaves.node_of(LeafId(i)).name;
    const PreparedLeaf& leaf = *placed.instances[i].leaf;
    parameters.push_back({leaf.parameters(), placed.instances[i].transform, leaf.surfaces()});
  }
  result.parameters =
      std::make_shared<const SurfaceParameters>(*result.complex, std::move(parameters), std::move(places));
}

/// What is said of nodes that are drawn otherwise when they stand alone: each by a scope of its own.
void tell_alone(ScopeContext context, Drawings& drawings, const std::shared_ptr<SweptLeaves>& swept,
                ScopeResult& made) {
  std::vector<InstanceId> waiting;
  std::set<InstanceId> known;
  const auto add_below = [&](InstanceId root, const PlacedLeaves& placed) {
    for (const InstanceId id : drawings.otherwise_below(root, placed)) {
      if (known.insert(id).second) waiting.push_back(id);
    }
  };
  for (const InstanceId root : context.unfolding.roots) add_below(root, drawings.whole());
  while (!waiting.empty()) {
    const InstanceId id = waiting.back();
    waiting.pop_back();
    const PlacedLeaves placed = drawings.alone(id);
    ScopeResult alone =
        evaluate_scopes({context.tree, context.unfolding, context.leaves, placed, context.options, context.grades},
                        std::span(&id, 1), {}, false);
    add(made.refine, alone.refine);
    made.refine_seconds += alone.refine_seconds;
    const auto bounds = std::make_shared<const VolumeBounds>(swept, placed);
    for (const InstanceId below : instances_below(context.unfolding.instances, id)) {
      if (!drawings.as_alone(below, placed)) continue;
      made.told[below] = std::move(alone.told[below]);
      made.told[below].row->volume_bound = [bounds, below] { return bounds->of(below); };
    }
    add_below(id, placed);
  }
}

Evaluation evaluate_roots(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                          bool graded);

Evaluation evaluate_together(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                             bool graded, const JoinedLeaves& joined);

/// The first root, and beside it the evaluations of the others.
Evaluation evaluate_each(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                         bool graded, const JoinedLeaves& joined) {
  Evaluation result = evaluate_together(tree, {roots.front()}, options, graded, joined);
  std::set<NodeId> here;
  const auto add_rows = [&](const std::vector<NodeRow>& rows) {
    std::set<NodeId> more;
    for (const NodeRow& row : rows) {
      if (here.count(row.node) != 0) continue;
      more.insert(row.node);
      result.rows.push_back(row);
    }
    here.merge(more);
  };
  add_rows(std::exchange(result.rows, {}));
  for (std::size_t i = 1; i < roots.size(); ++i) {
    Evaluation other = evaluate_together(tree, {roots[i]}, options, graded, joined);
    add(result.refine, other.refine);
    result.refine_seconds += other.refine_seconds;
    add_rows(other.rows);
    for (Diagnostic& one : other.diagnostics) {
      if (std::find(result.diagnostics.begin(), result.diagnostics.end(), one) == result.diagnostics.end())
        result.diagnostics.push_back(std::move(one));
    }
    result.others.push_back(std::move(other));
  }
  return result;
}

/// `roots`: those whose values are kept. `joined`: all joined nodes below them.
Evaluation evaluate_together(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                             bool graded, const JoinedLeaves& joined) {
  Evaluation result;
  const Unfolding unfolding = unfold(tree, roots);

  const LeafStop may_stop(options.watch.stop);
  options.watch.begin("leaves");
  const PreparedLeaves leaves(tree, unfolding, joined);
  append(result.diagnostics, leaves.notices());

  Drawings drawings(tree, unfolding, leaves, options, result.diagnostics);
  options.watch.begin("refine");
  const PlacedLeaves& placed = drawings.whole();
  options.watch.check();
  const bool all_alone = !options.drawn_together && !options.keep_all && !options.raw && !options.validate;
  const auto as_alone = [&](InstanceId root) {
    return drawings.framed_as_alone(root) && drawings.as_alone(root, placed);
  };
  if (all_alone && roots.size() > 1 && !std::ranges::all_of(unfolding.roots, as_alone))
    return evaluate_each(tree, roots, options, graded, joined);
  Grades grades(tree, graded ? unfolding : Unfolding(), [&](NodeId node) {
    EvaluateOptions alone;
    alone.threads = options.threads;
    alone.watch = options.watch;
    alone.proof = options.proof;
    alone.rows = Rows::none;
    return evaluate_roots(tree, {node}, alone, false);
  });
  const ScopeContext context{tree, unfolding, leaves, placed, options, grades};
  ScopeResult made =
      evaluate_scopes(context, unfolding.roots, sections_of(tree, unfolding, leaves, placed, options));
  const auto swept = std::make_shared<SweptLeaves>(tree, unfolding, leaves);
  const auto bounds = std::make_shared<const VolumeBounds>(swept, placed);
  for (const InstanceId id : IdRange<InstanceId>(made.told.size())) {
    if (made.told[id].row) made.told[id].row->volume_bound = [bounds, id] { return bounds->of(id); };
  }
  if (all_alone && options.rows == Rows::all) tell_alone(context, drawings, swept, made);
  result.complex = made.complex;
  result.refine = std::move(made.refine);
  result.refine_seconds = made.refine_seconds;
  name_leaves(leaves, placed, std::move(made.places), result);
  result.certificate = drawings.certificate(result);
  append(result.diagnostics, std::move(made.diagnostics));
  for (InstanceTold& told : made.told) {
    append(result.diagnostics, std::move(told.diagnostics));
    result.rows.push_back(std::move(*told.row));
  }
  ValueStore& values = made.values;
  const SimplifyMode mode = options.raw ? SimplifyMode::raw : SimplifyMode::features;
  for (const InstanceId root : unfolding.roots) {
    const NodeId node = unfolding.instances[root].node;
    result.kept.push_back({node, root, values.share(root),
                           made.of_result && root == unfolding.roots.front()
                               ? *made.of_result
                               : SimplifiedValue(result.complex, values.share(root), mode),
                           leaves.below(unfolding, root), tree.nodes[node].name,
                           leaves.numbers().sizes(tree, unfolding.instances, root),
                           [bounds, root] { return bounds->of(root); }});
  }
  for (const Material& m : tree.materials) result.materials.push_back({m.name, m.color});
  result.raw = options.raw;
  result.instances = unfolding.instances;
  if (options.keep_all) result.values = values.take();
  return result;
}

/// The same with the joined nodes below the roots. Without `graded` every material is the same all over.
Evaluation evaluate_roots(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                          bool graded) {
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  JoinedNodes joined(tree, roots, options,
                     [&](NodeId node, const EvaluateOptions& alone, const JoinedLeaves& known) {
                       return evaluate_together(tree, {node}, alone, graded, known);
                     });
  Evaluation result = evaluate_together(tree, roots, options, graded, joined.leaves());
  joined.tell(result);
  return result;
}

}  // namespace

Evaluation evaluate(const Tree& tree, const EvaluateOptions& options) {
  return evaluate_roots(tree, roots_of(tree, options), options, true);
}

std::vector<Diagnostic> check(const Tree& tree) {
  unfold(tree, {tree.result});
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    if (tree.nodes[id].within) unfold(tree, tree.operands(id));
  }
  return PreparedLeaves(tree).notices();
}

const KeptValue& Evaluation::value(NodeId node) const {
  const auto it = std::find_if(kept.begin(), kept.end(), [&](const KeptValue& k) { return k.node == node; });
  require(it != kept.end(), "evaluate: the value of this node was not kept");
  return *it;
}

std::vector<const NodeRow*> Evaluation::all_rows() const {
  std::vector<const NodeRow*> all;
  std::set<NodeId> here;
  for (const NodeRow& row : rows) here.insert(row.node);
  for (const JoinedNode& one : joined) {
    std::set<NodeId> below;
    for (const NodeRow& row : one.rows) {
      if (here.count(row.node) != 0) continue;
      all.push_back(&row);
      below.insert(row.node);
    }
    here.merge(below);
  }
  for (const NodeRow& row : rows) all.push_back(&row);
  return all;
}

}  // namespace cnrg

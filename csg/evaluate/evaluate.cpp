// Tree -> instances -> soup -> complex -> a group per leaf -> a group per node, operands first.
//
// All leaves are refined together, once; a node then costs what its operands touch. A value lives until its last
// user has run. Nothing recurses: instances are in an order in which operands come before users.
#include "csg/evaluate/evaluate.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "csg/evaluate/grades.h"
#include "csg/evaluate/operate.h"
#include "csg/evaluate/prepared_leaves.h"
#include "csg/leaves/cell_table.h"
#include "csg/leaves/surface_parameters.h"
#include "csg/operators/component_lists.h"
#include "csg/operators/group.h"
#include "csg/operators/leaf_value.h"
#include "csg/operators/node_value.h"
#include "csg/tree/unfold.h"
#include "kernel/selection/canonical.h"
#include "kernel/selection/measure.h"

namespace cnrg {
namespace {

using Values = IdVector<InstanceId, std::shared_ptr<NodeValue>>;

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

/// Soup and complex of all leaves.
void refine(const PreparedLeaves& leaves, const EvaluateOptions& options, Evaluation& result) {
  const Stopwatch stopwatch;
  RefineOptions refine_options;
  refine_options.threads = options.threads;
  leaves.locate_errors([&] {
    const Soup soup = make_soup(leaves.instances(), options.reach);
    result.complex = build_complex(soup, refine_options, &result.refine);
  });
  if (options.validate) {
    const std::string violation = validate(*result.complex);
    require(violation.empty(), "the complex of the leaves is broken: " + violation);
  }
  result.leaf_names.resize(result.complex->leaf_count);
  std::vector<PlacedParameters> placed;
  for (std::size_t i = 0; i < leaves.instances().size(); ++i) {
    result.leaf_names[i] = leaves.node_of(LeafId(i)).name;
    placed.push_back({leaves.instances()[i].leaf->parameters(), leaves.instances()[i].transform});
  }
  result.parameters = std::make_shared<const SurfaceParameters>(*result.complex, std::move(placed));
  result.refine_seconds = stopwatch.seconds();
}

/// Faces without area, counted per leaf node.
void report_dropped(const Tree& tree, const PreparedLeaves& leaves, Evaluation& result) {
  std::map<LeafId, std::size_t> dropped;
  for (const SourceId source : result.refine.zero_area) ++dropped[result.complex->sources[source].leaf];
  for (const auto& [leaf, count] : dropped) {
    if (leaf.index() >= leaves.instances().size()) continue;
    const Node& node = leaves.node_of(leaf);
    result.diagnostics.push_back(
        {tree.file, node.operator_at, Diagnostic::Level::notice,
         "`" + node.name + "`: faces without area were dropped: " + std::to_string(count)});
  }
}

/// A leaf's own value, without the attributes of its node; of a result read back by its cell table.
NodeValue value_of_leaf(const Tree& tree, const PreparedLeaves& leaves, const Instance& placed, Grades& grades,
                        const Complex& complex, LeafId leaf, Group group) {
  const LeafInstance& instance = leaves.instances()[leaf.index()];
  const CellTable* table = instance.leaf->cells();
  if (table == nullptr) return {complex, std::move(group)};
  try {
    const auto count = static_cast<std::uint32_t>(instance.leaf->regions().size());
    return leaf_value(complex, leaf, group, *table, instance.transform,
                      leaves.attributes(leaf, count, placed, grades));
  } catch (const InputError& e) {
    throw TreeError(tree.file, leaves.node_of(leaf).operator_at, e.what());
  }
}

Values leaf_values(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves, Grades& grades,
                   const Complex& complex) {
  std::vector<std::vector<RegionAttributes>> attributes;
  for (const InstanceId i : IdRange<InstanceId>(unfolding.instances.size())) {  // leaves come in this order
    const LeafId leaf = leaves.leaf_of(i);
    if (!leaf.valid()) continue;
    attributes.push_back(leaves.attributes(leaf, complex.leaf_regions[leaf], unfolding.instances[i], grades));
  }
  std::vector<Group> groups = leaf_groups(complex, attributes);
  Values values(unfolding.instances.size());
  for (const InstanceId i : IdRange<InstanceId>(values.size())) {
    const LeafId leaf = leaves.leaf_of(i);
    if (!leaf.valid()) continue;
    const Instance& instance = unfolding.instances[i];
    NodeValue value =
        value_of_leaf(tree, leaves, instance, grades, complex, leaf, std::move(groups[leaf.index()]));
    apply_attributes(complex, tree.nodes[instance.node], {}, value);  // of a leaf they have the material already
    values[i] = std::make_shared<NodeValue>(std::move(value));
  }
  return values;
}

/// Counts and volumes of leaves, for their rows: no leaf's depend on another's.
void measure_leaves(const Complex& complex, const Values& values) {
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t i) {
    const NodeValue* value = values[InstanceId(i)].get();
    if (value == nullptr || !value->is_group()) return;
    for (const PartRef& part : value->parts().parts) part->counts(complex), part->volumes(complex);
  });
}

/// How often each value is still needed: by users, and once more by each root.
IdVector<InstanceId, std::size_t> count_uses(const Unfolding& unfolding) {
  IdVector<InstanceId, std::size_t> uses(unfolding.instances.size());
  for (const Instance& instance : unfolding.instances) {
    for (const InstanceId operand : instance.operands) ++uses[operand];
  }
  for (const InstanceId root : unfolding.roots) ++uses[root];
  return uses;
}

/// The leaves below an instance, ascending.
std::vector<LeafId> leaves_below(const Unfolding& unfolding, const PreparedLeaves& leaves, InstanceId root) {
  std::vector<char> below(root.index() + 1);
  below[root.index()] = true;
  std::vector<LeafId> result;
  for (std::size_t i = below.size(); i-- > 0;) {  // users come after operands
    if (!below[i]) continue;
    const LeafId leaf = leaves.leaf_of(InstanceId(i));
    if (leaf.valid()) result.push_back(leaf);
    for (const InstanceId operand : unfolding.instances[InstanceId(i)].operands) below[operand.index()] = true;
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The operator of an inner instance on its operands' values; faults of the input come at the operator's place.
/// `last(operand)`: nobody needs the operand's value after this.
template <class Last>
Outcome value_of(const Tree& tree, const Unfolding& unfolding, const PreparedLeaves& leaves, Grades& grades,
                 const Values& values, const Complex& complex, InstanceId id, bool validate, Last last) {
  const Instance& instance = unfolding.instances[id];
  const Node& node = tree.nodes[instance.node];
  std::vector<Operand> operands;
  for (const InstanceId operand : instance.operands) {
    NodeValue* const value = values[operand].get();
    operands.push_back(
        {value, tree.nodes[unfolding.instances[operand].node].name, last(operand) ? value : nullptr, {}});
    if (is_topological(node.op)) operands.back().below = leaves_below(unfolding, leaves, operand);
  }
  try {
    return operate(complex, node, grades.on(instance, node.material), operands, validate);
  } catch (const InputError& e) {
    throw TreeError(tree.file, node.operator_at, e.what());
  }
}

/// Exact volume of each component with 3-cells, ascending; nothing for an unbounded one.
std::vector<std::pair<Component, std::optional<Rational>>> volumes_of(const Complex& complex,
                                                                      const Selection& selection) {
  std::map<Component, std::vector<RegionId>> cells;
  for (const auto& [cell, component] : selection.regions) cells[component].push_back(cell);
  std::vector<std::pair<Component, std::optional<Rational>>> result;
  for (const auto& [component, list] : cells) result.emplace_back(component, volume(complex, list));
  return result;
}

NodeRow row_of(const Tree& tree, const Unfolding& unfolding, InstanceId id) {
  const Instance& instance = unfolding.instances[id];
  const Node& node = tree.nodes[instance.node];
  NodeRow row;
  row.node = instance.node;
  row.name = unfolding.count[instance.node] == 1 ? node.name : node.name + "#" + std::to_string(instance.number);
  row.operator_name = node.operator_name;
  return row;
}

/// The simplified complex of a value, made when it is first asked for: conflicts name its cells, the row of a root
/// has its counts, its files are it.
class Simplified {
 public:
  Simplified(const Complex& complex, const NodeValue& value) : complex_(complex), value_(value) {}
  const Selection& selection() {
    if (!selection_) selection_ = selection_of(complex_, value_);
    return *selection_;
  }
  SimplifiedComplex& get() {
    if (!made_) {
      made_ = simplify(complex_, value_, selection());
      put_in_order(complex_, *made_);
    }
    return *made_;
  }

 private:
  const Complex& complex_;
  const NodeValue& value_;
  std::optional<Selection> selection_;
  std::optional<SimplifiedComplex> made_;
};

std::array<std::size_t, 4> raw_counts(const Selection& selection) {
  return {selection.vertices.size(), selection.edges.size(), selection.faces.size(), selection.regions.size()};
}

/// The group of a root that no other node uses: nothing is kept for a next value, and its cells are at hand.
void measure_last(const Complex& complex, const PartedGroup& group, Simplified& simplified, NodeRow& row) {
  row.raw_cells = raw_counts(simplified.selection());
  row.cells = active_counts(simplified.get());
  row.total = Rational(0);
  for (const PartRef& part : group.parts) {
    for (const std::optional<Rational>& one : part->volumes(complex)) {
      ++row.regions;
      if (row.total && one) *row.total += *one;
      else row.total.reset();
    }
  }
}

/// Fills the numbers of a row. A group's are kept with its parts: measured once, whichever values share them.
/// `simplified`: of a root that no other node uses; may be nullptr.
void measure(const Complex& complex, NodeValue& value, bool region_volumes, Simplified* simplified, NodeRow& row) {
  row.is_group = value.is_group();
  if (value.is_group()) {
    if (simplified != nullptr) {
      measure_last(complex, std::as_const(value).parts(), *simplified, row);
    } else {
      const Totals& totals = cnrg::measure(complex, value.parts());
      row.raw_cells = totals.raw;
      row.cells = totals.simplified;
      row.regions = totals.regions;
      row.total = totals.volume();
    }
    if (!region_volumes) return;
    const PartedGroup& group = std::as_const(value).parts();
    row.volumes = volumes(complex, group);
    for (const auto& [part, region] : region_order(group)) {
      const auto number = static_cast<Component>(row.named.size() + 1);
      row.named.emplace_back(number, group.parts[part]->group().regions[region - 1].name);
    }
    return;
  }
  const Selection& selection = value.components().selection;
  row.components = value.component_count();
  row.raw_cells = raw_counts(selection);
  row.cells =
      simplified != nullptr ? active_counts(simplified->get()) : simplified_counts(complex, value, selection);
  row.total = Rational(0);
  for (auto& [component, one] : volumes_of(complex, selection)) {
    ++row.regions;
    if (row.total && one) *row.total += *one;
    else row.total.reset();
    if (!region_volumes) continue;
    row.volumes.push_back(std::move(one));
    row.named.emplace_back(component, value.attributes(component).name);
  }
}

/// The simplified cells that hold the cells of a set, largest dimension first.
std::vector<SimplifiedComplex::Place> places_of(const SimplifiedComplex& simplified, const CellSet& cells) {
  std::vector<SimplifiedComplex::Place> places;
  const auto add = [&](const auto& list, const std::vector<SimplifiedComplex::Place>& map) {
    for (const auto cell : list) places.push_back(map[cell.index()]);
  };
  add(cells.regions, simplified.region_place);
  add(cells.faces, simplified.face_place);
  add(cells.edges, simplified.edge_place);
  add(cells.vertices, simplified.vertex_place);
  const auto key = [](const SimplifiedComplex::Place& p) { return std::pair(-p.dimension, p.index); };
  std::sort(places.begin(), places.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [&](const auto& a, const auto& b) { return key(a) == key(b); };
  places.erase(std::unique(places.begin(), places.end(), same), places.end());
  return places;
}

/// As `cnrg locate` names them, the first eight.
std::string cell_names(const std::vector<SimplifiedComplex::Place>& places) {
  constexpr std::size_t kListed = 8;
  std::string text = places.size() == 1 ? "cell " : "cells ";
  for (std::size_t i = 0; i < std::min(places.size(), kListed); ++i) {
    text += (i == 0 ? "" : ", ") + cell_name(places[i].dimension, places[i].index);
  }
  return places.size() > kListed ? text + " and " + std::to_string(places.size() - kListed) + " more" : text;
}

/// The active cells among `cells`.
CellSet active_of(const Selection& selection, const CellSet& cells) {
  CellSet out;
  const auto pick = [](const auto& list, const auto& from, auto& to) {
    for (const auto id : from) {
      if (place_in(list, id) != list.size()) to.push_back(id);
    }
  };
  pick(selection.vertices, cells.vertices, out.vertices);
  pick(selection.edges, cells.edges, out.edges);
  pick(selection.faces, cells.faces, out.faces);
  pick(selection.regions, cells.regions, out.regions);
  return out;
}

void report_conflicts(const Tree& tree, const Node& node, const NodeValue& value,
                      const std::vector<MaterialConflict>& conflicts, Simplified& simplified, Evaluation& result) {
  std::set<std::string> said;  // a fold may meet the same materials in the same cells more than once
  for (const MaterialConflict& conflict : conflicts) {
    // The others went in a later step of a fold.
    const CellSet cells = active_of(simplified.selection(), conflict.cells);
    if (cells.empty()) continue;
    const std::vector<SimplifiedComplex::Place> places = places_of(simplified.get(), cells);
    const Component component = component_of(simplified.get(), places.front());
    const std::string message =
        "`" + node.name + "`: the region `" + value.attributes(component).name + "` keeps the material `" +
        conflict.kept.name() + "` where `" + conflict.other.name() +
        (conflict.kept.name() == conflict.other.name() ? "` placed otherwise" : "`") + " has equal dominance (" +
        cell_names(places) + "); give one of the two a greater `dominance`";
    if (!said.insert(message).second) continue;
    result.diagnostics.push_back({tree.file, node.operator_at, Diagnostic::Level::warning, message});
  }
}

/// `roots`: those whose values are kept. Without `graded` every material is the same all over.
Evaluation evaluate_roots(const Tree& tree, const std::vector<NodeId>& roots, const EvaluateOptions& options,
                          bool graded) {
  const auto progress = [&](std::string_view stage, std::size_t done, std::size_t total) {
    if (options.progress) options.progress(stage, done, total);
  };
  std::optional<tbb::global_control> limit;
  if (options.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  }
  Evaluation result;
  const Unfolding unfolding = unfold(tree, roots);

  progress("leaves", 0, 0);
  const PreparedLeaves leaves(tree, unfolding);
  result.diagnostics = leaves.notices();

  progress("refine", 0, 0);
  refine(leaves, options, result);
  report_dropped(tree, leaves, result);
  const Complex& complex = *result.complex;

  // What distances are measured to is evaluated by itself; in it materials do not matter.
  Grades grades(tree, graded ? unfolding : Unfolding(), [&](NodeId node) {
    EvaluateOptions alone;
    alone.threads = options.threads;
    alone.rows = false;
    return evaluate_roots(tree, {node}, alone, false);
  });
  Values values = leaf_values(tree, unfolding, leaves, grades, complex);
  if (options.rows) measure_leaves(complex, values);
  IdVector<InstanceId, std::size_t> uses = count_uses(unfolding);
  std::map<InstanceId, SimplifiedComplex> simplified_roots;
  for (const InstanceId id : IdRange<InstanceId>(values.size())) {
    progress("nodes", id.index(), values.size());
    const Instance& instance = unfolding.instances[id];
    NodeRow row = row_of(tree, unfolding, id);
    std::shared_ptr<NodeValue> value = std::move(values[id]);
    std::vector<MaterialConflict> conflicts;
    if (!value) {
      const Stopwatch stopwatch;
      const auto last = [&](InstanceId operand) { return uses[operand] == 1 && !options.keep_all; };
      Outcome outcome = value_of(tree, unfolding, leaves, grades, values, complex, id, options.validate, last);
      row.seconds = stopwatch.seconds();
      row.removals = std::move(outcome.removals);
      conflicts = std::move(outcome.conflicts);
      value = std::make_shared<NodeValue>(std::move(outcome.value));
    }
    Simplified simplified(complex, *value);
    report_conflicts(tree, tree.nodes[instance.node], *value, conflicts, simplified, result);
    const bool is_root = std::find(unfolding.roots.begin(), unfolding.roots.end(), id) != unfolding.roots.end();
    if (options.rows || is_root) {
      // The result's cells are simplified for its files in any case: no part of the time of its row.
      const bool last = instance.node == tree.result && is_root && uses[id] == 1 && !options.raw;
      if (last) simplified.get();
      const Stopwatch stopwatch;
      measure(complex, *value, options.region_volumes || is_root, last ? &simplified : nullptr, row);
      row.measure_seconds = stopwatch.seconds();
      if (last) simplified_roots.emplace(id, std::move(simplified.get()));
    }
    values[id] = std::move(value);
    result.rows.push_back(std::move(row));
    for (const InstanceId operand : instance.operands) {
      if (--uses[operand] == 0 && !options.keep_all) values[operand].reset();
    }
  }
  progress("nodes", values.size(), values.size());

  for (const InstanceId root : unfolding.roots) {
    const NodeValue& value = *values[root];
    const auto [made, missing] = simplified_roots.try_emplace(root);
    if (missing) {
      made->second = simplify(complex, value, selection_of(complex, value),
                              options.raw ? SimplifyMode::raw : SimplifyMode::features);
      put_in_order(complex, made->second);
    }
    const NodeId node = unfolding.instances[root].node;
    result.kept.push_back({node, values[root], std::make_shared<const SimplifiedComplex>(std::move(made->second)),
                           leaves_below(unfolding, leaves, root), tree.nodes[node].name});
  }
  for (const Material& m : tree.materials) result.materials.push_back({m.name, m.color});
  result.raw = options.raw;
  result.instances = unfolding.instances;
  if (options.keep_all) {
    for (std::shared_ptr<NodeValue>& value : values) result.values.push_back(std::move(value));
  }
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

std::size_t NodeRow::removed() const {
  std::size_t total = 0;
  for (const auto& [id, count] : removals) total += count;
  return total;
}

const KeptValue& Evaluation::value(NodeId node) const {
  const auto it = std::find_if(kept.begin(), kept.end(), [&](const KeptValue& k) { return k.node == node; });
  require(it != kept.end(), "evaluate: the value of this node was not kept");
  return *it;
}

}  // namespace cnrg

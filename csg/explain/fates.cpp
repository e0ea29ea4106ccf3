// The steps of a Boolean are run again, as `explain` does, and each entity asks for its verdict.
#include "csg/explain/fates.h"

#include "csg/operators/node_value.h"
#include "csg/operators/pair_refinement.h"
#include "csg/operators/verdict.h"
#include "kernel/base/error.h"
#include "kernel/complex/by_dimension.h"

namespace cnrg {
namespace {

constexpr Component kNoTable = 1 + kRelations * 4;

/// A component per cell, 0 where nothing is known yet.
template <class IdT>
using Fates = IdVector<IdT, Component>;
using FateMarks = OfEntities<Fates>;

template <class IdT>
std::vector<std::pair<IdT, Component>> marked_cells(const Fates<IdT>& marks) {
  std::vector<std::pair<IdT, Component>> out;
  for (const IdT id : IdRange<IdT>(marks.size())) {
    if (marks[id] != 0) out.emplace_back(id, marks[id]);
  }
  return out;
}

void note(const Verdict& verdict, Component& mark) {
  if (!verdict.entity || verdict.row == nullptr) return;
  const Fate fate{verdict.relation, verdict.row->standing != Standing::equal, verdict.removed, true};
  const bool outside = verdict.relation == Relation::a_out_b || verdict.relation == Relation::b_out_a;
  if (fate.removed || mark == 0 || Fate::of(mark).removed || !outside) mark = fate.component();
}

void ask_tables(const Complex& complex, const Node& node, const std::vector<Operand>& operands, FateMarks& marks) {
  for_each_step(complex, node, operands, {}, [&](const BooleanStep& step) {
    const auto ask = [&](const auto& cells, auto& known) {
      for (const auto cell : cells) note(verdict(complex, step, cell), known[cell]);
    };
    for (const Group* group : {&step.left, &step.right}) for_each_entity(ask, *group, marks);
  });
}

bool is_boolean(Operator op) {
  return op == Operator::unite || op == Operator::intersect || op == Operator::subtract;
}

std::vector<Operand> operands_of(const Evaluation& evaluation, const Instance& instance) {
  std::vector<Operand> out;
  for (const InstanceId operand : instance.operands) {
    out.push_back({evaluation.values[operand].get(), evaluation.rows[operand.index()].name, nullptr, {}});
  }
  return out;
}

/// Counts the cells of a step by row; the operands alone cut each other.
class RowCounter {
 public:
  RowCounter(const Complex& complex, AskedRows& rows) : complex_(complex), rows_(rows), pair_(complex) {}

  void count(const BooleanStep& step) {
    const Roles step_roles = roles(step.op, step.dominance);
    rows_.steps.push_back({step.operand, step_roles, step.rule});
    if (step.rule == StepRule::operands) open_table(step.op, step_roles.dominant);
    pair_.refine(step.left, step.right);
    const auto count_left = [&](const auto& cells) {
      for (const auto cell : cells) count(step, cell);
    };
    const auto count_right = [&](const auto& cells) {
      for (const auto cell : cells) {
        if (!step.left.has(cell)) count(step, cell);
      }
    };
    for_each_entity(count_left, step.left);
    for_each_entity(count_right, step.right);
  }

 private:
  const Complex& complex_;
  AskedRows& rows_;
  PairRefinement pair_;

  void open_table(BooleanOp op, bool dominant) {
    for (std::size_t relation = 0; relation < kRelations; ++relation) {
      for (const int dimension : {0, 1, 2}) {
        rows_.cells.try_emplace(table_row(op, dominant, dimension, static_cast<Relation>(relation)));
      }
    }
  }
  template <class IdT>
  void count(const BooleanStep& step, IdT cell) {
    if (!pair_.is_first(cell)) return;
    const Verdict found = verdict(complex_, step, cell);
    if (!found.entity || found.row == nullptr) return;
    open_table(step.op, found.row->standing != Standing::equal);
    ++rows_.cells[static_cast<std::size_t>(found.row - table_rows().data())][found.removed ? 1 : 0];
  }
};

}  // namespace

AskedRows asked_rows(const Tree& tree, const Evaluation& evaluation, InstanceId id) {
  AskedRows out;
  const Instance& instance = evaluation.instances[id];
  const Node& node = tree.nodes[instance.node];
  if (!is_boolean(node.op)) return out;
  RowCounter counter(*evaluation.complex, out);
  for_each_step(*evaluation.complex, node, operands_of(evaluation, instance), {},
                [&](const BooleanStep& step) { counter.count(step); });
  return out;
}

Component Fate::component() const {
  if (!table) return kNoTable;
  return 1 + static_cast<Component>(relation) * 4 + (dominant ? 2 : 0) + (removed ? 1 : 0);
}

Fate Fate::of(Component component) {
  if (component == kNoTable) return {Relation::common, false, true, false};
  const Component code = component - 1;
  return {static_cast<Relation>(code / 4), (code & 2) != 0, (code & 1) != 0, true};
}

std::optional<Selection> fates(const Tree& tree, const Evaluation& evaluation, InstanceId id) {
  const Complex& complex = *evaluation.complex;
  const Instance& instance = evaluation.instances[id];
  const Node& node = tree.nodes[instance.node];
  if (instance.operands.empty()) return std::nullopt;
  FateMarks marks(complex);
  const std::vector<Operand> operands = operands_of(evaluation, instance);
  const bool boolean = is_boolean(node.op);
  if (boolean) ask_tables(complex, node, operands, marks);
  // What no table was asked about: what the operands have and the value does not.
  const Selection kept = selection_of(complex, *evaluation.values[id]);
  const auto lose = [&](const auto& before, const auto& after, auto& mark) {
    auto at = after.begin();
    for (const auto& [cell, component] : before) {
      while (at != after.end() && at->first < cell) ++at;
      const bool stays = at != after.end() && at->first == cell;
      if (!stays && (mark[cell] == 0 ? !boolean : !Fate::of(mark[cell]).removed)) mark[cell] = kNoTable;
    }
  };
  for (const Operand& operand : operands) {
    const Selection before = selection_of(complex, *operand.value);
    for_each_entity(lose, before, kept, marks);
  }
  Selection out{marked_cells(marks.vertices), marked_cells(marks.edges), marked_cells(marks.faces), {}};
  if (out.vertices.empty() && out.edges.empty() && out.faces.empty()) return std::nullopt;
  return out;
}

InstanceId instance_of(const Evaluation& evaluation, const KeptValue& kept) {
  InstanceId of;
  for (const InstanceId i : IdRange<InstanceId>(evaluation.values.size())) {
    if (evaluation.values[i] == kept.value) of = i;
  }
  require(of.valid(), "the evaluation has not kept all values");
  return of;
}

Selection removed_entities(const Tree& tree, const Evaluation& evaluation, const KeptValue& kept) {
  std::optional<Selection> all = fates(tree, evaluation, instance_of(evaluation, kept));
  if (!all) return {};
  const auto keep_removed = [](auto& cells) {
    std::erase_if(cells, [](const auto& cell) { return !Fate::of(cell.second).removed; });
    for (auto& cell : cells) cell.second = 1;
  };
  for_each_entity(keep_removed, *all);
  return std::move(*all);
}

}  // namespace cnrg

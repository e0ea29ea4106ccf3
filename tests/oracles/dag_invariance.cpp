#include "tests/oracles/dag_invariance.h"

#include <algorithm>
#include <array>

#include "tests/oracles/dag_values.h"
#include "tests/oracles/evaluation.h"

namespace cnrg::properties {
namespace {

using Failure = std::string;
using scenes::Motion;

/// A value without its names of cells: canonical forms of the whole and of each component, sorted; what
/// simplification with features leaves; volumes.
struct Form {
  Skeleton whole;
  std::vector<Skeleton> components;
  std::array<std::size_t, 4> cells{};
  std::vector<std::optional<Rational>> volumes;
  friend bool operator==(const Form&, const Form&) = default;
};

bool is_before(const Skeleton& a, const Skeleton& b) {
  const auto key = [](const Skeleton& s) {
    std::vector<RationalPoint> points;
    std::vector<char> marks;
    for (const auto& v : s.vertices) points.push_back(v.point), marks.push_back(v.mark);
    return std::tuple(std::move(points), std::move(marks), s.edges, s.facets, s.volumes);
  };
  return key(a) < key(b);
}

/// Moves a canonical form. Which side of a facet is above depends on the axes: in both forms it is forgotten.
Skeleton moved(Skeleton s, const Motion& motion) {
  for (auto& v : s.vertices) v.point = motion(v.point);
  for (auto& f : s.facets) {
    const bool one = f.above || f.below, both = f.above && f.below;
    f.above = one, f.below = both;
  }
  s.sort();
  return s;
}

std::vector<Form> forms(const RandomDag& dag, const DagValues& values, const Motion& motion) {
  std::vector<Form> out;
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    const Selection selection = selection_of(values.complex(), *values.values[i]);
    Form form;
    form.whole = moved(skeleton(values.complex(), joined(selection)), motion);
    for (Component c = 1; c <= values.values[i]->component_count(); ++c)
      form.components.push_back(
          moved(skeleton(values.complex(), joined(restrict_to(selection, support(selection, c)))), motion));
    std::sort(form.components.begin(), form.components.end(), is_before);
    for (const NodeRow& row : values.evaluation.rows)
      if (row.name == name_of(dag, i)) form.cells = row.cells, form.volumes = row.volumes;
    std::sort(form.volumes.begin(), form.volumes.end());
    out.push_back(std::move(form));
  }
  return out;
}

Failure compare(const RandomDag& dag, const std::vector<Form>& a, const std::vector<Form>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::string node = name_of(dag, i) + " (" + operator_name(dag.nodes[i]) + "): ";
    if (Failure f = difference(a[i].whole, b[i].whole); !f.empty()) return node + "\n" + f;
    if (a[i].components != b[i].components) return node + "components differ";
    if (a[i].cells != b[i].cells) return node + "counts of simplified cells differ";
    if (a[i].volumes != b[i].volumes) return node + "volumes differ";
  }
  return {};
}

template <class T>
void turn(std::vector<T>& list) {
  std::reverse(list.begin(), list.end());
}

/// The same dag with all lists of its leaves turned round, the first points of loops moved on, and the leaves in
/// another order: nodes of leaves come last first, and are named by new numbers.
RandomDag permuted(RandomDag dag, std::vector<std::size_t>& number) {
  for (scenes::Leaf& leaf : dag.leaves) {
    turn(leaf.faces);
    turn(leaf.wires);
    turn(leaf.points);
    for (auto& wire : leaf.wires) std::swap(wire[0], wire[1]);
    for (scenes::Face& face : leaf.faces)
      for (scenes::Polygon& loop : face.loops) std::rotate(loop.begin(), loop.begin() + 1, loop.end());
  }
  // Leaves first, from the last; inner nodes keep their order.
  number.assign(dag.nodes.size(), 0);
  std::vector<std::size_t> order;
  for (std::size_t i = dag.nodes.size(); i-- > 0;)
    if (dag.nodes[i].op == Operator::leaf) order.push_back(i);
  for (std::size_t i = 0; i < dag.nodes.size(); ++i)
    if (dag.nodes[i].op != Operator::leaf) order.push_back(i);
  RandomDag out;
  out.leaves = dag.leaves;
  for (std::size_t k = 0; k < order.size(); ++k) number[order[k]] = k;
  for (const std::size_t i : order) {
    out.nodes.push_back(dag.nodes[i]);
    for (std::size_t& operand : out.nodes.back().operands) operand = number[operand];
  }
  return out;
}

}  // namespace

std::string permutation_failure(const RandomDag& dag) {
  std::vector<std::size_t> number;
  const RandomDag other = permuted(dag, number);
  const Attempt a = attempt(dag), b = attempt(other);
  if (!a.values) return a.failure;
  if (!b.values) return b.failure;
  const std::vector<Form> forms_b = forms(other, *b.values, {});
  std::vector<Form> in_order;
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) in_order.push_back(forms_b[number[i]]);
  return compare(dag, forms(dag, *a.values, {}), in_order);
}

std::string motion_failure(const RandomDag& dag) {
  Motion motion = Motion::rotation(2, 1, 3, -1);
  motion.offset = {Rational(1, 3), Rational(-5, 7), 1000};
  RandomDag other = dag;
  for (scenes::Leaf& leaf : other.leaves) apply(motion, leaf);
  const Attempt a = attempt(dag), b = attempt(other);
  if (!a.values) return a.failure;
  if (!b.values) return b.failure;
  return compare(dag, forms(dag, *a.values, motion), forms(other, *b.values, {}));
}

}  // namespace cnrg::properties

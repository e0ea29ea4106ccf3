#include "tests/oracles/cubical_dag.h"

#include <algorithm>
#include <map>

#include "kernel/selection/simplify.h"
#include "tests/oracles/cubical_pair.h"
#include "tests/oracles/cubical_values.h"
#include "tests/oracles/dag_values.h"

namespace cubical {
namespace {

using cnrg::Operator;
using cnrg::Rational;
using cnrg::RationalPoint;
using cnrg::properties::DagNode;
using cnrg::properties::is_group_boolean;
using cnrg::properties::RandomDag;
using cnrg::scenes::Motion;

/// Whether all cells of the value are features of it: then no rule depends on cuts.
std::vector<char> named(const RandomDag& dag) {
  std::vector<char> out;
  for (const DagNode& node : dag.nodes) {
    const bool keeps =
        node.op == Operator::leaf || is_group_boolean(node.op) || (node.op == Operator::simplify && !node.points);
    out.push_back(keeps && !node.regularize &&
                  std::all_of(node.operands.begin(), node.operands.end(), [&](auto i) { return out[i] != 0; }));
  }
  return out;
}

/// In a wall of the weaker operand of an intersection stays what is a feature of it, and a mere cut goes. Which is
/// which the brute force knows only while all cells are features; any other such node loses its dominance.
void drop_dominance_without_features(RandomDag& dag) {
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    const std::vector<char> features = named(dag);
    DagNode& node = dag.nodes[i];
    if (node.op != Operator::intersect || !node.dominant) continue;
    if (!std::all_of(node.operands.begin(), node.operands.end(), [&](auto k) { return features[k] != 0; }))
      node.dominant = cnrg::DominantOperand::equal;
  }
}

template <class IdT>
cnrg::Component component_of(const std::vector<std::pair<IdT, cnrg::Component>>& list, IdT id) {
  const auto it = std::lower_bound(list.begin(), list.end(), std::pair<IdT, cnrg::Component>(id, 0));
  return it != list.end() && it->first == id ? it->second : 0;
}

cnrg::Component component_at(const cnrg::Selection& s, const cnrg::Location& at) {
  switch (at.dimension) {
    case 0: return component_of(s.vertices, at.vertex);
    case 1: return component_of(s.edges, at.edge);
    case 2: return component_of(s.faces, at.face);
    default: return component_of(s.regions, at.region);
  }
}

std::string name(const Grid& grid, Cell c) {
  const auto p = grid.position(c);
  return "(" + std::to_string(p[0]) + "," + std::to_string(p[1]) + "," + std::to_string(p[2]) + ")/2";
}

/// Components correspond one to one on all cells.
std::string compare_components(const Grid& grid, const std::vector<Cell>& cells,
                               const std::vector<cnrg::Location>& places, const Labels& want,
                               const cnrg::Selection& have) {
  std::map<std::uint32_t, cnrg::Component> to;
  std::map<cnrg::Component, std::uint32_t> from;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::uint32_t w = want[static_cast<std::size_t>(cells[i])];
    const cnrg::Component h = component_at(have, places[i]);
    if ((w == 0) != (h == 0)) return name(grid, cells[i]) + (w != 0 ? " should be active" : " should be inactive");
    if (w == 0) continue;
    if (!to.emplace(w, h).second && to[w] != h) return name(grid, cells[i]) + " splits a component";
    if (!from.emplace(h, w).second && from[h] != w) return name(grid, cells[i]) + " joins components";
  }
  return {};
}

}  // namespace

Motion random_place(std::uint64_t seed) {
  cnrg::scenes::Random random(seed * 17 + 3);
  Motion motion;
  if (random.one_in(2)) {
    motion = Motion::rotation(random.between(1, 4), random.between(-3, 3), random.between(-3, 3),
                              random.between(-3, 3));
  }
  if (random.one_in(2)) {
    Motion shear;
    const int i = random.below(3), j = (i + random.between(1, 2)) % 3;
    shear.matrix[i][j] = Rational(random.between(-5, 5)) / random.between(1, 7);
    motion = after(motion, shear);
  }
  if (random.one_in(3)) {
    Motion scale;
    for (int k = 0; k < 3; ++k) scale.matrix[k][k] = Rational(random.between(1, 9)) / random.between(1, 9);
    motion = after(motion, scale);
  }
  if (random.one_in(6)) {
    Rational factor = 1;
    for (int n = random.between(1, 40); n > 0; --n) factor *= 10;
    motion = after(motion, Motion::scaling(random.one_in(2) ? factor : Rational(1 / factor)));
  }
  if (random.one_in(4)) {
    Motion mirror;
    const int k = random.below(3);
    mirror.matrix[k][k] = -1;
    motion = after(motion, mirror);
  }
  for (Rational& x : motion.offset) x += Rational(random.between(-9, 9)) / random.between(1, 11);
  return motion;
}

CubicalDag random_cubical_dag(const Grid& grid, std::uint64_t seed, bool moved) {
  std::mt19937_64 random(seed + 123);
  std::vector<cnrg::scenes::Leaf> leaves;
  const std::size_t count = 2 + random() % 2 + (random() % 4 == 0 ? 1 : 0);
  while (leaves.size() < count) {
    cnrg::scenes::Leaf leaf =
        leaf_of(grid, random_group(grid, random, random() % 2 == 0, random() % 2 == 0 ? 1 : 4), false);
    if (!leaf.faces.empty() || !leaf.wires.empty() || !leaf.points.empty()) leaves.push_back(std::move(leaf));
  }
  CubicalDag out;
  out.dag = cnrg::properties::random_dag(seed, std::move(leaves));
  drop_dominance_without_features(out.dag);
  if (moved) out.place = random_place(seed);
  return out;
}

RandomDag placed(const CubicalDag& dag) {
  RandomDag out = dag.dag;
  for (cnrg::scenes::Leaf& leaf : out.leaves) place(dag.place, leaf);
  return out;
}

std::string compare_by_brute_force(const Grid& grid, const CubicalDag& dag) {
  std::vector<Value> want;
  if (std::string f = values_by_brute_force(grid, dag.dag, want); !f.empty()) return f;
  const cnrg::properties::DagValues have = cnrg::properties::evaluate(placed(dag));
  const cnrg::Complex& complex = have.complex();
  const cnrg::Locator locator(complex);
  std::vector<Cell> cells;
  std::vector<cnrg::Location> places;
  for (Cell c = 0; c < grid.cells(); ++c) {
    const auto p = grid.position(c);
    cells.push_back(c);
    places.push_back(locator.locate(dag.place({Rational(p[0], 2), Rational(p[1], 2), Rational(p[2], 2)})));
  }
  for (std::size_t i = 0; i < want.size(); ++i) {
    const cnrg::NodeValue& value = *have.values[i];
    const std::string words =
        cnrg::properties::name_of(dag.dag, i) + " (" + cnrg::properties::operator_name(dag.dag.nodes[i]) + "): ";
    if (value.is_group() != want[i].is_group) return words + "a value of the wrong family";
    const cnrg::Selection selection = selection_of(complex, value);
    if (std::string f = compare_components(grid, cells, places, want[i].labels, selection); !f.empty())
      return words + f;
    const auto most = *std::max_element(want[i].labels.begin(), want[i].labels.end());
    if (!want[i].is_group && value.component_count() != most) return words + "the number of components differs";
    // Canonical counts of what does not reach the rim.
    const bool bounded = std::none_of(cells.begin(), cells.end(), [&](Cell c) {
      return grid.on_rim(c) && grid.dimension(c) == 3 && want[i].labels[static_cast<std::size_t>(c)] != 0;
    });
    if (!bounded) continue;
    const std::vector<int> state(want[i].labels.begin(), want[i].labels.end());
    const auto counts = active_counts(cnrg::simplify(complex, selection, {}, cnrg::SimplifyMode::points));
    if (counts != canonical_counts(grid, state)) return words + "counts of the canonical form differ";
  }
  return {};
}

std::string tree_file(const CubicalDag& dag) { return cnrg::properties::tree_file(placed(dag)); }

std::vector<CubicalDag> smaller(const Grid& grid, const CubicalDag& dag) {
  std::vector<CubicalDag> out;
  for (RandomDag& less : cnrg::properties::smaller(dag.dag)) {
    drop_dominance_without_features(less);
    out.push_back({std::move(less), dag.place});
  }
  for (std::size_t l = 0; l < dag.dag.leaves.size(); ++l) {
    for (const Group& less : smaller(grid, group_of(grid, dag.dag.leaves[l]))) {
      cnrg::scenes::Leaf leaf = leaf_of(grid, less, false);
      if (leaf.faces.empty() && leaf.wires.empty() && leaf.points.empty()) continue;
      out.push_back(dag);
      out.back().dag.leaves[l] = std::move(leaf);
    }
  }
  return out;
}

}  // namespace cubical

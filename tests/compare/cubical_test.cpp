// Random trees of cubical groups, compared, against arrays over all cells of the grid (tests/oracles/cubical.h).
//
// What is only in one of two arrays is counted there: its connected pieces, and its cells that bound no larger
// one. Nothing of the program is used but its answers.
#include <algorithm>
#include <map>
#include <set>

#include "csg/compare/compare.h"
#include "tests/catch.h"
#include "tests/oracles/cubical_dag.h"
#include "tests/oracles/cubical_values.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using cubical::Cell;
using cubical::Labels;
using properties::DagNode;
using properties::RandomDag;

const cubical::Grid& grid() {
  static const cubical::Grid small_grid(4);
  return small_grid;
}

/// A tree, and the components of its result on the grid.
struct Value {
  RandomDag dag;
  Labels labels;
};

Value value_of(RandomDag dag) {
  std::vector<cubical::Value> values;
  REQUIRE(cubical::values_by_brute_force(grid(), dag, values) == "");
  return {std::move(dag), values.back().labels};
}

/// A tree whose result has bounds.
Value random_value(std::uint64_t seed) {
  for (;; seed += 1'000'000) {
    Value value = value_of(cubical::random_cubical_dag(grid(), seed, false).dag);
    bool bounded = true;
    for (Cell c = 0; c < grid().cells(); ++c)
      bounded = bounded && !(grid().on_rim(c) && value.labels[static_cast<std::size_t>(c)] != 0);
    if (bounded) return value;
  }
}

/// An operator on the results of two trees.
Value both(Operator op, const Value& x, const Value& y) {
  RandomDag dag = x.dag;
  dag.leaves.insert(dag.leaves.end(), y.dag.leaves.begin(), y.dag.leaves.end());
  for (DagNode node : y.dag.nodes) {
    for (std::size_t& operand : node.operands) operand += x.dag.nodes.size();
    if (node.op == Operator::leaf) node.leaf += x.dag.leaves.size();
    dag.nodes.push_back(std::move(node));
  }
  DagNode top;
  top.op = op;
  top.operands = {x.dag.nodes.size() - 1, dag.nodes.size() - 1};
  dag.nodes.push_back(std::move(top));
  return value_of(std::move(dag));
}

using Set = std::set<Cell>;

struct Count {
  std::size_t pieces = 0;
  std::array<std::size_t, 4> cells{};  // by dimension, those that bound no larger one
};

/// Of a cell, those of which it is in the closure, or which are in its own.
std::vector<Cell> incident(Cell c) {
  std::vector<Cell> out;
  for (const bool up : {true, false}) {
    std::vector<Cell> next{c};
    while (!next.empty()) {
      const Cell at = next.back();
      next.pop_back();
      for (const Cell d : up ? grid().around(at) : grid().boundary(at)) out.push_back(d), next.push_back(d);
    }
  }
  return out;
}

Count count(const Set& set) {
  Count out;
  Set left = set;
  while (!left.empty()) {
    ++out.pieces;
    std::vector<Cell> open{*left.begin()};
    left.erase(left.begin());
    while (!open.empty()) {
      const Cell c = open.back();
      open.pop_back();
      for (const Cell d : incident(c))
        if (left.erase(d) != 0) open.push_back(d);
    }
  }
  for (const Cell c : set) {
    const std::vector<Cell> all = incident(c);
    const auto bounded_by_it = [&](Cell d) {
      return grid().dimension(d) > grid().dimension(c) && set.contains(d);
    };
    if (std::none_of(all.begin(), all.end(), bounded_by_it))
      ++out.cells[static_cast<std::size_t>(grid().dimension(c))];
  }
  return out;
}

Cell cell_of(const RationalPoint& p) {
  std::array<int, 3> c;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer whole = p[k].get_num() / p[k].get_den();
    c[k] = static_cast<int>(2 * whole.get_si()) + (p[k] == Rational(whole) ? 0 : 1);
  }
  return grid().at(c[0], c[1], c[2]);
}

/// Holds pieces of a comparison against a set of cells.
void check_pieces(const std::vector<SetPiece>& pieces, const Set& set) {
  const Count expected = count(set);
  CHECK(pieces.size() == expected.pieces);
  Size size;
  for (const SetPiece& piece : pieces) size.add(piece.size);
  REQUIRE(size.volume);
  CHECK(*size.volume == Rational(expected.cells[3]));
  CHECK(size.area.sum.text() == std::to_string(expected.cells[2]));
  CHECK(size.length.sum.text() == std::to_string(expected.cells[1]));
  CHECK(size.points == expected.cells[0]);
  for (const SetPiece& piece : pieces) CHECK(set.contains(cell_of(piece.at)));
  for (std::size_t i = 1; i < pieces.size(); ++i) CHECK(*pieces[i - 1].size.volume >= *pieces[i].size.volume);
}

/// One component of one array is one of the other, cell by cell.
bool one_to_one(const Labels& a, const Labels& b) {
  std::map<std::uint32_t, std::uint32_t> to_b, to_a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if ((a[i] == 0) != (b[i] == 0)) return false;
    if (to_b.emplace(a[i], b[i]).first->second != b[i] || to_a.emplace(b[i], a[i]).first->second != a[i])
      return false;
  }
  return true;
}

Set labels_apart(const Labels& a, const Labels& b) {
  Set out;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != 0 && b[i] == 0) out.insert(static_cast<Cell>(i));
  return out;
}

struct Verdict {
  bool sets = false, components = false;
};

Verdict check_values(const Value& a, const Value& b) {
  const std::string text_a = tree_file(a.dag), text_b = tree_file(b.dag);
  INFO("A:\n" << text_a << "\nB:\n" << text_b);
  const Tree tree_a = parse_tree(text_a, "a.yaml"), tree_b = parse_tree(text_b, "b.yaml");
  const auto compared = [&](const Tree& x, const Tree& y, const CompareOptions& options = {}) {
    return compare(x, x.result, y, y.result, options);
  };
  const Comparison comparison = compared(tree_a, tree_b);
  INFO(comparison_text(comparison, 100));
  const Set only_a = labels_apart(a.labels, b.labels), only_b = labels_apart(b.labels, a.labels);
  check_pieces(comparison.only[0], only_a);
  check_pieces(comparison.only[1], only_b);
  const bool alike = one_to_one(a.labels, b.labels);
  CHECK(comparison.same() == alike);
  CHECK((comparison_text(comparison).empty()) == alike);
  CHECK(comparison.attributes.empty());

  const Comparison mirrored = compared(tree_b, tree_a);
  CHECK(mirrored.same() == alike);
  for (std::size_t side = 0; side < 2; ++side) {
    CHECK(mirrored.only[side].size() == comparison.only[1 - side].size());
    CHECK(mirrored.features[side].size() == comparison.features[1 - side].size());
  }
  REQUIRE(mirrored.moved.size() == comparison.moved.size());
  CHECK(mirrored.regrouped.size() == comparison.regrouped.size());
  for (const Comparison::Moved& one : comparison.moved) {
    CHECK(std::any_of(mirrored.moved.begin(), mirrored.moved.end(), [&](const Comparison::Moved& other) {
      return other.in[0] == one.in[1] && other.in[1] == one.in[0] && other.pieces.size() == one.pieces.size();
    }));
  }
  CompareOptions points;
  points.components = false;
  CHECK(compared(tree_a, tree_b, points).same() == (only_a.empty() && only_b.empty()));
  return {only_a.empty() && only_b.empty(), alike};
}

TEST_CASE("Random trees of sets differ where arrays over a grid do", "[compare][cubical]") {
  const auto [first, last] = scenes::seeds(60);
  std::size_t sets = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    const Value a = random_value(3 * seed), b = random_value(3 * seed + 1), c = random_value(3 * seed + 2);
    sets += check_values(a, b).sets;
    // Changed in one operand at the top: large parts in common.
    check_values(both(Operator::sum, a, b), both(Operator::sum, a, c));
  }
  CHECK(sets < (last - first));
}

TEST_CASE("Random trees of sets, written otherwise, mean the same", "[compare][cubical]") {
  constexpr Operator kSum = Operator::sum, kProduct = Operator::product, kSubtract = Operator::cnrg_subtract;
  const auto [first, last] = scenes::seeds(60);
  std::size_t alike = 0, regrouped = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    const Value a = random_value(3 * seed), b = random_value(3 * seed + 1), c = random_value(3 * seed + 2);
    // x + y = y + x, (x + y) + z = x + (y + z), x y = y x, (x - y) - z = x - (y + z), with all components.
    const auto same = [&](const Value& x, const Value& y) {
      const Verdict verdict = check_values(x, y);
      CHECK(verdict.sets);
      CHECK(verdict.components);
      alike += verdict.components;
    };
    same(both(kSum, a, b), both(kSum, b, a));
    same(both(kProduct, a, b), both(kProduct, b, a));
    same(both(kSum, both(kSum, a, b), c), both(kSum, a, both(kSum, b, c)));
    same(both(kSubtract, both(kSubtract, a, b), c), both(kSubtract, a, both(kSum, b, c)));
    // x = (x - y) + x y as a set; components of x are parted.
    const Verdict parted = check_values(a, both(kSum, both(kSubtract, a, b), both(kProduct, a, b)));
    CHECK(parted.sets);
    regrouped += !parted.components;
  }
  CHECK(alike == 4 * (last - first));
  CHECK(regrouped > (last - first) / 4);
}

}  // namespace
}  // namespace cnrg

// Random dags against Nef polyhedra, node by node: the point set of every value, open, unbounded or neither,
// equals Nef's for the same expression (csg/SEMANTICS.md#identities), and components are those of the definitions.
#include <catch2/catch.hpp>
#include <exception>
#include <sstream>

#include "tests/properties/dag_reference.h"
#include "tests/properties/dag_values.h"
#include "tests/properties/evaluation.h"
#include "tests/scenes/fixture.h"
#include "tests/scenes/measure.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

/// A failed comparison: what and where, in words; empty when all is well.
using Failure = std::string;

/// With `each`, Nef gets the operand's components one by one; nodes of more are compared by definition only.
constexpr std::size_t kMostComponents = 8;

struct Tally {
  Coverage coverage;
  std::size_t oracle_failures = 0, contradictions = 0, nodes = 0, empty = 0, open = 0, unbounded = 0;
  std::size_t each_by_nef = 0, cells = 0;
};

class Comparison {
 public:
  Comparison(const RandomDag& dag, const DagValues& values, Tally& tally)
      : dag_(dag),
        values_(values),
        complex_(values.complex()),
        standings_(standings(dag)),
        tally_(tally),
        incidence_(complex_) {}

  Failure run() {
    for (const RegionId r : IdRange<RegionId>(complex_.region_count))
      volumes_.push_back(complex_.unbounded(r) ? Rational(0) : scenes::volume(complex_, r));
    for (std::size_t i = 0; i < dag_.nodes.size(); ++i) {
      const DagNode& node = dag_.nodes[i];
      const NodeValue& value = *values_.values[i];
      const std::vector<const NodeValue*> operands = values_.operands(node);
      if (Failure f = compare_by_definition(complex_, incidence_, node, operands, value); !f.empty())
        return words(i) + f;
      nefs_.push_back(nef_of(node, nefs_, i));
      if (Failure f = compare(i); !f.empty()) {
        if (contradicted(node, i)) {
          ++tally_.contradictions;
          throw OracleFailure("Nef contradicts itself");
        }
        return words(i) + f;
      }
    }
    const Selection root = point_set(dag_.nodes.size() - 1);
    if (!(to_nef(complex_, root) == nefs_.back())) return "the result as a Nef polyhedron is another one";
    return cells(root);
  }

 private:
  std::string words(std::size_t i) const { return name_of(dag_, i) + " (" + operator_name(dag_.nodes[i]) + "): "; }

  Selection point_set(std::size_t i) const { return joined(selection_of(complex_, *values_.values[i])); }

  using Nefs = std::vector<NefSet>;

  NefSet nef_of(const DagNode& node, const Nefs& nefs, std::size_t i) const {
    if (node.op == Operator::leaf) return NefSet::leaf(dag_.leaves[node.leaf]);
    NefSet result = node.each ? each(node, i) : applied(node, nefs);
    return node.regularize ? result.regularization() : result;
  }

  /// Nef gives our value when it gets the same operands, by its own equality, in another form: operations
  /// of CGAL 5.5.1 now and then give a broken structure without an assertion.
  bool contradicted(const DagNode& node, std::size_t i) {
    if (node.op == Operator::leaf || node.each) return false;
    Nefs again = nefs_;
    for (const std::size_t k : node.operands) {
      again[k] = to_nef(complex_, point_set(k));
      if (!(again[k] == nefs_[k])) return false;
    }
    nefs_[i] = nef_of(node, again, i);
    return compare(i).empty();
  }

  /// An operand of a group Boolean: a complement stands for its closure.
  NefSet group_operand(const Nefs& nefs, std::size_t i) const {
    return standings_[i] == Standing::complement ? nefs[i].closure() : nefs[i];
  }

  NefSet applied(const DagNode& node, const Nefs& nefs) const {
    const NefSet& x = nefs[node.operands[0]];
    const auto fold = [&](bool groups, auto op) {
      NefSet all = groups ? group_operand(nefs, node.operands[0]) : x;
      for (std::size_t k = 1; k < node.operands.size(); ++k)
        all = op(all, groups ? group_operand(nefs, node.operands[k]) : nefs[node.operands[k]]);
      return all;
    };
    const auto unite = [](const NefSet& a, const NefSet& b) { return a.unite(b); };
    const auto intersect = [](const NefSet& a, const NefSet& b) { return a.intersect(b); };
    switch (node.op) {
      case Operator::unite: return fold(true, unite);
      case Operator::intersect: return fold(true, intersect);
      case Operator::subtract: return fold(true, [](const NefSet& a, const NefSet& b) { return a.subtract(b); });
      case Operator::aggregate:
      case Operator::sum: return fold(false, unite);
      case Operator::product: return fold(false, intersect);
      case Operator::cnrg_subtract:
        return fold(false, [](const NefSet& a, const NefSet& b) { return a.without(b); });
      case Operator::complement: return x.complement();
      case Operator::unify:
      case Operator::simplify: return x;
      default: return topological(node.op, x);
    }
  }

  static NefSet topological(Operator op, const NefSet& x) {
    switch (op) {
      case Operator::interior: return x.interior();
      case Operator::closure: return x.closure();
      case Operator::boundary: return x.boundary();
      default: return x.regularization();
    }
  }

  NefSet each(const DagNode& node, std::size_t i) const {
    const NodeValue& operand = *values_.values[node.operands[0]];
    const Selection selection = selection_of(complex_, operand);
    if (operand.component_count() > kMostComponents) return to_nef(complex_, point_set(i));
    ++tally_.each_by_nef;
    std::vector<NefSet> parts;
    for (Component c = 1; c <= operand.component_count(); ++c)
      parts.push_back(
          topological(node.op, to_nef(complex_, joined(restrict_to(selection, support(selection, c))))));
    return NefSet::unite_all(std::move(parts));
  }

  Failure compare(std::size_t i) const {
    const Selection set = point_set(i);
    const NefSet& nef = nefs_[i];
    const Skeleton ours = skeleton(complex_, set), theirs = nef.skeleton();
    if (Failure f = difference(ours, theirs); !f.empty()) return "ours first, then Nef's:\n" + f;
    const bool unbounded = !set.regions.empty() && set.regions.front().first == RegionId(0);
    if (unbounded != nef.unbounded()) return "the mark of the unbounded region differs";
    if (volume(set) != nef.volume()) return "volumes differ";
    ++tally_.nodes;
    tally_.unbounded += unbounded;
    tally_.empty += support(set).empty();
    tally_.open += !missing_closure(set).empty();
    return {};
  }

  /// Of the bounded regions after simplification: cells of other leaves in the unbounded one are no volumes.
  Rational volume(const Selection& set) const {
    Rational sum = 0;
    for (const auto& region : simplify(complex_, set, {}, SimplifyMode::points).regions)
      if (region.component != 0 && region.bounded)
        for (const RegionId cell : region.cells) sum += volumes_[cell.index()];
    return sum;
  }

  CellSet missing_closure(const Selection& set) const {
    const CellSet own = support(set);
    return subtract(closure(complex_, own), own);
  }

  /// A point in every cell of the common refinement is in both sets or in none: no symmetric difference.
  Failure cells(const Selection& set) {
    const CellIncidence::Labels active = incidence_.labels(set);
    const NefSet& nef = nefs_.back();
    std::size_t i = 0;
    const auto check = [&](const RationalPoint& p) -> Failure {
      const bool ours = active[i] != 0;
      if (ours != nef.contains(p))
        return incidence_.name(i) + (ours ? " is" : " is not") + " in the result, Nef disagrees";
      ++i;
      return {};
    };
    Failure f;
    for (const VertexId v : complex_.vertices)
      if (f = check(complex_.points.rational(v)); !f.empty()) return f;
    for (const EdgeId e : IdRange<EdgeId>(complex_.edge_count()))
      if (f = check(scenes::point_in(complex_, e)); !f.empty()) return f;
    for (const FaceId x : IdRange<FaceId>(complex_.face_count()))
      if (f = check(scenes::point_in(complex_, x)); !f.empty()) return f;
    for (const RegionId r : IdRange<RegionId>(complex_.region_count))
      if (f = check(scenes::point_in(complex_, r)); !f.empty()) return f;
    tally_.cells += i;
    return {};
  }

  const RandomDag& dag_;
  const DagValues& values_;
  const Complex& complex_;
  std::vector<Standing> standings_;
  Tally& tally_;
  CellIncidence incidence_;
  std::vector<Rational> volumes_;
  Nefs nefs_;
};

Failure failure_of(const RandomDag& dag, Tally& tally) {
  const Attempt tried = attempt(dag);
  if (!tried.values) return tried.failure;
  try {
    return Comparison(dag, *tried.values, tally).run();
  } catch (const OracleFailure&) {
    ++tally.oracle_failures;
    return {};
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

}  // namespace

TEST_CASE("Nef's unbounded and open sets are what the tests take them for", "[dag]") {
  const NefSet cube = NefSet::solid(scenes::box_solid({0, 0, 0}, {2, 2, 2}));
  const NefSet outside = cube.complement();
  CHECK(outside.unbounded());
  CHECK(outside.contains({5, 5, 5}));
  CHECK_FALSE(outside.contains({2, 1, 1}));
  CHECK(outside.closure().contains({2, 1, 1}));
  CHECK(outside.complement() == cube);
  CHECK_FALSE(cube.interior() == cube);
  CHECK(cube.interior().closure() == cube);
  CHECK(cube.without(cube.interior()) == cube.boundary());
  CHECK(cube.boundary().volume() == 0);
  CHECK(outside.boundary() == cube.boundary());
  CHECK(outside.volume() == 0);
  // Space has no vertex that tells CGAL its mark.
  const NefSet space = cube.unite(outside);
  CHECK(space.unbounded());
  CHECK(space.skeleton().vertices.empty());
  CHECK(space.complement() == NefSet());
  CHECK_FALSE(space == cube);
  CHECK(space.without(outside) == cube);
  CHECK(NefSet().complement() == space);
  CHECK_FALSE(cube.intersect(outside).unbounded());
  // Where an edge of what is taken off meets a facet of an open set.
  const NefSet bar = NefSet::solid(scenes::box_solid({1, 1, 1}, {5, Rational(3, 2), Rational(3, 2)}));
  CHECK_FALSE(outside.without(bar).contains({2, 1, 1}));
  CHECK_FALSE(cube.interior().without(bar).contains({2, 1, 1}));
  CHECK(outside.without(bar) == cube.unite(bar).complement());
  // The unbounded volume is the same after two volumes have become one.
  const NefSet plate = NefSet::solid(scenes::box_solid({0, 1, 1}, {3, 2, 4}));
  const NefSet hollow = NefSet::solid(scenes::box_solid({1, 0, 3}, {2, 3, 5})).boundary();
  CHECK(plate.unite(hollow).regularization() == plate);
  CHECK_FALSE(plate.unite(hollow).regularization().unbounded());
  // A sheet has no interior; regularization is the closure of the interior.
  const NefSet sheet = NefSet::polygon({{{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}}});
  CHECK(sheet.interior() == NefSet());
  CHECK(cube.unite(sheet).regularization() == cube);
  CHECK(sheet.boundary() == sheet);
  CHECK(sheet.complement().closure() == space);
  CHECK(sheet.complement().interior() == sheet.complement());
}

TEST_CASE("Dags on which Nef was wrong equal Nef's", "[dag]") {
  struct Case {
    const char* leaves;
    std::vector<DagNode> nodes;
  };
  const auto node = [](Operator op, std::vector<std::size_t> operands) {
    DagNode n;
    n.op = op;
    n.operands = std::move(operands);
    return n;
  };
  DagNode regularized = node(Operator::closure, {3});
  regularized.regularize = true;
  const Case cases[] = {
      // Edges of the tetrahedron meet facets that the open set lacks.
      {"leaf cells\ntetrahedron 1 4 0, 4 1 1, 3 4 5, 5 3 4\nleaf sides\nbox 1 0 2, 4 3 3\n",
       {node(Operator::complement, {1}), node(Operator::cnrg_subtract, {2, 0})}},
      // A hollow box opens to the outside.
      {"leaf sides\nbox 0 1 1, 3 2 4\nleaf sides\nbox 1 0 3, 2 3 5\n",
       {node(Operator::boundary, {1}), node(Operator::sum, {0, 2}), regularized}},
      // A wire leaves a box through the hole that a tetrahedron makes.
      {"leaf sides\nprism 0 0 4 | 42/5 -6/5 8, 9/5 38/5 8, 49/5 68/5 8, 82/5 24/5 8\nleaf sides\n"
       "tetrahedron -20/7 123/7 51/7, 0 4 6, 96/7 83/7 143/7, 139/7 80/7 47/7\n"
       "wire 16/7 22/7 32/7, 41/7 101/7 152/7\n",
       {node(Operator::sum, {1, 0}), node(Operator::subtract, {2, 1})}},
  };
  for (const Case& c : cases) {
    RandomDag dag;
    dag.leaves = scenes::parse_fixture(c.leaves);
    for (std::size_t i = 0; i < dag.leaves.size(); ++i) {
      dag.nodes.push_back({});
      dag.nodes.back().leaf = i;
    }
    dag.nodes.insert(dag.nodes.end(), c.nodes.begin(), c.nodes.end());
    INFO(tree_file(dag));
    Tally tally;
    CHECK(failure_of(dag, tally) == "");
    CHECK(tally.nodes + 10 * tally.oracle_failures >= dag.nodes.size());
  }
}

TEST_CASE("Every value of random dags equals Nef's", "[dag]") {
  const auto [first, last] = scenes::seeds(160);
  Tally tally;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = random_dag(seed, position_of(seed));
    tally.coverage.add(dag);
    const Failure failure = failure_of(dag, tally);
    if (failure.empty()) continue;
    Tally unused;
    const auto [least, why] = shrink(dag, failure, [&](const RandomDag& d) { return failure_of(d, unused); });
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << why << "\n" << tree_file(least));
  }
  std::ostringstream out;
  out << tally.coverage.text() << "\n"
      << tally.nodes << " values equal Nef's, " << tally.open << " of them not closed, " << tally.unbounded
      << " unbounded, " << tally.empty << " empty; " << tally.each_by_nef
      << " nodes with `each` by components of Nef; " << tally.cells << " cells of results located; "
      << tally.oracle_failures << " dags on which Nef itself failed, " << tally.contradictions
      << " of them by contradicting itself";
  const std::string report = out.str();
  INFO(report);
  if (last - first >= 100) CHECK(tally.coverage.complete());
  CHECK(tally.oracle_failures <= 1 + (last - first) / 50);
  CHECK(tally.contradictions <= 1 + (last - first) / 500);
  SUCCEED(report);
}

}  // namespace cnrg::properties

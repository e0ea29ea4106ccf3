// The laws of the CNRG algebra on the values of random dags (csg/SEMANTICS.md#identities): no oracle, so many more
// dags.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "csg/operators/cnrg.h"
#include "csg/operators/identities.h"
#include "tests/properties/dag_reference.h"
#include "tests/properties/dag_values.h"
#include "tests/properties/evaluation.h"
#include "tests/scenes/fixture.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using Failure = std::string;

constexpr std::array kTopological{Topological::interior, Topological::closure, Topological::boundary,
                                  Topological::regularize};

bool subset(const CellSet& a, const CellSet& b) { return subtract(a, b).empty(); }

class Laws {
 public:
  explicit Laws(const Complex& complex) : complex_(complex) {}

  /// The first law that two values break.
  Failure run(const Components& x, const Components& y) {
    sets(x, y);
    partitions(x, y);
    one(x);
    each(x);
    return broken_;
  }

  /// Sums and products are associative, and one distributes over the other, as point sets.
  Failure three(const Components& x, const Components& y, const Components& z) {
    same("sum is associative", of(plus(plus(x, y), z)), of(plus(x, plus(y, z))));
    same("product is associative", of(times(times(x, y), z)), of(times(x, times(y, z))));
    same("product distributes over sum", of(times(x, plus(y, z))), of(plus(times(x, y), times(x, z))));
    same("sum distributes over product", of(plus(x, times(y, z))), of(times(plus(x, y), plus(x, z))));
    same("subtract from the right", of(minus(minus(x, y), z)), of(minus(x, plus(y, z))));
    same("subtract of a subtract", of(minus(x, minus(y, z))), of(plus(minus(x, y), times(x, z))));
    // Not only as point sets: components are pairs, and pairs of pairs are triples.
    holds("triples of components are the same from both sides",
          plus(plus(x, y), z).attributes.size() == plus(x, plus(y, z)).attributes.size());
    return broken_;
  }

 private:
  static CellSet of(const Components& x) { return support(x.selection); }
  Components plus(const Components& x, const Components& y) const { return sum(complex_, x, y).value; }
  Components times(const Components& x, const Components& y) const { return product(complex_, x, y).value; }
  Components minus(const Components& x, const Components& y) const { return cnrg::subtract(complex_, x, y).value; }
  Components no(const Components& x) const { return complement(complex_, x).value; }
  Components one_of(const Components& x) const { return unify(complex_, x).value; }
  Components made(Topological op, const Components& x) const {
    return topological_operation(complex_, op, x).value;
  }
  Components interior(const Components& x) const { return made(Topological::interior, x); }
  Components closure(const Components& x) const { return made(Topological::closure, x); }
  Components boundary(const Components& x) const { return made(Topological::boundary, x); }
  Components regularize(const Components& x) const { return made(Topological::regularize, x); }

  void holds(const std::string& law, bool truth) {
    if (!truth && broken_.empty()) broken_ = "the law is broken: " + law;
  }
  void same(const std::string& law, const CellSet& a, const CellSet& b) { holds(law, a == b); }
  /// Equal components, cell by cell.
  void equal(const std::string& law, const Components& a, const Components& b) {
    holds(law, a.selection == b.selection && a.attributes.size() == b.attributes.size());
  }

  void sets(const Components& x, const Components& y) {
    // unify(op(X..)) = op(|X|..)
    const CellSet a = of(x), b = of(y);
    same("unify(sum) = |X| or |Y|", of(one_of(plus(x, y))), unite(a, b));
    same("unify(product) = |X| and |Y|", of(one_of(times(x, y))), intersect(a, b));
    same("unify(subtract) = |X| - |Y|", of(one_of(minus(x, y))), cnrg::subtract(a, b));
    same("unify(complement) = space - |X|", of(no(x)), cnrg::subtract(all_cells(complex_), a));
    for (const Topological op : kTopological) {
      const Components unified = one_of(x);
      same(std::string("unify(") + name(op) + "(X)) = " + name(op) + "(unify(X))", of(made(op, x)),
           of(made(op, unified)));
      same(std::string(name(op)) + " of a set", of(made(op, x)), topological_operation(complex_, op, a));
    }
    same("De Morgan of a sum", of(no(plus(x, y))), of(times(no(x), no(y))));
    same("De Morgan of a product", of(no(times(x, y))), of(plus(no(x), no(y))));
    same("subtract is product with the complement", of(minus(x, y)), of(times(x, no(y))));
    same("sum commutes", of(plus(x, y)), of(plus(y, x)));
    same("product commutes", of(times(x, y)), of(times(y, x)));
    same("closure of a sum", of(closure(plus(x, y))), unite(of(closure(x)), of(closure(y))));
    same("interior of a product", of(interior(times(x, y))), intersect(of(interior(x)), of(interior(y))));
    holds("closure of a product", subset(of(closure(times(x, y))), intersect(of(closure(x)), of(closure(y)))));
    holds("interior of a sum", subset(unite(of(interior(x)), of(interior(y))), of(interior(plus(x, y)))));
    holds("boundary of a sum", subset(of(boundary(plus(x, y))), unite(of(boundary(x)), of(boundary(y)))));
  }

  void partitions(const Components& x, const Components& y) {
    const Components whole = plus(x, y), left = minus(x, y), both = times(x, y), right = minus(y, x);
    holds("the parts of a sum are disjoint", intersect(of(left), of(both)).empty() &&
                                                 intersect(of(left), of(right)).empty() &&
                                                 intersect(of(both), of(right)).empty());
    holds("a sum has the components of its parts",
          whole.attributes.size() == left.attributes.size() + both.attributes.size() + right.attributes.size());
    const std::array<const Components*, 3> parts{&left, &both, &right};
    const std::array<std::string, 3> names{"left", "both", "right"};
    equal("sum(X, Y) = aggregate(X - Y, X and Y, Y - X)", whole, aggregate(complex_, parts, names).value);
    equal("sum(X, X) = product(X, X) = X", plus(x, x), times(x, x));
    same("sum(X, X) is |X|", of(plus(x, x)), of(x));
    holds("subtract(X, X) is empty", minus(x, x).attributes.empty() && of(minus(x, x)).empty());
    for (const Components* v : {&whole, &left, &both})
      if (Failure f = check_components(complex_, *v); !f.empty()) holds("well formed components: " + f, false);
  }

  void one(const Components& x) {
    equal("complement twice is unify", no(no(x)), one_of(x));
    equal("unify twice is unify", one_of(one_of(x)), one_of(x));
    equal("interior twice is interior", interior(interior(x)), interior(x));
    equal("closure twice is closure", closure(closure(x)), closure(x));
    equal("regularize twice is regularize", regularize(regularize(x)), regularize(x));
    same("interior = complement closure complement", of(interior(x)), of(no(closure(no(x)))));
    same("closure = complement interior complement", of(closure(x)), of(no(interior(no(x)))));
    same("boundary = closure and closure of the complement", of(boundary(x)),
         of(times(closure(x), closure(no(x)))));
    same("boundary = closure - interior", of(boundary(x)), of(minus(closure(x), interior(x))));
    same("boundary of the complement", of(boundary(x)), of(boundary(no(x))));
    same("regularize = closure interior", of(regularize(x)), of(closure(interior(x))));
    same("boundary of a boundary of a boundary", of(boundary(boundary(boundary(x)))), of(boundary(boundary(x))));
    holds("boundary of a closed set holds its own boundary", subset(of(boundary(boundary(x))), of(boundary(x))));
    holds("interior in X in closure", subset(of(interior(x)), of(x)) && subset(of(x), of(closure(x))));
    holds("interior and boundary are disjoint and make the closure",
          intersect(of(interior(x)), of(boundary(x))).empty() &&
              unite(of(interior(x)), of(boundary(x))) == of(closure(x)));
    holds("space is X, and the complement of X",
          unite(of(x), of(no(x))) == all_cells(complex_) && intersect(of(x), of(no(x))).empty());
    holds("a boundary has no 3-cells", of(boundary(x)).regions.empty());
  }

  void each(const Components& x) {
    const auto own = [&](Topological op) { return topological_operation_of_each(complex_, op, x).value; };
    for (const Topological op : kTopological) {
      CellSet all;
      for (Component c = 1; c <= x.attributes.size(); ++c)
        all = unite(all, topological_operation(complex_, op, support(x.selection, c)));
      same(std::string("each ") + name(op) + " is the union over the components", of(own(op)), all);
      if (Failure f = check_components(complex_, own(op)); !f.empty()) holds("each " + f, false);
      if (x.attributes.size() == 1)
        same(std::string("each ") + name(op) + " of one component", of(own(op)), of(made(op, x)));
    }
    same("each closure", of(own(Topological::closure)), of(closure(x)));
    holds("each interior", subset(of(own(Topological::interior)), of(interior(x))));
    holds("each boundary", subset(of(boundary(x)), of(own(Topological::boundary))));
    holds("each regularize", subset(of(own(Topological::regularize)), of(regularize(x))));
  }

  const Complex& complex_;
  Failure broken_;
};

Failure failure_of(const RandomDag& dag) {
  const Attempt tried = attempt(dag);
  if (!tried.values) return tried.failure;
  const DagValues& values = *tried.values;
  const Complex& complex = values.complex();
  try {
    const CellIncidence incidence(complex);
    std::vector<Components> x;
    for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
      const DagNode& node = dag.nodes[i];
      if (Failure f = compare_by_definition(complex, incidence, node, values.operands(node), *values.values[i]);
          !f.empty())
        return name_of(dag, i) + " (" + operator_name(node) + "): " + f;
      x.push_back(components_of(complex, *values.values[i]));
      if (Failure f = check_components(complex, x.back()); !f.empty()) return name_of(dag, i) + ": " + f;
    }
    // The result with each of the other values, a third one beside.
    for (std::size_t i = 0; i < x.size(); ++i) {
      const std::size_t k = (i + x.size() / 2) % x.size();
      const std::string operands = name_of(dag, dag.nodes.size() - 1) + ", " + name_of(dag, i);
      if (Failure f = Laws(complex).run(x[i], x.back()); !f.empty()) return operands + ": " + f;
      if (Failure f = Laws(complex).three(x.back(), x[i], x[k]); !f.empty())
        return operands + ", " + name_of(dag, k) + ": " + f;
    }
    return {};
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

/// Whether a group Boolean on a value is refused, and how.
std::string refusal(RandomDag dag) {
  DagNode boolean;
  boolean.op = Operator::unite;
  boolean.operands = {dag.nodes.size() - 1, 0};
  dag.nodes.push_back(boolean);
  return attempt(dag).failure;
}

}  // namespace

TEST_CASE("A simplified complement is a complement to a group Boolean", "[dag]") {
  // Found by seed 193 of the dags without kept values: what it stands for was lost.
  RandomDag dag;
  dag.leaves = scenes::parse_fixture("leaf sides\nface 0 0 0, 2 0 0, 2 2 0, 0 2 0\n");
  dag.nodes.resize(4);
  dag.nodes[1].op = Operator::complement;
  dag.nodes[1].operands = {0};
  dag.nodes[2].op = Operator::simplify;
  dag.nodes[2].operands = {1};
  dag.nodes[3].op = Operator::subtract;
  dag.nodes[3].operands = {2, 0};
  CHECK(failure_of(dag) == "");
  CHECK_FALSE(evaluate_result(dag).kept.front().value->group().cells.empty());
}

TEST_CASE("The laws of the algebra hold on the values of random dags", "[dag]") {
  const auto [first, last] = scenes::seeds(600);
  Coverage coverage;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = random_dag(seed + 1'000'000, position_of(seed));
    coverage.add(dag);
    const Failure failure = failure_of(dag);
    if (failure.empty()) continue;
    const auto [least, why] = shrink(dag, failure, failure_of);
    FAIL_CHECK("seed " << seed << ": " << failure << "\nshrunk: " << why << "\n" << tree_file(least));
  }
  INFO(coverage.text());
  if (last - first >= 100) CHECK(coverage.complete());
  SUCCEED(coverage.text());
}

TEST_CASE("A failing dag shrinks to what fails", "[dag]") {
  // Stands for a fault of `interior` on values with a wire, which only shows below another node.
  const FailureOf fault = [](const RandomDag& dag) -> Failure {
    const std::vector<int> depth = depths(dag);
    for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
      if (dag.nodes[i].op != Operator::interior || depth[i] < 2) continue;
      for (const scenes::Leaf& leaf : dag.leaves)
        if (!leaf.wires.empty()) return name_of(dag, i) + " is wrong";
    }
    return {};
  };
  int found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const RandomDag dag = random_dag(seed, position_of(seed));
    const Failure failure = fault(dag);
    if (failure.empty()) continue;
    ++found;
    const auto [least, why] = shrink(dag, failure, fault);
    INFO(tree_file(least));
    CHECK_FALSE(why.empty());
    CHECK(well_formed(least));
    CHECK(attempt(least).failure == "");
    CHECK(least.nodes.back().op == Operator::interior);
    CHECK(depths(least).back() == 2);
    std::size_t wires = 0;
    for (const scenes::Leaf& leaf : least.leaves) wires += leaf.wires.size();
    CHECK(wires == 1);
    CHECK(std::count_if(least.nodes.begin(), least.nodes.end(),
                        [](const DagNode& n) { return n.op != Operator::leaf; }) == 2);
  }
  CHECK(found > 3);
}

TEST_CASE("A group Boolean takes closed values and asks for `closure` of others", "[dag]") {
  const auto [first, last] = scenes::seeds(150);
  std::size_t taken = 0, refused = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const RandomDag dag = random_dag(seed + 2'000'000, position_of(seed));
    const Attempt tried = attempt(dag);
    INFO("seed " << seed << "\n" << tree_file(dag));
    REQUIRE(tried.failure == "");
    const NodeValue& value = *tried.values->values.back();
    // By definition: a cell outside of the set in the closure of one inside.
    const CellIncidence incidence(tried.values->complex());
    const auto set = CellIncidence::support(incidence.labels(selection_of(tried.values->complex(), value)));
    const bool closed = incidence.closure(set) == set;
    const bool fits = closed || value.stands_for.has_value();
    const std::string failure = refusal(dag);
    if (fits) {
      CHECK(failure == "");
      ++taken;
    } else {
      CHECK(failure.starts_with(kRefused));
      CHECK(failure.find("insert `closure`") != std::string::npos);
      ++refused;
    }
  }
  CHECK((taken > 0 && refused > 0));
}

}  // namespace cnrg::properties

#include "tests/oracles/dag_laws.h"

#include <array>

#include "csg/operators/cnrg.h"
#include "csg/operators/identities.h"
#include "tests/oracles/dag_reference.h"
#include "tests/oracles/dag_values.h"

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

}  // namespace

std::string law_failure(const RandomDag& dag) {
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

}  // namespace cnrg::properties

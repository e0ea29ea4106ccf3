// Families get their directions in the order of nesting, the innermost first: the outer family needs all
// directions of the inner one, and the bisectors beside each contact. Families in a cycle are taken in the order
// of their axes.
#include "csg/carriers/nested_turns.h"

#include <algorithm>

#include "csg/geometry/circle.h"
#include "kernel/exact/exact_vectors.h"

namespace cnrg {
namespace {

RationalPoint bisector(const RationalPoint& a, const RationalPoint& b) {
  const RationalPoint sum = a + b;
  return Rational(1 / root(dot(sum, sum))) * sum;
}

}  // namespace

void solve_turns(const std::vector<std::shared_ptr<Family>>& families, const std::vector<NestedFamilies>& nested) {
  std::vector<std::vector<std::size_t>> around(families.size()), inside(families.size());  // places in `nested`
  std::vector<std::size_t> missing(families.size());
  for (std::size_t k = 0; k < nested.size(); ++k) {
    around[nested[k].inner].push_back(k);
    inside[nested[k].outer].push_back(k);
    ++missing[nested[k].outer];
  }
  std::vector<bool> solved(families.size());
  std::vector<std::size_t> ready;
  const auto solve = [&](std::size_t f) {
    std::vector<RationalPoint> directions;
    for (const std::size_t k : inside[f]) {
      if (!solved[nested[k].inner]) continue;
      const Turns& turns = families[nested[k].inner]->turns();
      for (const RationalPoint& d : turns.directions()) directions.push_back(d);
      for (const RationalPoint& d : turns.beside(nested[k].direction))
        directions.push_back(bisector(nested[k].direction, d));
    }
    families[f]->solve_turns(directions);
    solved[f] = true;
    for (const std::size_t k : around[f]) {
      if (--missing[nested[k].outer] == 0) ready.push_back(nested[k].outer);
    }
  };
  std::vector<std::size_t> by_axis(families.size());
  for (std::size_t f = 0; f < by_axis.size(); ++f) by_axis[f] = f;
  std::sort(by_axis.begin(), by_axis.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(missing[a] > 0, families[a]->axis()) < std::pair(missing[b] > 0, families[b]->axis());
  });
  for (const std::size_t first : by_axis) {
    ready.push_back(first);
    while (!ready.empty()) {
      const std::size_t f = ready.back();
      ready.pop_back();
      if (!solved[f]) solve(f);
    }
  }
}

}  // namespace cnrg

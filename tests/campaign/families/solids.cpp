#include "tests/campaign/families/solids.h"

#include "csg/tree/tree.h"
#include "tests/oracles/curved_nef.h"
#include "tests/oracles/curved_trees.h"

namespace cnrg::campaign {

using scenes::Motion;
using scenes::Random;
using scenes::Solid;

namespace {

Solid random_curved(Random& random) {
  const Tree tree = parse_tree(
      "cnrg: 1\nnodes:\n  a: {" + properties::random_curved_solid(random.next()) + "}\nresult: a\n", "leaf.yaml");
  const Node& node = tree.nodes[tree.result];
  return properties::facets_of(make_soup({{prepare(*node.shape), node.transform.value_or(Transform{})}}),
                               LeafId(0));
}

}  // namespace

Solid random_solid(Random& random) {
  if (random.one_in(4)) return random_curved(random);
  for (;;) {
    const auto position = random.one_in(4) ? scenes::Position::tilted : scenes::Position::degenerate;
    const scenes::Leaf leaf = scenes::random_leaves(random.next(), 1, position)[0];
    if (!leaf.solids.empty()) return leaf.solids[0];
  }
}

Rational random_distance(Random& random) {
  if (random.one_in(3)) return 0;
  Rational x = 1;
  mpz_ui_pow_ui(x.get_den_mpz_t(), 10,
                static_cast<unsigned long>(random.one_in(2) ? random.between(1, 20) : random.between(1, 300)));
  return random.one_in(2) ? x : Rational(-x);
}

RationalPoint random_step(Random& random) {
  for (;;) {
    RationalPoint step;
    const Rational common = random_distance(random);
    for (Rational& x : step) x = random.one_in(2) ? common * random.between(-2, 2) : random_distance(random);
    if (step != RationalPoint{0, 0, 0}) return step;
  }
}

Motion translation(const RationalPoint& by) {
  Motion motion;
  motion.offset = by;
  return motion;
}

Motion scaling(const Rational& factor, const RationalPoint& about) {
  Motion motion = Motion::scaling(factor);
  for (int k = 0; k < 3; ++k) motion.offset[k] = about[k] - factor * about[k];
  return motion;
}

Solid moved(const Motion& motion, Solid solid) {
  for (scenes::Polygon& facet : solid)
    for (RationalPoint& p : facet) p = motion(p);
  return solid;
}

}  // namespace cnrg::campaign

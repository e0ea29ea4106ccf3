// Against CGAL's Nef polyhedra, which are slow: few leaves and few facets each.
#include "csg/tree/tree.h"
#include "tests/campaign/families/families.h"
#include "tests/oracles/curved_nef.h"
#include "tests/oracles/curved_trees.h"
#include "tests/oracles/dag_nef.h"
#include "tests/oracles/soup_nef.h"

namespace cnrg::campaign {
namespace {

using properties::RandomDag;
using scenes::Leaf;

/// Two curved solids, as texts of leaves.
using CurvedPair = std::array<std::string, 2>;

std::string pair_text(const CurvedPair& pair) {
  return "cnrg: 1\nnodes:\n  a: {" + pair[0] + "}\n  b: {" + pair[1] +
         "}\n  all: {union: [a, b]}\n  both: {intersection: [a, b]}\n  rest: {difference: [a, b]}\n"
         "  result: {sum: [all, both, rest]}\nresult: result\n";
}

std::string compare_pair(const CurvedPair& pair) {
  const Tree tree = parse_tree(pair_text(pair), "pair.yaml");
  const auto instance = [&](const char* name) {
    const Node& node = tree.nodes[tree.find(name)];
    return LeafInstance{prepare(*node.shape), node.transform.value_or(Transform{})};
  };
  return properties::compare_with_nef(instance("a"), instance("b"));
}

}  // namespace

void add_nef(Families& families) {
  const auto dags = [&](const char* name, const char* oracle, auto make) {
    Recipe<RandomDag> dag;
    dag.name = name;
    dag.oracle = oracle;
    dag.make = make;
    dag.compare = [](const RandomDag& d) { return properties::compare_with_nef(d); };
    dag.smaller = [](const RandomDag& d) { return properties::smaller(d); };
    dag.text = properties::tree_file;
    add(families, dag);
  };
  dags("nef-booleans", "Nef: groups at every node, every cell", [](std::uint64_t seed) {
    scenes::Random random(seed);
    const int leaves = 2 + static_cast<int>(seed / 3 % 4);
    const auto position = static_cast<scenes::Position>(seed % 3);
    return properties::boolean_tree(random, scenes::random_leaves(seed + 20'000'000, leaves, position));
  });
  dags("nef-trees", "Nef: every operator, open and unbounded sets", [](std::uint64_t seed) {
    return properties::random_dag(seed + 10'000'000, properties::position_of(seed));
  });

  Recipe<std::vector<Leaf>> soup;
  soup.name = "nef-soups";
  soup.oracle = "Nef: walls and cavities of soups";
  soup.share = 1.5;
  soup.make = [](std::uint64_t seed) {
    // A few parts on a tiny grid, and more on larger ones.
    const int kind = seed % 16 == 15 ? 2 : seed % 3 == 2 ? 1 : 0;
    const int parts[] = {6, 10, 16}, sizes[] = {2, 3, 6};
    return properties::random_soup(seed + 1'000'000, parts[kind], sizes[kind]);
  };
  soup.compare = properties::compare_soup_with_nef;
  soup.smaller = [](const std::vector<Leaf>& leaves) { return scenes::smaller(leaves); };
  soup.text = scenes::tree_file;
  add(families, soup);

  Recipe<CurvedPair> curved;
  curved.name = "nef-curved";
  curved.oracle = "Nef of the leaves' facets";
  curved.share = 0.6;
  curved.make = [](std::uint64_t seed) {
    return CurvedPair{properties::random_curved_solid(2 * seed), properties::random_curved_solid(2 * seed + 1)};
  };
  curved.compare = compare_pair;
  curved.smaller = [](const CurvedPair&) { return std::vector<CurvedPair>(); };
  curved.text = pair_text;
  add(families, curved);
}

}  // namespace cnrg::campaign

// Against CGAL's Nef polyhedra, which are slow: few leaves and few facets each.
#include "csg/tree/tree.h"
#include "tests/campaign/families/families.h"
#include "tests/oracles/curved_nef.h"
#include "tests/oracles/curved_trees.h"
#include "tests/oracles/dag_nef.h"
#include "tests/oracles/scene_nef.h"
#include "tests/oracles/soup_nef.h"

namespace cnrg::campaign {
namespace {

using properties::RandomDag;
using scenes::Leaf;
using scenes::Position;
using scenes::Scene;

std::string tree_of(const std::vector<Leaf>& leaves) {
  Scene scene{leaves, scenes::leaf_expression(0)};
  for (std::size_t i = 1; i < leaves.size(); ++i)
    scene.root =
        scenes::combine(scenes::Op::unite, scenes::Ranking::equal, scene.root, scenes::leaf_expression(i));
  return scenes::tree_file(scene);
}

/// A part of a leaf less.
std::vector<std::vector<Leaf>> smaller_soups(const std::vector<Leaf>& leaves) {
  std::vector<std::vector<Leaf>> out;
  const auto each = [&](auto part_of) {
    for (std::size_t l = 0; l < leaves.size(); ++l)
      for (std::size_t i = 0; i < part_of(const_cast<Leaf&>(leaves[l])).size(); ++i) {
        out.push_back(leaves);
        auto& list = part_of(out.back()[l]);
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
      }
  };
  each([](Leaf & leaf) -> auto& { return leaf.faces; });
  each([](Leaf & leaf) -> auto& { return leaf.wires; });
  each([](Leaf & leaf) -> auto& { return leaf.points; });
  return out;
}

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
  const auto scenes_family = [&](const char* name, Position position, int most_leaves, double share) {
    Recipe<Scene> scene;
    scene.name = name;
    scene.oracle = "Nef: groups at every node, every cell";
    scene.share = share;
    scene.make = [=](std::uint64_t seed) {
      return scenes::random_scene(seed + 20'000'000,
                                  2 + static_cast<int>(seed % static_cast<unsigned>(most_leaves - 1)), position);
    };
    scene.compare = [](const Scene& s) { return properties::compare_with_nef(s); };
    scene.smaller = [](const Scene& s) { return scenes::smaller(s); };
    scene.text = [](const Scene& s) { return scenes::tree_file(s); };
    add(families, scene);
  };
  scenes_family("nef-general", Position::general, 2, 0.6);
  scenes_family("nef-degenerate", Position::degenerate, 3, 1);
  scenes_family("nef-tilted", Position::tilted, 3, 0.6);

  Recipe<std::vector<Leaf>> soup;
  soup.name = "nef-soups";
  soup.oracle = "Nef: walls and cavities of soups";
  soup.share = 1.5;
  soup.make = [](std::uint64_t seed) {
    return properties::random_soup(seed + 1'000'000, 4 + static_cast<int>(seed % 4),
                                   2 + static_cast<int>(seed % 3));
  };
  soup.compare = [](const std::vector<Leaf>& leaves) { return properties::compare_soup_with_nef(leaves); };
  soup.smaller = smaller_soups;
  soup.text = tree_of;
  add(families, soup);

  Recipe<RandomDag> dag;
  dag.name = "nef-trees";
  dag.oracle = "Nef: every operator, open and unbounded sets";
  dag.share = 0.6;
  dag.make = [](std::uint64_t seed) {
    return properties::random_dag(seed + 10'000'000, properties::position_of(seed));
  };
  dag.compare = [](const RandomDag& d) {
    properties::Tally tally;
    return properties::compare_with_nef(d, properties::evaluate(d), tally);
  };
  dag.smaller = [](const RandomDag& d) { return properties::smaller(d); };
  dag.text = properties::tree_file;
  add(families, dag);

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

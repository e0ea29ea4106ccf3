// Near features joined and doubles snapped, held against what was there before.
#include "tests/campaign/families/families.h"
#include "tests/oracles/joined_dags.h"
#include "tests/oracles/near_trees.h"

namespace cnrg::campaign {

void add_moved(Families& families) {
  using properties::NearTree;
  const auto trees = [&](const char* name, auto make, auto compare) {
    Recipe<NearTree> tree;
    tree.name = name;
    tree.oracle = "points, swept volumes, all pairs; what is said near by";
    tree.make = [=](std::uint64_t seed) { return make(seed + 600'000'000); };
    tree.compare = compare;
    tree.smaller = [](const NearTree& t) { return properties::smaller(t); };
    tree.text = [](const NearTree& t) { return properties::text_of(t, "joined"); };
    add(families, tree);
  };
  trees("joined", properties::near_tree, properties::join_failure);
  trees("snapped", properties::slight_tree, properties::snap_failure);

  Recipe<properties::RandomDag> dag;
  dag.name = "joined-dags";
  dag.oracle = "the same of nodes; their files in place of them";
  dag.make = [](std::uint64_t seed) { return properties::joined_dag(seed + 700'000'000); };
  dag.compare = properties::joined_failure;
  dag.smaller = [](const properties::RandomDag& d) { return properties::smaller(d); };
  dag.text = properties::tree_file;
  add(families, dag);
}

}  // namespace cnrg::campaign

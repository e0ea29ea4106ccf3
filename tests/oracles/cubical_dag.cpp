#include "tests/oracles/cubical_dag.h"

#include <algorithm>
#include <array>

#include "tests/oracles/cubical_pair.h"

namespace cubical {
namespace {

using cnrg::Operator;
using cnrg::Rational;
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

cnrg::Attributes random_attributes(std::mt19937_64& random) {
  const auto pick = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  cnrg::Attributes out;
  if (pick(2) == 0) out.name = std::array{"bolt", "fault", "a.2", "x & y"}[static_cast<std::size_t>(pick(4))];
  if (pick(2) == 0) out.material = std::array{"rock", "steel", "ore"}[static_cast<std::size_t>(pick(3))];
  for (const char* key : {"k", "section"}) {
    if (pick(2) == 0) continue;
    switch (pick(5)) {
      case 0: out.properties[key] = Rational(1); break;
      case 1: out.properties[key] = Rational(1, 2); break;
      case 2: out.properties[key] = std::string("1"); break;
      default: out.properties[key] = std::string(pick(2) == 0 ? "round" : "1/2"); break;
    }
  }
  return out;
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

CubicalDag random_said_dag(const Grid& grid, std::uint64_t seed, bool moved) {
  std::mt19937_64 random(seed * 7 + 5);
  const auto pick = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  CubicalDag out = random_cubical_dag(grid, seed, moved);
  const bool booleans = seed % 2 == 0;
  if (booleans) {  // over the same leaves
    std::vector<DagNode> nodes;
    for (std::size_t l = 0; l < out.dag.leaves.size(); ++l) {
      nodes.emplace_back();
      nodes.back().leaf = l;
    }
    for (int k = 1 + pick(4); k > 0; --k) {
      DagNode node;
      node.op = std::array{Operator::unite, Operator::unite, Operator::intersect,
                           Operator::subtract}[static_cast<std::size_t>(pick(4))];
      const int most = static_cast<int>(nodes.size());
      for (int n = pick(4) == 0 ? 3 : 2; n > 0; --n)
        node.operands.push_back(
            static_cast<std::size_t>(pick(2) == 0 ? most - 1 - pick(std::min(most, 2)) : pick(most)));
      if (node.op != Operator::subtract && pick(3) != 0)
        node.dominant = static_cast<cnrg::DominantOperand>(pick(3));
      nodes.push_back(std::move(node));
    }
    out.dag.nodes = std::move(nodes);
    out.dag = cnrg::properties::compact(std::move(out.dag));
  }
  for (DagNode& node : out.dag.nodes) {
    if (node.op == Operator::leaf ? pick(4) != 0 : pick(4) == 0) node.said = random_attributes(random);
    if (booleans && !node.dominant && pick(3) == 0) node.number = pick(3);
    if (node.op != Operator::leaf) continue;
    for (std::uint32_t r = 1; r <= 3; ++r) {
      if (pick(3) != 0) continue;
      node.parts[r] = random_attributes(random);
      node.parts[r].properties.clear();
    }
  }
  return out;
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

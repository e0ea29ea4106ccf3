// Volumes to the last digit: inclusion and exclusion, and echoes, copies of a solid that nearly coincide with it.
//
// The volume of any Boolean of n solids follows from the volumes of their 2^n - 1 common parts. Of boxes these are
// products of lengths, written down here; of other solids each is evaluated in a tree of its own, so that the
// large tree is held against many small ones, and single solids against the sum over their facets.
#include <algorithm>

#include "tests/campaign/families/families.h"
#include "tests/campaign/families/solids.h"
#include "tests/oracles/cubical_dag.h"
#include "tests/oracles/dag_values.h"
#include "tests/oracles/evaluation.h"
#include "tests/oracles/point_sets.h"

namespace cnrg::campaign {
namespace {

using cubical::CubicalDag;
using properties::DagNode;
using properties::DagValues;
using properties::RandomDag;
using scenes::Leaf;
using scenes::Random;
using scenes::Solid;

std::vector<Leaf> leaves_of(const std::vector<Solid>& solids) {
  std::vector<Leaf> leaves;
  for (const Solid& solid : solids) leaves.push_back(scenes::solid_leaf(solid, Fill::winding));
  return leaves;
}

/// The leaves, without an operation.
RandomDag dag_of(const std::vector<Solid>& solids) {
  RandomDag dag;
  dag.leaves = leaves_of(solids);
  for (std::size_t i = 0; i < solids.size(); ++i) dag.nodes.emplace_back().leaf = i;
  return dag;
}

void add_node(RandomDag& dag, Operator op, std::vector<std::size_t> operands) {
  DagNode& node = dag.nodes.emplace_back();
  node.op = op;
  node.operands = std::move(operands);
}

/// By atom, the set of the leaves that it is in: whether it is in each node.
std::vector<std::vector<char>> atoms_in(const RandomDag& dag) {
  std::vector<std::vector<char>> in(dag.nodes.size());
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    const DagNode& node = dag.nodes[i];
    for (std::size_t atom = 0; atom < std::size_t{1} << dag.leaves.size(); ++atom) {
      if (node.op == Operator::leaf) {
        in[i].push_back((atom >> node.leaf & 1) != 0);
        continue;
      }
      const bool a = in[node.operands[0]][atom], b = in[node.operands[1]][atom];
      in[i].push_back(node.op == Operator::unite ? a || b : node.op == Operator::intersect ? a && b : a && !b);
    }
  }
  return in;
}

/// Every node has the volume of its atoms. `common[set]`: the volume that the solids of a set share; by inclusion
/// and exclusion that of what is in these and no others.
std::string check_volumes(const RandomDag& dag, std::vector<Rational> common) {
  for (std::size_t bit = 1; bit < common.size(); bit *= 2)
    for (std::size_t set = 0; set < common.size(); ++set)
      if ((set & bit) == 0) common[set] -= common[set | bit];
  const DagValues values = properties::evaluate(dag);
  const std::vector<std::vector<char>> in = atoms_in(dag);
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    const Group& group = values.values[i]->group();
    const std::string words = properties::name_of(dag, i) + " (" + properties::operator_name(dag.nodes[i]) + "): ";
    if (std::string f = properties::validate(values.complex(), group); !f.empty()) return words + "no group: " + f;
    Rational want = 0;
    for (std::size_t atom = 1; atom < common.size(); ++atom)
      if (in[i][atom]) want += common[atom];
    const Rational have = properties::volume(values.complex(), group);
    if (have != want) return words + "the volume is " + to_string(have) + ", not " + to_string(want);
  }
  return {};
}

CubicalDag random_boxes(std::uint64_t seed, bool echoes) {
  Random random(seed * 5 + (echoes ? 1 : 0));
  std::vector<std::array<RationalPoint, 2>> boxes;
  const int count = random.between(2, 5);
  for (int i = 0; i < count; ++i) {
    RationalPoint low, high;
    if (echoes && i > 0 && !random.one_in(4)) {
      const auto& other = boxes[static_cast<std::size_t>(random.below(i))];
      low = other[0], high = other[1];
      for (int k = 0; k < 3; ++k) {
        const Rational step = random_distance(random);
        low[k] += step;
        high[k] += random.one_in(2) ? step : random_distance(random);
      }
    } else {
      for (int k = 0; k < 3; ++k) {
        low[k] = random.between(0, 4);
        high[k] = low[k] + random.between(1, 3);
      }
    }
    boxes.push_back({low, high});
  }
  std::vector<Solid> solids;
  for (const auto& [low, high] : boxes) solids.push_back(scenes::box_solid(low, high));
  CubicalDag out{properties::boolean_tree(random, leaves_of(solids)), {}};
  if (random.one_in(2)) out.place = cubical::random_place(seed);
  return out;
}

std::string compare_boxes(const CubicalDag& boxes) {
  std::vector<Rational> common(std::size_t{1} << boxes.dag.leaves.size(), 0);
  for (std::size_t set = 1; set < common.size(); ++set) {
    Rational volume = abs(boxes.place.determinant());
    for (int k = 0; k < 3; ++k) {
      std::optional<Rational> low, high;
      for (std::size_t i = 0; i < boxes.dag.leaves.size(); ++i) {
        if ((set >> i & 1) == 0) continue;
        const Solid& box = boxes.dag.leaves[i].solids[0];  // of box_solid
        low = low ? std::max(*low, box[0][0][k]) : box[0][0][k];
        high = high ? std::min(*high, box[1][2][k]) : box[1][2][k];
      }
      volume *= std::max<Rational>(0, *high - *low);
    }
    common[set] = volume;
  }
  return check_volumes(placed(boxes), std::move(common));
}

std::vector<CubicalDag> smaller_boxes(const CubicalDag& boxes) {
  std::vector<CubicalDag> out;
  for (RandomDag& less : properties::smaller(boxes.dag)) out.push_back({std::move(less), boxes.place});
  const scenes::Motion none;
  if (boxes.place.matrix != none.matrix || boxes.place.offset != none.offset) out.push_back({boxes.dag, none});
  return out;
}

RandomDag random_solids(std::uint64_t seed) {
  Random random(seed * 5 + 2);
  std::vector<Solid> solids;
  const int count = random.between(2, 3);
  for (int i = 0; i < count; ++i) {
    if (i > 0 && random.one_in(4)) solids.push_back(moved(translation(random_step(random)), solids[0]));
    else solids.push_back(random_solid(random));
  }
  return properties::boolean_tree(random, leaves_of(solids));
}

/// What the solids share, in a tree of its own.
Rational common_volume(const std::vector<Solid>& solids) {
  if (solids.size() == 1) return properties::volume(solids[0]);
  RandomDag dag = dag_of(solids);
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < solids.size(); ++i) all.push_back(i);
  add_node(dag, Operator::intersect, all);
  const Evaluation evaluation = properties::evaluate_result(dag);
  return properties::volume(*evaluation.complex, evaluation.kept.front().group());
}

std::string compare_solids(const RandomDag& dag) {
  std::vector<Rational> common(std::size_t{1} << dag.leaves.size(), 0);
  for (std::size_t set = 1; set < common.size(); ++set) {
    std::vector<Solid> some;
    for (std::size_t i = 0; i < dag.leaves.size(); ++i)
      if ((set >> i & 1) != 0) some.push_back(dag.leaves[i].solids[0]);
    common[set] = common_volume(some);
  }
  return check_volumes(dag, std::move(common));
}

/// A convex solid in a slightly larger copy of itself, or the other way round.
struct Nested {
  Solid solid;
  Rational factor;
};

Nested random_nested(std::uint64_t seed) {
  Random random(seed * 5 + 3);
  Nested out;
  do {
    out.solid = random_solid(random);
  } while (!properties::convex(out.solid));
  Rational step = 0;
  while (step == 0) step = random_distance(random);
  out.factor = 1 + step;
  return out;
}

/// Both solids, the inner one first; their union, intersection and differences; all together.
RandomDag dag_of(const Nested& nested) {
  std::vector<Solid> solids{nested.solid,
                            moved(scaling(nested.factor, properties::middle(nested.solid)), nested.solid)};
  if (nested.factor < 1) std::swap(solids[0], solids[1]);
  RandomDag dag = dag_of(solids);
  add_node(dag, Operator::unite, {0, 1});
  add_node(dag, Operator::intersect, {0, 1});
  add_node(dag, Operator::subtract, {0, 1});
  add_node(dag, Operator::subtract, {1, 0});
  add_node(dag, Operator::sum, {2, 3, 4, 5});
  return dag;
}

std::string compare_nested(const Nested& nested) {
  const DagValues values = properties::evaluate(dag_of(nested));
  const Complex& complex = values.complex();
  const auto group = [&](std::size_t i) -> const Group& { return values.values[i]->group(); };
  const Rational volume = properties::volume(nested.solid),
                 other = volume * nested.factor * nested.factor * nested.factor;
  const Rational large = std::max(volume, other), small = std::min(volume, other);
  if (properties::volume(complex, group(2)) != large) return "the union has another volume than the outer solid";
  if (properties::volume(complex, group(3)) != small)
    return "the intersection has another volume than the inner solid";
  if (properties::volume(complex, group(5)) != large - small) return "the shell has another volume";
  if (!group(4).cells.empty() || group(4).has_entities()) return "something is left of the inner solid";
  const auto same = [&](std::size_t a, std::size_t b) {
    return difference(properties::skeleton(complex, group(a)), properties::skeleton(complex, group(b)));
  };
  if (std::string f = same(2, 1); !f.empty()) return "the union and the outer solid:\n" + f;
  if (std::string f = same(3, 0); !f.empty()) return "the intersection and the inner solid:\n" + f;
  return {};
}

}  // namespace

void add_volumes(Families& families) {
  const auto boxes = [&](const char* name, double share, bool echoes) {
    Recipe<CubicalDag> recipe;
    recipe.name = name;
    recipe.oracle = "inclusion and exclusion, by hand";
    recipe.share = share;
    recipe.make = [=](std::uint64_t seed) { return random_boxes(seed, echoes); };
    recipe.compare = compare_boxes;
    recipe.smaller = smaller_boxes;
    recipe.text = [](const CubicalDag& b) { return cubical::tree_file(b); };
    add(families, recipe);
  };
  boxes("volumes-boxes", 3, false);
  boxes("echoes-boxes", 1, true);

  Recipe<RandomDag> solids;
  solids.name = "volumes-solids";
  solids.oracle = "inclusion and exclusion over small trees";
  solids.make = random_solids;
  solids.compare = compare_solids;
  solids.smaller = [](const RandomDag& dag) { return properties::smaller(dag); };
  solids.text = properties::tree_file;
  add(families, solids);

  Recipe<Nested> nested;
  nested.name = "echoes-nested";
  nested.oracle = "a solid in a larger copy: volumes, cells";
  nested.share = 1.5;
  nested.make = random_nested;
  nested.compare = compare_nested;
  nested.smaller = [](const Nested&) { return std::vector<Nested>(); };
  nested.text = [](const Nested& n) { return properties::tree_file(dag_of(n)); };
  add(families, nested);
}

}  // namespace cnrg::campaign

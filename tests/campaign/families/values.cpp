// Values of whole trees against each other: what laws, definitions, order, motions, folds and contexts must leave
// as it is. No oracle outside, so these are fast and many.
#include <sstream>

#include "csg/evaluate/evaluate.h"
#include "csg/operators/node_value.h"
#include "tests/campaign/families/families.h"
#include "tests/oracles/contexts.h"
#include "tests/oracles/curved_trees.h"
#include "tests/oracles/dag_invariance.h"
#include "tests/oracles/dag_laws.h"
#include "tests/oracles/dag_values.h"
#include "tests/oracles/evaluation.h"

namespace cnrg::campaign {
namespace {

using properties::RandomDag;
using scenes::Leaf;
using scenes::Random;

// --- many operands

struct Fold {
  std::vector<Leaf> leaves;
  std::vector<int> numbers;  ///< dominance of each leaf
  std::string op, word;      ///< `union` ...; `left`, `right`, `equal` or nothing
};

Fold random_fold(std::uint64_t seed) {
  Random random(seed + 77);
  Fold fold;
  const int count = random.between(3, 5);
  fold.leaves = scenes::random_leaves(seed + 30'000'000, count, properties::position_of(seed));
  for (int i = 0; i < count; ++i) fold.numbers.push_back(random.one_in(2) ? 0 : random.below(3));
  const char* const ops[] = {"union", "intersection", "difference", "sum", "product", "subtract"};
  fold.op = ops[random.below(6)];
  const char* const words[] = {"", "", "left", "right", "equal"};
  if (fold.op != "difference" && fold.op != "subtract") fold.word = words[random.below(5)];
  return fold;
}

std::string fold_text(const Fold& fold) {
  std::ostringstream out;
  out << "cnrg: 1\nmaterials: {m0: {}, m1: {}}\nnodes:\n";
  for (std::size_t i = 0; i < fold.leaves.size(); ++i)
    out << "  a" << i << ":\n    group:\n"
        << scenes::group_text(fold.leaves[i]) << "    dominance: " << fold.numbers[i] << "\n    material: m"
        << i % 2 << "\n";
  const std::string word = fold.word.empty() ? "" : ", dominance: " + fold.word;
  const auto list = [&](bool reversed) {
    std::string all;
    for (std::size_t i = 0; i < fold.leaves.size(); ++i)
      all += (i ? ", a" : "a") + std::to_string(reversed ? fold.leaves.size() - 1 - i : i);
    return "[" + all + "]";
  };
  out << "  once: {" << fold.op << ": " << list(false) << word << "}\n";
  out << "  turned: {" << fold.op << ": " << list(true) << word << "}\n";
  std::string before = "a0";
  for (std::size_t i = 1; i < fold.leaves.size(); ++i) {
    const std::string step = "step" + std::to_string(i);
    out << "  " << step << ": {" << fold.op << ": [" << before << ", a" << i << "]" << word << "}\n";
    before = step;
  }
  out << "  result: {product: [once, turned, " << before << "]}\nresult: result\n";
  return out.str();
}

std::string compare_fold(const Fold& fold) {
  const Tree tree = parse_tree(fold_text(fold), "fold.yaml");
  const std::string last = "step" + std::to_string(fold.leaves.size() - 1);
  EvaluateOptions options;
  options.threads = 1;
  for (const std::string& name : {std::string("once"), std::string("turned"), last})
    options.nodes.push_back(tree.find(name));
  const Evaluation evaluation = evaluate(tree, options);
  const Complex& complex = *evaluation.complex;
  const NodeValue &once = *evaluation.value(tree.find("once")).value,
                  &step = *evaluation.value(tree.find(last)).value,
                  &turned = *evaluation.value(tree.find("turned")).value;
  const Selection set = selection_of(complex, once);
  if (set != selection_of(complex, step)) return "cells of all operands at once and one by one differ";
  if (once.features().edges != step.features().edges || once.features().vertices != step.features().vertices)
    return "features of all operands at once and one by one differ";
  const auto a = once.attributes(), b = step.attributes();
  if (a.size() != b.size()) return "numbers of components differ";
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].name != b[i].name || !(a[i].material == b[i].material) || a[i].leaves != b[i].leaves)
      return "component " + std::to_string(i + 1) + " has another name, material or leaves";
  const bool commutes = fold.op != "difference" && fold.op != "subtract";
  if (commutes && properties::joined(set) != properties::joined(selection_of(complex, turned)))
    return "the order of the operands changes the point set";
  return {};
}

std::vector<Fold> smaller_folds(const Fold& fold) {
  std::vector<Fold> out;
  for (std::size_t i = 0; i < fold.leaves.size() && fold.leaves.size() > 2; ++i) {
    out.push_back(fold);
    out.back().leaves.erase(out.back().leaves.begin() + static_cast<std::ptrdiff_t>(i));
    out.back().numbers.erase(out.back().numbers.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::vector<Leaf>& less : scenes::smaller(fold.leaves)) {
    out.push_back(fold);
    out.back().leaves = std::move(less);
  }
  return out;
}

}  // namespace

void add_values(Families& families) {
  const auto dags = [&](const char* name, const char* oracle, double share, std::uint64_t offset, auto compare) {
    Recipe<RandomDag> dag;
    dag.name = name;
    dag.oracle = oracle;
    dag.share = share;
    dag.make = [=](std::uint64_t seed) {
      return properties::random_dag(seed + offset, properties::position_of(seed));
    };
    dag.compare = compare;
    dag.smaller = [](const RandomDag& d) { return properties::smaller(d); };
    dag.text = properties::tree_file;
    add(families, dag);
  };
  dags("laws", "laws of the algebra, definitions cell by cell", 1, 100'000'000, properties::law_failure);
  dags("permuted", "other order of leaves, faces, points", 1, 200'000'000, properties::permutation_failure);
  dags("moved", "exact rotation and translation", 1, 300'000'000, properties::motion_failure);

  using properties::ContextCase;
  Recipe<ContextCase> context;
  context.name = "contexts";
  context.oracle = "a node alone and in larger trees, byte for byte";
  context.share = 4;
  context.make = [](std::uint64_t seed) { return properties::random_context_case(seed); };
  context.compare = properties::context_failure;
  context.smaller = [](const ContextCase& c) { return properties::smaller(c); };
  context.text = [](const ContextCase& c) { return properties::text_of(c); };
  add(families, context);

  Recipe<Fold> fold;
  fold.name = "folded";
  fold.oracle = "many operands at once, one by one, turned round";
  fold.share = 2;
  fold.make = random_fold;
  fold.compare = compare_fold;
  fold.smaller = smaller_folds;
  fold.text = [](const Fold& f) { return fold_text(f); };
  add(families, fold);

  Recipe<std::string> curved;
  curved.name = "curved-trees";
  curved.oracle = "identities, both classifications, simplified walks";
  curved.share = 1;
  curved.make = [](std::uint64_t seed) {
    return properties::random_curved_tree(seed + 40'000'000, seed % 4 == 3);
  };
  curved.compare = [](const std::string& text) { return properties::check_curved_tree(text); };
  curved.smaller = [](const std::string& text) {
    // Trees whose result is another node: the reader finds what is not needed any more.
    std::vector<std::string> out;
    const std::size_t result = text.rfind("result: ");
    for (std::size_t begin = text.find("\n  n"); begin != std::string::npos;
         begin = text.find("\n  n", begin + 1)) {
      const std::size_t end = text.find('\n', begin + 1);
      const std::string node = text.substr(begin + 3, text.find(':', begin) - begin - 3);
      std::string less = text.substr(0, end + 1) + "result: " + node + "\n";
      if (end + 1 < result) out.push_back(std::move(less));
    }
    return out;
  };
  curved.text = [](const std::string& text) { return text; };
  add(families, curved);
}

}  // namespace cnrg::campaign

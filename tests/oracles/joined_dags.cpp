#include "tests/oracles/joined_dags.h"

#include <algorithm>

#include "csg/compare/difference.h"
#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/result/join.h"
#include "tests/formats/cases.h"
#include "tests/oracles/dag_values.h"
#include "tests/oracles/moved_result.h"

namespace cnrg::properties {
namespace {

using scenes::Motion;
using scenes::Random;

/// A node that joins node `i`, in its place for all that use it.
RandomDag with_joined(RandomDag dag, std::size_t i) {
  DagNode node;
  node.op = Operator::simplify;
  node.operands = {i};
  node.within = Rational(1, 1000);
  for (DagNode& user : dag.nodes) {
    for (std::size_t& k : user.operands) k += k >= i ? 1 : 0;
  }
  dag.nodes.insert(dag.nodes.begin() + std::ptrdiff_t(i) + 1, node);
  return dag;
}

/// What `join` says no to, with reason; and an aggregate of operands that were disjoint until one of them was
/// joined.
bool is_refusal(const std::string& message) {
  for (const char* const words :
       {"give a smaller distance", "the whole result is", "nothing would be left", "overlap in"}) {
    if (message.find(words) != std::string::npos) return true;
  }
  return false;
}

/// The tree in which joined nodes are files.
std::string with_files(const RandomDag& dag, const std::vector<std::string>& files) {
  std::string text = tree_file(dag);
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    if (files[i].empty()) continue;
    const std::size_t begin = text.find("  " + name_of(dag, i) + ": {simplify: "), end = text.find('\n', begin);
    text.replace(begin, end - begin, "  " + name_of(dag, i) + ": {cnrg: " + files[i] + "}");
  }
  return text;
}

std::string node_failure(const RandomDag& dag, std::size_t i, const Evaluation& e, const Tree& tree,
                         const std::string& file, const std::string& folder) {
  const DagNode& node = dag.nodes[i];
  RandomDag below = dag;
  below.nodes.resize(node.operands[0] + 1);
  const Result before = evaluate_result(compact(std::move(below))).result();
  JoinReport report;
  const Result after = join(before, *node.within, &report);
  write(file, after);
  const std::string words = name_of(dag, i) + ": " + report.text(*node.within) + ": ";
  if (report.rounds > 0) {
    if (std::string f = moved_failure(before, after, {report.displacement, report.lost_regions}); !f.empty())
      return words + f;
  }
  const std::string near = near_failure(after, to_double(*node.within));
  if (near.empty() != (report.remaining == 0))
    return words + (near.empty() ? "told that something is near, and nothing is" : near);
  if (std::string f = file_failure(after, folder); !f.empty()) return words + f;
  const NodeId id = tree.find(name_of(dag, i));
  const auto told = std::find_if(e.joined.begin(), e.joined.end(), [&](const auto& j) { return j.node == id; });
  if (told == e.joined.end()) return words + "the evaluation tells of no joined node";
  if (told->report.text(*node.within) != report.text(*node.within))
    return words + "the node tells " + told->report.text(*node.within);
  return {};
}

std::string failure_of(const RandomDag& dag) {
  const test::ScratchFolder folder;
  const Tree tree = parse_tree(tree_file(dag), folder / "joined.yaml");
  EvaluateOptions options;
  options.threads = 1;
  options.validate = true;
  const Evaluation e = evaluate(tree, options);
  std::vector<std::string> files(dag.nodes.size());
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    if (!dag.nodes[i].within) continue;
    files[i] = folder / (name_of(dag, i) + ".json");
    if (std::string f = node_failure(dag, i, e, tree, files[i], folder.path()); !f.empty()) return f;
  }
  const Tree other = parse_tree(with_files(dag, files), folder / "files.yaml");
  CompareOptions sets;
  sets.threads = 1;
  sets.components = false;  // a group's regions that a fault has parted are two in the tree
  const Difference found = difference(tree, tree.result, other, other.result, sets);
  if (!found.same) return "above, in place of the node the file of what was joined: " + found.text;
  return file_failure(e.result(), folder.path());
}

}  // namespace

RandomDag joined_dag(std::uint64_t seed) {
  Random random(seed * 17 + 5);
  const scenes::Position position = random.one_in(4) ? position_of(seed) : scenes::Position::degenerate;
  RandomDag dag = random_dag(seed, position);
  for (scenes::Leaf& leaf : dag.leaves) {
    Motion shift;
    for (Rational& x : shift.offset) {
      x = Rational(random.between(-2, 2), 10000);
      x.canonicalize();
    }
    scenes::apply(shift, leaf);
  }
  for (std::size_t i = 0; i < dag.nodes.size(); ++i) {
    DagNode& node = dag.nodes[i];
    if (node.op != Operator::leaf) continue;
    if (random.one_in(2)) node.said.name = "s" + std::to_string(i);
    if (random.one_in(2)) node.said.material = RegionMaterial("m" + std::to_string(random.below(2)));
    if (random.one_in(2)) node.said.properties["number"] = Rational(random.below(3));
  }
  const std::vector<int> depth = depths(dag);
  std::vector<std::size_t> inner;  // some leaf is alone a group of many
  for (std::size_t i = 0; i < dag.nodes.size(); ++i)
    if (depth[i] > 0 || random.one_in(4)) inner.push_back(i);
  for (int k = 2 + random.below(2); k > 0; --k) {
    const std::size_t at = inner[static_cast<std::size_t>(random.below(static_cast<int>(inner.size())))];
    if (RandomDag more = with_joined(dag, at); well_formed(more)) dag = std::move(more);
  }
  return dag;
}

std::size_t joined_nodes(const RandomDag& dag) {
  try {
    const Evaluation e = evaluate_result(dag);
    return static_cast<std::size_t>(
        std::count_if(e.joined.begin(), e.joined.end(), [](const auto& node) { return node.report.rounds > 0; }));
  } catch (const TreeError&) {
    return 0;
  }
}

std::string joined_failure(const RandomDag& dag) {
  try {
    return failure_of(dag);
  } catch (const TreeError& error) {
    if (is_refusal(error.what())) return {};
    return std::string(kRefused) + error.what();
  } catch (const std::exception& error) {
    return std::string("thrown: ") + error.what();
  }
}

}  // namespace cnrg::properties

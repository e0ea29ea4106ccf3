// Random trees with every operator and dominance, in general and degenerate positions: the same, written
// otherwise, and changed in one place.
//
// Two results are the same exactly when their files say the same of the same cells (csg/FORMATS.md#numbering): the
// `.json` of each tree alone knows nothing of the other one, nor of a complex of both. How much only one of them
// has is what `subtract` says, in one tree with both.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "csg/compare/compare.h"
#include "csg/formats/result_file.h"
#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/oracles/dag.h"
#include "tests/scenes/seeds.h"

namespace cnrg::properties {
namespace {

using Json = nlohmann::json;
using scenes::Random;

/// Components by the order in which cells have them; without names, sources and flags that say how a cell came to
/// be one of its own.
void normalize(Json& json) {
  std::map<int, int> number{{0, 0}};
  for (const char* kind : {"vertices", "edges", "faces", "regions"}) {
    for (Json& cell : json[kind]) {
      for (const char* key : {"origin", "feature", "entity", "triangles", "wire", "patch", "name"})
        cell.erase(key);
      if (!cell.contains("component")) continue;
      const int old = cell["component"];
      cell["component"] = number.emplace(old, static_cast<int>(number.size())).first->second;
    }
  }
}

Json said(const Workshop& shop, const Tree& tree, NodeId node) {
  EvaluateOptions options;
  options.rows = Rows::none;
  options.nodes = {node};
  const Evaluation evaluation = evaluate(tree, options);
  const std::string path = shop.path("value.json").string();
  write(path, evaluation.result(node));
  Json json = Json::parse(shop.read("value.json"));
  Json out;
  for (const char* key : {"points", "frame", "vertices", "edges", "faces", "regions"}) out[key] = json[key];
  normalize(out);
  return out;
}

/// The same tree with its nodes in another order, and operands exchanged where their order means nothing.
RandomDag rewritten(const RandomDag& dag, Random& random) {
  std::vector<std::size_t> order, place(dag.nodes.size(), dag.nodes.size());
  while (order.size() < dag.nodes.size() - 1) {
    const auto i = static_cast<std::size_t>(random.below(static_cast<int>(dag.nodes.size() - 1)));
    const std::vector<std::size_t>& below = dag.nodes[i].operands;
    const bool ready =
        std::all_of(below.begin(), below.end(), [&](std::size_t k) { return place[k] != dag.nodes.size(); });
    if (place[i] != dag.nodes.size() || !ready) continue;
    place[i] = order.size();
    order.push_back(i);
  }
  place.back() = order.size();
  order.push_back(dag.nodes.size() - 1);
  RandomDag out{dag.leaves, {}};
  for (const std::size_t i : order) {
    DagNode node = dag.nodes[i];
    for (std::size_t& operand : node.operands) operand = place[operand];
    const bool symmetric = node.op == Operator::unite || node.op == Operator::intersect ||
                           node.op == Operator::sum || node.op == Operator::product ||
                           node.op == Operator::aggregate;
    if (symmetric && node.operands.size() == 2 && random.below(2) == 0) {
      std::swap(node.operands[0], node.operands[1]);
      if (node.dominant == DominantOperand::left) node.dominant = DominantOperand::right;
      else if (node.dominant == DominantOperand::right) node.dominant = DominantOperand::left;
    }
    out.nodes.push_back(std::move(node));
  }
  return out;
}

/// Both trees in one, and under them a - b and b - a.
RandomDag with_differences(const RandomDag& a, const RandomDag& b) {
  RandomDag out = a;
  out.leaves.insert(out.leaves.end(), b.leaves.begin(), b.leaves.end());
  for (DagNode node : b.nodes) {
    for (std::size_t& operand : node.operands) operand += a.nodes.size();
    if (node.op == Operator::leaf) node.leaf += a.leaves.size();
    out.nodes.push_back(std::move(node));
  }
  const std::size_t of_a = a.nodes.size() - 1, of_b = out.nodes.size() - 1;
  DagNode less;
  less.op = Operator::cnrg_subtract;
  less.operands = {of_a, of_b};
  out.nodes.push_back(less);
  less.operands = {of_b, of_a};
  out.nodes.push_back(less);
  return out;
}

Tree tree_of(const RandomDag& dag, const std::string& name) { return parse_tree(tree_file(dag), name); }

/// Compares; throws what evaluation throws. What is wrong is a failed check.
bool check_dags(const Workshop& shop, const RandomDag& a, const RandomDag& b) {
  const Tree tree_a = tree_of(a, "a.yaml"), tree_b = tree_of(b, "b.yaml");
  const Json json_a = said(shop, tree_a, tree_a.result), json_b = said(shop, tree_b, tree_b.result);
  const Comparison comparison = compare(tree_a, tree_a.result, tree_b, tree_b.result);
  INFO("A:\n" << tree_file(a) << "\nB:\n" << tree_file(b) << "\n" << comparison_text(comparison));
  const Json changes = Json::diff(json_a, json_b);
  INFO((changes.empty() ? "" : changes[0].dump()));
  CHECK(comparison.same() == changes.empty());
  CHECK(comparison.attributes.empty());

  const Comparison mirrored = compare(tree_b, tree_b.result, tree_a, tree_a.result);
  CHECK(mirrored.same() == comparison.same());
  CHECK(mirrored.moved.size() == comparison.moved.size());
  CHECK(mirrored.regrouped.size() == comparison.regrouped.size());

  const RandomDag both = with_differences(a, b);
  const Tree tree = tree_of(both, "both.yaml");
  EvaluateOptions options;
  const NodeId less = tree.find(name_of(both, both.nodes.size() - 2));
  options.nodes = {less};
  const Evaluation evaluation = evaluate(tree, options);
  for (std::size_t side = 0; side < 2; ++side) {
    Size size, back;
    for (const SetPiece& piece : comparison.only[side]) size.add(piece.size);
    for (const SetPiece& piece : mirrored.only[1 - side]) back.add(piece.size);
    CHECK(mirrored.only[1 - side].size() == comparison.only[side].size());
    CHECK(mirrored.features[1 - side].size() == comparison.features[side].size());
    CHECK(size.area.sum.text() == back.area.sum.text());
    CHECK(size.length.sum.text() == back.length.sum.text());
    CHECK(size.points == back.points);
    for (const NodeRow& row : evaluation.rows) {
      if (row.node != (side == 0 ? less : tree.result)) continue;
      CHECK(row.total == size.volume);
      const bool any = row.cells != std::array<std::size_t, 4>{};
      CHECK(any == !comparison.only[side].empty());
    }
  }
  return comparison.same();
}

TEST_CASE("Random trees are the same, or differ, as their files do", "[compare][dags]") {
  const auto [first, last] = scenes::seeds(60);
  const Workshop shop;
  std::size_t changed = 0, different = 0;
  for (std::uint64_t seed = first; seed < last; ++seed) {
    INFO("CNRG_FIRST_SEED=" << seed << " CNRG_SEEDS=1");
    const RandomDag dag = random_dag(seed, position_of(seed));
    Random random(seed + 77);
    const bool same = check_dags(shop, dag, rewritten(dag, random));
    CHECK(same);
    const std::vector<RandomDag> less = smaller(dag);
    if (less.empty()) continue;
    const RandomDag& other = less[static_cast<std::size_t>(random.below(static_cast<int>(less.size())))];
    try {
      different += !check_dags(shop, dag, other);
      ++changed;
    } catch (const TreeError&) {  // what became smaller may aggregate what overlaps, or the same twice
    }
  }
  CAPTURE(changed, different);
  CHECK(different > changed / 3);
  CHECK(different < changed);
  CHECK(changed > (last - first) / 2);
}

}  // namespace
}  // namespace cnrg::properties

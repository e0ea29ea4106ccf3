// Facets are finer where surfaces would not meet as they do, and each node has those that its own leaves need.
#include "csg/certify/certificate.h"
#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

Tree tree_with(const std::string& head, const std::string& nodes) {
  return parse_tree("cnrg: 1\n" + head + "nodes:\n" + nodes + "result: model\n", "t.yaml");
}

Evaluation proven(const Tree& tree, const std::string& result, const std::vector<std::string>& nodes = {},
                  AskedProof proof = AskedProof::within_budget) {
  EvaluateOptions options;
  options.proof = proof;
  options.result = tree.find(result);
  for (const std::string& name : nodes) options.nodes.push_back(tree.find(name));
  return evaluate(tree, options);
}

const NodeRow& row_of(const Evaluation& evaluation, const std::string& name) {
  for (const NodeRow& row : evaluation.rows) {
    if (row.name == name) return row;
  }
  FAIL("no row " << name);
  return evaluation.rows.front();
}

/// What is said of every node is what is said of it alone.
void check_alone(const Tree& tree, const Evaluation& whole) {
  for (const NodeRow& row : whole.rows) {
    CAPTURE(row.name);
    const NodeRow alone = proven(tree, row.name).rows.back();
    CHECK(row.cells == alone.cells);
    CHECK(row.volume() == alone.volume());
  }
}

/// Balls that overlap by a thousandth: a and b, b and c; d overlaps with a by much.
const char* const kBalls =
    "  a: {sphere: {center: [0, 0, 0], radius: 1}}\n"
    "  b: {sphere: {center: [1.1994, 1.5992, 0], radius: 1}}\n"
    "  c: {sphere: {center: [2.3988, 0, 0.0001], radius: 1}}\n"
    "  d: {sphere: {center: [-1, 0.2, 0.1], radius: 1}}\n"
    "  ab: {union: [a, b]}\n"
    "  abd: {union: [ab, d]}\n"
    "  model: {union: [abd, c]}\n";

TEST_CASE("each node has the facets that its own leaves need") {
  const Tree tree = tree_with("", kBalls);
  const Evaluation whole = proven(tree, "model"), as_drawn = proven(tree, "model", {}, AskedProof::none);
  CHECK(row_of(whole, "ab").regions == 1);
  CHECK(row_of(as_drawn, "ab").regions == 2);
  CHECK(row_of(whole, "model").regions == 1);
  check_alone(tree, whole);
  // The same where roots are evaluated each for itself.
  const Evaluation two = proven(tree, "model", {"ab", "a"});
  REQUIRE(two.others.size() == 2);
  CHECK(two.others[0].rows.back().volume() == row_of(whole, "ab").volume());
  CHECK(two.others[1].rows.back().volume() == row_of(as_drawn, "a").volume());
  CHECK(*row_of(whole, "ab").volume() > *row_of(as_drawn, "ab").volume());
}

TEST_CASE("facets are finer with a weld, and below a node that joins") {
  for (const std::string head : {"", "weld: 0.00001\n"}) {
    const Tree tree = tree_with(head, kBalls);
    const Evaluation whole = proven(tree, "model");
    CHECK(row_of(whole, "ab").regions == 1);
    check_alone(tree, whole);
  }
  const Tree joins = tree_with("", std::string(kBalls) + "  joined: {simplify: {of: ab, within: 0.00001}}\n");
  const Evaluation joined = proven(joins, "joined");
  CHECK(joined.rows.back().regions == 1);
  REQUIRE(joined.joined.size() == 1);
  CHECK(joined.joined[0].rows.back().volume() == proven(joins, "ab").rows.back().volume());
}

TEST_CASE("what cannot have finer facets is drawn as it is, and named") {
  const Tree tree = tree_with(
      "",
      "  a: {extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[2, 2, 0]]}, [0, 2, 0]], vector: [0, 0, 3], "
      "twist: 20, segments: 5}}\n"
      "  b: {box: {min: [0.5, 0.5, -1], max: [3, 3, 4]}}\n  model: {union: [a, b]}\n");
  const Evaluation asked = proven(tree, "model"), as_drawn = proven(tree, "model", {}, AskedProof::none);
  CHECK(asked.rows.back().raw_cells == as_drawn.rows.back().raw_cells);
  REQUIRE(asked.certificate);
  CHECK(asked.certificate->asked > 0);
  CHECK(!as_drawn.certificate);
}

}  // namespace
}  // namespace cnrg

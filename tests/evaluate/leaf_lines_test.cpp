// Further lines of leaves go with them: below every node, drawn together or alone, welded or joined.
#include "csg/evaluate/leaf_lines.h"

#include "csg/evaluate/evaluate.h"
#include "csg/leaves/surface_parameters.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

Tree tree_with(const std::string& head, const std::string& nodes) {
  return parse_tree("cnrg: 1\n" + head + "nodes:\n" + nodes + "result: model\n", "t.yaml");
}

NodeId node_named(const Tree& tree, const std::string& name) {
  for (const NodeId id : IdRange<NodeId>(tree.nodes.size())) {
    if (tree.nodes[id].name == name) return id;
  }
  FAIL("no node " << name);
  return {};
}

/// Lines of one leaf as it lies by itself, moved by `place`.
std::shared_ptr<const LeafLines> lines_of(const Tree& tree, const std::string& name, std::uint32_t patch,
                                          const Transform& place = {}) {
  auto lines = std::make_shared<LeafLines>();
  auto& of = lines->of[{node_named(tree, name), Placement(place)}].of[patch];
  of[0] = {Rational(1, 100), Rational(3, 100), Rational(2, 7)};
  of[1] = {Rational(3, 8)};
  return lines;
}

Evaluation with_lines(const Tree& tree, const std::shared_ptr<const LeafLines>& lines,
                      const std::vector<std::string>& nodes = {}, const std::string& result = "model") {
  EvaluateOptions options;
  options.lines = lines;
  options.result = node_named(tree, result);
  for (const std::string& name : nodes) options.nodes.push_back(node_named(tree, name));
  return evaluate(tree, options);
}

const NodeRow& row_of(const Evaluation& evaluation, const std::string& name) {
  for (const NodeRow& row : evaluation.rows) {
    if (row.name == name) return row;
  }
  FAIL("no row " << name);
  return evaluation.rows.front();
}

/// A shaft in a bore of the same radius, and a ball that shares nothing.
const char* const kNodes =
    "  shaft: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 10}}\n"
    "  block: {box: {min: [-2, -2, 1], max: [2, 2, 3]}}\n"
    "  drill: {cylinder: {from: [0, 0, 0], to: [0, 0, 5], radius: 1, segments: 7}}\n"
    "  ball: {sphere: {center: [9, 0, 0], radius: 1, segments: 8}}\n"
    "  plate: {difference: [block, drill]}\n"
    "  model: {union: [plate, shaft, ball]}\n";

TEST_CASE("nodes have the lines of their leaves in every drawing") {
  const Tree tree = tree_with("", kNodes);
  const auto lines = lines_of(tree, "shaft", 2);
  const Evaluation all = with_lines(tree, lines), without = with_lines(tree, nullptr);
  CHECK(all.with_lines == std::vector<LeafId>{LeafId(2)});
  for (const NodeRow& row : without.rows) {
    CHECK(row_of(all, row.name).cells == row.cells);
    // What is said of a node does not depend on leaves that are not below it.
    const NodeRow alone = with_lines(tree, lines, {}, row.name).rows.back();
    CHECK(row_of(all, row.name).volume() == alone.volume());
  }
  CHECK(*row_of(all, "shaft").volume() > *row_of(without, "shaft").volume());
  CHECK(row_of(all, "plate").volume() == row_of(without, "plate").volume());
  CHECK(row_of(all, "ball").volume() == row_of(without, "ball").volume());
  // The same where roots are evaluated each for itself.
  const Evaluation two = with_lines(tree, lines, {"plate", "shaft"});
  REQUIRE(two.others.size() == 2);
  CHECK(two.with_lines.size() == 1);
  CHECK(two.others[0].with_lines.empty());
  CHECK(two.others[1].with_lines == std::vector<LeafId>{LeafId(0)});
  CHECK(two.others[1].rows.back().volume() == row_of(all, "shaft").volume());
  // Three meridians more, cut once: of a prism with 10 sides 13, of each side two facets.
  CHECK(two.others[1].rows.back().raw_cells[2] == 2 * 13 + 2);
  CHECK(with_lines(tree, nullptr, {}, "shaft").rows.back().raw_cells[2] == 10 + 2);
}

TEST_CASE("a leaf that lies twice has lines where they are asked for") {
  const Tree tree = tree_with("",
                              "  ball: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}\n"
                              "  moved: {simplify: ball, translate: [5, 0, 0]}\n"
                              "  model: {union: [ball, moved]}\n");
  const auto count = [&](const Evaluation& of) { return row_of(of, "model").raw_cells[2]; };
  const std::size_t none = count(with_lines(tree, nullptr));
  const Evaluation one = with_lines(tree, lines_of(tree, "ball", 0)),
                   other = with_lines(tree, lines_of(tree, "ball", 0, Transform::translation({5, 0, 0})));
  CHECK(one.with_lines.size() == 1);
  CHECK(other.with_lines.size() == 1);
  CHECK(one.with_lines != other.with_lines);
  CHECK(count(one) == count(other));
  // 11 columns of 5 rows in the place of 8 columns of 4.
  CHECK(count(one) > none);
  CHECK(with_lines(tree, lines_of(tree, "ball", 0, Transform::translation({6, 0, 0}))).with_lines.empty());
}

TEST_CASE("lines with a weld, and below a node that joins") {
  const std::string nodes =
      "  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 4], radius: 1, segments: 10}}\n"
      "  b: {cylinder: {from: [0, 0, 1], to: [0, 0, 3], radius: 1.0001, segments: 7}}\n";
  const Tree welded = tree_with("weld: 0.001\n", nodes + "  model: {difference: [a, b]}\n");
  const Evaluation one = with_lines(welded, lines_of(welded, "a", 2)), none = with_lines(welded, nullptr);
  CHECK(one.with_lines == std::vector<LeafId>{LeafId(0)});
  CHECK(one.rows.back().cells == none.rows.back().cells);
  CHECK(one.rows.back().raw_cells[2] > none.rows.back().raw_cells[2]);
  const Tree joins = tree_with("", nodes +
                                       "  joined: {simplify: {of: a, within: 0.001}}\n"
                                       "  model: {union: [joined, b]}\n");
  const Evaluation finer = with_lines(joins, lines_of(joins, "a", 2)), as_before = with_lines(joins, nullptr);
  REQUIRE(finer.joined.size() == 1);
  CHECK(finer.joined[0].rows.back().raw_cells[2] == as_before.joined[0].rows.back().raw_cells[2] + 16);
}

TEST_CASE("what cannot have lines is drawn as before, and said") {
  const Tree tree =
      tree_with("",
                "  model: {extrude: {profile: [[0, 0, 0], [2, 0, 0], {bezier: [[2, 2, 0]]}, [0, 2, 0]], "
                "vector: [0, 0, 3], twist: 20, segments: 5}}\n");
  const Evaluation with = with_lines(tree, lines_of(tree, "model", 3)), without = with_lines(tree, nullptr);
  CHECK(with.with_lines.empty());
  CHECK(with.rows.back().raw_cells == without.rows.back().raw_cells);
  CHECK(with.rows.back().volume() == without.rows.back().volume());
}

}  // namespace
}  // namespace cnrg

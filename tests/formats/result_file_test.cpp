// Results as values of their own: they outlive what they were made of, by hand they have the file of a tree, and
// what was read back is what was written.
#include "csg/formats/result_file.h"

#include <optional>

#include "csg/formats/tetrahedra_arrays.h"
#include "csg/leaves/leaf.h"
#include "csg/operators/boolean.h"
#include "kernel/base/error.h"
#include "kernel/selection/measure.h"
#include "tests/catch.h"
#include "tests/formats/cases.h"

using namespace cnrg;
using namespace cnrg::test;

namespace {

const char* const kTree = R"(cnrg: 1
materials: {clay: {color: "#aa7744"}}
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}, name: a, material: clay}
  b: {box: {min: [1, 1, 1], max: [3, 3, "10/3"]}, name: b}
  both: {union: [a, b], dominance: left}
  rest: {intersection: [a, b]}
result: both
)";

Evaluation evaluation_of(const std::vector<std::string>& nodes = {}) {
  const Tree tree = parse_tree(kTree, "model.yaml");
  EvaluateOptions options;
  for (const std::string& node : nodes) options.nodes.push_back(tree.find(node));
  return evaluate(tree, options);
}

std::shared_ptr<const Complex> two_boxes() {
  return build_complex(make_soup(
      {{prepare(BoxShape{{0, 0, 0}, {2, 2, 2}})}, {prepare(BoxShape{{1, 1, 1}, {3, 3, Rational(10, 3)}})}}));
}

}  // namespace

TEST_CASE("a result outlives its evaluation") {
  const ScratchFolder dir;
  std::optional<Result> kept;
  {
    const Evaluation evaluation = evaluation_of({"rest"});
    kept = evaluation.result("rest");
    write(dir / "before.json", evaluation.result("rest"));
    CHECK(evaluation.result().name() == "both");
    CHECK_THROWS_AS(evaluation.result("a"), InputError);
  }
  write(dir / "after.json", *kept);
  CHECK(text_of(dir / "after.json") == text_of(dir / "before.json"));
  CHECK(kept->volume(1) == Rational(1));
  CHECK(validate(kept->complex()) == "");
}

TEST_CASE("a result by hand has the file of the tree's") {
  const ScratchFolder dir;
  write(dir / "tree.json", evaluation_of().result());
  std::optional<Result> by_hand;
  {
    const auto complex = two_boxes();
    const auto groups = leaf_groups(*complex, {{{.name = "a", .material = "clay"}}, {{.name = "b"}}});
    by_hand.emplace(complex,
                    boolean_operation(*complex, BooleanOp::unite, Dominance::left, groups[0], groups[1]).group,
                    ResultNames{.result = "both", .leaves = {"a", "b"}, .materials = {{"clay", "#aa7744"}}});
  }
  write(dir / "hand.json", *by_hand);
  CHECK(text_of(dir / "hand.json") == text_of(dir / "tree.json"));
}

TEST_CASE("a selection is a result without names") {
  const auto complex = two_boxes();
  Selection selection;  // what both boxes hold
  for (const RegionId r : IdRange<RegionId>(complex->region_count)) {
    if (complex->labels(r).size() == 2) selection.regions.emplace_back(r, 1);
  }
  selection = add_component(selection, closure(*complex, support(selection)), 2);
  const Result result(complex, selection);
  CHECK(result.component_count() == 2);
  CHECK(result.attributes(1).name.empty());
  CHECK(result.attributes(1).leaves.empty());
  CHECK(result.volume(1) == Rational(1));
  CHECK(result.volume(2) == Rational(0));
  CHECK(result.selection() == selection);
  CHECK(active_counts(result.cells()) == std::array<std::size_t, 4>{8, 12, 6, 1});
  const Locator locator(result.complex());
  CHECK(result.component(result.place(locator.locate({Rational(3, 2), Rational(3, 2), Rational(3, 2)}))) == 1);
  CHECK(result.component(result.place(locator.locate({1, 1, 1}))) == 2);
  CHECK(result.component(result.place(locator.locate({5, 5, 5}))) == 0);
  const ScratchFolder dir;
  CHECK(write(dir / "common.vtu", result).moved == 0);
}

TEST_CASE("a result read back has the cells, the names and the materials of its file") {
  const ScratchFolder dir;
  write(dir / "both.json", evaluation_of().result());
  const Result read = read_result(dir / "both.json");
  REQUIRE(read.component_count() == 3);
  CHECK(read.attributes(1).name == "a");
  CHECK(read.attributes(1).material.name() == "clay");
  CHECK(read.attributes(2).name == "b");
  CHECK(read.volume(1) == Rational(8));
  CHECK(read.volume(2) == Rational(25, 3));
  CHECK(active_counts(read.cells()) == active_counts(evaluation_of().result().cells()));
  CHECK_THROWS(read_result(dir / "none.json"));
}

TEST_CASE("a snapped result is on doubles and needs the exact one no more") {
  const ScratchFolder dir;
  SnapReport report;
  std::optional<Result> snapped = snap(evaluation_of().result(), &report);
  CHECK(report.moved == 0);  // plain rounding is right here
  CHECK(write(dir / "both.vtu", *snapped).embedded);
  snapped = snap(evaluate(parse_tree(R"(cnrg: 1
nodes:
  low:   {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  high:  {box: {min: [0, 0, 1.00000000000000001], max: [1, 1, 2]}}
  model: {union: [low, high]}
result: model
)",
                                     "gap.yaml"))
                     .result(),
                 &report);
  CHECK(report.moved == 4);
  CHECK(write(dir / "gap.msh", *snapped).moved == 0);
  CHECK(TetrahedralResult(*snapped).arrays().regions.size() == 2);
}

TEST_CASE("pictures of a result and of an evaluation") {
  const ScratchFolder dir;
  const Evaluation evaluation = evaluation_of();
  write(dir / "m.regions.dot", evaluation.result());
  write(dir / "m.dot", evaluation);
  CHECK(text_of(dir / "m.regions.dot") != text_of(dir / "m.dot"));
  CHECK_THROWS_AS(write(dir / "m.dot", evaluation.result()), InputError);
  CHECK_THROWS_AS(write(dir / "m.vtu", evaluation), InputError);
}

// What is said of components, and of sheets, wires and points, in one tree and not in the other; and selections in
// trees that are compared.

#include "csg/evaluate/evaluate.h"
#include "csg/formats/result_file.h"
#include "csg/tree/tree_of_file.h"
#include "tests/app/program.h"
#include "tests/catch.h"
#include "tests/compare/trees.h"
#include "tests/oracles/cubical_dag.h"
#include "tests/scenes/seeds.h"

namespace cnrg {
namespace {

using test::text;

/// Two layers, a fault in the lower one, and a bolt; `fault` and `bolt` are attributes of these.
std::string slope(const std::string& bolt, const std::string& fault = "", const std::string& low = "") {
  return "low: {box: {min: [0, 0, 0], max: [4, 4, 2]}" + low +
         "}\nhigh: {box: {min: [0, 0, 2], max: [4, 4, 4]}}\n"
         "fault: {polygon: [[1, 1, 1], [3, 1, 1], [3, 3, 1], [1, 3, 1]]" +
         fault + "}\nbolt: {polyline: [[2, 2, 3], [2, 2, 6]]" + bolt +
         "}\nmodel: {union: [bolt, fault, high, low], dominance: left}";
}

TEST_CASE("Sheets, wires and points of which other things are said differ", "[compare]") {
  const std::string plain = slope(""), clay = slope(", material: clay, attributes: {d: 25}");
  CHECK(text(clay, clay).empty());
  CHECK(text(plain, clay) ==
        "in both: an edge of length 2 about (2, 2, 5): no material in A, material `clay` in B; no d in A, d `25` "
        "in B/"
        "in both: an edge of length 1 about (2, 2, 7/2): no material in A, material `clay` in B; no d in A, d "
        "`25` in B/"
        "in both: all 2 together: length 3: no material in A, material `clay` in B; no d in A, d `25` in B");
  CHECK(text(clay, slope(", material: clay, attributes: {d: \"25\"}"))
            .find("in both: an edge of length 2 about (2, 2, 5): "
                  "d `25` in A, d `\"25\"` in B") == 0);
  CHECK(text(slope("", ", name: f"), slope("", ", name: g")) ==
        "in both: a face of area 4 about (2, 2, 1): name `f` in A, name `g` in B");
  CHECK(text(slope("", ", name: f"), slope("", ", name: f")).empty());
  CHECK(text(slope("", ", attributes: {open: 2/4}"), slope("", ", attributes: {open: 0.5}")).empty());

  CompareOptions options;
  options.materials = false;
  CHECK(text(plain, slope(", material: clay"), options).empty());
  CHECK(!text(plain, clay, options).empty());
  options.attributes = false;
  CHECK(text(plain, clay, options).empty());
  options = {};
  options.names = false;
  CHECK(text(slope("", ", name: f"), slope("", ", name: g"), options).empty());
}

TEST_CASE("Attributes of regions count", "[compare]") {
  const std::string one = slope("", "", ", attributes: {n: 1}"), two = slope("", "", ", attributes: {n: 2, m: x}");
  CHECK(text(one, two) == "m of region 1 `low`: no m in A, `\"x\"` in B/n of region 1 `low`: `1` in A, `2` in B");
}

TEST_CASE("A result that was read back says the same", "[compare]") {
  const Workshop w;
  const Tree tree = test::tree(slope(", material: clay, attributes: {d: 25}", ", name: f"));
  write(w.path("result.json").string(), evaluate(tree, {}).result());
  const Tree back = tree_of_file(w.path("result.json").string());
  CHECK(compare(tree, tree.result, back, back.result).same());
  const Tree other = test::tree(slope(", material: clay, attributes: {d: 26}", ", name: f"));
  CHECK_THAT(comparison_text(compare(other, other.result, back, back.result)),
             Catch::StartsWith("in both: an edge of length 2 about (2, 2, 5): d `26` in A, d `25` in B\n"));
}

TEST_CASE("A random tree with names, materials and attributes is the same as its result that was read back",
          "[compare]") {
  const Workshop w;
  const cubical::Grid grid(4);
  std::size_t said = 0;
  const auto [first, last] = scenes::seeds(80);
  for (std::uint64_t seed = first; seed < last; ++seed) {
    const std::string text = cubical::tree_file(cubical::random_said_dag(grid, seed, seed % 4 == 0));
    const Tree tree = parse_tree(text, "said.yaml");
    write(w.path("said.json").string(), evaluate(tree, {}).result());
    const Tree back = tree_of_file(w.path("said.json").string());
    const Comparison comparison = compare(tree, tree.result, back, back.result);
    INFO("seed " << seed << ": " << comparison_text(comparison) << text);
    REQUIRE(comparison.same());
    said += w.read("said.json").find("\"attributes\"") != std::string::npos;
  }
  CHECK(said > 0);
}

TEST_CASE("What is left of a sheet inside of a region says what the sheet said, read back, too", "[compare]") {
  const Workshop w;
  const Tree tree = test::tree(
      "s: {polygon: [[4, 1, 1], [6, 1, 1], [6, 1, 3], [4, 1, 3]], name: given}\n"
      "b: {box: {min: [0, 0, 0], max: [4, 4, 4]}}\n"
      "e: {intersection: [s, b], dominance: left}\n"
      "u: {union: [e, {box: {min: [0, 0, 0], max: [9, 9, 9]}}], dominance: left}");
  write(w.path("edge.json").string(), evaluate(tree, {}).result());
  const Tree back = tree_of_file(w.path("edge.json").string());
  CHECK(comparison_text(compare(tree, tree.result, back, back.result)) == "");
  CHECK_THAT(w.read("edge.json"), Catch::Contains("\"given\""));
}

TEST_CASE("Selections mean the same in both trees", "[compare]") {
  const std::string model = slope(", material: clay", ", name: f", ", material: rock");
  for (const char* const criteria :
       {"dimension: 2, between: [low, high]", "dimension: 2, between: [rock, high]",
        "dimension: 2, between: [low, null]", "region: low", "region: [low, high]", "name: low", "name: f",
        "material: rock", "material: clay", "from: fault", "from: high, source face: 5", "inside: low",
        "touching: fault", "dimension: 1, touching: high"}) {
    CAPTURE(criteria);
    const std::string picked = model + "\npicked: {select: {of: model, " + criteria + "}}";
    CHECK(!test::compared(picked, model).same());
    CHECK(test::compared(picked, picked).same());
    CHECK(test::compared(model + "\npicked: {simplify: {select: {of: model, " + criteria + "}}}", picked).same());
  }
}

}  // namespace
}  // namespace cnrg

// Every fault of a tree file: its line, its column, and what it says.
#include <optional>
#include <string>

#include "csg/tree/selector.h"
#include "csg/tree/suggest.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::optional<TreeError> fault(const std::string& text) {
  try {
    parse_tree(text, "t.yaml");
  } catch (const TreeError& e) {
    return e;
  }
  return std::nullopt;
}

/// The text must fail at (line, column) with a message that holds all `parts`.
void expect(const std::string& text, int line, int column, std::initializer_list<std::string> parts) {
  INFO(text);
  const std::optional<TreeError> error = fault(text);
  REQUIRE(error);
  INFO(error->what());
  CHECK(error->line() == line);
  CHECK(error->column() == column);
  const std::string head = "t.yaml:" + std::to_string(line) + ":" + std::to_string(column) + ": error: ";
  CHECK_THAT(error->what(), Catch::StartsWith(head));
  CHECK(std::string(error->what()).find('\n') == std::string::npos);
  for (const std::string& part : parts) CHECK_THAT(error->what(), Catch::Contains(part));
}

/// The same for the inside of the braces of node `a`, which begins at line 4, column 7.
void expect_node(const std::string& inside, int column, std::initializer_list<std::string> parts) {
  expect("cnrg: 1\nmaterials: {rock: {}}\nnodes:\n  a: {" + inside + "}\n  p: {points: [[0, 0, 0]]}\nresult: a\n",
         4, 6 + column, parts);
}

TEST_CASE("a missing tree file is a FileError with its path", "[tree][errors]") {
  CHECK_THROWS_AS(read_tree("no/such/tree.yaml"), FileError);
  CHECK_THROWS_WITH(read_tree("no/such/tree.yaml"),
                    Catch::StartsWith("no/such/tree.yaml:1:1: error: ") && Catch::Contains("there is no file"));
  CHECK_THROWS_WITH(read_tree("."), Catch::Contains("directory"));
}

TEST_CASE("all faults of a file are told, each at its value", "[tree][errors]") {
  const std::optional<TreeError> error = fault(
      "cnrg: 2\nmaterials: {rock: {colour: 1}}\nnodes:\n"
      "  a: {box: {min: [0, 0, x], max: [1, 1, y]}, size: 0}\n"
      "  b: {sphere: {center: [0, 0, 0], radiu: 1}}\n"
      "  c: {union: [a, bb, {boks: 1}, {prism: {bas: 1, vektor: 2}}], material: clay}\n"
      "result: d\nweld: -1\n");
  REQUIRE(error);
  std::vector<std::string> told;
  for (const Fault& f : error->faults())
    told.push_back(std::to_string(f.at.line) + ":" + std::to_string(f.at.column) + " " + f.message.substr(0, 24));
  CHECK(told == std::vector<std::string>{"1:7 this program reads versi", "2:20 unknown key `colour` in ",
                                         "4:25 `min` of box: `x` is no ", "4:41 `max` of box: `y` is no ",
                                         "4:52 `size` is how long edges", "5:35 unknown key `radiu` in s",
                                         "6:18 there is no node called ", "6:23 unknown key `boks` in th",
                                         "6:42 unknown key `bas` in pri", "6:50 unknown key `vektor` in ",
                                         "6:74 the material `clay` is n", "7:9 there is no node called ",
                                         "8:7 `weld` of a tree file mu"});
  CHECK(error->what() == error->faults()[0].text());
}

TEST_CASE("a fault that is met twice is told once", "[tree][errors]") {
  const std::optional<TreeError> error = fault(
      "cnrg: 1\nnodes:\n  a: &a {box: {min: [0, 0, 0], max: [1, 1, x]}}\n  b: *a\n  r: {union: [a, b]}\nresult: "
      "r\n");
  REQUIRE(error);
  CHECK(error->faults().size() == 1);
}

TEST_CASE("what was probably meant is said", "[tree][errors]") {
  expect("{\n\"format\": \"cnrg result\",\n\"version\": 1}\n", 1, 1,
         {"this is a result, not a tree", "with the leaf `part: {cnrg: t.yaml}`"});
  expect("format: other\ncnrg: 1\n", 1, 1, {"unknown key `format` in a tree file"});
  expect_node("select: p, dimension: 0", 12,
              {"`dimension` is a criterion of `select`", "{select: {of: NODE, dimension: ...}}"});
  expect_node("simplify: p, front of: p", 14, {"`front of` is a criterion of `select`"});
  expect_node("of: p, translate: [1, 0, 0]", 1,
              {"`of` stands in the map of `select` or `simplify`", "{simplify: NODE, translate: [1, 0, 0]}"});
  expect_node("points: [[0, 0, 0]], matrix: [[1, 0, 0, 0], [0, 1, 0, 0], [1, 1, 0, 5]]", 30,
              {"its determinant is zero"});
  expect_node("points: [[0, 0, 0]], matrix: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]", 31,
              {"a row of `matrix` must be four numbers"});
  expect_node("points: [[0, 0, 0]], matrix: [[1, 0, 0, 0]]", 30, {"`matrix` must be three rows"});
  expect_node("points: []", 9, {"points must be a list of 1 point or more, not a list of 0"});
  expect_node("polyline: {points: [[0, 0, 0]]}", 20, {"`points` of polyline must be a list of 2 points or more"});
  expect_node("prism: {base: [[0, 0, 0]], vector: [0, 0, 1]}", 15, {"`base` of prism must be a list of 3 points"});
  expect_node("polygon: {outer: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], holes: [[]]}", 61,
              {"a list of 3 points or more"});
  expect_node("polygon: {outer: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], fit: 0}", 58, {"must be a positive length"});
  expect_node("disk: {center: [0, 0, 0], radii: [1, 0], normal: [0, 0, 1]}", 34,
              {"each must be a positive length"});
  expect_node("disk: {center: [0, 0, 0], radii: [1, 1]}", 7, {"needs `normal` or `dip`"});
  expect_node("disk: {center: [0, 0, 0], radii: [1, 1], dip: 30}", 7, {"needs `strike`"});
  expect_node("minkowski: [[[0, 0, 0]]]", 12, {"minkowski must be two or more lists of points"});
  expect_node("csg: model.scad", 6, {"`csg` must be a file that ends as .csg"});
  for (const std::string word : {"yes", "No", "on", "\"true\""})
    expect_node("simplify: p, regularize: " + word, 26,
                {"`regularize` must be true, false or the name of a node"});
  expect("cnrg: 1\nnodes:\n  a: {regularize: yes}\n  b: {points: [[0, 0, 0]]}\nresult: a\n", 3, 19,
         {"`regularize` must be true, false or the name of a node, not the text `yes`"});
  CHECK_FALSE(fault("cnrg: 1\nnodes:\n  a: {regularize: yes}\n  yes: {points: [[0, 0, 0]]}\nresult: a\n"));
  expect_node("simplify: p, rotate: [0, 0, 90]", 22,
              {"`rotate` must be a map, such as {axis: [0, 0, 1], degrees: 90}, not a list of 3"});
  expect_node("simplify: p, mirror: 1", 22,
              {"`mirror` must be a map, such as {normal: [1, 0, 0], point: [0, 0, 0]}"});
  expect_node("cnrg: x.inp", 7, {"`x.inp` is none; write the result by `cnrg eval -o` as .json"});
  expect_node("cnrg: x.vtu", 7, {"{mesh: {file: x.vtu}}"});
  expect_node("cnrg: part.PLY", 7, {"{mesh: {file: part.PLY}}"});
  expect_node("cnrg: part.stp", 7, {"{step: {file: part.stp}}"});
  expect_node("cnrg: part.brep", 7, {"{brep: {file: part.brep}}"});
  Tree tree = parse_tree("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n", "t.yaml");
  CHECK_THROWS_WITH(tree.find("a#1"),
                    Catch::Contains("t.yaml has no node called `a#1`; rows call `a` so at one of its "
                                    "places: name `a`, or give that place a node of its own"));
  const auto select = [&](const std::string& criteria) { add_selection(tree, tree.result, criteria, "--select"); };
  CHECK_THROWS_WITH(select("dimension: 0, from: a"),
                    Catch::StartsWith("--select:1:1: error: criteria stand in braces") &&
                        Catch::EndsWith("; write {dimension: 0, from: a}"));
  CHECK_THROWS_WITH(select("{dimension: 0, from: a"), Catch::Contains("this is no YAML"));
  CHECK(tree.nodes.size() == 1);
  CHECK_NOTHROW(select("dimension: 0"));
}

TEST_CASE("faults of the file as a whole", "[tree][errors]") {
  expect("", 1, 1, {"empty", "cnrg: 1"});
  expect("# nothing\n", 1, 1, {"empty"});
  expect("just text", 1, 1, {"must be a map"});
  expect("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}\nresult: a\n", 3, 1, {"no YAML"});
  expect("cnrg: 1\n---\ncnrg: 1\n", 3, 1, {"second document"});
  expect(", \"x: 1\n", 1, 1, {"belongs to nothing"});
  expect("{cnrg: 1, nodes: {a: {points: [[0, 0, 0]]}}, result: a} }\n", 1, 57, {"no YAML"});
  expect("{cnrg: 1, nodes: {a: {points: [[0, 0, 0]]}}, result: a} more\n", 1, 57, {"belongs to nothing"});
  expect("cnrg: 1\nnodes:\n\ta: {points: [[0, 0, 0]]}\nresult: a\n", 3, 1, {"tabulator", "replace it by blanks"});
  expect("cnrg: 1\nnodes:\n  a: {points: [[0, 0, 0]]}\n  b:\n  \tpoints: [[0, 0, 0]]\nresult: a\n", 5, 3,
         {"tabulator"});
  expect("cnrg: 1\nnodes:\n  a:\n    union:\n\t- b\n\t- c\nresult: a\n", 5, 1, {"tabulator"});
  expect("nodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n", 1, 1, {"`cnrg`", "add `cnrg: 1`"});
  expect("cnrg: 2\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n", 1, 7, {"version 1"});
  expect("cnrg: 1\nresult: a\n", 1, 1, {"needs `nodes`"});
  expect("cnrg: 1\nnodes: {}\nresult: a\n", 2, 8, {"`nodes` is empty"});
  expect("cnrg: 1\nnodes: [a, b]\nresult: a\n", 2, 8, {"`nodes` must be a map", "a list of 2"});
  expect("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\n", 1, 1, {"needs `result`", "add `result: NAME`"});
  expect("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult:\n", 3, 1, {"`result` must be a text", "empty"});
  expect("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: [a]\n", 3, 9, {"`result` must be a text"});
  expect("cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: b\n", 3, 9,
         {"no node called `b`", "did you mean `a`"});
}

TEST_CASE("unknown and repeated keys", "[tree][errors]") {
  expect("cnrg: 1\nnode: {a: {points: [[0, 0, 0]]}}\nresult: a\n", 2, 1,
         {"unknown key `node`", "did you mean `nodes`?"});
  expect("cnrg: 1\nnodes:\n  a: {points: [[0, 0, 0]]}\n  a: {points: [[0, 0, 1]]}\nresult: a\n", 4, 3,
         {"`a` is there twice", "rename"});
  expect_node("bxo: {min: [0, 0, 0], max: [1, 1, 1]}", 1, {"unknown key `bxo`", "did you mean `box`?"});
  expect_node("points: [[0, 0, 0]], materiel: rock", 22, {"unknown key `materiel`", "did you mean `material`?"});
  expect_node("box: {min: [0, 0, 0], mx: [1, 1, 1]}", 23, {"unknown key `mx` in box", "did you mean `max`?"});
  expect_node("box: {min: [0, 0, 0], min: [1, 1, 1]}", 23, {"`min` is there twice in box"});
  expect_node("translate: [1, 2, 3], points: [[0, 0, 0]], translate: [1, 2, 3]", 44,
              {"`translate` is there twice"});
  expect_node("frobnicate: 1", 1, {"neither an operator nor an attribute"});
  expect_node("[1, 2]: 1", 1, {"must be a text"});
}

TEST_CASE("names of nodes", "[tree][errors]") {
  expect("cnrg: 1\nnodes:\n  ground: {points: [[0, 0, 0]]}\n  b: {union: [ground, grund]}\nresult: b\n", 4, 23,
         {"no node called `grund`", "did you mean `ground`?"});
  // A node is not suggested to itself, nor to what stands inline in it.
  expect("cnrg: 1\nnodes: {m: {union: [abc, b]}, abc: {points: [[0, 0, 0]]}}\nresult: m\n", 2, 26,
         {"no node called `b`; add it to `nodes` or use another name"});
  expect("cnrg: 1\nnodes: {m: {complement: {complement: n}}}\nresult: m\n", 2, 38,
         {"no node called `n`; add it to `nodes` or use another name"});
  expect("cnrg: 1\nnodes: {m: {complement: {points: [[0, 0, 0]]}}}\nresult: n\n", 3, 9, {"did you mean `m`?"});
  expect_node("complement: nobody_at_all", 13, {"no node called `nobody_at_all`", "add it to `nodes`"});
}

TEST_CASE("a cycle lists its names and lines", "[tree][errors]") {
  expect(R"(cnrg: 1
nodes:
  a: {union: [p, b]}
  b: {complement: c}
  c: {union: [p, a]}
  p: {points: [[0, 0, 0]]}
result: a
)",
         5, 18, {"cycle: `a` (line 3) -> `b` (line 4) -> `c` (line 5) -> `a`"});
  expect_node("complement: a", 13, {"cycle: `a` (line 4) -> `a`"});
  // An alias stands, for yaml-cpp, where its anchor stands.
  expect("cnrg: 1\nnodes:\n  a: {complement: &x {complement: *x}}\nresult: a\n", 3, 19, {"cycle: `a/1`"});
}

TEST_CASE("a long cycle is cut in the message and overflows no stack", "[tree][errors]") {
  std::string text = "cnrg: 1\nnodes:\n  n0: {complement: n19999}\n";
  for (int i = 1; i < 20000; ++i)
    text += "  n" + std::to_string(i) + ": {complement: n" + std::to_string(i - 1) + "}\n";
  const auto error = fault(text + "result: n0\n");
  REQUIRE(error);
  CHECK_THAT(error->what(), Catch::Contains("19980 more"));
}

TEST_CASE("unused nodes are warnings with their place", "[tree][errors]") {
  const Tree tree = parse_tree(R"(cnrg: 1
nodes:
  a: {points: [[0, 0, 0]]}
  left_over: {complement: {points: [[0, 0, 0]]}}
result: a
)",
                               "t.yaml");
  const std::vector<Diagnostic> warnings = reading_warnings(tree, {tree.result});
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0].text(), Catch::StartsWith("t.yaml:4:3: warning: the node `left_over` is not used"));
  CHECK(reading_warnings(tree, {tree.result, tree.find("left_over")}).empty());
}

TEST_CASE("operands of the wrong type or number", "[tree][errors]") {
  expect_node("union: [p]", 8, {"`union` must be a list of two or more nodes", "a list of one"});
  expect_node("union: []", 8, {"a list of 0"});
  expect_node("difference: p", 13, {"`difference` must be a list", "the text `p`"});
  expect_node("union: {box: {}}", 8, {"`union` must be a list", "a map"});
  expect_node("union: [p, [p]]", 12, {"an operand", "a list of one"});
  expect_node("union: [p, ]", 8, {"a list of one"});
  expect_node("complement: [p]", 13, {"one node"});
  expect_node("regularize: [p, p]", 13, {"one node"});
  expect_node("below: p", 1, {"`below` needs the solid that it is in", "within"});
  expect_node("below: p, within: [p]", 19, {"`within`", "one node"});
  expect_node("below: p, within: nobody_at_all", 19, {"no node called `nobody_at_all`"});
  expect_node("complement: p, within: p", 16, {"`within` is for below and above"});
  expect_node("complement:", 1, {"an operand of `a`", "empty"});
  expect_node("select: p", 9, {"`select` must be a map {of: NODE, ...}", "the text `p`"});
  expect_node("select: {dimension: 2}", 9, {"select needs `of`"});
  expect_node("select: {of: p, dimension: 4}", 28, {"`dimension` of select", "from 0 to 3"});
  expect_node("select: {of: p, dimension: []}", 28, {"is an empty list"});
  expect_node("select: {of: p, dimensions: 2}", 17, {"did you mean `dimension`"});
  expect_node("select: {of: p, material: gold}", 27, {"the material `gold` is not declared"});
  expect_node("select: {of: p, from: nobody_at_all}", 23, {"no node called `nobody_at_all`"});
  expect_node("select: {of: {points: [[0, 0, 0]]}, from: p}", 43, {"nothing of `a/1` is from `p`"});
  expect_node("select: {of: p, source face: 0}", 17, {"`source face` is a face of one leaf"});
  expect_node("select: {of: p, from: p, source face: -1}", 39, {"`source face` of select", "from 0"});
  expect_node("select: {of: &u {complement: p}, from: p, region: 0}", 51, {"`region` of select", "from 1"});
  expect_node("select: {of: p, between: p}", 26, {"`between` of select must be two names", "the text `p`"});
  expect_node("select: {of: p, between: [p]}", 26, {"two names", "a list of one"});
  expect_node("select: {of: p, between: [null, null]}", 26, {"null is no region"});
  expect_node("select: {of: p}", 9,
              {"select needs `dimension`, `name`, ", "`inside` or `touching`; add `dimension: 2`"});
  expect_node("select: {of: p, region: null}", 17, {"`region` of select must be a name or a number"});
  expect_node("select: {of: p, attributes: {k: 1/0}}", 33, {"`1/0` begins like a number"});
  expect_node("select: {of: p, attributes: 3}", 29, {"`attributes` of select must be a map"});
  expect_node("select: {of: p, inside: nobody_at_all}", 25, {"no node called `nobody_at_all`"});
  expect_node("simplify: {of: p, mode: pints}", 25, {"`mode` of simplify must be one of features, points"});
  expect_node("simplify: {mode: points}", 11, {"simplify needs `of`"});
  expect_node("simplify: {of: p, within: 0}", 27, {"`within` of simplify must be above 0"});
  expect_node("simplify: {of: p, within: -1e-3}", 27, {"`within` of simplify must be above 0"});
  expect_node("simplify: {of: p, within: inf}", 27, {"`within` of simplify", "no number"});
  expect_node("simplify: p, within: 0.001", 14, {"write {simplify: {of: NODE, within: 0.001}}"});
  expect_node("complement: p, size: 0", 22, {"`size` is how long edges of a mesh are to be", "above 0"});
  expect_node("complement: p, size: -1/2", 22, {"above 0"});
  expect_node("complement: p, size: 1e-400", 22, {"above 0"});
  expect_node("complement: p, size: small", 22, {"`size`", "number"});
  expect_node("complement: p, sizes: 1", 16, {"did you mean `size`"});
  expect_node("material: rock", -3, {"has no leaf and no operator"});
  expect_node("regularize: true", -3, {"has no leaf and no operator"});
  expect_node("complement: p, union: [p, p]", 16, {"two operators, `complement` and `union`"});
  expect_node("points: [[0, 0, 0]], plane: {}", 22, {"two leaves, `points` and `plane`"});
  expect_node("complement: p, plane: {}", 16, {"an operator and a leaf, `complement` and `plane`"});
  expect_node("plane: {}, complement: p", 12, {"a leaf and an operator, `plane` and `complement`"});
  expect("cnrg: 1\nnodes:\n  a: box\nresult: a\n", 3, 6, {"the node `a` must be a map"});
  expect("cnrg: 1\nnodes:\n  a:\nresult: a\n", 3, 3, {"the node `a` must be a map", "empty"});
}

TEST_CASE("values of the wrong type", "[tree][errors]") {
  expect_node("box: {min: 0, max: [1, 1, 1]}", 12, {"`min` of box must be a list of three numbers"});
  expect_node("box: {min: [0, 0], max: [1, 1, 1]}", 12, {"a list of 2"});
  expect_node("box: {min: [0, 0, [0]], max: [1, 1, 1]}", 19, {"must be a number, not a list of one"});
  expect_node("box: {max: [1, 1, 1]}", 6, {"box needs `min`", "add `min: [x, y, z]`"});
  expect_node("box: [0, 1]", 6, {"box must be a map"});
  expect_node("polygon: [0, 0, 0]", 11, {"each point of polygon must be a list of three numbers"});
  expect_node("tetrahedron: [[0, 0, 0]]", 14, {"four points"});
  expect_node("polyline: {points: [[0, 0, 0], [1, 0, 0]], closed: maybe}", 52, {"true or false"});
  expect_node("cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 2}", 65, {"a whole number from 3"});
  expect_node("cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 7.5}", 65, {"`7.5`"});
  expect_node("mesh: {file: [a]}", 14, {"`file` of mesh must be a text"});
  expect_node("mesh: {file: a.off, fill: full}", 27, {"one of winding, parity, cells, none"});
  expect_node("mesh: {points: [[0, 0, 0]], file: a.off}", 29,
              {"mesh has `points` and `file`; remove one of them"});
  expect_node("mesh: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], faces: [[0, 1, 3]]}", 66,
              {"a corner of a face must be a whole number from 0 to 2"});
  expect_node("mesh: {points: [[0, 0, 0]], faces: [[0, 0]]}", 37, {"three or more numbers of points"});
  expect_node("mesh: {points: [], faces: [[0, 0, 0]]}", 29, {"names a point, but `points` is empty"});
  expect_node("heightfield: {heights: [[0, 1], [2]]}", 33, {"all rows must be equally long"});
  expect_node("heightfield: {file: a.asc, spacing: [1, 1]}", 28, {"`file` and `spacing`"});
}

TEST_CASE("what is no number", "[tree][errors]") {
  for (const std::string bad : {"nan", ".inf", "-.inf", "abc", "1/0", "0x10", "1_000", "''", "--1"}) {
    expect_node("points: [[0, 0, " + bad + "]]", 17, {"is no number", "1/3"});
  }
  expect_node("points: [[0, 0, 1e100001]]", 17, {"`1e100001` has the exponent 100001", "-100000 to 100000"});
  expect_node("points: [[0, 0, 1/1e-999999999]]", 17, {"has the exponent -999999999"});
  expect_node("points: [[0, 0, " + std::string(100'001, '7') + "]]", 17,
              {"777...` has 100,001 characters", "at most 100,000"});
  expect_node("points: [[0, 0, ]]", 10, {"a list of 2"});
  expect_node("points: [[0, 0, ~]]", 17, {"must be a number, not empty"});
}

TEST_CASE("faults of attributes", "[tree][errors]") {
  expect_node("points: [[0, 0, 0]], material: rok", 32, {"`rok` is not declared", "did you mean `rock`?"});
  expect_node("points: [[0, 0, 0]], material: granite", 32, {"add `granite: {}` to `materials`"});
  expect_node("points: [[0, 0, 0]], dominance: left", 33,
              {"for union, intersection, difference, sum and product", "dominance: 2"});
  expect_node("union: [p, p], dominance: both", 27, {"left, right, equal or a number"});
  expect_node("points: [[0, 0, 0]], dominance: .nan", 33, {"must be a number"});
  expect_node("points: [[0, 0, 0]], scale: 0", 29, {"singular"});
  expect_node("points: [[0, 0, 0]], scale: [1, 0, 1]", 29, {"singular"});
  expect_node("points: [[0, 0, 0]], translate: 1", 33, {"`translate` must be a list of three numbers"});
  expect_node("points: [[0, 0, 0]], rotate: {degrees: 90}", 30, {"rotate needs `axis`"});
  expect_node("points: [[0, 0, 0]], rotate: {axis: [0, 0, 0], degrees: 90}", 37, {"no direction"});
  expect_node("points: [[0, 0, 0]], rotate: {axis: [0, 0, 1], degrees: right}", 57, {"no number"});
  expect_node("points: [[0, 0, 0]], rotate: {axis: [0, 0, 1], degrees: 90, centre: [0, 0, 0]}", 61,
              {"did you mean `center`?"});
  expect_node("points: [[0, 0, 0]], mirror: {normal: [0, 0, 0]}", 39, {"no direction"});
  expect("cnrg: 1\nmaterials: {rock: {color: red}}\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n", 2, 27,
         {"#998877"});
  expect("cnrg: 1\nmaterials: {rock: {colour: red}}\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n", 2, 20,
         {"did you mean `color`?"});
}

TEST_CASE("faults of groups", "[tree][errors]") {
  const std::string v = "group: {vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], ";
  expect_node(v + "faces: [{loops: [[0, 1, 3]]}]}", 78, {"from 0 to 2", "`3`"});
  expect_node(v + "faces: [{loops: [[0, 1]]}]}", 71, {"three vertices"});
  expect_node(v + "faces: [{loops: []}]}", 62, {"needs a loop"});
  expect_node(v + "faces: [{loops: [[0, 1, 2]], sides: [1]}]}", 90, {"two region numbers"});
  expect_node(v + "fill: cells, faces: [{loops: [[0, 1, 2]], sides: [1, 0]}]}", 96, {"`sides` or `fill`"});
  expect_node(v + "edges: [[0]]}", 62, {"a pair of vertex numbers"});
  expect_node(v + "points: [7]}", 63, {"from 0 to 2"});
  expect_node(v + "regions: {0: {}}}", 64, {"the number of a region, from 1"});
  expect_node(v + "regions: {1: {material: gold}}}", 78, {"`gold` is not declared"});
}

TEST_CASE("operators say how many operands they take", "[tree][errors]") {
  for (const std::string name : {"aggregate", "sum", "product", "subtract"}) {
    expect_node(name + ": p", static_cast<int>(name.size()) + 3, {"a list of two or more nodes"});
  }
  for (const std::string name : {"unify", "interior", "closure", "boundary"}) {
    expect_node(name + ": [p, p]", static_cast<int>(name.size()) + 3, {"one node"});
  }
  expect_node("unify: p, each: true", 11, {"`each` is for interior, closure, boundary and regularize"});
  expect_node("closure: p, each: 3", 19, {"true or false"});
}

TEST_CASE("nesting and aliases are bounded", "[tree][errors]") {
  std::string deep = "p";
  for (int i = 0; i < 5000; ++i) deep = "{complement: " + deep + "}";
  const auto nested = fault("cnrg: 1\nnodes: {p: {points: [[0, 0, 0]]}, a: " + deep + "}\nresult: a\n");
  REQUIRE(nested);
  CHECK(nested->line() == 2);
  CHECK_THAT(nested->what(), Catch::Contains("nested too deep") && Catch::Contains("give the inner nodes names"));

  // Ten lists of ten lists ... of points: a billion from a few lines.
  std::string bomb = "cnrg: 1\nnodes:\n  a: {polygon: {outer: &l0 [";
  for (int i = 0; i < 2000; ++i) bomb += "[0, 0, 0], ";
  bomb += "], holes: &l1 [";
  for (int i = 0; i < 2000; ++i) bomb += "*l0, ";
  bomb += "]}}\nresult: a\n";
  const auto exploded = fault(bomb);
  REQUIRE(exploded);
  CHECK_THAT(exploded->what(), Catch::Contains("aliases"));

  // Inline nodes by alias double at each level, but are one node each.
  std::string doubling = "cnrg: 1\nnodes:\n  n0: {points: [[0, 0, 0]]}\n  n1: &x1 {union: [n0, n0]}\n";
  for (int i = 2; i < 60; ++i) {
    const std::string last = "*x" + std::to_string(i - 1);
    doubling +=
        "  n" + std::to_string(i) + ": &x" + std::to_string(i) + " {union: [" + last + ", " + last + "]}\n";
  }
  const Tree tree = parse_tree(doubling + "result: n59\n", "t.yaml");
  CHECK(tree.nodes.size() == 60);
}

TEST_CASE("the nearest name", "[tree]") {
  const std::vector<std::string_view> names{"union", "intersection", "difference", "box"};
  CHECK(nearest("unoin", names) == "union");
  CHECK(nearest("Union", names) == "union");
  CHECK(nearest("intersect", names) == "intersection");
  CHECK(nearest("boks", names).empty());
  CHECK(nearest("xyz", names).empty());
  CHECK(nearest(std::string(1000, 'x'), names).empty());
}

TEST_CASE("faults of graded materials", "[tree]") {
  const auto material = [](const std::string& inside, int column, std::initializer_list<std::string> parts) {
    expect("cnrg: 1\nmaterials:\n  s: {}\n  m: {" + inside +
               "}\nnodes: {a: {points: [[0, 0, 0]], material: m}}\nresult: a\n",
           4, 6 + column, parts);
  };
  const std::string line = "linear: {from: [0, 0, 0], to: [1, 0, 0], stops: ";
  material("linear: {from: [0, 0, 0], to: [0, 0, 0], stops: [[0, s], [1, s]]}", 31,
           {"one point", "let them differ"});
  material(line + "[[0, s]]}", 49, {"two or more stops"});
  material(line + "[[1, s], [1, s]]}", 59, {"does not come after the one at 1", "ascending"});
  material(line + "[[0, s], [1, t]]}", 62, {"`t` is not declared"});
  material(line + "[[0, s], [1, m]]}", 62, {"the material `m` is made of itself: `m` -> `m`"});
  material(line + "[[0, s], [1, {s: 1/2}]]}", 62, {"add up to 1/2", "add up to 1,"});
  material(line + "[[0, s], [1, {s: -1}]]}", 66, {"fraction of `s` is negative"});
  material(line + "[[0, s], 1]}", 58, {"[NUMBER, MATERIAL]"});
  material("linear: {from: [0, 0, 0], stops: [[0, s], [1, s]]}", 9,
           {"`linear` of material `m` needs `to`", "[x, y, z]"});
  material("distance: {to: b, stops: [[0, s], [1, s]]}", 16, {"no node called `b`", "measure a distance"});
  material("distance: {to: a, stops: [[-1, s], [1, s]]}", 26, {"a stop of a distance is negative"});
  material("distance: {to: a, stops: [[0, s], [1, s]]}, " + line + "[[0, s], [1, s]]}", 45,
           {"material `m` has `distance` and `linear`; remove one of them"});
  material("linar: 1", 1, {"unknown key `linar`", "`linear`"});
}

}  // namespace
}  // namespace cnrg

// What a tree file may hold at most, each tried at the limit and one beyond. Of trees: unfold_test.cpp. The table
// of all limits is in tests/README.md.
#include <string>

#include "csg/leaves/leaf.h"
#include "csg/tree/tree.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

Tree tree_of(const std::string& node) {
  return parse_tree("cnrg: 1\nnodes:\n  a: " + node + "\nresult: a\n", "t.yaml");
}

/// Read, and refused with these words.
void expect_limit(const std::string& at_the_limit, const std::string& beyond, const std::string& words) {
  CHECK_NOTHROW(tree_of(at_the_limit));
  CHECK_THROWS_WITH(tree_of(beyond), Catch::Contains(words));
}

/// The same of the geometry of a leaf.
void expect_limit_of_shape(const std::string& at_the_limit, const std::string& beyond, const std::string& words) {
  const auto make = [](const std::string& node) {
    const Tree tree = tree_of(node);
    return prepare(*tree.nodes[tree.result].shape);
  };
  CHECK_NOTHROW(make(at_the_limit));
  CHECK_THROWS_WITH(make(beyond), Catch::Contains(words));
}

std::string cylinder(const std::string& segments) {
  return "{cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: " + segments + "}}";
}
std::string sphere(const std::string& segments, const std::string& rings) {
  return "{sphere: {center: [0, 0, 0], radius: 1, segments: " + segments + ", rings: " + rings + "}}";
}

TEST_CASE("segments and rings at their limits", "[tree][limits]") {
  expect_limit(cylinder("500000"), cylinder("500001"), "from 3 to 500000, not `500001`");
  expect_limit(cylinder("3"), cylinder("2"), "from 3 to 500000, not `2`");
  expect_limit(sphere("3", "500000"), sphere("3", "500001"), "from 2 to 500000, not `500001`");
  const auto curve = [](const std::string& segments) {
    return "{bezier: {curve: [[0, 0, 0], [1, 1, 0], [2, 0, 0]], segments: " + segments + "}}";
  };
  expect_limit(curve("500000"), curve("500001"), "from 1 to 500000, not `500001`");
}

TEST_CASE("ten million facets", "[.limits]") {
  expect_limit_of_shape(sphere("500000", "20"), sphere("500000", "21"), "10500000 facets: give at most 10000000");
}

TEST_CASE("one facet of a round leaf too many", "[tree][limits]") {
  const Tree tree = tree_of(sphere("499999", "22"));
  CHECK_THROWS_WITH(prepare(*tree.nodes[tree.result].shape),
                    Catch::Contains("10999978 facets: give at most 10000000"));
}

TEST_CASE("degrees of curves at their limit", "[tree][limits]") {
  const auto curve = [](int points) {
    std::string list;
    for (int i = 0; i < points; ++i)
      list += (i ? ", [" : "[") + std::to_string(i) + ", " + std::to_string(i * i) + ", 0]";
    return "{bezier: {curve: [" + list + "], segments: 4}}";
  };
  expect_limit_of_shape(curve(33), curve(34), "its degree is 33: give at most 32");
}

TEST_CASE("numbers of regions at their limit", "[tree][limits]") {
  const auto group = [](const std::string& region) {
    return "{group: {vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], faces: [{loops: [[0, 2, 1]], sides: "
           "[0, " +
           region + "]}, {loops: [[0, 1, 3]], sides: [0, " + region + "]}, {loops: [[1, 2, 3]], sides: [0, " +
           region + "]}, {loops: [[2, 0, 3]], sides: [0, " + region + "]}]}}";
  };
  expect_limit_of_shape(group("1000000"), group("1000001"), "region number 1000001");
}

TEST_CASE("nested lists and maps at their limit", "[tree][limits]") {
  const auto nested = [](int depth) {
    std::string text = "{points: [[0, 0, 0]]}";
    for (int i = 0; i < depth; ++i) text = "{complement: " + text + "}";
    return text;
  };
  // 500 levels for the reader of YAML: the file, `nodes`, the node and the point are among them.
  expect_limit(nested(493), nested(494), "nested too deep");
}

TEST_CASE("values by alias at their limit", "[.limits]") {
  // A list of a thousand points is 4,001 values, and a thousand letters stand for one more by alias.
  const auto aliases = [](int times) {
    std::string text = "cnrg: 1\nnodes:\n  a: {polygon: {outer: &l [";
    for (int i = 0; i < 1000; ++i) text += "[0, 0, 0], ";
    text += "], holes: [";
    for (int i = 0; i < times; ++i) text += "*l, ";
    return text + "]}}\nresult: a\n";
  };
  CHECK_NOTHROW(parse_tree(aliases(200), "t.yaml"));
  CHECK_THROWS_WITH(parse_tree(aliases(300), "t.yaml"),
                    Catch::Contains("the aliases and `repeat` of this file repeat too much"));
}

}  // namespace
}  // namespace cnrg

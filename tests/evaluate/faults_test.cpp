// Faults that only geometry can tell, with the places that the tree file has for them.
#include <filesystem>
#include <fstream>
#include <string>

#include "csg/evaluate/evaluate.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

std::string message_of(const std::string& nodes, bool only_check = false) {
  const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: r\n", "t.yaml");
  try {
    if (only_check) {
      check(tree);
    } else {
      evaluate(tree);
    }
  } catch (const TreeError& e) {
    return e.what();
  }
  return "no fault";
}

TEST_CASE("a leaf's fault stands at the value, else at its operator", "[evaluate][errors]") {
  const std::string flat = "  r: {box: {min: [0, 0, 0], max: [1, 0, 1]}}\n";
  CHECK_THAT(message_of(flat), Catch::StartsWith("t.yaml:3:34: error: box"));
  CHECK_THAT(message_of(flat, true), Catch::StartsWith("t.yaml:3:34: error: box"));
  CHECK_THAT(message_of("  r: {cone: {from: [0, 0, 0], to: [0, 0, 1], radius: 0}}\n"),
             Catch::StartsWith("t.yaml:3:7: error: cone"));
  CHECK_THAT(message_of("  r: {polygon: [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}\n"),
             Catch::StartsWith("t.yaml:3:16: error: all points of the polygon lie on one line"));
  CHECK_THAT(message_of("  r: {prism: {vector: [0, 0, 1], base: [[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]}}\n"),
             Catch::StartsWith("t.yaml:3:40: error: the prism's base is not simple"));
  CHECK_THAT(
      message_of(
          "  p: {points: [[0, 0, 0]]}\n  r: {union: [p, {name: x, sphere: {center: [0, 0, 0], radius: -1}}]}\n"),
      Catch::StartsWith("t.yaml:4:64: error: sphere"));
}

TEST_CASE("faults of all leaves are told, a missing file among them", "[evaluate][errors]") {
  const auto faults_of = [](const std::string& nodes) {
    const Tree tree = parse_tree("cnrg: 1\nnodes:\n" + nodes + "result: r\n", "t.yaml");
    std::string lines;
    try {
      evaluate(tree);
    } catch (const TreeError& e) {
      for (const Fault& f : e.faults()) lines += std::to_string(f.at.line) + " ";
    } catch (const TreeFileError& e) {
      lines = "file ";
      for (const Fault& f : e.faults()) lines += std::to_string(f.at.line) + " ";
    }
    return lines;
  };
  const std::string ball = "{sphere: {center: [0, 0, 0], radius: -1}}\n", file = "{mesh: {file: no_such.off}}\n";
  CHECK(faults_of("  a: " + ball + "  b: " + file + "  c: " + ball + "  r: {union: [a, b, c]}\n") == "3 4 5 ");
  CHECK(faults_of("  a: " + file + "  b: " + ball + "  r: {union: [a, b]}\n") == "file 3 4 ");
}

TEST_CASE("overlaps are told by decimals, with their volume and both leaves", "[evaluate][errors]") {
  const std::string message = message_of(
      "  a: {unify: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\n  b: {unify: {box: {min: [2/3, 0, 0], max: [2, 1, "
      "1]}}}\n"
      "  r: {aggregate: [a, b]}\n");
  INFO(message);
  CHECK_THAT(message,
             Catch::StartsWith("t.yaml:5:7: error: aggregate: the operands `a` and `b` overlap in ") &&
                 Catch::Contains(" of the volume 0.333333333333, among them the region at the face near (") &&
                 Catch::Contains(", inside `a/1` (line 3) and `b/1` (line 4); use `sum`") &&
                 !Catch::Contains("1/3"));
}

TEST_CASE("check looks at unused leaves too, evaluate does not", "[evaluate][errors]") {
  const std::string nodes = "  r: {points: [[0, 0, 0]]}\n  z: {box: {min: [0, 0, 0], max: [0, 1, 1]}}\n";
  CHECK(message_of(nodes) == "no fault");
  CHECK_THAT(message_of(nodes, true), Catch::StartsWith("t.yaml:4:34: error: box"));
}

TEST_CASE("sides that contradict each other name the faces and their lines", "[evaluate][errors]") {
  const std::string message = message_of(R"(  r:
    group:
      vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
      faces:
        - {loops: [[0, 2, 1]], sides: [0, 1]}
        - {loops: [[0, 1, 3]], sides: [0, 1]}
        - {loops: [[1, 2, 3]], sides: [0, 2]}
        - {loops: [[0, 3, 2]], sides: [0, 1]}
)");
  INFO(message);
  CHECK_THAT(message, Catch::Matches("t\\.yaml:(7|8|9|10):11: error: .*face .* \\(line 9\\) of `r`.*"));
  CHECK_THAT(message, !Catch::Contains("leaf 0"));
}

TEST_CASE("a mesh file that is missing stands at its node", "[evaluate][errors]") {
  const Tree tree = parse_tree("cnrg: 1\nnodes: {r: {mesh: {file: no_such.off}}}\nresult: r\n", "t.yaml");
  CHECK_THROWS_WITH(evaluate(tree), Catch::StartsWith("t.yaml:2:26: error: ") && Catch::Contains("no_such.off"));
}

TEST_CASE("a fault inside a mesh file stands there and mentions the node", "[evaluate][errors]") {
  const auto folder = std::filesystem::temp_directory_path() / "cnrg_faults_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "bad.off") << "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n";
  const Tree tree =
      parse_tree("cnrg: 1\nnodes: {r: {mesh: {file: bad.off}}}\nresult: r\n", (folder / "t.yaml").string());
  CHECK_THROWS_WITH(evaluate(tree), Catch::StartsWith((folder / "bad.off").string() + ":4:") &&
                                        Catch::Contains("the node `r`") && Catch::Contains("t.yaml:2:13"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cnrg

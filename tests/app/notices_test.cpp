// What `eval` tells of what a model may have lost, and is silent about where nothing is.
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

std::string told(const std::string& nodes, const std::string& options = "", const std::string& head = "") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\n" + head + "nodes:\n" + nodes + "result: r\n");
  const Outcome o = w.run("eval t.yaml" + options);
  INFO(o.err);
  CHECK(o.status == 0);
  return o.err;
}

TEST_CASE("cells that nearly touch are told, with weld as a remedy", "[app][notices]") {
  const std::string near =
      "  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  b: {box: {min: [1.0000001, 0, 0], max: [2, 1, 1]}}\n"
      "  r: {union: [a, b]}\n";
  const std::string text = told(near);
  CHECK_THAT(text,
             Catch::StartsWith("t.yaml:5:7: notice: `r`: ") && Contains(" pairs of cells do not touch and are ") &&
                 Contains(", the nearest 1e-07 apart; `cnrg check --features` lists what is near, and `weld` or "
                          "--join 3e-06 joins it\n"));
  CHECK(told(near, " --quiet").empty());
  CHECK(told("  r: {box: {min: [0, 0, 0], max: [1, 1, 10000000]}}\n").empty());  // thin by itself
  CHECK_THAT(told(near, "", "weld: 3e-6\n"), Contains("notice: weld") && !Contains("do not touch"));
  CHECK(told("  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n  b: {box: {min: [1.001, 0, 0], max: [2, 1, 1]}}\n"
             "  r: {union: [a, b]}\n")
            .empty());
}

TEST_CASE("a name that is nowhere in the result is told", "[app][notices]") {
  const auto nodes = [](const std::string& second, const std::string& operation) {
    return "  d: {polygon: [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]], name: matrix}\n"
           "  first: {polyline: [[0.2, 0.2, 0], [1.8, 1.8, 0]], name: one}\n  second: {polyline: [" +
           second + "], name: two}\n  r: " + operation + "\n";
  };
  const std::string part = "[1, 1, 0], [0.3, 0.3, 0]", all = "{union: [first, second, d]}";
  CHECK(told(nodes(part, all)) ==
        "t.yaml:5:12: notice: `second`: in `r` nothing is called `two`, since all of it is part of `one`; to keep "
        "the "
        "name, let it dominate\n");
  CHECK(told(nodes(part, "{union: [second, first, d]}")).empty());           // then it is a part of the first one
  CHECK(told(nodes("[1, 1, 0], [0.1, 0.1, 0]", all)).empty());               // a part of it is its own
  CHECK(told(nodes("[1, 0.1, 0], [1, 1.9, 0]", all)).empty());               // they cross
  CHECK(told(nodes(part, "{union: [first, second, d], name: x}")).empty());  // somebody calls all of it otherwise
}

TEST_CASE("a mesh that is inside out is told", "[app][notices]") {
  const std::string points = "points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], ";
  const std::string out = "  r: {mesh: {" + points + "faces: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}}\n";
  const std::string in = "  r: {mesh: {" + points + "faces: [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]}}\n";
  CHECK(told(out).empty());
  CHECK(told(in) ==
        "t.yaml:3:7: notice: `r`: mesh: its faces look inward; it is taken as the solid that they enclose: "
        "turn the faces around\n");
  // So flat that doubles do not tell.
  const auto flat = [](const std::string& faces) {
    return "  r: {mesh: {points: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1/3, 1/3, 1e-40]], faces: " + faces + "}}\n";
  };
  CHECK(told(flat("[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]"), " --no-certify").find("inward") ==
        std::string::npos);
  CHECK_THAT(told(flat("[[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]]")), Contains("its faces look inward"));
}

}  // namespace
}  // namespace cnrg

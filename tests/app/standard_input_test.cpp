// `-` for a tree: it comes on standard input, and all else is as of a file.
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const std::string kTwoBoxes = R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}
  b: {box: {min: [1, 1, 1], max: [3, 3, 3]}}
  u: {union: [a, b]}
result: u
)";
const std::string kMesh = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string kReader = "cnrg: 1\nnodes: {m: {mesh: {file: parts/t.off}}}\nresult: m\n";

TEST_CASE("a tree on standard input is what it is in a file", "[app][stdin]") {
  const Workshop w;
  w.write("t.yaml", kTwoBoxes);
  REQUIRE(w.run("eval t.yaml -o file.json --quiet").status == 0);
  REQUIRE(w.run("eval - -o input.json --quiet", kTwoBoxes).status == 0);
  CHECK(w.read("input.json") == w.read("file.json"));
  CHECK(w.run("check -", kTwoBoxes).out == "<stdin>: 3 nodes, 2 of them leaves; no faults\n");
  CHECK(w.run("explain - --point 1,1,1", kTwoBoxes).out == w.run("explain t.yaml --point 1,1,1").out);
  REQUIRE(w.run("mesh t.yaml -o file.msh --quiet").status == 0);
  REQUIRE(w.run("mesh - -o input.msh --quiet", kTwoBoxes).status == 0);
  CHECK(w.read("input.msh") == w.read("file.msh"));
  CHECK(w.run("compare t.yaml -", kTwoBoxes).status == 0);
  CHECK_THAT(w.run("compare - t.yaml", kTwoBoxes).out, Contains("A: `u` of <stdin>\n") && Contains("the same"));
  const Outcome piped = w.shell("cat t.yaml | '" CNRG_PROGRAM "' check - >.out 2>.err");
  CHECK(piped.status == 0);
}

TEST_CASE("faults of a tree on standard input have a line and a column", "[app][stdin][errors]") {
  const Workshop w;
  for (const std::string command : {"eval -", "check -", "explain - --point 0,0,0", "mesh - -o m.msh",
                                    "view - -o v.html", "compare t.yaml -"}) {
    w.write("t.yaml", kTwoBoxes);
    const Outcome o =
        w.run(command, "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, nan]}}\nresult: a\n");
    INFO(command);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("<stdin>:3:41: error: `max` of box: `nan` is no number"));
  }
  const Outcome flat =
      w.run("eval -", "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 0]}}\nresult: a\n");
  CHECK_THAT(flat.err, StartsWith("<stdin>:3:34: error: box"));
  CHECK_THAT(w.run("eval -", "").err, StartsWith("<stdin>:1:1: error: "));
  CHECK_THAT(w.shell("'" CNRG_PROGRAM "' check - <&- >.out 2>.err").err,
             StartsWith("<stdin>:1:1: error: the tree file: standard input cannot be read"));
}

TEST_CASE("files that a tree on standard input names are looked for in the current folder", "[app][stdin]") {
  const Workshop w;
  std::filesystem::create_directory(w.path("parts"));
  w.write("parts/t.off", kMesh);
  CHECK(w.run("eval - --quiet", kReader).status == 0);
  CHECK(w.run("eval - --quiet --inside parts", kReader).status == 0);
  std::filesystem::create_directory(w.path("other"));
  const Outcome outside = w.run("eval - --quiet --inside other", kReader);
  CHECK(outside.status == 2);
  CHECK_THAT(outside.err, StartsWith("<stdin>:2:") && Contains("is no file inside of the folder"));
}

TEST_CASE("what standard input cannot be is refused", "[app][stdin][errors]") {
  const Workshop w;
  w.write("t.yaml", kTwoBoxes);
  const auto refused = [&](const std::string& arguments, const std::string& message) {
    const Outcome o = w.run(arguments, kTwoBoxes);
    INFO(arguments << ": " << o.err);
    CHECK(o.status == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, StartsWith("cnrg: error: ") && Contains(message));
  };
  refused("locate -", "reads points from standard input");
  refused("compare - -", "only one of A and B");
  refused("view -", "add -o FILE.html");
  refused("view - -o v.html --watch", "--watch");
  // The tree that the shell reads is not replaced.
  w.write("t.json", R"({"cnrg": 1, "nodes": {"a": {"points": [[0, 0, 0]]}}, "result": "a"})");
  const std::string before = w.read("t.json");
  const Outcome o = w.shell("'" CNRG_PROGRAM "' eval - -o t.json <t.json >.out 2>.err");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("would replace the tree itself"));
  CHECK(w.read("t.json") == before);
}

TEST_CASE("standard input without an end is not read for ever", "[app][stdin][limits]") {
  const Workshop w;
  const Outcome o = w.shell("yes '# much' | '" CNRG_PROGRAM "' check - >.out 2>.err");
  CHECK(o.status == 2);
  CHECK(o.err ==
        "<stdin>:1:1: error: standard input has more than 100,000,000 bytes, and no more are read; give large "
        "shapes "
        "as files that the tree names\n");
}

}  // namespace
}  // namespace cnrg

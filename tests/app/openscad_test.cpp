// Trees of OpenSCAD on the command line: alone, in other trees, written as tree files; and against OpenSCAD.
#include <cstdlib>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

constexpr const char* kCorner =
    "difference() {\n\tcube(size = [2, 2, 2], center = false);\n\tcube(size = [1, 1, 1], center = false);\n}\n";

/// The row of a node without its seconds.
std::string row_of(const std::string& rows, const std::string& name) {
  const std::size_t at = rows.find("\n" + name + " ");
  INFO(rows);
  REQUIRE(at != std::string::npos);
  return rows.substr(at + 1, rows.find('\n', at + 1) - at - 1);
}

TEST_CASE("a .csg file is a tree, and a node of one", "[app]") {
  const Workshop w;
  w.write("corner.csg", kCorner);
  const Outcome alone = w.run("eval corner.csg -o corner.yaml -o corner.json");
  INFO(alone.out << alone.err);
  REQUIRE(alone.status == 0);
  CHECK_THAT(row_of(alone.out, "model"), Catch::Contains("14") && Catch::EndsWith("  7"));
  CHECK_THAT(row_of(alone.out, "cube-2"), Catch::Contains("hull"));
  CHECK(w.run("eval corner.yaml -o again.json").status == 0);
  CHECK(w.read("again.json") == w.read("corner.json"));
  w.write("two.yaml",
          "cnrg: 1\nnodes:\n  part: {csg: corner.csg, translate: [0, 0, 5]}\n  both: {union: [part, {csg: "
          "corner.csg}]}\nresult: both\n");
  const Outcome two = w.run("eval two.yaml");
  INFO(two.out << two.err);
  REQUIRE(two.status == 0);
  CHECK_THAT(row_of(two.out, "both"), Catch::EndsWith("  14"));
  CHECK_THAT(row_of(two.out, "part/difference-1"), Catch::EndsWith("  7"));
  CHECK(w.run("locate two.yaml", "1.5 1.5 6\n0.5 0.5 5.5\n").out.substr(0, 2) == "3 ");
}

TEST_CASE("faults of .csg files say where", "[app]") {
  const Workshop w;
  w.write("text.csg", "group() {\n  text(text = \"a\");\n}\n");
  CHECK_THAT(w.run("eval text.csg").err,
             Catch::StartsWith("text.csg:2:3: error: `text` is not read; let OpenSCAD"));
  CHECK(w.run("eval text.csg").status == 2);
  w.write("tree.yaml", "cnrg: 1\nnodes: {a: {csg: text.csg}}\nresult: a\n");
  CHECK_THAT(w.run("eval tree.yaml").err, Catch::StartsWith("text.csg:2:3: error: "));
  w.write("corner.csg", kCorner);
  CHECK_THAT(w.run("eval corner.csg -o corner.csg").err, Catch::Contains("no writer"));
  CHECK_THAT(w.run("eval corner.csg --node cube-2 -o a.yaml").err, Catch::Contains("leave out --node"));
  w.write("box.yaml", "cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n");
  CHECK_THAT(w.run("eval box.yaml -o b.yaml").err, Catch::Contains("is a tree already; copy it"));
  w.write("in.csg", "import(file = \"../x.stl\");");
  CHECK_THAT(w.run("eval --inside . in.csg").err, Catch::Contains("x.stl"));
}

TEST_CASE("random models of OpenSCAD have its volume, area, box and counts", "[app]") {
  if (std::system("command -v openscad >/dev/null") != 0) NOT_RUN("openscad is not installed (Debian: openscad)");
  const Workshop w;
  const Outcome o = w.shell("/usr/bin/python3 '" CNRG_SOURCES "/tests/campaign/openscad.py' '" CNRG_PROGRAM
                            "' --random 12 1 >.out 2>.err");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Catch::Contains("12 of 12 agree"));
}

}  // namespace
}  // namespace cnrg

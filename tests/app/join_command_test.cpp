// `cnrg check --features` and `--join` of eval and mesh, as people type them.
#include <sstream>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

const char* const kSlope = R"(cnrg: 1
materials: {granite: {color: "#998877"}}
nodes:
  bolt:   {polyline: [[60, 50, 30], [60, 50, 47.9999]], name: B1, attributes: {bars: 2}}
  fault:  {polygon: [[20, 0, 0], [70, 0, 60], [70, 100, 60], [20, 100, 0]], name: F1}
  ground: {box: {min: [0, 0, 0], max: [100, 100, 60]}, name: rock, material: granite}
  model:  {union: [bolt, fault, ground], dominance: left}
result: model
)";

const char* const kThin = R"(cnrg: 1
nodes:
  low:  {box: {min: [0, 0, 0], max: [9, 9, 1]}, name: low}
  dust: {box: {min: [0, 0, 1], max: [9, 9, 1.00001]}, name: dust}
  high: {box: {min: [0, 0, 1.00001], max: [9, 9, 2]}, name: high}
  model: {union: [low, dust, high], dominance: left}
result: model
)";

std::size_t lines_with(const std::string& text, const std::string& part) {
  std::istringstream stream(text);
  std::size_t n = 0;
  for (std::string line; std::getline(stream, line);) n += line.find(part) != std::string::npos;
  return n;
}

TEST_CASE("small features are listed with places and nodes", "[app][join]") {
  const Workshop w;
  w.write("slope.yaml", kSlope);
  const Outcome o = w.run("check --features 0.001 slope.yaml");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains("small features of model\n"));
  CHECK(lines_with(o.out, "vertex-face") == 1);
  CHECK_THAT(o.out, Contains("bolt | fault") && Contains("(60, 50, 47.9999)"));
  CHECK(lines_with(o.out, "length") == 0);
  CHECK(w.run("check slope.yaml --features=1e-3").out == o.out);
  CHECK(w.run("check --features=1/1000 slope.yaml").out == o.out);
  CHECK(w.run("check --features 0.001 -", kSlope).out == o.out);
  // Without a distance the smallest; the tree is not taken for one.
  const Outcome all = w.run("check --features slope.yaml");
  CHECK(all.status == 0);
  CHECK(lines_with(all.out, "length") == 10);
  CHECK(lines_with(all.out, "dihedral angle") == 2);
  CHECK(lines_with(w.run("check --features slope.yaml --node bolt").out, "length") == 1);
  // A result in a file is a model, too.
  CHECK(w.run("eval slope.yaml --quiet -o slope.json").status == 0);
  CHECK(lines_with(w.run("check --features 0.001 slope.json").out, "vertex-face") == 1);
  CHECK_THAT(w.run("check slope.yaml").out, Contains("no faults"));
}

TEST_CASE("a bolt is joined with its fault in files, lists and meshes", "[app][join]") {
  const Workshop w;
  w.write("slope.yaml", kSlope);
  const Outcome o = w.run("eval slope.yaml --join 0.001 -o joined.json --list --topology");
  INFO(o.out << o.err);
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("slope.yaml: notice: `model`: joined 1 pair nearer than 0.001, in 1 round") &&
                        Contains("of bolt and face f") && Contains("of fault, at ("));
  CHECK(lines_with(o.out, " B1 ") == 1);
  CHECK(lines_with(o.out, " F1 ") == 1);
  CHECK_THAT(o.out, Contains("{bars: 2}"));
  CHECK(lines_with(w.run("check --features 0.001 joined.json").out, "vertex-") == 0);
  // Once joined, nothing is left to join.
  CHECK_THAT(w.run("eval joined.json --join 0.001").err, Contains("nothing is nearer than 0.001"));
  const Outcome mesh = w.run("mesh slope.yaml --join 0.001 -o joined.msh");
  INFO(mesh.out << mesh.err);
  CHECK(mesh.status == 0);
  CHECK_THAT(mesh.err, Contains("joined 1 pair"));
  CHECK_THAT(mesh.out, Contains("600000"));
}

TEST_CASE("a region that vanishes is told even to the quiet", "[app][join]") {
  const Workshop w;
  w.write("thin.yaml", kThin);
  for (const char* const command :
       {"eval thin.yaml --join 0.001 --quiet", "mesh thin.yaml --join 1/1000 --quiet -o t.msh"}) {
    const Outcome o = w.run(command);
    INFO(command << "\n" << o.out << o.err);
    CHECK(o.status == 0);
    CHECK_THAT(o.err, Contains("thin.yaml: warning: `model`: the region dust, r") && Contains("has vanished"));
    CHECK(lines_with(o.err, "notice") == 0);
  }
}

TEST_CASE("a region that vanishes when doubles are snapped is told even to the quiet", "[app][snap]") {
  const Workshop w;
  w.write("gap.yaml", R"(cnrg: 1
nodes:
  low:   {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  dust:  {box: {min: [3, 0, 1], max: [4, 1, 1.00000000000000001]}}
  model: {union: [low, dust]}
result: model
)");
  const std::string told = ": warning: the region dust, r2, at (3, 0, 1), is thinner than 2.";
  for (const std::string command : {"eval gap.yaml -o t.msh -o t.vtu", "mesh gap.yaml -o t.msh -o t.vtu -o t.html",
                                    "mesh gap.yaml --surface -o t.msh -o t.vtu -o t.html"}) {
    Outcome o = w.run(command + " --quiet");
    INFO(command << "\n" << o.out << o.err);
    CHECK(o.status == 0);
    CHECK_THAT(o.err, Contains("t.msh" + told) && Contains("t.vtu" + told));
    CHECK(lines_with(o.err, "notice") == 0);
    o = w.run(command);
    INFO(o.err);
    CHECK(lines_with(o.err, "; 6 faces vanished; 1 region vanished") == 2);
    CHECK(lines_with(o.err, told) == (command.ends_with(".html") ? 3 : 2));
    if (command.ends_with(".html")) CHECK_THAT(w.read("t.html"), Contains("the region dust, r2, at (3, 0, 1)"));
  }
}

TEST_CASE("distances to join by that are none", "[app][join]") {
  const Workshop w;
  w.write("thin.yaml", kThin);
  for (const std::string number : {"0", "-1", "nan", "inf", "x", "1/0", "1e999999999"}) {
    for (const std::string command :
         {"eval thin.yaml --join=", "mesh thin.yaml -o t.msh --join=", "check thin.yaml --features="}) {
      const Outcome o = w.run(command + number);
      INFO(command << number << "\n" << o.out << o.err);
      CHECK(o.status == 2);
      CHECK(lines_with(o.err, "error") == 1);
    }
  }
  const Outcome large = w.run("eval thin.yaml --join 9 -o t.vtu");
  CHECK(large.status == 2);
  CHECK_THAT(large.err, Contains("thin.yaml:6:3: error: ") && Contains("the whole result is 9 long"));
  CHECK_FALSE(std::filesystem::exists(w.path("t.vtu")));
  CHECK_THAT(w.run("eval thin.yaml --join 0.1 -o t.svg").err, Contains("leave out --join or the picture"));
  CHECK(w.run("mesh thin.yaml --join 0.1 --curved -o t.msh").status == 2);
  CHECK_THAT(w.run("check thin.yaml --node low").err, Contains("add --features"));
  w.write("open.yaml", "cnrg: 1\nnodes: {p: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}}\nresult: p\n");
  for (const std::string command : {"eval open.yaml --join 0.1", "check open.yaml --features"}) {
    const Outcome o = w.run(command);
    INFO(o.out << o.err);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Contains("cut the node with a box first"));
  }
}

TEST_CASE("mesh: surfaces of what is joined", "[app][mesh]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
          "  b: {box: {min: [0, 0, 1.0001], max: [1, 1, 2]}}\n  u: {union: [a, b]}\nresult: u\n");
  const Outcome o = w.run("mesh t.yaml -o s.msh --surface --join 0.001");
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains("wall a | b"));
  CHECK_THAT(o.err, Contains("joined 4 pairs"));
}

}  // namespace
}  // namespace cnrg

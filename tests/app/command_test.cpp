// The program from outside: output, messages, exit statuses.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "kernel/exact/rational.h"
#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

const char* const kBoxes = R"(cnrg: 1
materials: {rock: {color: "#998877"}}
nodes:
  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}, material: rock}
  b: {box: {min: [1, 1, 1], max: [3, 3, "10/3"]}, dominance: 1}
  wire: {polyline: [[0, 0, 0], [-1, 0, 0]]}
  u: {union: [a, b]}
  d: {difference: [u, {box: {min: [0, 0, 0], max: [1, 1, 1]}}]}
  r: {union: [d, wire]}
result: r
)";

TEST_CASE("version names the libraries", "[app]") {
  const Outcome o = Workshop().run("--version");
  CHECK(o.status == 0);
  CHECK(o.err.empty());
  for (const char* name : {"cnrg 0.", "CGAL 5.", "GMP 6.", "MPFR 4.", "Boost 1.", "OpenCASCADE"})
    CHECK_THAT(o.out, Contains(name));
}

TEST_CASE("every command has help with an example", "[app]") {
  const Workshop w;
  CHECK(w.run("--help").status == 0);
  for (const std::string name : {"eval", "check", "locate", "tables", "explain", "view", "mesh"}) {
    const Outcome o = w.run(name + " --help");
    CHECK(o.status == 0);
    CHECK_THAT(o.out, Contains("Example") && Contains("cnrg " + name));
  }
}

TEST_CASE("a command line that makes no sense is bad input", "[app][errors]") {
  const Workshop w;
  for (const char* arguments :
       {"", "evaluate", "eval", "eval t.yaml --thread", "eval t.yaml --threads many", "--what"}) {
    const Outcome o = w.run(arguments);
    INFO(arguments);
    CHECK(o.status == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, StartsWith("cnrg: error: "));
    CHECK(lines_in(o.err) == 1);
  }
}

TEST_CASE("help lists what there is, and nothing else is a command", "[app][errors]") {
  const Workshop w;
  CHECK_THAT(w.run("--help").out, !Contains("not in this version"));
  const Outcome o = w.run("paint t.yaml -o a.html");
  CHECK(o.status == 2);
  CHECK(lines_in(o.err) == 1);
  CHECK_THAT(o.err, StartsWith("cnrg: error: "));
}

TEST_CASE("faults of the tree: each with its line and a mark, exit status 2; no file: 3", "[app][errors]") {
  const Workshop w;
  w.write("bad.yaml", "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, nan]}}\nresult: a\n");
  w.write("flat.yaml", "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 0]}}\nresult: a\n");
  for (const std::string command : {"eval", "check", "locate"}) {
    const Outcome bad = w.run(command + " bad.yaml");
    CHECK(bad.status == 2);
    CHECK_THAT(bad.err, StartsWith("bad.yaml:3:41: error: `max` of box: `nan` is no number"));
    CHECK_THAT(bad.err, EndsWith("\n  3 |   a: {box: {min: [0, 0, 0], max: [1, 1, nan]}}\n    | " +
                                 std::string(40, ' ') + "^\n"));
    CHECK(lines_in(bad.err) == 3);
    const Outcome flat = w.run(command + " flat.yaml");
    CHECK(flat.status == 2);
    CHECK_THAT(flat.err, StartsWith("flat.yaml:3:34: error: box"));
    CHECK(lines_in(flat.err) == 3);
    const Outcome none = w.run(command + " none.yaml");
    CHECK(none.status == 3);
    CHECK_THAT(none.err, StartsWith("none.yaml:1:1: error: ") && Contains("there is no file"));
    CHECK(lines_in(none.err) == 1);
  }
}

TEST_CASE("eval prints one aligned row per node", "[app]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  const Outcome o = w.run("eval t.yaml");
  INFO(o.err);
  REQUIRE(o.status == 0);
  CHECK(o.err.empty());
  CHECK(lines_in(o.out) == 11);  // the head, seven nodes, three stages
  CHECK(row(o.out, "a").back() == "8");
  CHECK(row(o.out, "b").back() == "(28/3)");
  CHECK(row(o.out, "u").back() == "(49/3)");
  CHECK(row(o.out, "d").back() == "(46/3)");
  CHECK(row(o.out, "r").back() == "(46/3)");
  CHECK(row(o.out, "d/2").at(1) == "box");
  CHECK(row(o.out, "wire").at(1) == "polyline");

  const Outcome trace = w.run("eval t.yaml --trace");
  CHECK(trace.status == 0);
  CHECK_THAT(trace.out, Contains("    union.face.") && Contains("\nrefinement: ") && Contains("\npredicates: "));
  CHECK_THAT(trace.out, Contains("    region 1 `a`: volume ") && Contains("    region 2 `b`: volume "));
  const Outcome raw = w.run("eval t.yaml --raw --threads 1");
  CHECK(raw.status == 0);
  CHECK(std::stoi(row(raw.out, "a").at(4)) > 6);
  CHECK(row(o.out, "a").at(4) == "6");
  CHECK(w.run("eval t.yaml --threads 1").status == 0);
}

TEST_CASE("quiet is quiet, warnings aside", "[app]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  const Outcome o = w.run("eval t.yaml --quiet");
  CHECK(o.status == 0);
  CHECK(o.out.empty());
  CHECK(o.err.empty());
  w.write("unused.yaml", "cnrg: 1\nnodes:\n  a: {points: [[0, 0, 0]]}\n  b: {points: [[0, 0, 0]]}\nresult: a\n");
  const Outcome unused = w.run("eval unused.yaml");
  CHECK(unused.status == 0);
  CHECK_THAT(unused.err, StartsWith("unused.yaml:4:3: warning: the node `b` is not used"));
}

TEST_CASE("files show the result or the nodes asked for", "[app]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  REQUIRE(w.run("eval t.yaml -o r.json -o r.vtu").status == 0);
  CHECK(nlohmann::json::accept(w.read("r.json")));
  CHECK_THAT(w.read("r.vtu"), Contains("UnstructuredGrid"));

  REQUIRE(w.run("eval t.yaml --node a -o a.json").status == 0);
  REQUIRE(w.run("eval t.yaml --node a --node u -o a2.json -o u.json").status == 0);
  CHECK(w.read("a.json") == w.read("a2.json"));
  CHECK(w.read("u.json") != w.read("a.json"));

  const Outcome uneven = w.run("eval t.yaml --node a --node u -o a.json");
  CHECK(uneven.status == 2);
  CHECK_THAT(uneven.err, Contains("2 times --node and 1 times -o"));
  const Outcome unknown = w.run("eval t.yaml --node wier");
  CHECK(unknown.status == 2);
  CHECK(unknown.err == "cnrg: error: --node: t.yaml has no node called `wier`; did you mean `wire`?\n");
  for (const std::string command :
       {"eval t.yaml", "locate t.yaml", "mesh t.yaml -o m.msh", "explain t.yaml --point 0,0,0"}) {
    const Outcome strange = w.run(command + " --node nosuch");
    CHECK(strange.status == 2);
    CHECK_THAT(strange.err, StartsWith("cnrg: error: --node: t.yaml has no node called `nosuch`; it has `") &&
                                Contains("`wire`"));
  }
  const Outcome extension = w.run("eval t.yaml -o r.doc");
  CHECK(extension.status == 2);
  CHECK_THAT(extension.err, StartsWith("cnrg: error: r.doc: "));
  CHECK(extension.out.empty());  // before any work, and before any other file
  CHECK_FALSE(std::filesystem::exists(w.path("r.doc")));
  const Outcome second = w.run("eval t.yaml -o good.json -o r.doc");
  CHECK(second.status == 2);
  CHECK_FALSE(std::filesystem::exists(w.path("good.json")));
  const Outcome folder = w.run("eval t.yaml -o no/such/folder/r.json");
  CHECK(folder.status == 3);
  CHECK_THAT(folder.err, Contains("no/such/folder"));
}

TEST_CASE("no thread count changes a byte", "[app]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  a: {sphere: {center: [0, 0, 0], radius: 2, segments: 12}}
  b: {sphere: {center: [1, 1/2, 1/3], radius: 2, segments: 10}, rotate: {axis: [1, 2, 3], degrees: 20}}
  r: {union: [{difference: [a, b]}, {intersection: [a, b]}], dominance: left}
result: r
)");
  REQUIRE(w.run("eval t.yaml --threads 1 -o one.json").status == 0);
  REQUIRE(w.run("eval t.yaml --threads 4 -o four.json").status == 0);
  CHECK(w.read("one.json").size() > 1000);
  CHECK(w.read("one.json") == w.read("four.json"));
}

TEST_CASE("results that cannot be written are no success", "[app][errors]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  if (!std::filesystem::exists("/dev/full")) return;
  const Outcome o = w.shell("'" CNRG_PROGRAM "' eval t.yaml 2>.err >/dev/full");
  CHECK(o.status == 3);
  CHECK_THAT(o.err, Contains("standard output"));
}

TEST_CASE("a format that refuses a result does not keep the others from being written", "[app][errors]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
          "  b: {box: {min: [1, 0, 0], max: [2, 1, 1]}}\n  u: {union: [a, b], dominance: left}\nresult: u\n");
  const Outcome o = w.run("eval t.yaml -o r.off -o r.json -o r.ply -o r.obj");
  CHECK(o.status == 2);
  CHECK_THAT(o.out, Contains("\nu "));
  CHECK_THAT(o.err, StartsWith("t.yaml:5:3: error: r.off: OFF holds ") && Contains("error: r.ply: PLY holds "));
  CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 6);  // each with the line of the file and a mark
  for (const char* file : {"r.off", "r.ply"}) CHECK_FALSE(std::filesystem::exists(w.path(file)));
  CHECK_FALSE(w.read("r.json").empty());
  CHECK_THAT(w.read("r.obj"), Contains("\nf "));
}

TEST_CASE("a file beyond the limit of its size says so, whoever makes it", "[app][errors]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes:\n  b: {sphere: {center: [0, 0, 0], radius: 1, segments: 64}}\nresult: b\n");
  for (const std::string file : {"r.msh", "r.h5m", "r.med"}) {
    if (w.run("eval t.yaml --quiet -o whole-" + file).status == 3) continue;  // without its library
    const Outcome o = w.shell("ulimit -f 16; '" CNRG_PROGRAM "' eval t.yaml --quiet -o " + file + " >.out 2>.err");
    CHECK(o.status == 3);
    CHECK_THAT(o.err, Contains(file + ": cannot be written: File too large"));
    CHECK_FALSE(std::filesystem::exists(w.path(file)));
  }
}

TEST_CASE("only files in which elements have several groups take --one-group", "[app][errors]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes:\n  b: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nresult: b\n");
  for (const std::string command : {"eval", "mesh", "mesh --surface"}) {
    const Outcome o = w.run(command + " t.yaml --one-group -o r.inp");
    CHECK(o.status == 2);
    CHECK_THAT(o.err, Contains("r.inp: --one-group is for .msh"));
    CHECK(w.run(command + " t.yaml --quiet --one-group -o r.msh").status == 0);
    CHECK_THAT(w.read("r.msh"), Contains("\"boundary of b\"") && !Contains("\"from b\""));
  }
}

TEST_CASE("when memory runs out the status is 3, whoever asked for it", "[app][errors]") {
  const Workshop w;
  std::string nodes, names;
  for (int i = 0; i < 200; ++i) {
    const std::string n = std::to_string(i);
    nodes += "  s" + n + ": {sphere: {center: [" + n + "/2, 0, " + n + "/7], radius: 1, segments: 16}}\n";
    names += (i ? ", s" : "s") + n;
  }
  w.write("t.yaml", "cnrg: 1\nnodes:\n" + nodes + "  r: {union: [" + names + "]}\nresult: r\n");
  for (int megabytes = 60; megabytes <= 70; megabytes += 10) {
    const Outcome o = w.shell("ulimit -v " + std::to_string(megabytes * 1024) +
                              "; '" CNRG_PROGRAM "' eval t.yaml --threads 1 >.out 2>.err");
    INFO(megabytes << " MB: " << o.err);
    if (o.status == 0) break;
    // Not even room for the libraries, the sanitizer or the stack of a thread: the program had not begun.
    const auto says = [&](const char* text) { return o.err.find(text) != std::string::npos; };
    if (says("error while loading") || says("Sanitizer") || says("pthread_create")) continue;
    CHECK(o.status == 3);
    CHECK_THAT(o.err, Contains("memory ran out"));
  }
}

TEST_CASE("a result is read back as a leaf", "[app]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  REQUIRE(w.run("eval t.yaml --node d -o d.json").status == 0);
  w.write("again.yaml", "cnrg: 1\nnodes: {d: {cnrg: d.json}}\nresult: d\n");
  const Outcome o = w.run("eval again.yaml");
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK(row(o.out, "d").back() == "(46/3)");
}

TEST_CASE("materials of a mixture are read back, and none that there is not", "[app][errors]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nmaterials:\n  steel: {}\n  ceramic: {}\n"
          "  graded: {linear: {from: [0, 0, 0], to: [0, 0, 1], stops: [[0, steel], [1, ceramic]]}}\n"
          "nodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}, material: graded}}\nresult: a\n");
  w.write("back.yaml", "cnrg: 1\nnodes: {a: {cnrg: a.json}}\nresult: a\n");
  REQUIRE(w.run("eval t.yaml --quiet -o a.json").status == 0);
  REQUIRE(w.run("eval back.yaml --quiet -o b.json").status == 0);
  for (const char* name : {"steel", "ceramic", "graded"}) {
    CHECK_THAT(w.read("b.json"), Contains("{\"name\":\"" + std::string(name) + "\",\"color\":\"\"}"));
  }
  const std::string written = w.read("a.json");
  const std::string mixture = "\"mixture\":{\"steel\":";
  const auto with = [&](const std::string& name) {
    std::string text = written;
    text.replace(text.find(mixture), mixture.size(), "\"mixture\":{\"" + name + "\":");
    w.write("a.json", text);
    return w.run("check back.yaml");
  };
  REQUIRE(written.find(mixture) != std::string::npos);
  CHECK_THAT(with("brass").err, Contains("/grades/0/stops/0/mixture/brass: `materials` has none of this name"));
  CHECK_THAT(with("graded").err, Contains("mixture/graded: a graded material is made of itself"));
}

TEST_CASE("files of doubles are snapped where rounding breaks them, or not", "[app][snap]") {
  const Workshop w;
  w.write("gap.yaml", R"(cnrg: 1
nodes:
  low:   {box: {min: [0, 0, 0], max: [1, 1, 1]}}
  high:  {box: {min: [0, 0, 1.00000000000000001], max: [1, 1, 2]}}
  model: {union: [low, high]}
result: model
)");
  w.write("open.yaml", R"(cnrg: 1
nodes:
  ground: {halfspace: {point: [0, 0, "1/3"], normal: [0, 0, 1]}}
  sky: {halfspace: {point: [0, 0, "100000000000000001/300000000000000000"], normal: [0, 0, -1]}}
  cut: {interior: ground}
  both: {sum: [cut, {interior: sky}]}
result: cut
)");
  Outcome o = w.run("eval gap.yaml --quiet --no-snap -o gap.msh -o gap.json");
  CHECK(o.status == 0);
  CHECK_THAT(o.err,
             Contains("gap.msh: warning: rounding moved 4 vertices and broke") && Contains("out --no-snap"));
  const std::string exact = w.read("gap.json"), rounded = w.read("gap.msh");
  for (const char* ending : {"poly", "smesh"}) {
    o = w.run(std::string("eval gap.yaml --no-snap -o gap.") + ending);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("gap.yaml:5:11: notice: `model`: 4 pairs of cells do not touch") &&
                          Contains("\ngap.yaml:5:3: error: gap.") && Contains("without --no-snap"));
    o = w.run(std::string("eval gap.yaml -o gap.") + ending);
    CHECK(o.status == 0);
    CHECK_THAT(o.err, Contains("notice: snapped 4 of 16 vertices"));
  }
  o = w.run("mesh gap.yaml --no-snap -o tets.msh");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, StartsWith("gap.yaml:5:3: error: ") && Contains("without --no-snap"));
  CHECK(w.run("mesh gap.yaml --no-snap --snap -o tets.msh").status == 2);
  o = w.run("mesh gap.yaml -o tets.msh");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("tets.msh: notice: snapped 4 of 16 vertices"));
  CHECK(row(o.out, "all").back() == "2");

  // Files that know the parameters of patches hold the exact result's points.
  o = w.run("eval gap.yaml --quiet --parameters -o gap.vtu -o gap.msh");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("gap.vtu: warning: ") && Contains("leave out --parameters") && !Contains("gap.msh"));
  CHECK(w.read("gap.msh") != rounded);

  o = w.run("eval gap.yaml --snap -o gap.msh -o gap.json -o gap.vtu --node model");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("gap.msh: notice: snapped 4 of 16 vertices, by 1") &&
                        Contains("gap.vtu: notice: snapped 4 of 16 vertices") &&
                        Contains("gap.json: notice: this format is exact; --snap changes nothing in it"));
  CHECK(w.read("gap.json") == exact);
  CHECK_THAT(w.read("gap.msh"), Contains("\"wall low | high\""));
  const std::string snapped = w.read("gap.msh");
  CHECK(w.run("eval gap.yaml --quiet -o gap.msh").err.empty());
  CHECK(w.read("gap.msh") == snapped);
  o = w.run("mesh gap.yaml --snap -o tets.msh");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("tets.msh: notice: snapped 4 of 16 vertices"));
  CHECK(row(o.out, "all").back() == "2");

  o = w.run("eval open.yaml -o open.vtu");
  CHECK(o.status == 0);
  CHECK_THAT(o.err, Contains("rounding moved 4 vertices; the facets still meet as they should"));
  o = w.run("eval open.yaml --node both -o open.vtu");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, Contains("open.yaml:6:3: error: ") && Contains("only one whose faces and lines have bounds"));
  CHECK(w.run("eval open.yaml --node both -o open.vtu --no-snap").status == 0);
}

TEST_CASE("binary forms of files, where there are such", "[app]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  a: {box: {min: [0, 0, 0], max: [1, 1, "1/3"]}}
  b: {box: {min: [1, 1, 0], max: [2, 2, 1]}}
  m: {union: [a, b]}
  thin: {box: {min: [0, 0, 1], max: [1, 1, 1.00000001]}}
result: m
)");
  for (const std::string file : {"m.stl", "m.ply"}) {
    CAPTURE(file);
    Outcome o = w.run("eval t.yaml --node m --binary -o " + file);
    CHECK(o.status == 0);
    CHECK_THAT(o.err,
               Contains(file + ": notice: rounding moved 4 vertices; the facets still meet as they should"));
    const std::string bytes = w.read(file);
    CHECK(bytes.find('\0') != std::string::npos);
    w.write("back.yaml", "cnrg: 1\nnodes:\n  r: {mesh: {file: " + file + "}}\nresult: r\n");
    o = w.run("eval back.yaml -o back.json");
    CHECK(o.status == 0);
    CHECK_THAT(o.out, Contains(file == "m.stl" ? "  1.33333334327 (44739243/33554432)" : "  1.33333333333 ("));
  }
  Outcome o = w.run("eval t.yaml --node thin --binary -o thin.stl");
  CHECK(o.status == 2);
  CHECK_THAT(o.err, StartsWith("t.yaml:6:3: error: thin.stl: STL in binary holds numbers of 24 bits") &&
                        Contains("(4 vertices move); leave out --binary"));
  CHECK(w.run("eval t.yaml --node thin --binary --quiet -o thin.ply").status == 0);
  CHECK(w.run("eval t.yaml --node thin --quiet -o thin.stl").status == 0);
  for (const std::string file : {"m.obj", "m.vtu", "m.svg", "m.dot"}) {
    o = w.run("eval t.yaml --binary -o " + file);
    CHECK(o.status == 2);
    CHECK_THAT(o.err,
               Contains(file + ": this format has one form only; leave out --binary, which is for .stl .ply"));
  }
}

TEST_CASE("check reads and validates only", "[app]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  const Outcome o = w.run("check t.yaml");
  CHECK(o.status == 0);
  CHECK(o.out == "t.yaml: 7 nodes, 4 of them leaves; no faults\n");
  CHECK(w.run("check -", "cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n").out ==
        "<stdin>: 1 node, a leaf; no faults\n");
  CHECK(w.run("check -", "cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}, b: {unify: a}}\nresult: b\n").out ==
        "<stdin>: 2 nodes, 1 of them a leaf; no faults\n");
}

TEST_CASE("a mesh and a result stand for trees of one leaf") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes:\n  part: {box: {min: [0, 0, 0], max: [1, 2, 3]}}\nresult: part\n");
  REQUIRE(w.run("eval t.yaml -o part.off -o part.json").status == 0);
  for (const char* extension : {"off", "json"}) {
    CAPTURE(extension);
    const std::string file = "part." + std::string(extension);
    CHECK(row(w.run("eval " + file).out, "part").back() == "6");
    CHECK(w.run("check " + file).out == file + ": 1 node, a leaf; no faults\n");
    CHECK(w.run("mesh " + file + " -o part.msh --quiet").status == 0);
    CHECK(w.run("compare t.yaml " + file).status == 0);
    CHECK(w.run("view " + file + " -o part.html").status == 0);
    CHECK_THAT(w.run("eval " + file + " -D R=1").err, Contains("the parameter `R`: " + file + " is no tree"));
  }
  // Whatever a tree in JSON begins with, it is a tree.
  for (const char* first : {"\"parameters\": {\"R\": 1}", "\"x-mine\": 1", "\"materials\": {}", "\"cnrg\": 1"}) {
    w.write("tree.json", "{" + std::string(first) +
                             ", \"nodes\": {\"p\": {\"points\": [[0, 0, 0]]}}, \"result\": \"p\"" +
                             (first == std::string("\"cnrg\": 1") ? "}" : ", \"cnrg\": 1}"));
    INFO(first);
    CHECK(w.run("eval tree.json").status == 0);
  }
}

TEST_CASE("locate names cell, component and region", "[app]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  const Outcome o = w.run("locate t.yaml --node u", "1/2 0.5 1\n-1 0 0\n2.5 2.5 3\n\n2 2 1/2\n0 1 1\n0 0 0\n");
  INFO(o.err);
  REQUIRE(o.status == 0);
  std::istringstream lines(o.out);
  std::vector<std::string> line(7);
  for (std::string& l : line) std::getline(lines, l);
  CHECK_THAT(line[0], Catch::Matches("3 r[0-9]+ [12] a"));
  CHECK_THAT(line[1], Catch::Matches("3 (r[0-9]+|-) 0"));
  CHECK_THAT(line[2], Catch::Matches("3 r[0-9]+ [12] b"));
  CHECK(line[3].empty());
  CHECK_THAT(line[4], Catch::Matches("1 e[0-9]+ 3 .*"));
  CHECK_THAT(line[5], Catch::Matches("2 f[0-9]+ 3 .*"));
  CHECK_THAT(line[6], Catch::Matches("0 v[0-9]+ 3 .*"));
}

TEST_CASE("files and commands number cells alike", "[app]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}\n"
          "  b: {box: {min: [1, -1, 1], max: [3, 3, 3]}}\n  c: {cylinder: {from: [1, 1, -1], to: [1, 1, 4], "
          "radius: 1/2, segments: 12}}\n  w: {polyline: [[5, 5, 5], [0, 0, 0], [1, 1, 1]]}\n"
          "  other: {box: {min: [-9, -9, -9], max: [9, 9, 1/2]}}\n"
          "  s: {sum: [{unify: a}, {unify: b}, {unify: c}, w]}\n  r: {product: [s, other]}\nresult: r\n");
  REQUIRE(w.run("eval t.yaml --quiet --node s -o s.json").status == 0);
  const auto json = nlohmann::json::parse(w.read("s.json"));
  std::string points, expected;
  const auto ask = [&](const std::array<Rational, 3>& p, const std::string& name, const nlohmann::json& cell) {
    points += to_string(p[0]) + " " + to_string(p[1]) + " " + to_string(p[2]) + "\n";
    expected += name + " " + std::to_string(cell["component"].get<int>()) + "\n";
  };
  const auto middle = [&](const nlohmann::json& corners) {
    std::array<Rational, 3> sum{0, 0, 0};
    for (const auto& i : corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += *parse_rational(json["points"][i.get<std::size_t>()][k].get<std::string>());
      }
    }
    for (Rational& x : sum) x /= Rational(static_cast<long>(corners.size()));
    return sum;
  };
  for (std::size_t i = 0; i < json["vertices"].size(); ++i) {
    const auto& v = json["vertices"][i];
    ask(middle(nlohmann::json::array({v["point"]})), "0 v" + std::to_string(i), v);
  }
  for (std::size_t i = 0; i < json["edges"].size(); ++i) {
    const auto& e = json["edges"][i];
    ask(middle(nlohmann::json::array({e["points"][0], e["points"][1]})), "1 e" + std::to_string(i), e);
  }
  for (std::size_t i = 0; i < json["faces"].size(); ++i) {
    const auto& f = json["faces"][i];
    ask(middle(f["triangles"][0]), "2 f" + std::to_string(i), f);
  }
  const Outcome o = w.run("locate t.yaml --node s", points);
  REQUIRE(o.status == 0);
  std::istringstream lines(o.out);
  std::string named, line;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string dimension, cell, component;
    words >> dimension >> cell >> component;
    named += dimension + " " + cell + " " + component + "\n";
  }
  CHECK(named == expected);
}

TEST_CASE("points far away are located in planes and half-spaces", "[app]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  h: {halfspace: {point: [0, 0, 0], normal: [0, 0, 1]}}\n"
          "  p: {plane: {point: [0, 0, 1], normal: [0, 0, 1]}}\n  r: {aggregate: [{unify: h}, p]}\n"
          "  e: {closure: h, each: true}\n  u: {unify: {aggregate: [p, {points: [[0, 0, 4]]}]}}\nresult: r\n");
  const std::string points = "0 0 -500\n700 800 1\n100 100 1000\n-9 0 0\n";
  const Outcome o = w.run("locate t.yaml", points);
  INFO(o.err);
  REQUIRE(o.status == 0);
  CHECK_THAT(o.out, Catch::Matches("3 r[0-9]+ 1 h\n2 f[0-9]+ 2 entities\n3 (r[0-9]+|-) 0\n2 f[0-9]+ 1 h\n"));
  CHECK(w.run("eval t.yaml --node e --node u -o e.json -o u.json").status == 0);
  CHECK(w.run("explain t.yaml --point=0,0,-500").status == 0);
}

TEST_CASE("a bad line of points has its place", "[app][errors]") {
  const Workshop w;
  w.write("t.yaml", kBoxes);
  const auto fault = [&](const std::string& input) {
    const Outcome o = w.run("locate t.yaml", input);
    CHECK(o.status == 2);
    CHECK(lines_in(o.err) == 1);
    return o.err;
  };
  CHECK_THAT(fault("0 0 0\n1 zwei 3\n"), StartsWith("<stdin>:2:3: error: `zwei` is no number"));
  CHECK_THAT(fault("1 2\n"), StartsWith("<stdin>:1:4: error: a point has three numbers"));
  CHECK_THAT(fault("1 2 3 4\n"), StartsWith("<stdin>:1:7: error: a point has three numbers"));
  CHECK_THAT(fault("1 2 1/0\n"), StartsWith("<stdin>:1:5: error: `1/0` is no number"));
}

TEST_CASE("tables are Markdown", "[app]") {
  const Outcome o = Workshop().run("tables");
  CHECK(o.status == 0);
  CHECK_THAT(o.out, Contains("|") && Contains("INTERS") && Contains("union"));
}

TEST_CASE("one file for two results is refused before any work", "[app]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n");
  for (const std::string command : {"eval t.yaml -o a.msh -o a.msh", "mesh t.yaml -o a.msh -o a.msh"}) {
    INFO(command);
    const Outcome o = w.run(command);
    CHECK(o.status == 2);
    CHECK(o.err == "cnrg: error: the file a.msh is given by two -o; give each its own name\n");
    CHECK(o.out == "");
    CHECK_FALSE(std::filesystem::exists(w.path("a.msh")));
  }
}

TEST_CASE("no file that a run reads is replaced by what it writes", "[app][errors]") {
  const Workshop w;
  w.write("a.json",
          R"({"cnrg": 1, "nodes": {"a": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}}, "result": "a"})");
  const std::string tree = w.read("a.json");
  REQUIRE(w.run("eval a.json --quiet -o b.json").status == 0);
  const std::string result = w.read("b.json");
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {cnrg: b.json}}\nresult: a\n");
  w.shell("ln -s a.json link.json; mkdir f");
  for (const std::string name : {"a.json", "./a.json", "f/../a.json", "link.json"}) {
    const Outcome o = w.run("eval a.json -o " + name);
    CHECK(o.status == 2);
    CHECK(o.err == "cnrg: error: -o " + name + " would replace the tree itself; give another name\n");
  }
  const Outcome o = w.run("eval t.yaml -o b.json");
  CHECK(o.status == 2);
  CHECK(o.err == "cnrg: error: -o b.json would replace a file that the node a reads; give another name\n");
  CHECK(w.read("a.json") == tree);
  CHECK(w.read("b.json") == result);
  CHECK(w.run("eval a.json -o c.json -o ./c.json").err ==
        "cnrg: error: the file ./c.json is given by two -o; give each its own name\n");
}

}  // namespace
}  // namespace cnrg

// `cnrg compare` from outside: what it prints, files that it takes, exit statuses.

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

const std::string kUnitBox = "cnrg: 1\nnodes:\n  box: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n";
const std::string kTree = kUnitBox + "  low: {box: {min: [0, 0, 0], max: [1, 1, 1/2]}}\nresult: box\n";

TEST_CASE("compare prints what differs and ends with 4, or with 0", "[compare][command]") {
  const Workshop w;
  w.write("a.yaml", kTree);
  const Outcome same = w.run("compare a.yaml a.yaml");
  CHECK(same.status == 0);
  CHECK(same.out == "A: `box` of a.yaml\nB: `box` of a.yaml\nthe same\n");
  CHECK(same.err.empty());
  const Outcome different = w.run("compare a.yaml a.yaml --node-b low");
  CHECK(different.status == 4);
  CHECK(different.out ==
        "A: `box` of a.yaml\nB: `low` of a.yaml\ndifferent\nonly in A: a region of volume 0.5 about (1/2, 1/2, "
        "3/4)\n");
  CHECK(different.err.empty());
  const Outcome quiet = w.run("compare a.yaml a.yaml --node-a low --quiet");
  CHECK(quiet.status == 4);
  CHECK(quiet.out.empty());
  CHECK(w.run("compare a.yaml a.yaml --quiet --threads 1").status == 0);
}

TEST_CASE("compare takes results, meshes and trees in JSON", "[compare][command]") {
  const Workshop w;
  w.write("a.yaml", kTree);
  w.write(
      "tree.json",
      R"({"materials": {}, "cnrg": 1, "nodes": {"x": {"box": {"min": [0,0,0], "max": [1,1,1]}}}, "result": "x"})");
  REQUIRE(w.run("eval a.yaml --quiet -o a.json -o a.off").status == 0);
  // The other formats of a `mesh` leaf.
  w.write("a.vtk",
          "# vtk DataFile Version 3.0\na box\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n0 0 0 1 0 0 0 1 0 1 1 0 "
          "0 0 1 1 0 1 0 1 1 1 1 1\nPOLYGONS 6 30\n4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 "
          "5\n");
  w.write(
      "a.TS",
      "GOCAD TSurf 1\nHEADER {\nname: a\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nVRTX 4 1 1 0\n"
      "VRTX 5 0 0 1\nVRTX 6 1 0 1\nVRTX 7 0 1 1\nVRTX 8 1 1 1\nTRGL 1 3 4\nTRGL 1 4 2\nTRGL 5 6 8\nTRGL 5 8 7\n"
      "TRGL 1 2 6\nTRGL 1 6 5\nTRGL 3 7 8\nTRGL 3 8 4\nTRGL 1 5 7\nTRGL 1 7 3\nTRGL 2 4 8\nTRGL 2 8 6\nEND\n");
  for (const std::string a : {"a.yaml", "a.json", "a.off", "tree.json"}) {
    for (const std::string b : {"a.yaml", "a.json", "a.off", "tree.json", "a.vtk", "a.TS"}) {
      INFO(a << " " << b);
      CHECK(w.run("compare " + a + " " + b).status == 0);
    }
    CHECK(w.run("compare a.yaml --node-a low " + a + " --quiet").status == 4);
  }
  // Members of a result in another order, as other programs write them.
  REQUIRE(w.shell("python3 -c 'import json; json.dump(json.load(open(\"a.json\")), open(\"sorted.json\", \"w\"), "
                  "sort_keys=True)' >.out 2>.err")
              .status == 0);
  CHECK(w.run("compare a.yaml sorted.json --quiet").status == 0);
}

TEST_CASE("What compare cannot do is one error with a way round", "[compare][command]") {
  const Workshop w;
  w.write("a.yaml", kTree);
  const auto refused = [&](const std::string& arguments, int status, const std::string& message) {
    const Outcome outcome = w.run("compare " + arguments);
    INFO(arguments << ": " << outcome.err);
    CHECK(outcome.status == status);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.find(message) != std::string::npos);
    CHECK(errors_in(outcome.err) == 1);
  };
  refused("a.yaml", 2, "B is required");
  refused("a.yaml none.yaml", 3, "none.yaml");
  refused("a.yaml none.off", 3, "none.off");
  refused("a.yaml none.json", 3, "none.json");
  refused("a.yaml a.yaml --node-b lwo", 2, "--node-b: a.yaml has no node called `lwo`; did you mean `low`?");
  refused("a.yaml a.yaml --ignore colours", 2, "--ignore");
  w.write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1\n3 0 1 2\n");
  refused("a.yaml bad.off", 2, "bad.off:");
  w.write("open.yaml",
          "cnrg: 1\nnodes:\n  o: {interior: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\n"
          "  u: {union: [o, o]}\nresult: u\n");
  refused("a.yaml open.yaml", 2, "open.yaml:4:7: error: `union` of `u` takes closed values and `o` is not closed");
  w.write("far.yaml", "cnrg: 1\nnodes:\n  m: {mesh: {file: ../elsewhere.off}}\nresult: m\n");
  w.write("gone.yaml", "cnrg: 1\nnodes:\n  m: {mesh: {file: gone.off}}\nresult: m\n");
  refused("a.yaml gone.yaml", 3, "gone.yaml:3:20: error: there is no file");
  refused("a.yaml far.yaml --inside .", 2, "far.yaml:3:20: error:");
}

TEST_CASE("compare makes both trees finer", "[compare][command]") {
  const Workshop w;
  w.write("a.yaml", "cnrg: 1\nnodes:\n  b: {sphere: {center: [0, 0, 0], radius: 1, segments: 8}}\nresult: b\n");
  REQUIRE(w.run("eval a.yaml --quiet -o coarse.json").status == 0);
  REQUIRE(w.run("eval a.yaml --quiet --finer 2 -o fine.json").status == 0);
  CHECK(w.run("compare a.yaml coarse.json --quiet").status == 0);
  CHECK(w.run("compare a.yaml coarse.json --quiet --finer 2").status == 4);
  CHECK(w.run("compare a.yaml fine.json --quiet --finer 2").status == 0);
}

}  // namespace
}  // namespace cnrg

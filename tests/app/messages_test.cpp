// Messages that say what to do: options, forms of leaves, files that are cut short.
#include <algorithm>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::EndsWith;
using Catch::StartsWith;

TEST_CASE("faults of options name the nearest one and the right help", "[app][messages]") {
  const Workshop w;
  const auto fault = [&](const std::string& arguments) {
    const Outcome o = w.run(arguments);
    CHECK(o.status == 2);
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    return o.err;
  };
  CHECK_THAT(fault("eval t.yaml --topologie"),
             Contains("did you mean `--topology`?") && EndsWith(" see `cnrg eval --help`\n"));
  CHECK_THAT(fault("mesh t.yaml -o m.msh --qualitie=2"), Contains("did you mean `--quality`?"));
  CHECK(fault("mesh t.yaml -o m.msh --qualty 1.4") ==
        "cnrg: error: not expected: --qualty 1.4; did you mean `--quality`? see `cnrg mesh --help`\n");
  CHECK(fault("mesh t.yaml -o m.msh -g 1.4") ==
        "cnrg: error: not expected: -g 1.4; did you mean `--growth`? see `cnrg mesh --help`\n");
  CHECK_THAT(fault("eval t.yaml -t"), Contains("did you mean `--trace` or `--topology` or `--threads`?"));
  CHECK(fault("check t.yaml -z") == "cnrg: error: not expected: -z; see `cnrg check --help`\n");
  CHECK_THAT(fault("locate t.yaml --zzzzzz"),
             !Contains("did you mean") && EndsWith("; see `cnrg locate --help`\n"));
  CHECK_THAT(fault("check"), Contains("TREE is required") && EndsWith("; see `cnrg check --help`\n"));
  CHECK_THAT(fault("eval t.yaml --threads many"), EndsWith("; see `cnrg eval --help`\n"));
  CHECK_THAT(fault("evla t.yaml"), StartsWith("cnrg: error: there is no command `evla`; did you mean `eval`?") &&
                                       EndsWith(" see `cnrg --help`\n"));
}

TEST_CASE("all faults of a tree are told with their lines; of long lines and odd letters the part there",
          "[app][messages]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], maxx: [1, 1, 1]}}\n  Größe: {boks: 1}\nresult: c\n");
  CHECK(w.run("eval t.yaml").err ==
        "t.yaml:3:29: error: unknown key `maxx` in box; did you mean `max`?\n"
        "  3 |   a: {box: {min: [0, 0, 0], maxx: [1, 1, 1]}}\n    |                             ^\n"
        "t.yaml:4:13: error: unknown key `boks` in the node `Größe`: neither an operator nor an attribute; remove "
        "it "
        "or write the one that is meant\n  4 |   Größe: {boks: 1}\n    |           ^\n"
        "t.yaml:5:9: error: there is no node called `c`; did you mean `a`?\n  5 | result: c\n    |         ^\n");
  const std::string blanks(100, ' ');
  w.write("t.yaml", "cnrg: 1\nnodes: {a: " + blanks + "{box: x}" + blanks + "}\nresult: a\n");
  CHECK_THAT(w.run("eval t.yaml").err,
             StartsWith("t.yaml:2:118: error: ") &&
                 EndsWith("\n  2 | ..." + std::string(54, ' ') + "{box: x}" + std::string(38, ' ') +
                          "...\n    | " + std::string(63, ' ') + "^\n"));
  std::string many = "cnrg: 1\nnodes:\n";
  for (int i = 0; i < 60; ++i) many += "  n" + std::to_string(i) + ": {boks: 1}\n";
  w.write("t.yaml", many + "result: n0\n");
  const Outcome o = w.run("eval t.yaml");
  CHECK(errors_in(o.err) == 50);
  CHECK_THAT(o.err, EndsWith("^\n10 more faults\n"));
}

TEST_CASE("a directory given to -o is told before any work", "[app][messages]") {
  const Workshop w;
  w.shell("mkdir out out.vtu");
  for (const std::string command : {"eval none.yaml -o out", "eval none.yaml -o out/", "eval none.yaml -o out.vtu",
                                    "mesh none.yaml -o out", "eval none.yaml -o gone/"}) {
    const Outcome o = w.run(command);
    INFO(o.err);
    CHECK(o.status == 3);
    CHECK_THAT(o.err, StartsWith("cnrg: error: ") && Contains("it is a directory; give the name of a file in it"));
  }
}

TEST_CASE("an empty name on the command line is told as such", "[app][messages]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {points: [[0, 0, 0]]}}\nresult: a\n");
  for (const std::string command :
       {"eval t.yaml -o ''", "eval t.yaml -o a.json -o ''", "eval ''", "eval t.yaml --node ''",
        "eval t.yaml --inside ''", "mesh t.yaml -o ''", "mesh t.yaml -o m.msh --node ''",
        "locate t.yaml --node ''", "explain t.yaml --cell v0 --node ''", "check ''"}) {
    const Outcome o = w.run(command);
    INFO(command);
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("cnrg: error: ") && Contains(": the name is empty; see `cnrg "));
  }
  CHECK(w.run("eval t.yaml -o ''").err == "cnrg: error: --output: the name is empty; see `cnrg eval --help`\n");
  CHECK_FALSE(std::filesystem::exists(w.path("a.json")));
}

TEST_CASE("a folder that is not there is told before the work, a file that may not grow after it",
          "[app][messages]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes:\n  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 60}}\nresult: a\n");
  for (const std::string command : {"eval", "mesh"}) {
    CAPTURE(command);
    const std::string name = command == "eval" ? "no/x.json" : "no/x.msh";
    const Outcome o = w.run(command + " t.yaml -o " + name);
    CHECK(o.status == 3);
    CHECK(o.err == "cnrg: error: " + name + ": cannot be written: there is no folder 'no'; make it first\n");
    CHECK(o.out.empty());
  }
  const Outcome o = w.shell("ulimit -f 1; '" CNRG_PROGRAM "' eval --quiet t.yaml -o x.json >.out 2>.err");
  CHECK(o.status == 3);
  CHECK(o.err == "cnrg: error: x.json: cannot be written: File too large\n");
}

TEST_CASE("the version names every library", "[app][messages]") {
  const std::string text = Workshop().run("--version").out;
  for (const char* name : {"\noneTBB 2", "\nyaml-cpp 0.", "\nExpat 2.", "\nTetGen 1."})
    CHECK_THAT(text, Contains(name));
}

TEST_CASE("a file that ends too early is told at its last line", "[app][messages]") {
  const Workshop w;
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {mesh: {file: a.off}}}\nresult: a\n");
  w.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n\n\n");
  CHECK_THAT(
      w.run("check t.yaml").err,
      StartsWith("a.off:5:1: error: the file ends after 0 of 1 faces: it is truncated, or a count is wrong; "
                 "write the file again (read for the node `a`, t.yaml:2:"));
  w.write("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n");
  CHECK_THAT(w.run("check t.yaml").err,
             StartsWith("a.off:6:1: error: the file ends where the index of a corner is"));
  w.write("t.yaml", "cnrg: 1\nnodes: {a: {mesh: {file: a.stl}}}\nresult: a\n");
  w.write("a.stl", std::string(60, 'x'));
  const std::string binary = w.run("check t.yaml").err;
  CHECK_THAT(binary, StartsWith("a.stl:1:1: error: byte 60: the file ends within the header"));
  CHECK(binary.find("error:") == binary.rfind("error:"));
}

TEST_CASE("an empty file is told as such, whatever it should hold", "[app][messages]") {
  const Workshop w;
  const auto leaf_of = [](const std::string& kind, const std::string& file) {
    return kind == "json" ? "cnrg: " + file
                          : (kind == "asc" ? "heightfield: {file: " : kind + ": {file: ") + file + "}";
  };
  for (const std::string content : {"", " \n\n", "\xef\xbb\xbf"}) {
    for (const std::string kind : {"off", "obj", "stl", "ply", "json", "asc", "step", "brep"}) {
      const std::string file = "empty." + kind;
      w.write(file, content);
      const bool mesh = kind == "off" || kind == "obj" || kind == "stl" || kind == "ply";
      w.write("t.yaml", "cnrg: 1\nnodes: {a: {" + leaf_of(mesh ? "mesh" : kind, file) + "}}\nresult: a\n");
      const Outcome o = w.run("check t.yaml");
      if (o.err.find("without OpenCASCADE") != std::string::npos) continue;
      CHECK(o.status == 2);
      CHECK_THAT(o.err, StartsWith(file + ":1:1: error: the file is empty: "));
    }
    w.write("t.yaml", content);
    CHECK_THAT(w.run("check t.yaml").err, StartsWith("t.yaml:1:1: error: the file is empty; "));
  }
}

TEST_CASE("faults of a result that is read back say what to do", "[app][messages]") {
  const Workshop w;
  w.write("back.yaml", "cnrg: 1\nnodes: {a: {cnrg: r.json}}\nresult: a\n");
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\n"
          "  b: {box: {min: [3, 0, 0], max: [4, 1, 1]}}\n  m: {aggregate: [a, b]}\nresult: m\n");
  REQUIRE(w.run("eval t.yaml --quiet -o r.json").status == 0);
  const std::string good = w.read("r.json");
  const auto broken = [&](const std::string& what, const std::string& by) {
    std::string text = good;
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    w.write("r.json", text.replace(at, what.size(), by));
    const Outcome o = w.run("check back.yaml");
    CHECK(o.status == 2);
    return o.err;
  };
  const std::string again = "; write the file again with `cnrg eval -o` (read for the node `a`, back.yaml:2:";
  CHECK_THAT(broken("\"component\":2", "\"component\":5"),
             Contains("/component: component 5 does not exist: numbers are 0 to 4" + again));
  CHECK_THAT(broken("\"leaves\":[0]", "\"leaves\":[2]"),
             Contains("/leaves/0: leaf 2 does not exist: numbers are 0 to 1" + again));
  w.write("r.json", good.substr(0, good.size() / 2));
  CHECK_THAT(w.run("check back.yaml").err,
             Contains("this is no JSON text from here on: the file may be cut short" + again));
}

}  // namespace
}  // namespace cnrg

// Messages that say what to do: options, forms of leaves, files that are cut short.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>

#include "tests/app/program.h"

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
  CHECK_THAT(fault("locate t.yaml --zzzzzz"),
             !Contains("did you mean") && EndsWith("; see `cnrg locate --help`\n"));
  CHECK_THAT(fault("check"), Contains("TREE is required") && EndsWith("; see `cnrg check --help`\n"));
  CHECK_THAT(fault("eval t.yaml --threads many"), EndsWith("; see `cnrg eval --help`\n"));
  CHECK_THAT(fault("evla t.yaml"), StartsWith("cnrg: error: there is no command `evla`; did you mean `eval`?") &&
                                       EndsWith(" see `cnrg --help`\n"));
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

TEST_CASE("the version names every library", "[app][messages]") {
  const std::string text = Workshop().run("--version").out;
  for (const char* name : {"\noneTBB 2", "\nyaml-cpp 0.", "\nTetGen 1."}) CHECK_THAT(text, Contains(name));
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

}  // namespace
}  // namespace cnrg

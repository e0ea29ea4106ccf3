// What whoever starts the program gives it or does not: standard streams, children that can be waited for.
#include <filesystem>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

const char* const kBox = "cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}}\nresult: a\n";

TEST_CASE("a standard stream that is closed is not taken for a file", "[app][streams]") {
  const Workshop w;
  w.write("t.yaml", kBox);
  REQUIRE(w.run("mesh t.yaml -o whole.msh").status == 0);
  struct Case {
    std::string closed;
    int status;  // results that nobody can get are an error
  };
  for (const auto& [closed, status] :
       {Case{"2>&-", 0}, Case{"<&-", 0}, Case{">&-", 3}, Case{">&- 2>&-", 3}, Case{"<&- >&- 2>&-", 3}}) {
    std::filesystem::remove(w.path("m.msh"));
    INFO(closed);
    CHECK(w.shell("'" CNRG_PROGRAM "' mesh t.yaml -o m.msh >.out 2>.err " + closed).status == status);
    CHECK(w.read("m.msh") == w.read("whole.msh"));
  }
}

TEST_CASE("points cannot be read from a standard input that is closed", "[app][streams]") {
  const Workshop w;
  w.write("t.yaml", kBox);
  const Outcome o = w.shell("'" CNRG_PROGRAM "' locate t.yaml <&- >.out 2>.err");
  CHECK(o.status == 3);
  CHECK_THAT(o.err, Contains("<stdin>:1:1: error: the points cannot be read"));
}

TEST_CASE("help and versions that cannot be written are an error, too", "[app][streams]") {
  if (!std::filesystem::exists("/dev/full")) return;
  const Workshop w;
  for (const char* arguments : {"--version", "--help", "eval --help"}) {
    const Outcome o = w.shell("'" CNRG_PROGRAM "' " + std::string(arguments) + " 2>.err >/dev/full");
    CHECK(o.status == 3);
    CHECK_THAT(o.err, Contains("standard output"));
  }
}

TEST_CASE("a program that ignores the ends of its children starts ours as well", "[app][streams]") {
  const Workshop w;
  w.write("t.yaml", kBox);
  const Outcome o = w.shell("trap '' CHLD; '" CNRG_PROGRAM "' mesh t.yaml -o m.msh >.out 2>.err");
  INFO(o.err);
  CHECK(o.status == 0);
}

}  // namespace
}  // namespace cnrg

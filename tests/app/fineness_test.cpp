// Facets of curved leaves on the command line: what is uncertain between them, and how they are made finer.
#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

TEST_CASE("uncertain crossings of curved surfaces are told, and an error if that is asked for", "[app]") {
  const Workshop w;
  w.write(
      "lens.yaml",
      "cnrg: 1\nnodes:\n  a: {sphere: {center: [0, 0, 0], radius: 1}}\n"
      "  b: {sphere: {center: [1.1994, 1.5992, 0], radius: 1}}\n  lens: {intersection: [a, b]}\nresult: lens\n");
  CHECK(w.run("eval lens.yaml").err.empty());
  CHECK_THAT(w.run("eval lens.yaml").out, Contains("lens  intersection         0      1      2        1"));
  CHECK_THAT(w.run("eval lens.yaml --no-certify").out,
             Contains("lens  intersection         0      0      0        0"));
  CHECK_THAT(w.run("eval lens.yaml --no-certify").err,
             Contains("notice: it was not asked whether curved surfaces meet as their facets do"));
  CHECK_THAT(w.run("eval lens.yaml --no-certify --certify").err, Contains("--certify"));
  CHECK(w.run("eval lens.yaml --quiet").err.empty());
  for (const std::string command : {"eval lens.yaml", "mesh lens.yaml -o lens.msh"}) {
    INFO(command);
    const Outcome o = w.run(command + " --certify --threads 2");
    CHECK(o.status == 0);
    CHECK_THAT(o.err, StartsWith("lens.yaml: notice: certified: surfaces meet as their facets do: of "));
  }
  // The rod touches the ball and crosses it in one point: Viviani's curve.
  w.write("curve.yaml",
          "cnrg: 1\nnodes:\n  a: {cylinder: {from: [1, 0, -3], to: [1, 0, 3], radius: 1}}\n"
          "  b: {sphere: {center: [0, 0, 0], radius: 2}}\n  model: {union: [a, b]}\nresult: model\n");
  for (const std::string command : {"eval curve.yaml", "mesh curve.yaml -o curve.msh"}) {
    INFO(command);
    Outcome o = w.run(command + " --certify");
    CHECK(o.status == 2);
    CHECK(o.out.empty());
    CHECK_THAT(o.err, StartsWith("curve.yaml:3:7: error: `a` (cylinder side) and `b` (sphere) near [") &&
                          Contains("]: they touch, or are nearer to it than ") &&
                          Contains(": apart there, or with a curve in common; ") &&
                          Contains("; --certify found 1 such place: "));
    CHECK(!std::filesystem::exists(w.path("curve.msh")));
    o = w.run(command + " --certify --quiet");
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("curve.yaml:3:7: error: "));
  }
  w.write("box.yaml", "cnrg: 1\nnodes:\n  a: {box: {min: [0, 0, 0], max: [1, 1, 1]}}\nresult: a\n");
  for (const std::string quiet : {"", " --quiet"}) {
    CHECK_THAT(w.run("eval curve.yaml -o u.step" + quiet).err,
               Contains("u.step: warning: its surfaces may not meet as its faces say: `a` (cylinder side) and `b` "
                        "(sphere) near ["));
    CHECK(w.run("eval lens.yaml -o u.step" + quiet).err.find("u.step: warning") == std::string::npos);
  }
  CHECK_THAT(w.run("mesh curve.yaml --curved --quiet -o u.msh").err,
             Contains("u.msh: warning: its surfaces may not meet as its faces say: "));
  CHECK(w.run("eval curve.yaml --quiet -o u.vtu").err.empty());
  CHECK_THAT(w.run("eval box.yaml --certify").err,
             Contains("certified: surfaces meet as their facets do: no curved"));
  CHECK(w.run("eval box.yaml --certify --quiet").err.empty());
}

TEST_CASE("every command that reads a tree can make its curved leaves finer", "[app]") {
  const Workshop w;
  w.write("t.yaml", R"(cnrg: 1
nodes:
  a: {cylinder: {from: [0, 0, 0], to: [0, 0, 1], radius: 1, segments: 4}}
result: a
)");
  CHECK(row(w.run("eval t.yaml").out, "a").back() == "2");
  const Outcome fine = w.run("eval t.yaml --finer 25");
  CHECK(fine.status == 0);
  CHECK_THAT(fine.out, Contains("  3.139525976"));  // 50 sin(2 pi / 100)
  // Between the square and the circle.
  CHECK_THAT(w.run("locate t.yaml", "0.6 0.6 0.5\n").out, Catch::Matches("3 (r[0-9]+|-) 0\n"));
  CHECK_THAT(w.run("locate t.yaml --finer 3", "0.6 0.6 0.5\n").out, Catch::Matches("3 r[0-9]+ 1 a\n"));
  CHECK_THAT(w.run("explain t.yaml --point 0.6,0.6,0.5 --finer 3").out, Contains("region 1 `a`"));
  const Outcome mesh = w.run("mesh t.yaml --finer 25 -o t.msh");
  INFO(mesh.err);
  CHECK(mesh.status == 0);
  CHECK_THAT(row(mesh.out, "all").back(), StartsWith("3.139525976"));
  CHECK(w.run("check t.yaml --finer 3").status == 0);
  w.write("many.yaml",
          "cnrg: 1\nnodes:\n  a: {sphere: {center: [0, 0, 0], radius: 1, segments: 499999}}\nresult: a\n");
  for (const std::string command : {"eval", "check"}) {
    const Outcome o = w.run(command + " many.yaml --finer 2");
    CHECK(o.status == 2);
    CHECK_THAT(o.err, StartsWith("many.yaml:3:7: error: made 2 times finer, `sphere` would have "));
  }
  const Outcome none = w.run("eval t.yaml --finer 0");
  CHECK(none.status == 2);
  CHECK_THAT(none.err, Contains("--finer: `0` is not a whole number from 1 to 1000"));
}

}  // namespace
}  // namespace cnrg

// What `locate`, `explain` and `eval` say of parameters on patches.
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;

const char* const kCurvedTree = R"(cnrg: 1
nodes:
  can: {cylinder: {from: [0, 0, 0], to: [0, 0, 2], radius: 1, segments: 8}}
  pin: {cone: {from: [0, 0, 1], to: [0, 0, 3], radius: 1/2, segments: 16}}
  wire: {bezier: {curve: [[5, 0, 0], [6, 0, 1], [7, 0, 0]], segments: 2}}
  tee: {difference: [can, pin]}
  all: {union: [tee, wire]}
result: all
)";

}  // namespace

TEST_CASE("locate tells patches and parameters when asked", "[app]") {
  const Workshop w;
  w.write("t.yaml", kCurvedTree);
  // On the seam; a quarter round at half height; in the tip's side, which the difference made the can's; on the
  // cap at its corner; a wire; inside.
  const std::string points = "1 0 1/2\n0 1 1\n0 1/4 2\n1/4 0 2\n1 0 2\n11/2 0 1/4\n0 0 0.5\n\n9 9 9\n";
  const Outcome plain = w.run("locate t.yaml", points), o = w.run("locate t.yaml --parameters", points);
  INFO(o.err);
  REQUIRE(o.status == 0);
  CHECK_THAT(o.out, Catch::Matches("2 f[0-9]+ 2 entities\tcan: cylinder side: 0 1/4\n"
                                   "2 f[0-9]+ 2 entities\tcan: cylinder side: 1/4 1/2\n"
                                   "1 e[0-9]+ 2 entities\tpin: cone side: 1/4 1/2\n"
                                   "1 e[0-9]+ 2 entities\tpin: cone side: 0 1/2\n"
                                   "1 e[0-9]+ 2 entities\tcan: cylinder side: 0 1\n"
                                   "1 e[0-9]+ 2 entities\twire: bezier curve: 1/4\n"
                                   "3 r[0-9]+ 1 can\n\n3 (r[0-9]+|-) 0\n"));
  std::string cut;
  bool in_fields = false;
  for (const char c : o.out) {
    in_fields = c == '\t' || (in_fields && c != '\n');
    if (!in_fields) cut += c;
  }
  CHECK(cut == plain.out);
}

TEST_CASE("explain tells the place on patches and curves", "[app]") {
  const Workshop w;
  w.write("t.yaml", kCurvedTree);
  const auto said = [&](const std::string& arguments) {
    const Outcome o = w.run("explain t.yaml " + arguments);
    INFO(o.err);
    REQUIRE(o.status == 0);
    return o.out;
  };
  CHECK_THAT(said("--point 1,0,1/2"), Contains("\non      can: cylinder side at u = 0, v = 1/4\n"));
  CHECK_THAT(said("--point 0,1/4,2"), Contains("\non      pin: cone side at u = 1/4, v = 1/2\n"));
  CHECK_THAT(said("--point 6,0,1/2"), Contains("\non      wire: bezier curve at t = 1/2\n"));
  CHECK_THAT(said("--point 0,0,1/2"), !Contains("\non  "));
  CHECK_THAT(said("--point 0.3,0.9,0.5"), !Contains("\non  "));
}

TEST_CASE("files have parameters with --parameters only", "[app]") {
  const Workshop w;
  w.write("t.yaml", kCurvedTree);
  REQUIRE(w.run("eval t.yaml -o a.json -o a.vtu --quiet").status == 0);
  REQUIRE(w.run("eval t.yaml -o b.json -o b.vtu --quiet --parameters").status == 0);
  for (const char* name : {"a.json", "a.vtu"})
    CHECK_THAT(w.read(name), !Contains("cylinder side") && !Contains("Name=\"patch "));
  CHECK_THAT(w.read("b.json"), Contains("\"name\":\"cylinder side\"") && Contains("\"cells\":[["));
  CHECK_THAT(w.read("b.vtu"), Contains("Name=\"parameters\"") && Contains("Name=\"patch "));
  w.write("r.yaml", "cnrg: 1\nnodes:\n  r: {cnrg: b.json}\nresult: r\n");
  const Outcome o = w.run("locate r.yaml --parameters", "0 1 1\n0 1/4 2\n");
  CHECK_THAT(o.out, Contains("\tr: cylinder side: 1/4 1/2\n") && Contains("\tr: cone side: 1/4 1/2\n"));
}

}  // namespace cnrg

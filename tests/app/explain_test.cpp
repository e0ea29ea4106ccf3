// `cnrg explain` from outside: the text of a small tree, and command lines that make no sense.
#include <algorithm>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const char* const kSplit = R"(cnrg: 1
nodes:
  block: {box: {min: [0, 0, 0], max: [4, 4, 4]}}
  fault: {polygon: [[-1, -1, 2], [5, -1, 2], [5, 5, 2], [-1, 5, 2]]}
  hole:  {box: {min: [1, 1, 1], max: [2, 2, 5]}}
  split: {union: [fault, block], dominance: left}
  model: {difference: [split, hole]}
  solid: {regularize: model}
result: solid
)";

TEST_CASE("a region thinner than any double tells is explained too", "[app][explain]") {
  const Workshop w;
  w.write("thin.yaml",
          "cnrg: 1\nnodes:\n  a: {box: {min: [\"1/3\", \"1/3\", \"1/3\"], max: [2, 2, "
          "\"1000000000000000000000000000001/3000000000000000000000000000000\"]}}\nresult: a\n");
  for (const std::string cell : {"r0", "r1"}) {
    const Outcome o = w.run("explain thin.yaml --cell " + cell);
    INFO(o.err);
    CHECK(o.status == 0);
    // The point that it shows lies in the cell.
    const std::size_t at = o.out.find("at      ");
    REQUIRE(at != std::string::npos);
    std::string point = o.out.substr(at + 8, o.out.find('\n', at) - at - 8);
    const std::string exactly = "exactly ";  // after a rounded one
    if (point.find(exactly) != std::string::npos) point.erase(0, point.find(exactly) + exactly.size());
    std::replace(point.begin(), point.end(), ',', ' ');
    const Outcome located = w.run("locate thin.yaml", point + "\n");
    CHECK_THAT(located.out, Catch::StartsWith("3 " + cell + " "));
  }
}

TEST_CASE("explain tells the fault's life", "[app][explain]") {
  const Workshop w;
  w.write("t.yaml", kSplit);
  const Outcome o = w.run("explain t.yaml --point 3/2,3/2,2");
  CHECK(o.status == 0);
  CHECK(o.err.empty());
  CHECK(o.out == R"(3/2,3/2,2: a face of the refinement; part of r0 of `solid`: outside

normal  n = (0, 0, 1)

fault  polygon       line 4  entity: face 0
block  box           line 3  inside region 1 `block`
split  union, A > B  line 6  kept: entity
    A = fault  face, outside on both sides: numRegA = 0, dangling, outsideA
    B = block  inside region 1 `block`
    AinB       kept by union.face.AinB.dominant, which never removes
hole   box           line 5  inside region 1 `hole`
model  difference    line 7  removed; outside
    A = split  face, region 2 `block` where n points, region 1 `block` behind: numRegA = 2
    B = hole   inside region 1 `hole`
    AinB       removed by difference.face.AinB, which always removes
solid  regularize    line 8  outside

The rows are our reading of Fig. 3 of Pereira et al. (2012), whose cells its text does not carry: see `cnrg tables`.
)");
  const Outcome dangling = w.run("explain t.yaml --node solid --point -1/2,2,2");
  CHECK(dangling.out == R"(-1/2,2,2: a face of the refinement; part of r0 of `solid`: outside

normal  n = (0, 0, 1)

fault  polygon       line 4  entity: face 0
block  box           line 3  outside
split  union, A > B  line 6  kept: entity
    A = fault  face, outside on both sides: numRegA = 0, dangling, outsideA
    B = block  outside
    AoutB      kept by union.face.AoutB.dominant, which never removes
hole   box           line 5  outside
model  difference    line 7  kept: entity
    A = split  face, outside on both sides: numRegA = 0, dangling, outsideA
    B = hole   outside
    AoutB      kept by difference.face.AoutB, which never removes
solid  regularize    line 8  outside
    X = model  entity, a face
               face, outside on both sides: numRegX = 0, dangling, outsideX: removed

The rows are our reading of Fig. 3 of Pereira et al. (2012), whose cells its text does not carry: see `cnrg tables`.
)");
}

TEST_CASE("columns of explain are as wide as names have letters", "[app][explain]") {
  const Workshop w;
  const auto with_marks = [](std::string text) {
    const std::pair<std::string, std::string> names[] = {{"block", "blöck"}, {"fault", "fäült"}, {"hole", "höhl"}};
    for (const auto& [plain, marked] : names) {
      for (std::size_t at = 0; (at = text.find(plain, at)) != std::string::npos; at += marked.size())
        text.replace(at, plain.size(), marked);
    }
    return text;
  };
  w.write("t.yaml", kSplit);
  w.write("marks.yaml", with_marks(kSplit));
  const std::string point = " --point 3/2,3/2,2";
  const Outcome o = w.run("explain marks.yaml" + point);
  CHECK(o.status == 0);
  CHECK(o.out == with_marks(w.run("explain t.yaml" + point).out));
}

TEST_CASE("explain takes a cell as locate names it", "[app][explain]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  sheet: {polygon: [[0, 0, 1], [4, 0, 1], [4, 2, 1], [0, 2, 1]]}\n"
          "  fin: {polygon: [[2, 0, 0], [2, 2, 0], [2, 2, 2], [2, 0, 2]]}\n"
          "  cut: {difference: [sheet, fin]}\nresult: cut\n");
  const std::string located = w.run("locate t.yaml", "1 1 1\n").out;
  const std::string cell = located.substr(2, located.find(' ', 2) - 2);
  const Outcome o = w.run("explain t.yaml --threads 1 --cell " + cell);
  CHECK(o.status == 0);
  CHECK_THAT(o.out, StartsWith(cell + " of `cut`: face, entity; unites 2 faces of the refinement"));
  CHECK_THAT(o.out, Contains("All 2 faces live alike; one of them:\nat      "));
  CHECK(o.out == w.run("explain t.yaml --threads 2 --cell " + cell).out);
}

TEST_CASE("explain refuses what it cannot look up", "[app][explain][errors]") {
  const Workshop w;
  w.write("t.yaml", kSplit);
  const auto fault = [&](const std::string& arguments) {
    const Outcome o = w.run("explain t.yaml " + arguments);
    CHECK(o.status == 2);
    CHECK(o.out.empty());
    return o.err;
  };
  CHECK_THAT(fault(""), StartsWith("cnrg: error: give one of --cell and --point"));
  CHECK_THAT(fault("--cell f0 --point 0,0,0"), StartsWith("cnrg: error: give one of --cell and --point"));
  CHECK(fault("--node block --cell f6") == "cnrg: error: `f6`: the node `block` has faces f0 to f5\n");
  CHECK_THAT(fault("--cell face1"), StartsWith("cnrg: error: `face1` names no cell"));
  CHECK_THAT(fault("--point 1,2"), StartsWith("cnrg: error: --point: `1,2` has not three numbers"));
  CHECK_THAT(fault("--point 1,2,3,4"), StartsWith("cnrg: error: --point: `1,2,3,4` has not three numbers"));
  CHECK_THAT(fault("--point 1,two,3"), StartsWith("cnrg: error: --point: `two` is no number"));
  CHECK(fault("--node blok --cell f0") ==
        "cnrg: error: --node: t.yaml has no node called `blok`; did you mean `block`?\n");
}

}  // namespace
}  // namespace cnrg
